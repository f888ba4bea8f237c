use antialiasing::{LESSON, METHODS};
use common::{Color, Image};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, Row, every_method};

use crate::scenes::{
    Scene, above, behind_a_side, circle, codes, fan, grid, halves, hidden, on_white, pair, rectangle,
    right_of, slivers, steep, stripes, strips, through,
};

/// Where every method is right.
const ALL_EXACT: &[Row] =
    &[("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16, area", Exact)];

/// Makes a scene.
type Make = fn() -> Scene;

/// Scenes, and what each method must do: exact is the mean of all that is seen in each pixel, rounded. What is not is told by
/// how many pixels differ from that by more than rounding, and by how many grey levels at most.
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
        &[
            ("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16", Exact),
            ("area", Fails("8 by 61")),
        ],
    ),
    (
        "an upright edge through the centres",
        || Scene::white([9, 7], [right_of(2.5)]),
        &[
            ("none", Fails("7 by 128")),
            ("ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16, area", Exact),
        ],
    ),
    (
        "a level edge through the centres",
        || Scene::white([9, 7], [above(2.5)]),
        &[
            ("none", Fails("9 by 128")),
            ("ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16, area", Exact),
        ],
    ),
    (
        "a square of half pixels all around",
        || Scene::white([9, 7], rectangle([2.5, 1.5], [6.5, 5.5])),
        &[
            ("none", Fails("16 by 191")),
            ("ssaa-4, ssaa-16, ordered-16, msaa-4, msaa-8, msaa-16", Exact),
            ("msaa-2", Fails("4 by 64")),
            ("area", Fails("5 by 63")),
        ],
    ),
    (
        "an upright edge through samples, at 1/8",
        || Scene::white([9, 7], [right_of(2.125)]),
        &[
            ("none, ssaa-4, ordered-16, msaa-2, msaa-4", Fails("7 by 32")),
            ("ssaa-16, msaa-8, msaa-16, area", Exact),
        ],
    ),
    (
        "a level edge through samples, at 7/8",
        || Scene::white([9, 7], [above(4.875)]),
        &[
            ("none, ssaa-4, ordered-16, msaa-2, msaa-4", Fails("9 by 32")),
            ("ssaa-16, msaa-8, msaa-16, area", Exact),
        ],
    ),
    (
        "an upright edge at a third",
        || Scene::white([9, 7], [right_of(2.333)]),
        &[
            ("none", Fails("7 by 85")),
            ("ssaa-4, ordered-16, msaa-4", Fails("7 by 21")),
            ("ssaa-16, msaa-8, msaa-16", Fails("7 by 11")),
            ("msaa-2", Fails("7 by 42")),
            ("area", Exact),
        ],
    ),
    (
        "a level edge at a third",
        || Scene::white([9, 7], [above(2.333)]),
        &[
            ("none", Fails("9 by 85")),
            ("ssaa-4, ordered-16, msaa-4", Fails("9 by 21")),
            ("ssaa-16, msaa-16", Fails("9 by 5")),
            ("msaa-2", Fails("9 by 42")),
            ("msaa-8", Fails("9 by 11")),
            ("area", Exact),
        ],
    ),
    (
        "an upright edge at 1/256",
        || Scene::white([9, 7], [right_of(2.003_906_3)]),
        &[
            ("none, ssaa-4, ordered-16, msaa-2, msaa-4, msaa-8", Fails("7 by 1")),
            ("ssaa-16, msaa-16", Fails("7 by 15")),
            ("area", Exact),
        ],
    ),
    (
        "a diagonal edge through the pixels' corners",
        || Scene::white([9, 7], [[[-1.0, -1.0], [9.0, -1.0], [9.0, 9.0]]]),
        &[
            ("none", Fails("7 by 128")),
            ("ssaa-4, msaa-2, msaa-4, area", Exact),
            ("ssaa-16, msaa-16", Fails("7 by 16")),
            ("ordered-16, msaa-8", Fails("7 by 32")),
        ],
    ),
    (
        "a diagonal edge through the middles of the pixels' sides",
        || Scene::white([9, 7], [[[-1.0, -1.5], [9.0, -1.5], [9.0, 8.5]]]),
        &[
            ("none, ssaa-4, msaa-4", Fails("14 by 32")),
            ("ssaa-16, msaa-16, area", Exact),
            ("ordered-16", Fails("14 by 16")),
            ("msaa-2", Fails("14 by 96")),
            ("msaa-8", Fails("7 by 32")),
        ],
    ),
    (
        "an edge that rises 1 in 2",
        || Scene::white([9, 7], [[[0.0, 1.0], [12.0, 1.0], [12.0, 7.0]]]),
        &[
            ("none, msaa-2", Fails("9 by 64")),
            ("ssaa-4, ssaa-16, ordered-16, msaa-4, msaa-16, area", Exact),
            ("msaa-8", Fails("5 by 32")),
        ],
    ),
    (
        "an edge that rises 1 in 16",
        || Scene::white([16, 3], [[[0.0, 1.0], [16.0, 0.0], [16.0, 2.0]]]),
        &[
            ("none", Fails("32 by 120")),
            ("ssaa-4, ordered-16, msaa-4", Fails("32 by 24")),
            ("ssaa-16, msaa-8, msaa-16", Fails("32 by 8")),
            ("msaa-2", Fails("32 by 56")),
            ("area", Exact),
        ],
    ),
    (
        "an edge that falls 16 in 1",
        || Scene::white([3, 16], [[[1.0, 16.0], [0.0, 0.0], [2.0, 0.0]]]),
        &[
            ("none", Fails("32 by 120")),
            ("ssaa-4, ordered-16, msaa-4", Fails("32 by 24")),
            ("ssaa-16, msaa-8, msaa-16", Fails("32 by 8")),
            ("msaa-2", Fails("32 by 56")),
            ("area", Exact),
        ],
    ),
    (
        "an edge of golden slope",
        || Scene::white([13, 8], [[[0.0, 0.0], [13.0, 0.0], [13.0, 8.034]]]),
        &[
            ("none", Fails("20 by 125")),
            ("ssaa-4, msaa-4, msaa-8", Fails("20 by 34")),
            ("ssaa-16, msaa-16", Fails("20 by 26")),
            ("ordered-16", Fails("20 by 11")),
            ("msaa-2", Fails("20 by 92")),
            ("area", Exact),
        ],
    ),
    (
        "clockwise",
        || Scene::white([13, 8], [[[0.0, 0.0], [13.0, 8.034], [13.0, 0.0]]]),
        &[
            ("none", Fails("20 by 125")),
            ("ssaa-4, msaa-4, msaa-8", Fails("20 by 34")),
            ("ssaa-16, msaa-16", Fails("20 by 26")),
            ("ordered-16", Fails("20 by 11")),
            ("msaa-2", Fails("20 by 92")),
            ("area", Exact),
        ],
    ),
    (
        "a corner on a sample",
        || Scene::white([9, 7], [[[4.375, 3.125], [9.0, 0.5], [8.0, 6.5]]]),
        &[
            ("none", Fails("19 by 128")),
            ("ssaa-4, msaa-4", Fails("18 by 77")),
            ("ssaa-16, msaa-16", Fails("18 by 28")),
            ("ordered-16", Fails("18 by 14")),
            ("msaa-2", Fails("18 by 94")),
            ("msaa-8", Fails("18 by 51")),
            ("area", Exact),
        ],
    ),
    (
        "thinner than the gaps between samples, upright",
        || Scene::white([9, 7], rectangle([4.507_812_5, -1.0], [4.546_875, 8.0])),
        &[
            ("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16", Fails("7 by 10")),
            ("area", Exact),
        ],
    ),
    (
        "thinner than the gaps between samples, level",
        || Scene::white([9, 7], rectangle([-1.0, 3.507_812_5], [10.0, 3.546_875])),
        &[
            ("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16", Fails("9 by 10")),
            ("area", Exact),
        ],
    ),
    (
        "1/256 px wide, level, off all samples",
        || Scene::white([9, 7], rectangle([-1.0, 3.527_343_8], [10.0, 3.531_25])),
        &[
            ("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16", Fails("9 by 1")),
            ("area", Fails("1 by 1")),
        ],
    ),
    (
        "a line of 1/4 px, nearly level",
        || {
            Scene::white(
                [16, 4],
                [[[0.0, 1.1], [16.0, 2.1], [16.0, 2.35]], [[0.0, 1.1], [16.0, 2.35], [0.0, 1.35]]],
            )
        },
        &[
            ("none", Fails("21 by 191")),
            ("ssaa-4, msaa-4", Fails("12 by 64")),
            ("ssaa-16, msaa-16", Fails("12 by 18")),
            ("ordered-16", Fails("10 by 18")),
            ("msaa-2", Fails("21 by 67")),
            ("msaa-8", Fails("12 by 32")),
            ("area", Fails("15 by 4")),
        ],
    ),
    (
        "a needle across the diagonal",
        || Scene::white([12, 9], [[[0.3, 0.2], [11.7, 8.6], [11.5, 8.9]]]),
        &[
            ("none", Fails("22 by 188")),
            ("ssaa-4, msaa-4", Fails("22 by 62")),
            ("ssaa-16, msaa-16", Fails("20 by 19")),
            ("ordered-16", Fails("20 by 14")),
            ("msaa-2", Fails("22 by 91")),
            ("msaa-8", Fails("22 by 35")),
            ("area", Exact),
        ],
    ),
    (
        "smaller than a pixel, at no centre",
        || Scene::white([3, 3], [[[1.6, 1.1], [1.95, 1.2], [1.7, 1.45]]]),
        &[
            ("none, msaa-8", Fails("1 by 14")),
            ("ssaa-4, msaa-4", Fails("1 by 50")),
            ("ssaa-16, ordered-16, msaa-16", Fails("1 by 2")),
            ("msaa-2", Fails("1 by 114")),
            ("area", Exact),
        ],
    ),
    (
        "in between all samples",
        || Scene::white([3, 3], [[[1.59, 1.37], [1.28, 1.69], [1.07, 1.41]]]),
        &[
            ("none, ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16", Fails("1 by 20")),
            ("area", Exact),
        ],
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
        &[
            ("none", Fails("17 by 139")),
            ("ssaa-4, msaa-4", Fails("17 by 52")),
            ("ssaa-16, msaa-16", Fails("17 by 29")),
            ("ordered-16", Fails("17 by 14")),
            ("msaa-2", Fails("17 by 127")),
            ("msaa-8", Fails("17 by 35")),
            ("area", Exact),
        ],
    ),
    (
        "corners at 4e6",
        || Scene::white([9, 7], [[[-4e6, -3e6], [4e6, 3e6], [3.0, -4e6]]]),
        &[
            ("none", Fails("13 by 96")),
            ("ssaa-4, msaa-4", Fails("13 by 32")),
            ("ssaa-16, msaa-16", Fails("13 by 16")),
            ("ordered-16", Fails("8 by 6")),
            ("msaa-2", Fails("13 by 86")),
            ("msaa-8", Fails("8 by 22")),
            ("area", Exact),
        ],
    ),
    (
        "one pixel, covered whole",
        || Scene::white([1, 1], [[[-1.0, -1.0], [4.0, -1.0], [-1.0, 4.0]]]),
        ALL_EXACT,
    ),
    (
        "one pixel, halved",
        || Scene::white([1, 1], [[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]]),
        &[
            ("none", Fails("1 by 128")),
            ("ssaa-4, msaa-2, msaa-4, area", Exact),
            ("ssaa-16, msaa-16", Fails("1 by 16")),
            ("ordered-16, msaa-8", Fails("1 by 32")),
        ],
    ),
    (
        "one pixel, three quarters of it white",
        || Scene::white([1, 1], [right_of(0.25)]),
        &[
            ("none, msaa-2", Fails("1 by 64")),
            ("ssaa-4, ssaa-16, ordered-16, msaa-4, msaa-8, msaa-16, area", Exact),
        ],
    ),
    (
        "a column of pixels",
        || Scene::white([1, 11], [[[0.2, 0.0], [0.9, 3.0], [0.4, 10.6]]]),
        &[
            ("none", Fails("11 by 210")),
            ("ssaa-4, msaa-4", Fails("11 by 61")),
            ("ssaa-16, msaa-16", Fails("11 by 11")),
            ("ordered-16", Fails("11 by 40")),
            ("msaa-2", Fails("11 by 137")),
            ("msaa-8", Fails("11 by 41")),
            ("area", Exact),
        ],
    ),
    (
        "a row of pixels",
        || Scene::white([23, 1], [[[0.5, 0.1], [22.0, 0.4], [11.0, 0.95]]]),
        &[
            ("none", Fails("22 by 214")),
            ("ssaa-4, ordered-16, msaa-4", Fails("22 by 51")),
            ("ssaa-16, msaa-16", Fails("22 by 18")),
            ("msaa-2", Fails("22 by 106")),
            ("msaa-8", Fails("22 by 28")),
            ("area", Exact),
        ],
    ),
    (
        "out of the picture on all sides",
        || Scene::white([9, 7], [[[-2.0, 3.5], [4.5, -3.0], [11.0, 9.5]]]),
        &[
            ("none", Fails("19 by 128")),
            ("ssaa-4, msaa-4", Fails("18 by 46")),
            ("ssaa-16, msaa-16", Fails("17 by 26")),
            ("ordered-16", Fails("18 by 16")),
            ("msaa-2", Fails("18 by 92")),
            ("msaa-8", Fails("15 by 39")),
            ("area", Exact),
        ],
    ),
    (
        "two colours before a third",
        || Scene { background: Color::rgb(10, 20, 30), ..pair(0.5, 0.25) },
        &[
            ("none", Fails("35 by 199")),
            ("ssaa-4, msaa-4", Fails("35 by 37")),
            ("ssaa-16, msaa-16", Fails("36 by 27")),
            ("ordered-16", Fails("35 by 19")),
            ("msaa-2", Fails("35 by 103")),
            ("msaa-8", Fails("35 by 23")),
            ("area", Fails("20 by 44")),
        ],
    ),
    (
        "two halves of a square, seen before white",
        || on_white(&halves([[1.3, 0.6], [7.7, 1.2], [7.1, 6.3], [1.9, 5.8]])),
        &[
            ("none", Fails("32 by 118")),
            ("ssaa-4, msaa-4", Fails("32 by 32")),
            ("ssaa-16, msaa-16", Fails("32 by 16")),
            ("ordered-16", Fails("32 by 21")),
            ("msaa-2", Fails("32 by 63")),
            ("msaa-8", Fails("32 by 29")),
            ("area", Fails("23 by 52")),
        ],
    ),
    (
        "neighbours at an upright edge",
        || on_white(&[[[1.0, 1.0], [4.5, 1.0], [4.5, 6.0]], [[4.5, 1.0], [8.0, 1.0], [4.5, 6.0]]]),
        &[
            ("none", Fails("19 by 110")),
            ("ssaa-4, msaa-4", Fails("15 by 59")),
            ("ssaa-16, msaa-16", Fails("15 by 21")),
            ("ordered-16", Fails("15 by 9")),
            ("msaa-2", Fails("15 by 86")),
            ("msaa-8", Fails("15 by 25")),
            ("area", Fails("12 by 61")),
        ],
    ),
    (
        "neighbours at a diagonal through the pixels' corners",
        || on_white(&halves([[1.0, 1.0], [6.0, 1.0], [6.0, 6.0], [1.0, 6.0]])),
        &[
            ("none", Fails("5 by 30")),
            ("ssaa-4, msaa-2, msaa-4", Exact),
            ("ssaa-16, msaa-16", Fails("5 by 4")),
            ("ordered-16, msaa-8", Fails("5 by 7")),
            ("area", Fails("5 by 61")),
        ],
    ),
    (
        "a fan about a centre",
        || on_white(&fan([4.5, 3.5])),
        &[
            ("none", Fails("45 by 136")),
            ("ssaa-4, msaa-4", Fails("45 by 67")),
            ("ssaa-16, msaa-16", Fails("46 by 22")),
            ("ordered-16", Fails("42 by 12")),
            ("msaa-2", Fails("45 by 89")),
            ("msaa-8", Fails("45 by 32")),
            ("area", Fails("40 by 77")),
        ],
    ),
    (
        "a fan about a sample",
        || on_white(&fan([4.375, 3.125])),
        &[
            ("none", Fails("44 by 136")),
            ("ssaa-4, msaa-4", Fails("44 by 67")),
            ("ssaa-16, msaa-16", Fails("44 by 22")),
            ("ordered-16", Fails("42 by 13")),
            ("msaa-2", Fails("44 by 89")),
            ("msaa-8", Fails("44 by 29")),
            ("area", Fails("38 by 72")),
        ],
    ),
    (
        "a fan of slivers",
        || on_white(&slivers()),
        &[
            ("none", Fails("39 by 122")),
            ("ssaa-4, msaa-4", Fails("36 by 41")),
            ("ssaa-16, msaa-16", Fails("38 by 26")),
            ("ordered-16", Fails("35 by 32")),
            ("msaa-2", Fails("36 by 92")),
            ("msaa-8", Fails("38 by 24")),
            ("area", Fails("37 by 78")),
        ],
    ),
    (
        "strips thinner than a pixel",
        || on_white(&strips()),
        &[
            ("none", Fails("46 by 124")),
            ("ssaa-4, msaa-4", Fails("43 by 63")),
            ("ssaa-16, msaa-16", Fails("46 by 20")),
            ("ordered-16", Fails("43 by 25")),
            ("msaa-2", Fails("46 by 90")),
            ("msaa-8", Fails("46 by 36")),
            ("area", Fails("43 by 82")),
        ],
    ),
    (
        "a grid of triangles smaller than pixels",
        || on_white(&grid()),
        &[
            ("none", Fails("63 by 78")),
            ("ssaa-4, msaa-4", Fails("62 by 31")),
            ("ssaa-16, msaa-16", Fails("61 by 18")),
            ("ordered-16", Fails("63 by 23")),
            ("msaa-2", Fails("62 by 66")),
            ("msaa-8", Fails("63 by 25")),
            ("area", Fails("57 by 79")),
        ],
    ),
    (
        "the near one last",
        || pair(0.75, 0.25),
        &[
            ("none", Fails("35 by 203")),
            ("ssaa-4, msaa-4", Fails("35 by 39")),
            ("ssaa-16, msaa-16", Fails("36 by 30")),
            ("ordered-16", Fails("35 by 21")),
            ("msaa-2", Fails("35 by 108")),
            ("msaa-8", Fails("35 by 25")),
            ("area", Fails("18 by 45")),
        ],
    ),
    (
        "the near one first",
        || pair(0.25, 0.75),
        &[
            ("none", Fails("30 by 163")),
            ("ssaa-4, msaa-4", Fails("30 by 57")),
            ("ssaa-16, msaa-16", Fails("31 by 30")),
            ("ordered-16", Fails("30 by 21")),
            ("msaa-2", Fails("30 by 108")),
            ("msaa-8", Fails("30 by 38")),
            ("area", Fails("16 by 213")),
        ],
    ),
    (
        "equal depths: the first is seen",
        || pair(0.5, 0.5),
        &[
            ("none", Fails("30 by 163")),
            ("ssaa-4, msaa-4", Fails("30 by 57")),
            ("ssaa-16, msaa-16", Fails("31 by 30")),
            ("ordered-16", Fails("30 by 21")),
            ("msaa-2", Fails("30 by 108")),
            ("msaa-8", Fails("30 by 38")),
            ("area", Fails("16 by 213")),
        ],
    ),
    ("hidden behind all of a picture", || hidden(), ALL_EXACT),
    (
        "hidden behind a common side",
        || behind_a_side(),
        &[
            ("none", Fails("11 by 30")),
            ("ssaa-4, msaa-4", Fails("10 by 14")),
            ("ssaa-16, msaa-16", Fails("10 by 5")),
            ("ordered-16", Fails("8 by 3")),
            ("msaa-2", Fails("10 by 20")),
            ("msaa-8", Fails("10 by 7")),
            ("area", Fails("13 by 245")),
        ],
    ),
    (
        "two that pass through each other",
        || through(),
        &[
            ("none", Fails("35 by 179")),
            ("ssaa-4, msaa-4", Fails("35 by 44")),
            ("ssaa-16, ordered-16, msaa-16", Fails("35 by 21")),
            ("msaa-2", Fails("35 by 108")),
            ("msaa-8", Fails("35 by 28")),
            ("area", Fails("22 by 210")),
        ],
    ),
    (
        "three that hide each other in a circle",
        || circle(),
        &[
            ("none", Fails("38 by 129")),
            ("ssaa-4, msaa-4", Fails("37 by 42")),
            ("ssaa-16, msaa-16", Fails("38 by 25")),
            ("ordered-16", Fails("37 by 22")),
            ("msaa-2", Fails("38 by 73")),
            ("msaa-8", Fails("38 by 36")),
            ("area", Fails("33 by 154")),
        ],
    ),
    (
        "steep: a depth of its own at each sample",
        || steep(),
        &[
            ("none", Fails("14 by 109")),
            ("ssaa-4, msaa-4", Fails("14 by 31")),
            ("ssaa-16, ordered-16, msaa-16", Fails("14 by 16")),
            ("msaa-2", Fails("14 by 57")),
            ("msaa-8", Fails("14 by 20")),
            ("area", Fails("6 by 88")),
        ],
    ),
    (
        "as bright as can be beside as dark",
        || stripes(),
        &[
            ("none", Fails("40 by 128")),
            ("ssaa-4, ssaa-16, ordered-16, msaa-2, msaa-4, msaa-8, msaa-16", Exact),
            ("area", Fails("40 by 16")),
        ],
    ),
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
