use antialiasing::{LESSON, METHODS};
use common::{Color, Image};
use verify::stability::Must::{self, Exact, Fails};
use verify::stability::{Case, Row, every_method};

use crate::scenes::{
    Scene, above, behind_a_side, circle, codes, fan, flat, grid, halves, hidden, on_white, pair, rectangle,
    right_of, slivers, steep, stripes, strips, through,
};

/// Where every method is right.
const ALL_EXACT: &[Row] =
    &[("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16, area", Exact)];

/// Nothing wrong, or this.
const fn must(faults: &'static str) -> Must {
    if faults.is_empty() { Exact } else { Fails(faults) }
}

/// What each method gets wrong, nothing where it is right. Shaded once or at each sample, the same samples see the same.
macro_rules! off {
    [$none:literal, $two:literal, $four:literal, $eight:literal, $sixteen:literal, $ordered:literal, $area:literal] => {
        &[
            ("none", must($none)),
            ("msaa-2", must($two)),
            ("ssaa-4, msaa-4", must($four)),
            ("msaa-8", must($eight)),
            ("ssaa-16, msaa-16", must($sixteen)),
            ("ordered-16", must($ordered)),
            ("area", must($area)),
        ]
    };
}

/// Makes a scene.
type Make = fn() -> Scene;

/// Scenes, and what each method must do: exact is the mean of all that is seen in each pixel, rounded. What is not is told by
/// how many pixels differ from that by more than rounding, and by how many grey levels at most. Columns: `none`, then 2, 4, 8 and
/// 16 samples, `ordered-16`, `area`.
const TABLE: &[Case<Make>] = &[
    ("all of the picture", || Scene::white([9, 7], [[[-9.0, -9.0], [40.0, -9.0], [-9.0, 40.0]]]), ALL_EXACT),
    ("nothing", || Scene::white([9, 7], []), ALL_EXACT),
    (
        "outside of the picture",
        || Scene::white([9, 7], [[[-9.0, -9.0], [0.0, -9.0], [-9.0, 30.0]]]),
        ALL_EXACT,
    ),
    (
        "a square of whole pixels",
        || Scene::white([9, 7], rectangle([2.0, 1.0], [7.0, 5.0])),
        off!["", "", "", "", "", "", "8 by 61"],
    ),
    (
        "an upright edge through the centres",
        || Scene::white([9, 7], [right_of(2.5)]),
        off!["7 by 128", "", "", "", "", "", ""],
    ),
    (
        "a level edge through the centres",
        || Scene::white([9, 7], [above(2.5)]),
        off!["9 by 128", "", "", "", "", "", ""],
    ),
    (
        "a square of half pixels all around",
        || Scene::white([9, 7], rectangle([2.5, 1.5], [6.5, 5.5])),
        off!["16 by 191", "4 by 64", "", "", "", "", "5 by 63"],
    ),
    (
        "an upright edge through samples, at 1/8",
        || Scene::white([9, 7], [right_of(2.125)]),
        off!["7 by 32", "7 by 32", "7 by 32", "", "", "7 by 32", ""],
    ),
    (
        "a level edge through samples, at 7/8",
        || Scene::white([9, 7], [above(4.875)]),
        off!["9 by 32", "9 by 32", "9 by 32", "", "", "9 by 32", ""],
    ),
    (
        "an upright edge at a third",
        || Scene::white([9, 7], [right_of(2.333)]),
        off!["7 by 85", "7 by 42", "7 by 21", "7 by 11", "7 by 11", "7 by 21", ""],
    ),
    (
        "a level edge at a third",
        || Scene::white([9, 7], [above(2.333)]),
        off!["9 by 85", "9 by 42", "9 by 21", "9 by 11", "9 by 5", "9 by 21", ""],
    ),
    (
        "an upright edge at 1/256",
        || Scene::white([9, 7], [right_of(2.003_906_3)]),
        off!["7 by 1", "7 by 1", "7 by 1", "7 by 1", "7 by 15", "7 by 1", ""],
    ),
    (
        "a diagonal edge through the pixels' corners",
        || Scene::white([9, 7], [[[-1.0, -1.0], [9.0, -1.0], [9.0, 9.0]]]),
        off!["7 by 128", "", "", "7 by 32", "7 by 16", "7 by 32", ""],
    ),
    (
        "a diagonal edge through the middles of the pixels' sides",
        || Scene::white([9, 7], [[[-1.0, -1.5], [9.0, -1.5], [9.0, 8.5]]]),
        off!["14 by 32", "14 by 96", "14 by 32", "7 by 32", "", "14 by 16", ""],
    ),
    (
        "an edge that rises 1 in 2",
        || Scene::white([9, 7], [[[0.0, 1.0], [12.0, 1.0], [12.0, 7.0]]]),
        off!["9 by 64", "9 by 64", "", "5 by 32", "", "", ""],
    ),
    (
        "an edge that rises 1 in 16",
        || Scene::white([16, 3], [[[0.0, 1.0], [16.0, 0.0], [16.0, 2.0]]]),
        off!["32 by 120", "32 by 56", "32 by 24", "32 by 8", "32 by 8", "32 by 24", ""],
    ),
    (
        "an edge that falls 16 in 1",
        || Scene::white([3, 16], [[[1.0, 16.0], [0.0, 0.0], [2.0, 0.0]]]),
        off!["32 by 120", "32 by 56", "32 by 24", "32 by 8", "32 by 8", "32 by 24", ""],
    ),
    (
        "an edge of golden slope",
        || Scene::white([13, 8], [[[0.0, 0.0], [13.0, 0.0], [13.0, 8.034]]]),
        off!["20 by 125", "20 by 92", "20 by 34", "20 by 34", "20 by 26", "20 by 11", ""],
    ),
    (
        "clockwise",
        || Scene::white([13, 8], [[[0.0, 0.0], [13.0, 8.034], [13.0, 0.0]]]),
        off!["20 by 125", "20 by 92", "20 by 34", "20 by 34", "20 by 26", "20 by 11", ""],
    ),
    (
        "a corner on a sample",
        || Scene::white([9, 7], [[[4.375, 3.125], [9.0, 0.5], [8.0, 6.5]]]),
        off!["19 by 128", "18 by 94", "18 by 77", "18 by 51", "18 by 28", "18 by 14", ""],
    ),
    (
        "thinner than the gaps between samples, upright",
        || Scene::white([9, 7], rectangle([4.507_812_5, -1.0], [4.546_875, 8.0])),
        off!["7 by 10", "7 by 10", "7 by 10", "7 by 10", "7 by 10", "7 by 10", ""],
    ),
    (
        "thinner than the gaps between samples, level",
        || Scene::white([9, 7], rectangle([-1.0, 3.507_812_5], [10.0, 3.546_875])),
        off!["9 by 10", "9 by 10", "9 by 10", "9 by 10", "9 by 10", "9 by 10", ""],
    ),
    (
        "1/256 px wide, level, off all samples",
        || Scene::white([9, 7], rectangle([-1.0, 3.527_343_8], [10.0, 3.531_25])),
        off!["9 by 1", "9 by 1", "9 by 1", "9 by 1", "9 by 1", "9 by 1", "1 by 1"],
    ),
    (
        "a line of 1/4 px, nearly level",
        || {
            Scene::white(
                [16, 4],
                [[[0.0, 1.1], [16.0, 2.1], [16.0, 2.35]], [[0.0, 1.1], [16.0, 2.35], [0.0, 1.35]]],
            )
        },
        off!["21 by 191", "21 by 67", "12 by 64", "12 by 32", "12 by 18", "10 by 18", "15 by 4"],
    ),
    (
        "a needle across the diagonal",
        || Scene::white([12, 9], [[[0.3, 0.2], [11.7, 8.6], [11.5, 8.9]]]),
        off!["22 by 188", "22 by 91", "22 by 62", "22 by 35", "20 by 19", "20 by 14", ""],
    ),
    (
        "smaller than a pixel, at no centre",
        || Scene::white([3, 3], [[[1.6, 1.1], [1.95, 1.2], [1.7, 1.45]]]),
        off!["1 by 14", "1 by 114", "1 by 50", "1 by 14", "1 by 2", "1 by 2", ""],
    ),
    (
        "in between all samples",
        || Scene::white([3, 3], [[[1.59, 1.37], [1.28, 1.69], [1.07, 1.41]]]),
        off!["1 by 20", "1 by 20", "1 by 20", "1 by 20", "1 by 20", "1 by 20", ""],
    ),
    (
        "512 slivers that tile half of a pixel",
        || {
            let strip = |n: u16| rectangle([0.0, f32::from(n) / 256.0], [0.5, f32::from(n + 1) / 256.0]);
            let slivers = (0..256).flat_map(strip).map(|corners| flat(corners, 0.5, Color::WHITE));
            Scene { triangles: slivers.collect(), ..Scene::white([1, 1], []) }
        },
        off!["1 by 128", "", "", "", "", "", "1 by 128"],
    ),
    ("without area, in a line", || Scene::white([9, 7], [[[1.0, 1.0], [7.0, 4.0], [5.0, 3.0]]]), ALL_EXACT),
    (
        "without area, two corners in one place",
        || Scene::white([9, 7], [[[1.0, 1.0], [7.0, 4.5], [7.0, 4.5]]]),
        ALL_EXACT,
    ),
    (
        "without area, once rounded",
        || Scene::white([9, 7], [[[1.0, 1.0], [7.0, 1.0015], [5.0, 1.0]]]),
        ALL_EXACT,
    ),
    (
        "corners at 1e5",
        || {
            Scene::white(
                [9, 7],
                [[[-1e5, -1e5], [1e5, -1e5], [0.0, 1e5]], [[4.5, 3.0], [1e5, 3.0], [0.0, -1e5]]],
            )
        },
        ALL_EXACT,
    ),
    (
        "a sliver from −1e5 to 1e5",
        || Scene::white([9, 7], [[[-1e5, -55_555.0], [1e5, 55_560.0], [-1e5, -55_556.0]]]),
        off!["17 by 139", "17 by 127", "17 by 52", "17 by 35", "17 by 29", "17 by 14", ""],
    ),
    (
        "corners at 4e6",
        || Scene::white([9, 7], [[[-4e6, -3e6], [4e6, 3e6], [3.0, -4e6]]]),
        off!["13 by 96", "13 by 86", "13 by 32", "8 by 22", "13 by 16", "8 by 6", ""],
    ),
    (
        "one pixel, covered whole",
        || Scene::white([1, 1], [[[-1.0, -1.0], [4.0, -1.0], [-1.0, 4.0]]]),
        ALL_EXACT,
    ),
    (
        "one pixel, halved",
        || Scene::white([1, 1], [[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]]),
        off!["1 by 128", "", "", "1 by 32", "1 by 16", "1 by 32", ""],
    ),
    (
        "one pixel, three quarters of it white",
        || Scene::white([1, 1], [right_of(0.25)]),
        off!["1 by 64", "1 by 64", "", "", "", "", ""],
    ),
    (
        "a column of pixels",
        || Scene::white([1, 11], [[[0.2, 0.0], [0.9, 3.0], [0.4, 10.6]]]),
        off!["11 by 210", "11 by 137", "11 by 61", "11 by 41", "11 by 11", "11 by 40", ""],
    ),
    (
        "a row of pixels",
        || Scene::white([23, 1], [[[0.5, 0.1], [22.0, 0.4], [11.0, 0.95]]]),
        off!["22 by 214", "22 by 106", "22 by 51", "22 by 28", "22 by 18", "22 by 51", ""],
    ),
    (
        "out of the picture on all sides",
        || Scene::white([9, 7], [[[-2.0, 3.5], [4.5, -3.0], [11.0, 9.5]]]),
        off!["19 by 128", "18 by 92", "18 by 46", "15 by 39", "17 by 26", "18 by 16", ""],
    ),
    (
        "two colours before a third",
        || Scene { background: Color::rgb(10, 20, 30), ..pair(0.5, 0.25) },
        off!["35 by 199", "35 by 103", "35 by 37", "35 by 23", "36 by 27", "35 by 19", "20 by 44"],
    ),
    (
        "two halves of a square, seen before white",
        || on_white(&halves([[1.3, 0.6], [7.7, 1.2], [7.1, 6.3], [1.9, 5.8]])),
        off!["32 by 118", "32 by 63", "32 by 32", "32 by 29", "32 by 16", "32 by 21", "23 by 52"],
    ),
    (
        "neighbours at an upright edge",
        || on_white(&[[[1.0, 1.0], [4.5, 1.0], [4.5, 6.0]], [[4.5, 1.0], [8.0, 1.0], [4.5, 6.0]]]),
        off!["19 by 110", "15 by 86", "15 by 59", "15 by 25", "15 by 21", "15 by 9", "12 by 61"],
    ),
    (
        "neighbours at a diagonal through the pixels' corners",
        || on_white(&halves([[1.0, 1.0], [6.0, 1.0], [6.0, 6.0], [1.0, 6.0]])),
        off!["5 by 30", "", "", "5 by 7", "5 by 4", "5 by 7", "5 by 61"],
    ),
    (
        "a fan about a centre",
        || on_white(&fan([4.5, 3.5])),
        off!["45 by 136", "45 by 89", "45 by 67", "45 by 32", "46 by 22", "42 by 12", "40 by 77"],
    ),
    (
        "a fan about a sample",
        || on_white(&fan([4.375, 3.125])),
        off!["44 by 136", "44 by 89", "44 by 67", "44 by 29", "44 by 22", "42 by 13", "38 by 72"],
    ),
    (
        "a fan of slivers",
        || on_white(&slivers()),
        off!["39 by 122", "36 by 92", "36 by 41", "38 by 24", "38 by 26", "35 by 32", "37 by 78"],
    ),
    (
        "strips thinner than a pixel",
        || on_white(&strips()),
        off!["46 by 124", "46 by 90", "43 by 63", "46 by 36", "46 by 20", "43 by 25", "43 by 82"],
    ),
    (
        "a grid of triangles smaller than pixels",
        || on_white(&grid()),
        off!["63 by 78", "62 by 66", "62 by 31", "63 by 25", "61 by 18", "63 by 23", "57 by 79"],
    ),
    (
        "the near one last",
        || pair(0.75, 0.25),
        off!["35 by 203", "35 by 108", "35 by 39", "35 by 25", "36 by 30", "35 by 21", "18 by 45"],
    ),
    (
        "the near one first",
        || pair(0.25, 0.75),
        off!["30 by 163", "30 by 108", "30 by 57", "30 by 38", "31 by 30", "30 by 21", "16 by 213"],
    ),
    (
        "equal depths: the first is seen",
        || pair(0.5, 0.5),
        off!["30 by 163", "30 by 108", "30 by 57", "30 by 38", "31 by 30", "30 by 21", "16 by 213"],
    ),
    ("hidden behind all of a picture", || hidden(), ALL_EXACT),
    (
        "hidden behind a common side",
        || behind_a_side(),
        off!["11 by 30", "10 by 20", "10 by 14", "10 by 7", "10 by 5", "8 by 3", "13 by 245"],
    ),
    (
        "two that pass through each other",
        || through(),
        off!["35 by 179", "35 by 108", "35 by 44", "35 by 28", "35 by 21", "35 by 21", "22 by 210"],
    ),
    (
        "three that hide each other in a circle",
        || circle(),
        off!["38 by 129", "38 by 73", "37 by 42", "38 by 36", "38 by 25", "37 by 22", "33 by 154"],
    ),
    (
        "steep: a depth of its own at each sample",
        || steep(),
        off!["14 by 109", "14 by 57", "14 by 31", "14 by 20", "14 by 16", "14 by 16", "6 by 88"],
    ),
    ("as bright as can be beside as dark", || stripes(), off!["40 by 128", "", "", "", "", "", "40 by 16"]),
];

/// What differs in a picture from what is to be seen.
fn faults(scene: &Scene, image: &Image) -> Vec<String> {
    let (mut pixels, mut largest) = (0, 0.0_f64);
    for ((x, y), exact) in scene.pixels().zip(scene.truth()) {
        let got = codes(image.get(x, y).unwrap());
        let off = (0..3).map(|channel| (got[channel] - exact[channel]).abs()).fold(0.0, f64::max);
        // Half a grey level is rounding.
        if off > 0.501 {
            pixels += 1;
            largest = largest.max(off);
        }
    }
    // Halves are halves up, whatever the last bit says.
    let largest = (largest + 0.5 + 1e-6).floor();
    if pixels == 0 { Vec::new() } else { vec![format!("{pixels} by {largest}")] }
}

#[test]
fn a_pixel_shows_the_mean_of_all_that_is_seen_in_it() {
    every_method(LESSON.name, METHODS, TABLE, |method, make| {
        let scene = make();
        faults(&scene, &scene.drawn(&method.run))
    });
}

/// However much of what is to be seen they miss, samples are right each for itself: in all these scenes, to the last code.
#[test]
fn every_sample_is_right_for_itself() {
    for (name, make, _) in TABLE {
        let scene = make();
        for method in METHODS.iter().filter(|method| method.name != "area") {
            let image = scene.drawn(&method.run);
            for ((x, y), mean) in scene.pixels().zip(scene.sampled(method)) {
                let mean = mean.unwrap_or_else(|| {
                    panic!("{name}: the depths at ({x}, {y}) are too close to be told apart")
                });
                let expected = mean.map(|mean| (mean + 0.5).floor());
                assert_eq!(codes(image.get(x, y).unwrap()), expected, "{name}, {}, ({x}, {y})", method.name);
            }
        }
    }
}

/// Triangles about all of the picture, whose corners are farther out than a way to draw can count.
const FAR: &[Case<Make>] = &[
    ("corners at 1e15", || about(1e15), ALL_EXACT),
    (
        "corners at 4e15, beyond 2⁵² px in a picture four times as large",
        || about(4e15),
        &[
            ("none, ssaa-4, ssaa-16, msaa-2, msaa-4, msaa-8, msaa-16, area", Exact),
            ("ordered-16", Fails("63 by 255")),
        ],
    ),
    (
        "corners at 5e15, beyond 2⁵² px",
        || about(5e15),
        &[("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16, area", Fails("63 by 255"))],
    ),
];

/// A triangle about the picture with corners so far out.
fn about(far: f32) -> Scene {
    Scene::white([9, 7], [[[-far, -far], [far, -far], [0.0, far]]])
}

#[test]
fn what_is_too_far_out_is_left_out() {
    every_method(LESSON.name, METHODS, FAR, |method, make| {
        let scene = make();
        faults(&scene, &scene.drawn(&method.run))
    });
}
