//! Lesson 4: the nearest surface.

use checks::visibility::nearest;
use common::{Color, Format, Image, Method, Vec3};
use fastrand::Rng;
use zbuffer::{METHODS, Surface, Visibility, surfaces};

use crate::measure::{Effort, Errors, Work};
use crate::models::{TRIANGLES, USUAL, sphere};
use crate::table::{Chart, Quantity, Series, Sizes, Stability};

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
        stress: "distance between two sloping planes, the scene's depth as the unit",
        falling: true,
        error: Quantity { name: "pixels that show the farther one", unit: "%", limit: (0.0, "none") },
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

/// Two planes across the whole picture, sloping through the whole depth of the scene, drawn in either order.
fn stability(effort: Effort) -> Vec<Series> {
    let planes = |random: &mut Rng, gap: f32| -> Vec<[Vec3; 3]> {
        let side = f32::from(SIDE);
        let [left, right, top] = [(); 3].map(|()| random.f32() * 2.0 - 1.0);
        let plane = |depth: f32| {
            [
                Vec3::new(-1.0, -1.0, left + depth),
                Vec3::new(3.0 * side, -1.0, right + depth),
                Vec3::new(-1.0, 3.0 * side, top + depth),
            ]
        };
        // Two triangles beside the picture set the scene's depth.
        let beside = |depth: f32| [-9.0, -8.0, -7.0].map(|x| Vec3::new(x, x * x, depth));
        let [far, near] = [plane(0.0), plane(gap)];
        let pair = if random.bool() { [far, near] } else { [near, far] };
        pair.into_iter().chain([beside(-2.0), beside(2.0)]).collect()
    };
    let mut series = vec![Series::new(); METHODS.len()];
    for half in 1..=16 {
        let gap = 10f64.powf(-f64::from(half) / 2.0);
        let mut random = effort.random();
        let mut sums = vec![0.0; METHODS.len()];
        let scenes = effort.samples(100);
        for _ in 0..scenes {
            let scene = planes(&mut random, 4.0 * gap as f32);
            sums.iter_mut().zip(wrong(&scene)).for_each(|(sum, wrong)| *sum += wrong);
        }
        series.iter_mut().zip(sums).for_each(|(series, sum)| series.push((gap, sum / scenes as f64)));
    }
    series
}
