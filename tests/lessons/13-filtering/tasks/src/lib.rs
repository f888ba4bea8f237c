//! Mission 13: light between texels, and the level of a footprint.

pub use filtering_given as given;

use common::{Format, Image, Vec2, Vec3};
use fastrand::Rng;
use tasks::scenery::{canvas, noise, pattern, signed};
use tasks::{Check, Code, Mission, Precision, Raw, Task};

use given::{Bilinear, Footprint, Level, LevelOf, Wrap, floor, levels};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Filtering {
    /// The lesson's `bilinear`.
    pub bilinear: Bilinear,
    /// The lesson's `level`.
    pub level: LevelOf,
}

/// The mission.
pub const MISSION: Mission<Filtering> = Mission {
    lesson: "13-filtering",
    checks: &[
        Check {
            name: "centres",
            asks: "a texel's own light at its centre, and most of it nearby",
            points: 1,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for size in [[5, 3], [4, 6], [1, 7]] {
                    let texel = size.map(|n| f32::from(rng.u16(..n)) + 0.5);
                    tasks.push(at(rng, size, Vec2::from_array(texel), Wrap::Clamp));
                }
                let near = [6, 5].map(|n| f32::from(rng.u16(1..n - 1)) + 0.6 + 0.2 * rng.f32());
                tasks.push(at(rng, [6, 5], Vec2::from_array(near), Wrap::Clamp));
                tasks
            },
            precision: LIGHT,
        },
        Check {
            name: "between",
            asks: "the light between four centres",
            points: 3,
            tasks: |rng| {
                let within = |rng: &mut Rng, n: u16| 0.6 + (f32::from(n) - 1.2) * rng.f32();
                [[5, 3], [3, 8], [6, 6], [2, 2]]
                    .map(|size| {
                        let place = Vec2::new(within(rng, size[0]), within(rng, size[1]));
                        at(rng, size, place, Wrap::Repeat)
                    })
                    .into()
            },
            precision: LIGHT,
        },
        Check {
            name: "borders",
            asks: "the light at the borders and beyond, clamped, repeated and mirrored",
            points: 2,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for wrap in [Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
                    // Within half a texel of a border, on either side of it; and far outside.
                    let places: [fn(&mut Rng, f32) -> f32; 4] = [
                        |rng, _| 0.05 + 0.4 * rng.f32(),
                        |rng, n| n - 0.05 - 0.4 * rng.f32(),
                        |rng, _| -0.05 - 0.4 * rng.f32(),
                        |rng, n| n * (2.0 + 3.0 * rng.f32()) * if rng.bool() { 1.0 } else { -1.0 },
                    ];
                    for place in places {
                        let size = [rng.u16(2..6), rng.u16(6..9)];
                        let both = [0, 1].map(|axis| place(rng, size[axis].into()));
                        tasks.push(at(rng, size, Vec2::from_array(both), wrap));
                    }
                    tasks.push(at(rng, [1, 5], Vec2::new(0.9, 0.2), wrap));
                }
                tasks
            },
            precision: LIGHT,
        },
        Check {
            name: "level",
            asks: "the level of a footprint",
            points: 2,
            tasks: |rng| {
                let mut side = |long: f32| {
                    let angle = rng.f32() * std::f32::consts::TAU;
                    Vec2::new(angle.cos(), angle.sin()) * long
                };
                let footprints = [[0.05, 0.01], [0.01, 0.05], [0.3, 0.2], [0.002, 0.0005], [0.0, 0.1]]
                    .map(|[x, y]| Footprint { x: side(x), y: side(y) });
                let sizes = [[64, 64], [256, 32], [16, 512], [100, 48], [300, 7]];
                let sizes = sizes.map(|[w, h]: [u16; 2]| Vec2::new(w.into(), h.into()));
                footprints.into_iter().zip(sizes).map(|(footprint, size)| level(footprint, size)).collect()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "a floor to the horizon",
            points: 2,
            tasks: |rng| (0..2).map(|_| seen(rng)).collect(),
            precision: Precision { tolerance: 2.0, strays: 30 },
        },
    ],
};

/// A thousandth of a level of 255: light is a sum of products.
const LIGHT: Precision = Precision { tolerance: 1e-3, strays: 0 };

/// A texture of random colours.
#[must_use]
pub fn texture(seed: u64, [width, height]: [u16; 2]) -> Level {
    let square = noise(&mut Rng::with_seed(seed), width.max(height));
    let mut image = Image::new(width, height, Format::Rgb);
    for (x, y, color) in square.pixels() {
        image.set(x, y, color);
    }
    Level { image }
}

/// The light of a random texture at a place, which is given in texels.
fn at(rng: &mut Rng, size: [u16; 2], texels: Vec2, wrap: Wrap) -> Task<Filtering> {
    let seed = rng.u64(..1_000_000);
    let uv = texels / Vec2::from_array(size.map(f32::from));
    let before = format!("let texels = filtering_tasks::texture({seed}, {size:?});\n");
    let call = format!("bilinear(&texels, {}, Wrap::{wrap:?})", uv.code());
    let [width, height] = size;
    let input = format!("{call}, of {width}x{height} texels");
    Task::new(input, format!("{before}let got = {call};"), move |student: &Filtering| {
        Raw::value((student.bilinear)(&texture(seed, size), uv, wrap).to_array())
    })
}

fn level(footprint: Footprint, size: Vec2) -> Task<Filtering> {
    let Footprint { x, y } = footprint;
    let call = format!("level(Footprint {{ x: {}, y: {} }}, {})", x.code(), y.code(), size.code());
    Task::call("", call, move |student: &Filtering| Raw::value([(student.level)(footprint, size)]))
}

/// Width and height of the pictures.
const SIZE: [u16; 2] = [240, 180];

/// The levels of a texture of large squares.
#[must_use]
pub fn squares() -> Vec<Level> {
    let small = pattern();
    let mut large = canvas(64, 64);
    for (x, y, _) in large.clone().pixels() {
        if let Some(color) = small.get(x / 16, y / 16) {
            large.set(x, y, color);
        }
    }
    levels(large)
}

/// The floor from a random place over it.
fn seen(rng: &mut Rng) -> Task<Filtering> {
    let [width, height] = SIZE;
    let eye = Vec3::new(signed(rng), 0.25 + 0.5 * rng.f32(), signed(rng));
    let eye = (eye * 100.0).round() / 100.0;
    let code = format!(
        "let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         floor(&filtering_tasks::squares(), {}, bilinear, level, &mut got);",
        eye.code()
    );
    let input = format!("a floor, {width}x{height}, from {}", eye.code());
    Task::new(input, code, move |student: &Filtering| {
        let mut image = canvas(width, height);
        floor(&squares(), eye, student.bilinear, student.level, &mut image);
        Raw::Picture(image)
    })
}
