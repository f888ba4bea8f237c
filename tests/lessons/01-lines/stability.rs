use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use checks::segment::{Report, largest_smooth, measure, thickness};
use common::{Bounds, Color, IVec2};
use lines::METHODS;
use verify::{method, window};

/// What must happen.
#[derive(Debug)]
enum Must {
    /// One pixel a step, the nearest one; both ends; the same from b to a. A smooth line: its centre of mass
    /// within 1/255 px; if it is equally thick in every direction instead, each pixel's share within 1/10 of what a line
    /// 1 px thick covers.
    Exact,
    /// As `Exact`, but for pixels as far from the line as this many px.
    AtMost(f64),
    /// Just these faults.
    Fail(&'static str),
}
use Must::{AtMost, Exact, Fail};

type Row = (&'static str, Must);
type Case = (&'static str, [i32; 4], &'static [Row]);

/// Input, its two ends, and what each method must do with it.
const TABLE: &[Case] = &[
    (
        "the slides' white line",
        [13, 20, 80, 40],
        &[
            ("step-0.1", Fail("gaps 58, ends missed 1, reversed differs")),
            ("step-0.01", Fail("gaps 1, doubled 34, ends missed 1, 0.96 px off, reversed differs")),
            ("per-column", Fail("0.99 px off, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", AtMost(1.0)),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "the slides' red line: steep",
        [20, 13, 40, 80],
        &[
            ("step-0.1", Fail("gaps 58, ends missed 1, reversed differs")),
            ("step-0.01", Fail("gaps 1, doubled 34, ends missed 1, 0.96 px off, reversed differs")),
            ("per-column", Fail("gaps 47, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", AtMost(1.0)),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "leftward",
        [20, 7, 0, 0],
        &[
            ("step-0.1", Fail("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fail("doubled 20, 0.95 px off, reversed differs")),
            ("per-column", Fail("gaps 21, ends missed 2, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", Fail("ends missed 1, 1.00 px off")),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "leftward and steep",
        [7, 20, 0, 0],
        &[
            ("step-0.1", Fail("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fail("doubled 20, 0.95 px off, reversed differs")),
            ("per-column", Fail("gaps 21, ends missed 2, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", Fail("ends missed 1, 1.00 px off")),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "slope above 1/2",
        [0, 0, 20, 13],
        &[
            ("step-0.1", Fail("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fail("gaps 1, doubled 20, ends missed 1, 0.85 px off, reversed differs")),
            ("per-column", Fail("0.95 px off, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", Fail("ends missed 1, 1.00 px off")),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Fail("ends missed 2, 1.10 px off")),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "slope 1",
        [0, 0, 9, 9],
        &[
            ("step-0.1", Fail("gaps 1, doubled 1, ends missed 1, reversed differs")),
            ("step-0.01", Fail("gaps 1, doubled 9, ends missed 1, reversed differs")),
            ("per-column", Fail("reversed differs")),
            ("transposed", Exact),
            ("slope", Exact),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Fail("ends missed 2, 1.00 px off")),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "horizontal",
        [0, 5, 9, 5],
        &[
            ("step-0.1", Fail("gaps 1, doubled 1, ends missed 1, reversed differs")),
            ("step-0.01", Fail("gaps 1, doubled 9, ends missed 1, reversed differs")),
            ("per-column", Fail("reversed differs")),
            ("transposed", Exact),
            ("slope", Exact),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Exact),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "vertical, downward",
        [5, 9, 5, 0],
        &[
            ("step-0.1", Fail("reversed differs")),
            ("step-0.01", Fail("doubled 9, reversed differs")),
            ("per-column", Fail("gaps 9, ends missed 1")),
            ("transposed", Exact),
            ("slope", Exact),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Exact),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "ties",
        [0, 0, 8, 4],
        &[
            ("step-0.1", Fail("gaps 1, doubled 2, ends missed 1, reversed differs")),
            ("step-0.01", Fail("gaps 1, doubled 8, ends missed 1, reversed differs")),
            ("per-column", Fail("reversed differs")),
            ("transposed", Exact),
            ("slope", Exact),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Exact),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "negative coordinates",
        [-20, -7, -1, -1],
        &[
            ("step-0.1", Fail("gaps 10, ends missed 1, 0.74 px off, reversed differs")),
            ("step-0.01", Fail("doubled 19, 0.95 px off, reversed differs")),
            ("per-column", Fail("0.95 px off, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", AtMost(1.0)),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "both ends one",
        [3, 4, 3, 4],
        &[
            ("step-0.1", Fail("doubled 1")),
            ("step-0.01", Fail("doubled 1")),
            ("per-column", Fail("ends missed 2, 4.00 px off")),
            ("transposed", Fail("ends missed 2, 4.00 px off")),
            ("slope", Exact),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Exact),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "200 px",
        [0, 0, 200, 73],
        &[
            ("step-0.1", Fail("gaps 191, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fail("gaps 100, ends missed 1, 0.98 px off, reversed differs")),
            ("per-column", Fail("0.99 px off, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", AtMost(1.0)),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "16k px",
        [0, 0, 16_384, 11_111],
        &[
            ("step-0.1", Fail("gaps 16375, ends missed 1, 0.66 px off, reversed differs")),
            ("step-0.01", Fail("gaps 16284, ends missed 1, 0.90 px off, reversed differs")),
            ("per-column", Fail("1.00 px off, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", Fail("ends missed 1, 2.18 px off")),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Fail("ends missed 2, 1.18 px off")),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "65k px",
        [0, 0, 65_536, 44_444],
        &[
            ("step-0.1", Fail("gaps 65527, ends missed 1, 0.66 px off, reversed differs")),
            ("step-0.01", Fail("gaps 65436, ends missed 1, 0.80 px off, reversed differs")),
            ("per-column", Fail("1.00 px off, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", Fail("ends missed 1, 15.84 px off")),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", Fail("ends missed 2, 1.18 px off")),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "a million px",
        [0, 0, 1_000_000, 333_333],
        &[
            ("step-0.1", Fail("gaps 999991, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fail("gaps 999900, ends missed 1, 0.99 px off, reversed differs")),
            ("per-column", Fail("1.00 px off, reversed differs")),
            ("transposed", AtMost(1.0)),
            ("slope", Fail("ends missed 1, 1676.07 px off")),
            ("fraction", Fail("0.51 px off")),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "beyond 2^24",
        [16_777_216, 0, 16_777_236, 7],
        &[
            ("step-0.1", Fail("gaps 11, ends missed 1, 0.90 px off, reversed differs")),
            ("step-0.01", Fail("gaps 10, doubled 11, ends missed 1, 1.20 px off, reversed differs")),
            ("per-column", Fail("1.15 px off, reversed differs")),
            ("transposed", Fail("1.15 px off")),
            ("slope", Fail("ends missed 1, 1.00 px off")),
            ("fraction", Exact),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "at the top of i32",
        [2_147_483_627, 2_147_483_640, 2_147_483_647, 2_147_483_647],
        &[
            ("step-0.1", Fail("gaps 20, doubled 1, ends missed 1")),
            ("step-0.01", Fail("gaps 20, doubled 1, ends missed 1")),
            ("per-column", Fail("ends missed 2, 2147483647.00 px off, reversed differs")),
            ("transposed", Fail("ends missed 2, 2147483647.00 px off")),
            ("slope", Fail("ends missed 2, 2147483647.00 px off")),
            ("fraction", Fail("ends missed 1, 7.00 px off")),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
    (
        "at the bottom of i32",
        [-2_147_483_648, -2_147_483_648, -2_147_483_628, -2_147_483_641],
        &[
            ("step-0.1", Fail("gaps 20, doubled 1, ends missed 1")),
            ("step-0.01", Fail("gaps 20, doubled 1, ends missed 1")),
            ("per-column", Fail("ends missed 2, 2147483648.00 px off, reversed differs")),
            ("transposed", Fail("ends missed 2, 2147483648.00 px off")),
            ("slope", Fail("ends missed 1, 2147483647.65 px off")),
            ("fraction", Fail("ends missed 1, 7.00 px off")),
            ("scaled", Exact),
            ("listing", AtMost(1.0)),
            ("bresenham", Exact),
            ("wu", Exact),
            ("distance", Exact),
        ],
    ),
];

#[test]
fn every_method_does_what_it_must() {
    for (input, [x0, y0, x1, y1], rows) in TABLE {
        assert!(rows.iter().map(|row| row.0).eq(METHODS.iter().map(|method| method.name)), "{input}");
        for (name, must) in *rows {
            let (faults, report) = examine(name, IVec2::new(*x0, *y0), IVec2::new(*x1, *y1));
            let met = match *must {
                Exact => faults == "exact",
                AtMost(limit) => {
                    report.largest <= limit
                        && [format!("{:.2} px off", report.largest), "exact".into()].contains(&faults)
                }
                Fail(expected) => faults == expected,
            };
            assert!(met, "{input}, {name}: {faults}, but {must:?} was expected");
        }
    }
}

/// All that is wrong with a method's pixels, in words.
fn examine(name: &str, a: IVec2, b: IVec2) -> (String, Report) {
    let visit = method(METHODS, name).visit;
    let run = |a, b| {
        let mut pixels = Vec::new();
        visit(a, b, Bounds::EVERYTHING, &mut |x, y, coverage| pixels.push((x, y, coverage)));
        pixels
    };
    let [forth, back] = [run(a, b), run(b, a)];
    let pixels: Vec<_> = forth.iter().map(|&(x, y, _)| (x, y)).collect();
    let report = measure(a, b, &pixels);
    let smooth = forth.iter().any(|pixel| pixel.2 < 255);
    let (error, allowed) = match (name, smooth) {
        ("distance", _) => (thickness(a, b, &forth).largest, 0.1),
        (_, true) => (largest_smooth(a, b, &forth), 1.0 / 255.0),
        (_, false) => (report.largest, 0.5),
    };
    let mut faults = Vec::new();
    let mut note = |count: u64, what: &str| {
        if count > 0 {
            faults.push(format!("{what} {count}"));
        }
    };
    note(report.gaps, "gaps");
    note(if smooth { 0 } else { report.doubled }, "doubled");
    note(report.beyond as u64, "beyond");
    note(report.missed_ends as u64, "ends missed");
    if error > allowed {
        faults.push(format!("{error:.2} px off"));
    }
    let sorted = |mut pixels: Vec<_>| {
        pixels.sort_unstable();
        pixels
    };
    if sorted(forth) != sorted(back) {
        faults.push("reversed differs".into());
    }
    (if faults.is_empty() { "exact".into() } else { faults.join(", ") }, report)
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

/// Wu's light is the same in every column, so that a line at 45° has 1/√2 of the ink of one that is 1 px thick. By the
/// distance at a right angle it is about as thick in every direction.
#[test]
fn wu_is_thinner_the_steeper_and_distance_is_not() {
    for (rise, wu, distance) in [
        (0, "1.00, off by 0.00", "1.00, off by 0.00"),
        (80, "0.93, off by 0.07", "1.01, off by 0.07"),
        (200, "0.71, off by 0.25", "1.12, off by 0.09"),
    ] {
        for (name, expected) in [("wu", wu), ("distance", distance)] {
            let (a, b) = (IVec2::ZERO, IVec2::new(200, rise));
            let mut pixels = Vec::new();
            (method(METHODS, name).visit)(a, b, Bounds::EVERYTHING, &mut |x, y, share| {
                pixels.push((x, y, share))
            });
            let found = thickness(a, b, &pixels);
            assert_eq!(format!("{:.2}, off by {:.2}", found.ink, found.largest), expected, "{name}, {rise}");
        }
    }
}

/// Beyond some 2³⁰ px the sums do not fit into 32 bits: y stays where it is, or moves when it should not.
#[test]
fn the_integer_methods_overflow() {
    let heights = |name, length: i32| {
        let mut heights = Vec::new();
        let mut plot = |_, y, _| {
            heights.push(y);
            if heights.len() == 16 {
                // Enough seen of a very long line. Unlike a panic, this prints nothing.
                resume_unwind(Box::new(()));
            }
        };
        let visit = method(METHODS, name).visit;
        let (a, b) = (IVec2::ZERO, IVec2::new(length, length / 8));
        let _ = catch_unwind(AssertUnwindSafe(|| visit(a, b, Bounds::EVERYTHING, &mut plot)));
        heights
    };
    let right = [0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2];
    for (name, length, expected) in [
        ("bresenham", 1 << 30, right),
        ("scaled", (1 << 30) - 4, right),
        ("bresenham", i32::MAX - 3, right),
        ("scaled", i32::MAX - 3, [0; 16]),
        ("listing", i32::MAX - 3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 4, 5, 6, 7, 7]),
    ] {
        assert_eq!(heights(name, length), expected, "{name}, {length} px");
    }
}

/// How far off the last hundred pixels are, of many lines of one length and any slope: the median, the worst.
/// ½ px is what rounding to nearest costs, 1 px what rounding down does; the rest has added up.
#[test]
fn rounding_adds_up() {
    for (name, length, lines, expected) in [
        ("transposed", 65_000, 1000, "0.99, 1.00 px"),
        ("slope", 16_000, 1000, "1.28, 4.56 px"),
        ("slope", 65_000, 1000, "11.33, 57.22 px"),
        ("fraction", 65_000, 1000, "0.50, 0.50 px"),
        ("fraction", 1_000_000, 60, "0.50, 0.53 px"),
    ] {
        let mut off: Vec<f64> = (0..lines)
            .map(|n| {
                let Color { r, g, b, .. } = Color::random(n);
                let rise = i32::from_le_bytes([r, g, b, 0]) % (length + 1);
                let mut pixels = Vec::new();
                let (from, to) = (IVec2::ZERO, IVec2::new(length, rise));
                (method(METHODS, name).visit)(from, to, Bounds::EVERYTHING, &mut |x, y, _| {
                    pixels.push((x, y));
                });
                measure(from, to, &pixels[pixels.len() - 100..]).largest
            })
            .collect();
        off.sort_by(f64::total_cmp);
        let got = format!("{:.2}, {:.2} px", off[off.len() / 2], off[off.len() - 1]);
        assert_eq!(got, expected, "{name}, {length} px");
    }
}
