//! Lesson 6: smooth shading.

use checks::sphere::intensity;
use common::{Color, Format, Image, Method, Model, Vec3};
use fastrand::Rng;
use gouraud::{Draw, METHODS, Scene, Wrap, corner_normals};

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::{TRIANGLES, USUAL, sphere, texture};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const CHART: Chart = Chart {
    name: "06-gouraud",
    job: "Lesson 6, the brightness at each pixel",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference from a smooth sphere",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "a sphere of 5,000 triangles under random lights, 256×256 px",
    exhaustive: false,
    proved: &[],
    errors,
    timed: "a textured sphere of 5,000 triangles in a picture of 800×800",
    throughput: "Mpx/s",
    work,
    sizes: Sizes { name: "triangles", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "angle between neighbouring corners of the sphere, degrees",
        falling: false,
        error: Quantity { name: "mean difference", unit: "grey levels of 255", limit: (1.0, "1 level") },
        measure: stability,
    },
    wrong: &["none"],
    advice: &[
        ("gouraud", "round things"),
        ("flat", "things with flat faces, and models without normals"),
        ("none", "what has its light in the texture"),
    ],
};

/// A random direction in front of the picture.
pub(crate) fn light(random: &mut Rng) -> Vec3 {
    loop {
        let [x, y] = [0; 2].map(|_| random.f32() * 2.0 - 1.0);
        let square = x * x + y * y;
        if square < 1.0 {
            return Vec3::new(x, y, (1.0 - square).sqrt()).normalize();
        }
    }
}

/// The largest and the mean difference between a drawn sphere and a smooth one, where both are seen.
fn difference(method: &Method<Draw>, model: &Model, light: Vec3, side: u16) -> (f64, f64) {
    let mut white = Image::new(1, 1, Format::Rgb);
    white.set(0, 0, Color::WHITE);
    let scene = Scene { model, normals: &corner_normals(model), texture: &white, wrap: Wrap::Clamp, light };
    let mut image = Image::new(side, side, Format::Rgb);
    let drawn = (method.run)(&scene, &mut image);
    let toward = light.as_dvec3().normalize();
    let center = |n: i32| (f64::from(n) + 0.5) * 2.0 / f64::from(side) - 1.0;
    let (mut largest, mut sum, mut count) = (0.0_f64, 0.0, 0_u32);
    for (x, y, color) in image.pixels() {
        if drawn.depths.get(x, y) > f32::NEG_INFINITY
            && let Some(exact) = intensity(center(x), center(y), toward)
        {
            let off = (f64::from(color.r) - 255.0 * exact).abs();
            largest = largest.max(off);
            sum += off;
            count += 1;
        }
    }
    (largest, sum / f64::from(count))
}

fn errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(400) {
        let light = light(&mut random);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let (largest, mean) = difference(method, sphere(USUAL), light, 256);
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

fn work(size: usize, _: Effort) -> Vec<Work> {
    let model = sphere(size);
    let work = |method: &'static Method<Draw>| {
        let texture: &'static Image = Box::leak(Box::new(texture()));
        let normals = corner_normals(model).leak();
        let scene = Scene { model, normals, texture, wrap: Wrap::Clamp, light: Vec3::Z };
        let empty = Image::new(800, 800, Format::Rgb);
        let depths = (method.run)(&scene, &mut empty.clone()).depths;
        let seen = empty.pixels().filter(|&(x, y, _)| depths.get(x, y) > f32::NEG_INFINITY).count();
        let mut image = empty;
        Work::new(seen as f64, move || (method.run)(&scene, &mut image))
    };
    METHODS.iter().map(work).collect()
}

/// Coarser and coarser spheres.
fn stability(effort: Effort) -> Vec<Series> {
    let sectors = [240_usize, 160, 100, 60, 40, 24, 16, 10, 6, 4];
    let mean = |method: &Method<Draw>, sectors: usize| {
        let mut random = effort.random();
        let lights = effort.samples(40);
        let model = sphere(2 * sectors * sectors);
        (0..lights).map(|_| difference(method, model, light(&mut random), 256).1).sum::<f64>() / lights as f64
    };
    METHODS
        .iter()
        .map(|method| sectors.map(|sectors| (360.0 / sectors as f64, mean(method, sectors))).to_vec())
        .collect()
}
