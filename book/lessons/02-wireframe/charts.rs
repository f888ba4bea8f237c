//! Lesson 2: a model's edges.

use std::collections::BTreeSet;

use checks::{segment, vertex};
use common::{Color, Format, Image, Method, Model, Vec3};
use fastrand::Rng;
use wireframe::{METHODS, Wireframe};

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::{USUAL, sphere};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const CHART: Chart = Chart {
    name: "02-wireframe",
    job: "Lesson 2, a model's edges",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity { name: "wrong pixels in a picture", unit: "px", limit: (0.5, "without a wrong pixel") },
    further: &[],
    samples: "random nets of 24 triangles in pictures of 10 to 200 px",
    exhaustive: false,
    proved: &[],
    errors,
    timed: "spheres of 5,000 triangles in a picture of 800×800",
    throughput: "Mtri/s",
    work,
    sizes: Sizes { name: "triangles", all: &[18, 98, 968, 10_082, 100_352, 999_698], usual: USUAL },
    stability: Stability {
        stress: "size of the model, the picture as the unit",
        falling: false,
        error: Quantity { name: "wrong pixels", unit: "% of those drawn", limit: (0.0, "none") },
        measure: stability,
    },
    wrong: &[],
    advice: &[
        ("unique-edges", "closed models, where it draws half as many lines"),
        ("three-per-triangle", "a few triangles, or no memory for a list of edges"),
    ],
};

/// Random triangles that share their corners, within ±`size`; some corners on the very border. Every other
/// corner lies across from the one before it, so that edges pass through the middle however large they are.
fn net(random: &mut Rng, size: f32) -> Model {
    let mut coordinate = || match random.u8(..16) {
        0 => size,
        1 => -size,
        _ => (random.f32() * 2.0 - 1.0) * size,
    };
    let pairs = (0..6).flat_map(|_| {
        let corner = Vec3::new(coordinate(), coordinate(), 0.0);
        [corner, -corner]
    });
    let corners = pairs.collect();
    let triangles = (0..24).map(|n| [n % 12, (n % 12) ^ 1, (n * 7 + 3) % 12]).collect();
    Model::from_triangles(corners, triangles).expect("its corners exist")
}

/// How many pixels each method gets wrong, and how many there should be.
fn wrong(model: &Model, side: u16) -> (Vec<usize>, usize) {
    let empty = Image::new(side, side, Format::Gray);
    let corner =
        |point: Vec3| [point.x, point.y].map(|coordinate| vertex::pixel(coordinate, i32::from(side)));
    let mut expected = BTreeSet::new();
    for [a, b, c] in model.faces() {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            expected.extend(segment::pixels(corner(from), corner(to), empty.bounds()));
        }
    }
    let count = |method: &Method<Wireframe>| {
        let mut image = empty.clone();
        (method.run.draw)(model, &mut image, Color::WHITE);
        let drawn = |x, y| image.get(x, y) == Some(Color::WHITE);
        image.pixels().filter(|&(x, y, _)| drawn(x, y) != expected.contains(&(x, y))).count()
    };
    (METHODS.iter().map(count).collect(), expected.len())
}

fn errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(2_000) {
        let side = random.u16(10..=200);
        let (wrong, _) = wrong(&net(&mut random, 1.0), side);
        errors.iter_mut().zip(wrong).for_each(|(errors, wrong)| errors.add(wrong as f64, wrong as f64, &[]));
    }
    errors
}

fn work(size: usize, _: Effort) -> Vec<Work> {
    let model = sphere(size);
    let work = |method: &'static Method<Wireframe>| {
        let mut image = Image::new(800, 800, Format::Rgb);
        Work::new(model.faces().len() as f64, move || {
            (method.run.draw)(model, &mut image, Color::WHITE);
            image.get(0, 0)
        })
    };
    METHODS.iter().map(work).collect()
}

/// A model that is larger and larger: first its corners and then most of it leave the picture.
fn stability(effort: Effort) -> Vec<Series> {
    let mut series = vec![Series::new(); METHODS.len()];
    for size in (0..=9).map(|power| 10f32.powi(power)) {
        let mut random = effort.random();
        let (mut sums, mut all) = (vec![0; METHODS.len()], 0);
        for _ in 0..effort.samples(200) {
            let (wrong, right) = wrong(&net(&mut random, size), 200);
            sums.iter_mut().zip(wrong).for_each(|(sum, wrong)| *sum += wrong);
            all += right;
        }
        let share = |sum: usize| 100.0 * sum as f64 / all.max(1) as f64;
        series.iter_mut().zip(sums).for_each(|(series, sum)| series.push((f64::from(size), share(sum))));
    }
    series
}
