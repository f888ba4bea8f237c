//! Mission 14: a colour over another, and the tests of a fragment.

pub use blending_given as given;

use std::cmp::Ordering;

use common::{Color, Vec2};
use fastrand::Rng;
use tasks::scenery::{canvas, signed};
use tasks::{Check, Code, Mission, Precision, Raw, Task};

use given::{Compare, DepthTest, Kept, Layer, Over, StencilOp, StencilTest, Test, draw};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Blending {
    /// The lesson's `over`.
    pub over: Over,
    /// The lesson's `test`.
    pub test: Test,
}

/// The mission.
pub const MISSION: Mission<Blending> = Mission {
    lesson: "14-blending",
    checks: &[
        Check {
            name: "products",
            asks: "each of the 65,536 products of a channel and an alpha, rounded to the nearest",
            points: 2,
            tasks: |rng| {
                (0..2).map(|_| products(any_color(rng), Color { a: 255, ..any_color(rng) })).collect()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "alpha",
            asks: "the alpha of two colours together, for all 65,536 pairs",
            points: 1,
            tasks: |rng| vec![alphas(any_color(rng), any_color(rng))],
            precision: Precision::EXACT,
        },
        Check {
            name: "layers",
            asks: "many colours, each over those before it",
            points: 1,
            tasks: |rng| [3, 10, 100].map(|count| layers(count, rng.u64(..1_000_000))).into(),
            precision: Precision::EXACT,
        },
        Check {
            name: "stencil",
            asks: "the stencil test by each of eight functions, of the masked bits alone",
            points: 1,
            tasks: |rng| {
                let always = DepthTest { function: Compare::Always, write: false };
                let mut tasks = Vec::new();
                for function in Compare::ALL {
                    for order in ORDERS {
                        let read_mask = mask(rng);
                        let (reference, stencil) = ordered(rng, read_mask, order);
                        let kept = Kept { stencil, depth: depth(rng) };
                        let operations = some_operations(rng);
                        let test = StencilTest { function, reference, read_mask, ..operations };
                        tasks.push(tested(test, always, depth(rng), kept));
                    }
                }
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "depth",
            asks: "the depth test by each of eight functions, and whose depth is kept",
            points: 1,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for function in Compare::ALL {
                    for order in ORDERS {
                        let (here, step) = (depth(rng), 1.0 / 64.0);
                        let fragment = match order {
                            Ordering::Less => here - step,
                            Ordering::Equal => here,
                            Ordering::Greater => here + step,
                        };
                        let kept = Kept { stencil: rng.u8(..), depth: here };
                        let depth = DepthTest { function, write: tasks.len() % 2 == 0 };
                        tasks.push(tested(passing(rng), depth, fragment, kept));
                    }
                }
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "operations",
            asks: "the operation that belongs to what came of the tests, and the bits that it may change",
            points: 2,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for operation in StencilOp::ALL {
                    for outcome in [Outcome::Fail, Outcome::DepthFail, Outcome::Pass] {
                        for stencil in [rng.u8(1..255), *rng.choice(&[0, 255]).unwrap_or(&0)] {
                            tasks.push(ending(rng, outcome, operation, stencil));
                        }
                    }
                }
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "glass discs, some of them seen through others",
            points: 2,
            tasks: |rng| (0..2).map(|_| picture(rng.u64(..1_000_000))).collect(),
            precision: Precision::EXACT,
        },
    ],
};

const ORDERS: [Ordering; 3] = [Ordering::Less, Ordering::Equal, Ordering::Greater];

/// What can come of the tests.
#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    Fail,
    DepthFail,
    Pass,
}

fn any_color(rng: &mut Rng) -> Color {
    let [r, g, b, a] = rng.u32(..).to_le_bytes();
    Color { r, g, b, a }
}

fn color_code(Color { r, g, b, a }: Color) -> String {
    format!("Color {{ r: {r}, g: {g}, b: {b}, a: {a} }}")
}

/// A depth with room on both sides, in 64ths.
fn depth(rng: &mut Rng) -> f32 {
    f32::from(rng.u8(8..56)) / 64.0
}

/// Some of the bits are set, and some are not.
fn mask(rng: &mut Rng) -> u8 {
    (0..)
        .find_map(|_| Some(rng.u8(..)).filter(|mask| (3..=5).contains(&mask.count_ones())))
        .unwrap_or(0b0011_1001)
}

/// Two numbers whose masked bits are in this order, and whose others are not.
fn ordered(rng: &mut Rng, mask: u8, order: Ordering) -> (u8, u8) {
    let pair = |_| {
        let (a, b) = (rng.u8(..), rng.u8(..));
        ((a & mask).cmp(&(b & mask)) == order && a.cmp(&b) != order).then_some((a, b))
    };
    (0..).find_map(pair).unwrap_or((0, 0))
}

/// Three operations, no two alike, and a write mask.
fn some_operations(rng: &mut Rng) -> StencilTest {
    let mut all = StencilOp::ALL;
    rng.shuffle(&mut all);
    let [fail, depth_fail, pass, ..] = all;
    StencilTest {
        function: Compare::Always,
        reference: rng.u8(..),
        read_mask: 255,
        write_mask: mask(rng),
        fail,
        depth_fail,
        pass,
    }
}

/// A stencil test that each fragment passes.
fn passing(rng: &mut Rng) -> StencilTest {
    some_operations(rng)
}

fn stencil_code(test: &StencilTest) -> String {
    let StencilTest { function, reference, read_mask, write_mask, fail, depth_fail, pass } = test;
    format!(
        "StencilTest {{ function: Compare::{function:?}, reference: {reference}, read_mask: {read_mask:#010b}, write_mask: \
         {write_mask:#010b}, fail: StencilOp::{fail:?}, depth_fail: StencilOp::{depth_fail:?}, pass: StencilOp::{pass:?} }}"
    )
}

/// One fragment: whether it passes, and what is kept.
fn tested(stencil: StencilTest, depth: DepthTest, fragment: f32, kept: Kept) -> Task<Blending> {
    let stencil_test = stencil_code(&stencil);
    let DepthTest { function, write } = depth;
    let depth_test = format!("DepthTest {{ function: Compare::{function:?}, write: {write} }}");
    let before = format!("let stencil = {stencil_test};\nlet depth = {depth_test};\n");
    let kept_code = format!("Kept {{ stencil: {}, depth: {} }}", kept.stencil, kept.depth.code());
    let call = format!("test(&stencil, &depth, {}, {kept_code})", fragment.code());
    let input = format!("test(&{stencil_test}, &{depth_test}, {}, {kept_code})", fragment.code());
    Task::new(input, format!("{before}let got = {call};"), move |student: &Blending| {
        let (passes, after) = (student.test)(&stencil, &depth, fragment, kept);
        Raw::value([f32::from(u8::from(passes)), after.stencil.into(), after.depth])
    })
}

/// A fragment that ends in one way, with an operation for that.
fn ending(rng: &mut Rng, outcome: Outcome, operation: StencilOp, stencil: u8) -> Task<Blending> {
    let (function, order) = if outcome == Outcome::Fail {
        (Compare::Less, Ordering::Greater)
    } else {
        (Compare::Gequal, Ordering::Equal)
    };
    let read_mask = mask(rng);
    // The kept value is given: look for the reference.
    let reference = (0..)
        .find_map(|_| {
            let reference = rng.u8(..);
            let right = (reference & read_mask).cmp(&(stencil & read_mask));
            (right == order || (order == Ordering::Greater && right == Ordering::Equal)).then_some(reference)
        })
        .unwrap_or(stencil);
    let mut test = StencilTest { function, reference, read_mask, ..some_operations(rng) };
    // What it takes the place of goes where it came from: the three stay different.
    let place = match outcome {
        Outcome::Fail => test.fail,
        Outcome::DepthFail => test.depth_fail,
        Outcome::Pass => test.pass,
    };
    for other in [&mut test.fail, &mut test.depth_fail, &mut test.pass] {
        if *other == operation {
            *other = place;
        }
    }
    match outcome {
        Outcome::Fail => test.fail = operation,
        Outcome::DepthFail => test.depth_fail = operation,
        Outcome::Pass => test.pass = operation,
    }
    let here = depth(rng);
    // Where the stencil test fails, it does not matter what the depth test would say.
    let deeper = outcome == Outcome::DepthFail || outcome == Outcome::Fail && matches!(stencil, 0 | 255);
    let fragment = here + if deeper { 0.125 } else { -0.125 };
    let depth = DepthTest { function: Compare::Less, write: true };
    tested(test, depth, fragment, Kept { stencil, depth: here })
}

/// A source of each alpha in a row and of each red in a column over a destination.
fn products(source: Color, destination: Color) -> Task<Blending> {
    let code = format!(
        "let mut got = Image::new(256, 256, Format::Rgb);\n\
         for (x, y, _) in got.clone().pixels() {{\n    \
             let source = Color {{ r: y as u8, g: 255 - y as u8, b: {}, a: x as u8 }};\n    \
             let Color {{ r, g, b, .. }} = over(source, {});\n    \
             got.set(x, y, Color::rgb(r, g, b));\n}}",
        source.b,
        color_code(destination)
    );
    let input = format!(
        "over(Color {{ r: y, g: 255 - y, b: {}, a: x }}, {}) at each (x, y), 256x256",
        source.b,
        color_code(destination)
    );
    Task::new(input, code, move |student: &Blending| {
        each_pair(|x, y| {
            let Color { r, g, b, .. } =
                (student.over)(Color { r: y, g: 255 - y, b: source.b, a: x }, destination);
            Color::rgb(r, g, b)
        })
    })
}

/// The alpha of each alpha, in a row, over each other one, in a column.
fn alphas(source: Color, destination: Color) -> Task<Blending> {
    let [over, below] = [source, destination].map(|Color { r, g, b, .. }| format!("r: {r}, g: {g}, b: {b}"));
    let code = format!(
        "let mut got = Image::new(256, 256, Format::Rgb);\n\
         for (x, y, _) in got.clone().pixels() {{\n    \
             let a = over(Color {{ {over}, a: x as u8 }}, Color {{ {below}, a: y as u8 }}).a;\n    \
             got.set(x, y, Color::rgb(a, a, a));\n}}"
    );
    let input =
        format!("over(Color {{ {over}, a: x }}, Color {{ {below}, a: y }}).a at each (x, y), 256x256");
    Task::new(input, code, move |student: &Blending| {
        each_pair(|x, y| {
            let a = (student.over)(Color { a: x, ..source }, Color { a: y, ..destination }).a;
            Color::rgb(a, a, a)
        })
    })
}

fn each_pair(color: impl Fn(u8, u8) -> Color) -> Raw {
    let mut image = canvas(256, 256);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, color(x as u8, y as u8));
    }
    Raw::Picture(image)
}

/// Random colours.
#[must_use]
pub fn colors(count: usize, seed: u64) -> Vec<Color> {
    let mut rng = Rng::with_seed(seed);
    // Mostly thin, so that the first ones are not forgotten at once.
    (0..count).map(|_| Color { a: rng.u8(..64), ..any_color(&mut rng) }).collect()
}

fn layers(count: usize, seed: u64) -> Task<Blending> {
    let input = format!("{count} random colours, each over what there is, from {} on", color_code(FIRST));
    let code = format!(
        "let mut color = {};\n\
         for layer in blending_tasks::colors({count}, {seed}) {{\n    color = over(layer, color);\n}}\n\
         let got = [color.r, color.g, color.b, color.a].map(f32::from);",
        color_code(FIRST)
    );
    Task::new(input, code, move |student: &Blending| {
        let Color { r, g, b, a } =
            colors(count, seed).into_iter().fold(FIRST, |below, layer| (student.over)(layer, below));
        Raw::value([r, g, b, a].map(f32::from))
    })
}

/// What layers begin with.
const FIRST: Color = Color { r: 200, g: 20, b: 90, a: 80 };

/// Width and height of the pictures.
const SIZE: [u16; 2] = [240, 180];

/// Discs before a ground: one that marks what may be drawn, opaque ones, and glass.
#[must_use]
pub fn discs(seed: u64) -> Vec<Layer> {
    let mut rng = Rng::with_seed(seed);
    let [width, height] = SIZE.map(f32::from);
    let keep = StencilTest {
        function: Compare::Always,
        reference: 1,
        read_mask: 255,
        write_mask: 255,
        fail: StencilOp::Keep,
        depth_fail: StencilOp::Keep,
        pass: StencilOp::Keep,
    };
    let solid = DepthTest { function: Compare::Less, write: true };
    let ground = Layer {
        center: Vec2::new(width, height) / 2.0,
        radius: width,
        depth: 0.99,
        slope: Vec2::ZERO,
        color: Color::rgb(40, 60, 90),
        stencil: keep,
        test: solid,
    };
    let disc = |rng: &mut Rng| Layer {
        center: Vec2::new(width * (0.25 + 0.5 * rng.f32()), height * (0.25 + 0.5 * rng.f32())),
        radius: 25.0 + 35.0 * rng.f32(),
        depth: 0.3 + 0.4 * rng.f32(),
        slope: Vec2::new(signed(rng), signed(rng)) * 0.006,
        color: Color { a: 255, ..any_color(rng) },
        stencil: keep,
        test: solid,
    };
    let mut layers = vec![ground];
    layers.extend((0..4).map(|_| disc(&mut rng)));
    // Two windows: what is behind something raises the value by 2, what is not by 1. Neither colour nor depth changes.
    for _ in 0..2 {
        let window = disc(&mut rng);
        let stencil = StencilTest { pass: StencilOp::Incr, depth_fail: StencilOp::IncrWrap, ..keep };
        let test = DepthTest { write: false, ..solid };
        let marked = Layer { radius: 50.0, color: Color { a: 0, ..window.color }, stencil, test, ..window };
        layers.extend([marked, marked]);
    }
    // Glass, seen where a window has marked, in whatever order, and not behind what is opaque.
    for n in 0..6 {
        let glass = disc(&mut rng);
        let function = if n % 2 == 0 { Compare::Lequal } else { Compare::Equal };
        let stencil = StencilTest { function, reference: 2, read_mask: 0b0111, ..keep };
        let test = DepthTest { function: Compare::Lequal, write: n == 3 };
        layers.push(Layer { color: Color { a: rng.u8(60..200), ..glass.color }, stencil, test, ..glass });
    }
    layers
}

fn picture(seed: u64) -> Task<Blending> {
    let [width, height] = SIZE;
    let code = format!(
        "let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         draw(&blending_tasks::discs({seed}), over, test, &mut got);"
    );
    let input = format!("opaque discs, windows and glass, {width}x{height}");
    Task::new(input, code, move |student: &Blending| {
        let mut image = canvas(width, height);
        draw(&discs(seed), student.over, student.test, &mut image);
        Raw::Picture(image)
    })
}
