//! Lesson 5: colour from an image.

use checks::texel::{clamped, repeated};
use common::{Color, Format, Image, Method, Vec2, Vec3};
use fastrand::Rng;
use textures::{METHODS, Sampler};

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::{TRIANGLES, USUAL, sphere, texture};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const CHART: Chart = Chart {
    name: "05-textures",
    job: "Lesson 5, the texel of (u, v)",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "how far the texel found lies from (u, v)",
        unit: "texels",
        limit: (0.01, "within 1/100 texel"),
    },
    further: &["black_%"],
    samples: "random u, v from 0 to 1, one in 64 of them just 1, in 200×200 texels",
    exhaustive: false,
    proved: &[],
    errors,
    timed: "a textured sphere of 5,000 triangles in a picture of 800×800",
    throughput: "Mpx/s",
    work,
    sizes: Sizes { name: "triangles", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "width of the texture, texels",
        falling: false,
        error: Quantity { name: "lookups of another texel", unit: "%", limit: (0.0, "none") },
        measure: stability,
    },
    wrong: &[],
    advice: &[("nearest", "always, unless the texture tiles"), ("repeat", "textures that tile")],
};

/// A texture whose colours tell where they are: column and row, each in 12 bits, from 1.
fn numbered(width: u16, height: u16) -> Image {
    let mut image = Image::new(width, height, Format::Rgba);
    for (x, y) in (0..i32::from(height)).flat_map(|y| (0..i32::from(width)).map(move |x| (x, y))) {
        let [r, g, b, a] = ((x as u32 + 1) | (y as u32) << 16).to_le_bytes();
        image.set(x, y, Color { r, g, b, a });
    }
    image
}

/// The texel that was found, or `None` for black.
fn found(color: Color) -> Option<[i32; 2]> {
    let number = u32::from_le_bytes([color.r, color.g, color.b, color.a]);
    let column = (number & 0xffff) as i32;
    (color != Color::BLACK && column > 0).then(|| [column - 1, (number >> 16) as i32])
}

/// The texel that a method promises for a coordinate.
fn promised(method: &Method<Sampler>, coordinate: f32, size: u16) -> i32 {
    let texel = if method.name == "repeat" { repeated } else { clamped };
    texel(coordinate, size).expect("it is finite")
}

/// Where a coordinate lies, in texels: the product of an f32 and 16 bits is exact in f64.
fn place(method: &Method<Sampler>, coordinate: f32, size: u16) -> f64 {
    let exact = f64::from(coordinate);
    f64::from(size) * if method.name == "repeat" { exact.fract() } else { exact }
}

/// How far a point is outside of a texel.
fn outside(point: f64, texel: i32) -> f64 {
    let low = f64::from(texel);
    (low - point).max(point - low - 1.0).max(0.0)
}

fn errors(effort: Effort) -> Vec<Errors> {
    const SIDE: u16 = 200;
    const LOOKUPS: u32 = 500;
    let texture = numbered(SIDE, SIDE);
    let mut random = effort.random();
    let mut coordinate = || if random.u8(..64) == 0 { 1.0 } else { random.f32() };
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(4_000) {
        let inputs: Vec<Vec2> = (0..LOOKUPS).map(|_| Vec2::new(coordinate(), coordinate())).collect();
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let (mut largest, mut sum, mut black) = (0.0_f64, 0.0, 0);
            for uv in &inputs {
                let off = if let Some(texel) = found((method.run.sample)(&texture, *uv)) {
                    let point = uv.to_array().map(|coordinate| place(method, coordinate, SIDE));
                    (0..2).map(|n| outside(point[n], texel[n])).fold(0.0, f64::max)
                } else {
                    // Black is no texel: it was looked for next to the texture.
                    black += 1;
                    1.0
                };
                largest = largest.max(off);
                sum += off;
            }
            let count = f64::from(LOOKUPS);
            errors.add(largest, sum / count, &[100.0 * f64::from(black) / count]);
        }
    }
    errors
}

fn work(size: usize, _: Effort) -> Vec<Work> {
    let model = sphere(size);
    let empty = Image::new(800, 800, Format::Rgb);
    let amount = {
        let mut image = empty.clone();
        let depths = (METHODS[0].run.draw)(model, &texture(), Vec3::Z, &mut image);
        image.pixels().filter(|&(x, y, _)| depths.get(x, y) > f32::NEG_INFINITY).count() as f64
    };
    let work = |method: &'static Method<Sampler>| {
        let (texture, mut image) = (texture(), empty.clone());
        Work::new(amount, move || (method.run.draw)(model, &texture, Vec3::Z, &mut image))
    };
    METHODS.iter().map(work).collect()
}

/// Wider and wider textures, up to where f32 can no longer tell one texel from the next.
fn stability(effort: Effort) -> Vec<Series> {
    let widths = [1_u16, 3, 10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 65_535];
    let share = |method: &Method<Sampler>, width: u16| {
        let texture = numbered(width, 1);
        let mut random = Rng::with_seed(effort.seed);
        let lookups = effort.samples(1_000_000);
        let wrong = (0..lookups).filter(|_| {
            let u = random.f32();
            found((method.run.sample)(&texture, Vec2::new(u, 0.25))) != Some([promised(method, u, width), 0])
        });
        100.0 * wrong.count() as f64 / lookups as f64
    };
    METHODS
        .iter()
        .map(|method| widths.map(|width| (f64::from(width), share(method, width))).to_vec())
        .collect()
}
