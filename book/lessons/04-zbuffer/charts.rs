//! Lesson 4: the nearest surface.

use checks::visibility::nearest;
use common::{Color, Format, Image, Method, Vec3};
use fastrand::Rng;
use zbuffer::{METHODS, Surface, Visibility, surfaces};

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::{TRIANGLES, USUAL, sphere};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const CHART: Chart = Chart {
    name: "04-zbuffer",
    job: "Lesson 4, the nearest surface",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "pixels that show another surface",
        unit: "%",
        limit: (0.01, "within 1 px of 100×100"),
    },
    further: &[],
    samples: "scenes of 12 random triangles that cut each other, 40×40 px",
    exhaustive: false,
    proved: &[],
    errors,
    timed: "spheres of 5,000 triangles, those that face the light, in a picture of 800×800",
    throughput: "Mpx/s",
    work,
    sizes: Sizes { name: "triangles", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "distance between layers, the scene's depth as the unit",
        falling: true,
        error: Quantity {
            name: "pixels that show another surface",
            unit: "%",
            limit: (0.0, "no wrong pixel"),
        },
        measure: stability,
    },
    wrong: &[],
    advice: &[
        ("z-f32", "always, unless memory is short"),
        ("z24", "with near and far known: as good, and leaves 8 bits"),
        ("z16", "half the memory, with surfaces at least 1/10,000 of the depth apart"),
        ("painter", "without memory for depths, or for what is transparent, in scenes that can be sorted"),
    ],
};

/// The side of the pictures in which pixels are counted.
const SIDE: u16 = 40;

/// The share of pixels, in %, in which each method shows another surface than the nearest. In the order in
/// which they are drawn, the n-th surface has the colour (n + 1, 0, 0).
fn wrong(scene: &[[Vec3; 3]]) -> Vec<f64> {
    let color = |n: usize| Color::rgb(n as u8 + 1, 0, 0);
    let surfaces: Vec<Surface> =
        scene.iter().enumerate().map(|(n, &corners)| Surface { corners, color: color(n) }).collect();
    let empty = Image::new(SIDE, SIDE, Format::Rgb);
    let seen = |(x, y, _)| nearest(scene, x, y).map_or(Color::BLACK, |seen| color(seen.triangle));
    let expected: Vec<Color> = empty.pixels().map(seen).collect();
    let covered = expected.iter().filter(|color| **color != Color::BLACK).count().max(1);
    let count = |method: &Method<Visibility>| {
        let mut image = empty.clone();
        (method.run.draw)(&surfaces, &mut image);
        let wrong = image.pixels().zip(&expected).filter(|((_, _, got), expected)| got != *expected).count();
        100.0 * wrong as f64 / covered as f64
    };
    METHODS.iter().map(count).collect()
}

fn errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(4_000) {
        let mut corner = || {
            let [x, y] = [0; 2].map(|_| random.f32() * f32::from(SIDE));
            Vec3::new(x, y, random.f32() * 2.0 - 1.0)
        };
        let scene: Vec<[Vec3; 3]> = (0..12).map(|_| [(); 3].map(|()| corner())).collect();
        errors.iter_mut().zip(wrong(&scene)).for_each(|(errors, wrong)| errors.add(wrong, wrong, &[]));
    }
    errors
}

fn work(size: usize, _: Effort) -> Vec<Work> {
    let empty = Image::new(800, 800, Format::Rgb);
    let surfaces = surfaces(sphere(size), Vec3::Z, &empty);
    let pixels = |method: &Method<Visibility>| {
        let mut image = empty.clone();
        (method.run.draw)(&surfaces, &mut image);
        image.pixels().filter(|pixel| pixel.2 != Color::BLACK).count()
    };
    let amount = pixels(&METHODS[METHODS.len() - 1]) as f64;
    let work = |method: &'static Method<Visibility>| {
        let (surfaces, mut image) = (surfaces.clone(), empty.clone());
        Work::new(amount, move || {
            (method.run.draw)(&surfaces, &mut image);
            image.get(0, 0)
        })
    };
    METHODS.iter().map(work).collect()
}

/// A plane across the whole picture, sloping through the whole depth of the scene, and a part of it as a layer in
/// front, drawn in either order. Every fourth scene is a cycle of three instead: each lies in front of the next.
fn stability(effort: Effort) -> Vec<Series> {
    let mut series = vec![Series::new(); METHODS.len()];
    for half in 1..=16 {
        let gap = 10f64.powf(-f64::from(half) / 2.0);
        let mut random = effort.random();
        let mut sums = vec![0.0; METHODS.len()];
        let scenes = effort.samples(100);
        for n in 0..scenes {
            let layers = if n % 4 == 3 { cycle } else { layers };
            // Two triangles beside the picture set the scene's depth, 4.
            let beside = |depth: f32| [-9.0, -8.0, -7.0].map(|x| Vec3::new(x, x * x, depth));
            let mut scene = layers(&mut random, 4.0 * gap as f32);
            scene.extend([beside(-2.0), beside(2.0)]);
            sums.iter_mut().zip(wrong(&scene)).for_each(|(sum, wrong)| *sum += wrong);
        }
        series.iter_mut().zip(sums).for_each(|(series, sum)| series.push((gap, sum / scenes as f64)));
    }
    series
}

/// A sloping plane, and a part of it that lies in front by `gap`.
fn layers(random: &mut Rng, gap: f32) -> Vec<[Vec3; 3]> {
    let side = f32::from(SIDE);
    let [left, right, top] = [(); 3].map(|()| random.f32() * 2.0 - 1.0);
    let plane =
        [Vec3::new(-1.0, -1.0, left), Vec3::new(3.0 * side, -1.0, right), Vec3::new(-1.0, 3.0 * side, top)];
    // Of the part that is seen a triangle, which as a whole may lie before or behind the middle of the plane.
    let part = [(); 3].map(|()| {
        let [u, v] = [0; 2].map(|_| random.f32() / 3.0);
        plane[0] * (1.0 - u - v) + plane[1] * u + plane[2] * v + Vec3::Z * gap
    });
    if random.bool() { vec![plane, part] } else { vec![part, plane] }
}

/// Three triangles around the middle, the tip of each behind the foot of the next by `gap`.
fn cycle(random: &mut Rng, gap: f32) -> Vec<[Vec3; 3]> {
    let (middle, start) = (f32::from(SIDE) / 2.0, random.f32());
    let around = |thirds: f32, radius: f32, depth: f32| {
        let (sin, cos) = ((start + thirds / 3.0) * std::f32::consts::TAU).sin_cos();
        Vec3::new(middle + radius * cos, middle + radius * sin, depth)
    };
    [0.0, 1.0, 2.0].map(|n| [around(n, 18.0, gap), around(n, 6.0, gap), around(n + 1.3, 18.0, -gap)]).to_vec()
}
