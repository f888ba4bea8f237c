//! Where ways to divide by 255 fail, and where they must not: against rational numbers, all products there are, and layer upon
//! layer.

use std::collections::BTreeMap;

use blending::{AnyState, Blend, Divide, Equation, Factor, Formula, Framebuffer, LESSON, METHODS};
use checks::fragment::{blended, layered, rounded};
use clap::ValueEnum;
use common::{Color, Format, Image, Vec3};
use fastrand::Rng;
use verify::stability::Must::{AtMost, Between, Exact, Fails};
use verify::stability::{Case, Did, Row, every_method};
use zbuffer::Surface;

use crate::state::{any_color, name};

/// What lies between source and destination.
type Mix = fn(u8, u8, u8) -> u8;

/// How often a way is off by how much, as `3 by -1, 2 by +1`.
fn counted(off: impl Iterator<Item = i32>) -> Did {
    let mut counts = BTreeMap::new();
    off.filter(|&off| off != 0).for_each(|off| *counts.entry(off).or_insert(0) += 1);
    let counts = counts.iter().map(|(off, count)| format!("{count} by {off:+}")).collect::<Vec<_>>();
    counts.into()
}

fn bytes() -> impl Iterator<Item = u8> + Clone {
    0..=255
}

/// The exact mixture, rounded.
fn exactly(source: u8, destination: u8, alpha: u8) -> u8 {
    let [s, d, a] = [source, destination, alpha].map(i128::from);
    rounded(s * a + d * (255 - a))
}

/// All 65,536 products of a colour and an alpha, over that destination.
fn products_on(destination: u8, mix: Mix) -> Did {
    let pairs = bytes().flat_map(|source| bytes().map(move |alpha| (source, alpha)));
    counted(pairs.map(|(s, a)| i32::from(mix(s, destination, a)) - i32::from(exactly(s, destination, a))))
}

/// All colours on themselves, under all alphas.
fn on_itself(mix: Mix) -> Did {
    let pairs = bytes().flat_map(|color| bytes().map(move |alpha| (color, alpha)));
    counted(pairs.map(|(color, alpha)| i32::from(mix(color, color, alpha)) - i32::from(color)))
}

/// All colours on all colours, at one alpha.
fn at_alpha(alpha: u8, mix: Mix) -> Did {
    let pairs = bytes().flat_map(|s| bytes().map(move |d| (s, d)));
    counted(pairs.map(|(s, d)| i32::from(mix(s, d, alpha)) - i32::from(exactly(s, d, alpha))))
}

/// By how many codes so many layers of one colour and alpha are off what they would be, rounded nowhere.
fn layers(source: u8, destination: u8, alpha: u8, count: u32, mix: Mix) -> Did {
    let code = (0..count).fold(destination, |below, _| mix(source, below, alpha));
    (f64::from(code) - layered(source, destination, alpha, count)).abs().into()
}

const ALL_EXACT: &[Row] = &[("float, exact, two-shift, shift-8, div-256", Exact)];

/// Something that is done with a way to mix.
type Tried = fn(Mix) -> Did;

const MIXTURES: &[Case<Tried>] = &[
    (
        "all 65,536 products, on black",
        |mix| products_on(0, mix),
        &[
            ("float, exact, two-shift", Exact),
            ("shift-8", Fails("1392 by -2, 45664 by -1")),
            ("div-256", Fails("3840 by -1, 4288 by +1")),
        ],
    ),
    (
        "all 65,536 products, on white",
        |mix| products_on(255, mix),
        &[
            ("float, exact, two-shift", Exact),
            ("shift-8", Fails("17167 by -2, 46882 by -1")),
            ("div-256", Fails("3840 by -1, 4288 by +1")),
        ],
    ),
    (
        "all 65,536 products, on 100",
        |mix| products_on(100, mix),
        &[
            ("float, exact, two-shift", Exact),
            ("shift-8", Fails("2855 by -2, 56050 by -1")),
            ("div-256", Fails("1868 by -1, 2316 by +1")),
        ],
    ),
    (
        "each colour on itself, under each alpha",
        on_itself,
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("65280 by -1"))],
    ),
    (
        "255·255: opaque white on white",
        |mix| counted([i32::from(mix(255, 255, 255)) - 255].into_iter()),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("1 by -1"))],
    ),
    (
        "alpha 0: each colour on each",
        |mix| at_alpha(0, mix),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("65280 by -1"))],
    ),
    (
        "alpha 255: each colour on each",
        |mix| at_alpha(255, mix),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("65280 by -1"))],
    ),
    (
        "alpha 127, the last that is not stretched",
        |mix| at_alpha(127, mix),
        &[
            ("float, exact, two-shift", Exact),
            ("shift-8", Fails("4032 by -2, 57216 by -1")),
            ("div-256", Fails("4032 by -1, 4160 by +1")),
        ],
    ),
    (
        "alpha 128, the first that is stretched",
        |mix| at_alpha(128, mix),
        &[
            ("float, exact, two-shift", Exact),
            ("shift-8", Fails("4032 by -2, 57216 by -1")),
            ("div-256", Fails("4032 by -1, 4160 by +1")),
        ],
    ),
    (
        "10 layers of white at alpha 26 on black",
        |mix| layers(255, 0, 26, 10, mix),
        &[("float, exact, two-shift, div-256", AtMost(0.02)), ("shift-8", Between(7.0, 7.1))],
    ),
    (
        "100 layers of white at alpha 26 on black: 8 bits stand still at 251",
        |mix| layers(255, 0, 26, 100, mix),
        &[("float, exact, two-shift, div-256", Between(3.9, 4.0)), ("shift-8", Between(17.9, 18.0))],
    ),
    (
        "1000 layers of white at alpha 26 on black",
        |mix| layers(255, 0, 26, 1000, mix),
        &[("float, exact, two-shift, div-256", Between(3.9, 4.01)), ("shift-8", Between(17.9, 18.01))],
    ),
    (
        "10 layers of white at alpha 1 on black: one shift never shows them",
        |mix| layers(255, 0, 1, 10, mix),
        &[("float, exact, two-shift, div-256", AtMost(0.18)), ("shift-8", Between(9.8, 9.9))],
    ),
    (
        "100 layers of white at alpha 1 on black",
        |mix| layers(255, 0, 1, 100, mix),
        &[("float, exact, two-shift, div-256", Between(17.1, 17.2)), ("shift-8", Between(82.8, 82.9))],
    ),
    (
        "1000 layers of white at alpha 1 on black: 8 bits stand still at 128",
        |mix| layers(255, 0, 1, 1000, mix),
        &[("float, exact, two-shift, div-256", Between(121.9, 122.0)), ("shift-8", Between(249.9, 250.0))],
    ),
    (
        "1000 layers of black at alpha 1 on white: what is always rounded down goes on",
        |mix| layers(0, 255, 1, 1000, mix),
        &[
            ("float, exact, two-shift", Between(121.9, 122.0)),
            ("shift-8", Between(5.0, 5.1)),
            ("div-256", Between(122.9, 123.0)),
        ],
    ),
    (
        "1000 layers of 200 at alpha 128 on itself",
        |mix| layers(200, 200, 128, 1000, mix),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Between(2.0, 2.0))],
    ),
    (
        "1000 layers of 180 at alpha 10 on 60",
        |mix| layers(180, 60, 10, 1000, mix),
        &[("float, exact, two-shift, div-256", Between(11.9, 12.01)), ("shift-8", Between(38.9, 39.01))],
    ),
];

#[test]
fn mixtures() {
    every_method(LESSON.name, METHODS, MIXTURES, |method, input| input(method.run.mix));
}

/// All 16,777,216 mixtures: the greatest error of each way.
#[test]
fn all_mixtures_there_are() {
    for (name, least, most) in
        [("float", 0, 0), ("exact", 0, 0), ("two-shift", 0, 0), ("shift-8", -2, 0), ("div-256", -1, 1)]
    {
        let mix = verify::method::<Divide>(METHODS, name).mix;
        let mut range = (0, 0);
        for (s, d) in bytes().flat_map(|s| bytes().map(move |d| (s, d))) {
            for a in bytes() {
                // Of a whole number of 255ths, 127 more make the nearest whole number of what is rounded down.
                let n = i32::from(s) * i32::from(a) + i32::from(d) * i32::from(255 - a);
                let off = i32::from(mix(s, d, a)) - (n + 127) / 255;
                range = (range.0.min(off), range.1.max(off));
            }
        }
        assert_eq!(range, (least, most), "{name}");
    }
}

/// A colour over another, under one of the formulas.
struct Pair {
    formula: Formula,
    source: Color,
    destination: Color,
}

fn pair(equation: Equation, [source, destination]: [Factor; 2], colors: [Color; 2]) -> Pair {
    Pair { formula: Formula { equation, source, destination }, source: colors[0], destination: colors[1] }
}

const GREY: Color = Color { r: 100, g: 200, b: 255, a: 180 };
const DARK: Color = Color { r: 30, g: 90, b: 255, a: 255 };

const FORMULAS: &[Case<fn() -> Pair>] = &[
    (
        "one, one: what is more than white is white",
        || pair(Equation::FuncAdd, [Factor::One; 2], [GREY, DARK]),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("1 by -1"))],
    ),
    (
        "subtract: what is less than black is black",
        || pair(Equation::FuncSubtract, [Factor::One; 2], [DARK, GREY]),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("1 by -1"))],
    ),
    (
        "reverse-subtract",
        || pair(Equation::FuncReverseSubtract, [Factor::One; 2], [DARK, GREY]),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("2 by -1"))],
    ),
    ("min: factors do not count", || pair(Equation::Min, [Factor::Zero; 2], [DARK, GREY]), ALL_EXACT),
    ("max: factors do not count", || pair(Equation::Max, [Factor::Zero; 2], [DARK, GREY]), ALL_EXACT),
    (
        "zero, one: nothing changes",
        || pair(Equation::FuncAdd, [Factor::Zero, Factor::One], [GREY, DARK]),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("4 by -1"))],
    ),
    (
        "one, zero: the source replaces",
        || pair(Equation::FuncAdd, [Factor::One, Factor::Zero], [GREY, DARK]),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("4 by -1"))],
    ),
    (
        "dst-color, zero: a product of colours",
        || pair(Equation::FuncAdd, [Factor::DstColor, Factor::Zero], [GREY, DARK]),
        &[("float, exact, two-shift", Exact), ("shift-8", Fails("4 by -1")), ("div-256", Fails("1 by -1"))],
    ),
    (
        "src-alpha-saturate, one: on what is opaque, nothing",
        || pair(Equation::FuncAdd, [Factor::SrcAlphaSaturate, Factor::One], [GREY, DARK]),
        &[("float, exact, two-shift, div-256", Exact), ("shift-8", Fails("3 by -1"))],
    ),
];

fn off(
    divide: &Divide,
    Pair { formula, source, destination }: &Pair,
    constant: Color,
) -> impl Iterator<Item = i32> {
    let blend = Blend { color: *formula, alpha: *formula, constant };
    let names = [name(&formula.equation), name(&formula.source), name(&formula.destination)];
    let got = (divide.blend)(&blend, *source, *destination);
    let (source, destination) = (*source, *destination);
    [got.r, got.g, got.b, got.a].into_iter().enumerate().map(move |(channel, code)| {
        let names = names.each_ref().map(String::as_str);
        i32::from(code) - i32::from(rounded(blended(names, channel, source, destination, constant)))
    })
}

#[test]
fn formulas() {
    every_method(LESSON.name, METHODS, FORMULAS, |method, input| {
        counted(off(&method.run, &input(), Color::BLACK))
    });
}

/// No factor makes a way more wrong than it is for a mixture, and by half a code more for sums that are no mixture.
#[test]
fn any_formula_by_each_way() {
    let mut rng = Rng::with_seed(255);
    let mut worst: BTreeMap<&str, (i32, i32)> = BTreeMap::new();
    for _ in 0..100_000 {
        let factors = Factor::value_variants();
        let equation = Equation::value_variants()[rng.usize(..5)];
        let input =
            pair(equation, [(); 2].map(|()| factors[rng.usize(..15)]), [(); 2].map(|()| any_color(&mut rng)));
        let constant = any_color(&mut rng);
        for row in METHODS {
            for off in off(&row.run, &input, constant) {
                let range = worst.entry(row.name).or_default();
                *range = (range.0.min(off), range.1.max(off));
            }
        }
    }
    let expected = [
        ("div-256", (-1, 1)),
        ("exact", (0, 0)),
        ("float", (0, 0)),
        ("shift-8", (-2, 0)),
        ("two-shift", (0, 0)),
    ];
    assert_eq!(worst.into_iter().collect::<Vec<_>>(), expected);
}

/// An alpha, the one before, and a picture of transparent layers with an opaque one on top: nothing of them is left.
#[test]
fn opaque_after_transparent_leaves_nothing_of_it() {
    let at = |x: f32, z: f32| Vec3::new(x, -3.0 * x, z);
    let mut rng = Rng::with_seed(7);
    for row in METHODS {
        let mut image = Image::new(8, 6, Format::Rgba);
        let corners = |z| [at(-90.0, z), at(90.0, z), Vec3::new(3.0, 300.0, z)];
        let mut surfaces: Vec<Surface> = (0..20)
            .map(|n| Surface { corners: corners(0.9 - n as f32 / 100.0), color: any_color(&mut rng) })
            .collect();
        let top = Color::rgb(12, 250, 255);
        surfaces.push(Surface { corners: corners(0.1), color: top });
        drop((row.run.triangles_under)(Framebuffer::new(&mut image, AnyState::USUAL), &surfaces));
        let left = if row.name == "shift-8" { Color { r: 11, g: 249, b: 254, a: 254 } } else { top };
        assert!(image.pixels().all(|pixel| pixel.2 == left), "{}", row.name);
    }
}
