use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use checks::segment::{draws, largest_smooth, measure, thickness};
use common::{Bounds, Color, IVec2, Method};
use lines::{LESSON, Line, METHODS};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, counted, every_method, some_methods};
use verify::window;

use crate::{places, visited};

/// A segment's ends: x and y of the one, x and y of the other.
type Ends = [i32; 4];

/// The segments, and what each method must make of them. Exact is one pixel a step, the nearest one; both ends; the
/// same from b to a; of `wu` the centre of mass within 1/255 px; of `distance`, which is as thick in every direction, each
/// pixel's share within 1/10 of what a line 1 px thick covers.
const TABLE: &[Case<Ends>] = &[
    (
        "the slides' white line",
        [13, 20, 80, 40],
        &[
            ("step-0.1", Fails("gaps 58, ends missed 1, reversed differs")),
            ("step-0.01", Fails("gaps 1, doubled 34, ends missed 1, 0.96 px off, reversed differs")),
            ("per-column", Fails("0.99 px off, reversed differs")),
            ("transposed, slope", Fails("0.99 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.79 px off")),
        ],
    ),
    (
        "the slides' red line: steep",
        [20, 13, 40, 80],
        &[
            ("step-0.1", Fails("gaps 58, ends missed 1, reversed differs")),
            ("step-0.01", Fails("gaps 1, doubled 34, ends missed 1, 0.96 px off, reversed differs")),
            ("per-column", Fails("gaps 47, reversed differs")),
            ("transposed, slope", Fails("0.99 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.79 px off")),
        ],
    ),
    (
        "leftward",
        [20, 7, 0, 0],
        &[
            ("step-0.1", Fails("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fails("doubled 20, 0.95 px off, reversed differs")),
            ("per-column", Fails("gaps 21, ends missed 2, reversed differs")),
            ("transposed", Fails("0.95 px off")),
            ("slope", Fails("ends missed 1, 1.00 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.80 px off")),
        ],
    ),
    (
        "leftward and steep",
        [7, 20, 0, 0],
        &[
            ("step-0.1", Fails("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fails("doubled 20, 0.95 px off, reversed differs")),
            ("per-column", Fails("gaps 21, ends missed 2, reversed differs")),
            ("transposed", Fails("0.95 px off")),
            ("slope", Fails("ends missed 1, 1.00 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.80 px off")),
        ],
    ),
    (
        "slope above 1/2",
        [0, 0, 20, 13],
        &[
            ("step-0.1", Fails("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fails("gaps 1, doubled 20, ends missed 1, 0.85 px off, reversed differs")),
            ("per-column", Fails("0.95 px off, reversed differs")),
            ("transposed", Fails("0.95 px off")),
            ("slope", Fails("ends missed 1, 1.00 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("ends missed 2, 1.10 px off")),
        ],
    ),
    (
        "slope 1",
        [0, 0, 9, 9],
        &[
            ("step-0.1", Fails("gaps 1, doubled 1, ends missed 1, reversed differs")),
            ("step-0.01", Fails("gaps 1, doubled 9, ends missed 1, reversed differs")),
            ("per-column", Fails("reversed differs")),
            ("transposed, slope, fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("ends missed 2, 1.00 px off")),
        ],
    ),
    (
        "horizontal",
        [0, 5, 9, 5],
        &[
            ("step-0.1", Fails("gaps 1, doubled 1, ends missed 1, reversed differs")),
            ("step-0.01", Fails("gaps 1, doubled 9, ends missed 1, reversed differs")),
            ("per-column", Fails("reversed differs")),
            ("transposed, slope, fraction, scaled, listing, bresenham, wu, distance", Exact),
        ],
    ),
    (
        "vertical, downward",
        [5, 9, 5, 0],
        &[
            ("step-0.1", Fails("reversed differs")),
            ("step-0.01", Fails("doubled 9, reversed differs")),
            ("per-column", Fails("gaps 9, ends missed 1")),
            ("transposed, slope, fraction, scaled, listing, bresenham, wu, distance", Exact),
        ],
    ),
    (
        "ties",
        [0, 0, 8, 4],
        &[
            ("step-0.1", Fails("gaps 1, doubled 2, ends missed 1, reversed differs")),
            ("step-0.01", Fails("gaps 1, doubled 8, ends missed 1, reversed differs")),
            ("per-column", Fails("reversed differs")),
            ("transposed, slope, fraction, scaled, listing, bresenham, wu, distance", Exact),
        ],
    ),
    (
        "negative coordinates",
        [-20, -7, -1, -1],
        &[
            ("step-0.1", Fails("gaps 10, ends missed 1, 0.74 px off, reversed differs")),
            ("step-0.01", Fails("doubled 19, 0.95 px off, reversed differs")),
            ("per-column", Fails("0.95 px off, reversed differs")),
            ("transposed, slope", Fails("0.95 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.79 px off")),
        ],
    ),
    (
        "both ends one",
        [3, 4, 3, 4],
        &[
            ("step-0.1, step-0.01", Fails("doubled 1")),
            ("per-column, transposed", Fails("ends missed 2, 4.00 px off")),
            ("slope, fraction, scaled, listing, bresenham, wu, distance", Exact),
        ],
    ),
    (
        "200 px",
        [0, 0, 200, 73],
        &[
            ("step-0.1", Fails("gaps 191, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fails("gaps 100, ends missed 1, 0.98 px off, reversed differs")),
            ("per-column", Fails("0.99 px off, reversed differs")),
            ("transposed, slope", Fails("0.99 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.86 px off")),
        ],
    ),
    (
        "16k px",
        [0, 0, 16_384, 11_111],
        &[
            ("step-0.1", Fails("gaps 16375, ends missed 1, 0.66 px off, reversed differs")),
            ("step-0.01", Fails("gaps 16284, ends missed 1, 0.90 px off, reversed differs")),
            ("per-column", Fails("1.00 px off, reversed differs")),
            ("transposed", Fails("1.00 px off")),
            ("slope", Fails("ends missed 1, 2.18 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("ends missed 2, 1.18 px off")),
        ],
    ),
    (
        "65k px",
        [0, 0, 65_536, 44_444],
        &[
            ("step-0.1", Fails("gaps 65527, ends missed 1, 0.66 px off, reversed differs")),
            ("step-0.01", Fails("gaps 65436, ends missed 1, 0.80 px off, reversed differs")),
            ("per-column", Fails("1.00 px off, reversed differs")),
            ("transposed", Fails("1.00 px off")),
            ("slope", Fails("ends missed 1, 15.84 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("ends missed 2, 1.18 px off")),
        ],
    ),
    (
        "a million px",
        [0, 0, 1_000_000, 333_333],
        &[
            ("step-0.1", Fails("gaps 999991, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fails("gaps 999900, ends missed 1, 0.99 px off, reversed differs")),
            ("per-column", Fails("1.00 px off, reversed differs")),
            ("transposed", Fails("1.00 px off")),
            ("slope", Fails("ends missed 1, 1676.07 px off")),
            ("fraction", Fails("0.51 px off")),
            ("scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.83 px off")),
        ],
    ),
    (
        "beyond 2^24",
        [16_777_216, 0, 16_777_236, 7],
        &[
            ("step-0.1", Fails("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fails("gaps 10, doubled 11, ends missed 1, 1.20 px off, reversed differs")),
            ("per-column", Fails("1.15 px off, reversed differs")),
            ("transposed", Fails("1.15 px off")),
            ("slope", Fails("ends missed 1, 1.00 px off")),
            ("fraction, scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.80 px off")),
        ],
    ),
    (
        "at the top of i32",
        [2_147_483_627, 2_147_483_640, 2_147_483_647, 2_147_483_647],
        &[
            ("step-0.1, step-0.01", Fails("gaps 20, doubled 1, ends missed 1")),
            ("per-column", Fails("ends missed 2, 2147483647.00 px off, reversed differs")),
            ("transposed, slope", Fails("ends missed 2, 2147483647.00 px off")),
            ("fraction", Fails("ends missed 1, 7.00 px off")),
            ("scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.80 px off")),
        ],
    ),
    (
        "at the bottom of i32",
        [-2_147_483_648, -2_147_483_648, -2_147_483_628, -2_147_483_641],
        &[
            ("step-0.1, step-0.01", Fails("gaps 20, doubled 1, ends missed 1")),
            ("per-column", Fails("ends missed 2, 2147483648.00 px off, reversed differs")),
            ("transposed", Fails("ends missed 2, 2147483648.00 px off")),
            ("slope", Fails("ends missed 1, 2147483647.65 px off")),
            ("fraction", Fails("ends missed 1, 7.00 px off")),
            ("scaled, bresenham, wu, distance", Exact),
            ("listing", Fails("0.80 px off")),
        ],
    ),
];

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method, &ends| faults(method, ends));
}

fn ends([x0, y0, x1, y1]: Ends) -> [IVec2; 2] {
    [IVec2::new(x0, y0), IVec2::new(x1, y1)]
}

/// What a method visits between two ends, wherever it is.
fn walked(method: &Method<Line>, [a, b]: [IVec2; 2]) -> Vec<(i32, i32, u8)> {
    visited(|plot| (method.run.visit)(a, b, Bounds::EVERYTHING, plot))
}

/// All that is wrong with a method's pixels.
fn faults(method: &Method<Line>, segment: Ends) -> Vec<String> {
    let [a, b] = ends(segment);
    let [mut forth, mut back] = [walked(method, [a, b]), walked(method, [b, a])];
    let report = measure(a, b, &places(&forth));
    let smooth = forth.iter().any(|pixel| pixel.2 < 255);
    let (error, allowed) = match (method.name, smooth) {
        ("distance", _) => (thickness(a, b, &forth).largest, 0.1),
        (_, true) => (largest_smooth(a, b, &forth), 1.0 / 255.0),
        (_, false) => (report.largest, 0.5),
    };
    let doubled = if smooth { 0 } else { report.doubled };
    let mut faults = counted([
        ("gaps", report.gaps as usize),
        ("doubled", doubled as usize),
        ("beyond", report.beyond),
        ("ends missed", report.missed_ends),
    ]);
    if error > allowed {
        faults.push(format!("{error:.2} px off"));
    }
    forth.sort_unstable();
    back.sort_unstable();
    if forth != back {
        faults.push("reversed differs".into());
    }
    faults
}

/// A segment of which a window of 20×20 px shows a piece.
#[test]
fn what_cannot_be_seen_costs_the_last_three_nothing() {
    let (a, b) = (IVec2::new(-100_000, -7), IVec2::new(100_000, 32));
    for row in METHODS {
        let (mut plotted, mut seen) = (0, Vec::new());
        (row.run.visit)(a, b, window(20, 20), &mut |x, y, coverage| {
            plotted += 1;
            if window(20, 20).contains(x, y) {
                seen.push((x, y, coverage));
            }
        });
        let expected = match row.name {
            "step-0.1" => (10, 1),
            "step-0.01" => (101, 1),
            "bresenham" => (20, 20),
            "wu" | "distance" => (40, 40),
            _ => (200_001, 20),
        };
        assert_eq!((plotted, seen.len()), expected, "{}", row.name);
    }
}

/// Lengths of segments that rise by 1 in 8, in px. Beyond some 2³⁰ px the sums do not fit into 32 bits: y stays where
/// it is, or moves when it should not.
const OVERFLOW: &[Case<i32>] = &[
    ("2^30 px", 1 << 30, &[("bresenham", Exact)]),
    ("2^30 - 4 px", (1 << 30) - 4, &[("scaled", Exact)]),
    (
        "2^31 - 4 px",
        i32::MAX - 3,
        &[
            ("scaled", Fails("rises 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0")),
            ("listing", Fails("rises 0 0 0 0 1 2 3 3 3 3 3 4 5 6 7 7")),
            ("bresenham", Exact),
        ],
    ),
];

#[test]
fn the_integer_methods_overflow() {
    some_methods(LESSON.name, METHODS, OVERFLOW, |method, &length| {
        let mut heights = Vec::new();
        let mut plot = |_, y, _| {
            heights.push(y);
            if heights.len() == 16 {
                // Enough seen of a very long line. Unlike a panic, this prints nothing.
                resume_unwind(Box::new(()));
            }
        };
        let (a, b) = (IVec2::ZERO, IVec2::new(length, length / 8));
        let _ = catch_unwind(AssertUnwindSafe(|| (method.run.visit)(a, b, Bounds::EVERYTHING, &mut plot)));
        let right = [0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2];
        let told = heights.iter().map(i32::to_string).collect::<Vec<_>>().join(" ");
        if heights == right { vec![] } else { vec![format!("rises {told}")] }
    });
}

/// How long lines of any slope are, and how many of them: how far off the last hundred pixels of each are, the
/// median and the worst. ½ px is what rounding to nearest costs, 1 px what rounding down does; the rest has added up.
const LONG: &[Case<(i32, u64)>] = &[
    ("16,000 px", (16_000, 1000), &[("slope", Fails("1.28 px off, 4.56 at worst"))]),
    (
        "65,000 px",
        (65_000, 1000),
        &[
            ("transposed", Fails("0.99 px off, 1.00 at worst")),
            ("slope", Fails("11.33 px off, 57.22 at worst")),
            ("fraction", Fails("0.50 px off, 0.50 at worst")),
        ],
    ),
    (
        "a million px",
        (1_000_000, 60),
        &[
            ("transposed", Fails("0.98 px off, 1.00 at worst")),
            ("fraction", Fails("0.50 px off, 0.53 at worst")),
        ],
    ),
];

#[test]
fn rounding_adds_up() {
    some_methods(LESSON.name, METHODS, LONG, |method, &(length, lines)| {
        let last = |n| {
            let Color { r, g, b, .. } = Color::random(n);
            let rise = i32::from_le_bytes([r, g, b, 0]) % (length + 1);
            let (from, to) = (IVec2::ZERO, IVec2::new(length, rise));
            let pixels = places(&walked(method, [from, to]));
            measure(from, to, &pixels[pixels.len() - 100..]).largest
        };
        let mut off: Vec<f64> = (0..lines).map(last).collect();
        off.sort_by(f64::total_cmp);
        vec![format!("{:.2} px off, {:.2} at worst", off[off.len() / 2], off[off.len() - 1])]
    });
}

/// Long segments that pass so closely over a pixel's centre that the share of the way, in f32, falls short of it: where
/// rounding down is right, `transposed` is one more pixel down.
const OVER_A_CENTER: &[Case<Ends>] = &[
    ("50,000 px", [0, 0, 50_000, 27_961], &[("transposed", Fails("1.00 px off")), ("bresenham", Exact)]),
    (
        "a million px",
        [0, 0, 1_000_003, 990_581],
        &[("transposed", Fails("1.01 px off")), ("bresenham", Exact)],
    ),
    ("5 million px", [0, 0, 5_000_000, 4_017_913], &[("transposed", Fails("1.06 px off"))]),
];

#[test]
fn transposed_is_over_a_pixel_off_on_long_segments() {
    some_methods(LESSON.name, METHODS, OVER_A_CENTER, |method, &segment| faults(method, segment));
}

/// Segments whose middle is half-way between two pixels: it is to stay with the lower end. The sum of a fraction that
/// f32 rounds goes either way.
const TIES: &[Case<Ends>] = &[
    ("1 in 2", [0, 0, 100, 50], &[("fraction, scaled, bresenham", Exact)]),
    ("1 in 6", [0, 0, 6, 1], &[("fraction, scaled, bresenham", Exact)]),
    ("3 in 10", [0, 0, 10, 3], &[("fraction", Fails("ties the other way 1")), ("scaled, bresenham", Exact)]),
    (
        "5 in 14, downward",
        [14, 0, 0, 5],
        &[("fraction", Fails("ties the other way 1")), ("scaled, bresenham", Exact)],
    ),
    (
        "11 in 12, steep",
        [0, 0, 11, 12],
        &[("fraction", Fails("ties the other way 1")), ("scaled, bresenham", Exact)],
    ),
];

#[test]
fn a_tie_goes_to_the_lower_end_but_in_fraction() {
    some_methods(LESSON.name, METHODS, TIES, |method, &segment| {
        let [a, b] = ends(segment);
        let pixels = places(&walked(method, [a, b]));
        counted([("ties the other way", pixels.iter().filter(|&&(x, y)| !draws(a, b, x, y)).count())])
    });
}

/// How many pixels wide a line is, and how dark: what it covers as a share of a band 1 px wide. `wu` shares a pixel's
/// worth out to two; on a slope that is as much too little as one whole pixel a column.
const THICKNESS: &[Case<Ends>] = &[
    ("level", [0, 0, 100, 0], &[("scaled, bresenham, wu", Exact)]),
    (
        "1 in 5",
        [0, 0, 100, 20],
        &[("scaled, bresenham", Fails("0.98 of the ink")), ("wu", Fails("1.79 px wide, 0.98 of the ink"))],
    ),
    (
        "1 in 2",
        [0, 0, 100, 50],
        &[("scaled, bresenham", Fails("0.89 of the ink")), ("wu", Fails("1.50 px wide, 0.89 of the ink"))],
    ),
    ("1 in 1", [0, 0, 100, 100], &[("scaled, bresenham, wu", Fails("0.71 of the ink"))]),
];

#[test]
fn wu_is_wider_and_all_are_pale_on_a_slope() {
    some_methods(LESSON.name, METHODS, THICKNESS, |method, &segment| {
        let [a, b] = ends(segment);
        let pixels = walked(method, [a, b]);
        let steps = f64::from((b - a).abs().max_element());
        let length = (b - a).as_dvec2().length();
        let width = pixels.len() as f64 / (steps + 1.0);
        let ink = pixels.iter().map(|pixel| f64::from(pixel.2)).sum::<f64>() / 255.0 / (steps + 1.0);
        let share = ink * steps / length;
        let told = [(width, "px wide"), (share, "of the ink")];
        let wrong = told.into_iter().filter(|(value, _)| (value - 1.0).abs() > 0.005);
        wrong.map(|(value, what)| format!("{value:.2} {what}")).collect::<Vec<_>>()
    });
}

/// Held against a line 1 px thick, pixel by pixel: the steeper, the more `wu` lacks; `distance` stays within 1/10.
#[test]
fn wu_lacks_ink_the_steeper_it_is_and_distance_does_not() {
    for (rise, wu, distance) in [
        (0, "1.00, off by 0.00", "1.00, off by 0.00"),
        (80, "0.93, off by 0.07", "1.01, off by 0.07"),
        (200, "0.71, off by 0.25", "1.12, off by 0.09"),
    ] {
        for (name, expected) in [("wu", wu), ("distance", distance)] {
            let [a, b] = ends([0, 0, 200, rise]);
            let method = Method::find(METHODS, name).expect("the lesson has it");
            let found = thickness(a, b, &walked(method, [a, b]));
            assert_eq!(format!("{:.2}, off by {:.2}", found.ink, found.largest), expected, "{name}, {rise}");
        }
    }
}
