//! Lesson 8: looking at a point.

use std::hint::black_box;

use camera::{Look, METHODS, View};
use checks::view::{basis, seen};
use common::{Method, Vec3};
use fastrand::Rng;
use glam::DVec3;

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

/// Pixels to a length of 1 in a picture of 800×800.
const PIXELS: f64 = 400.0;

pub(crate) const CHART: Chart = Chart {
    name: "08-camera",
    job: "Lesson 8, looking at a point",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "how far the corners of a cube are off",
        unit: "px of 800",
        limit: (0.5, "within ½ px"),
    },
    further: &[],
    samples: "random eyes 1 to 10 away from centres up to 10⁶ from the origin, up at least 10⁻³ radians off the view",
    exhaustive: false,
    proved: &[],
    errors,
    timed: "a view, and 1,000 points through it",
    throughput: "Mpt/s",
    work,
    sizes: Sizes { name: "points a view", all: &[1, 10, 100, 1000, 10_000], usual: 1000 },
    stability: Stability {
        stress: "angle between up and the view, radians",
        falling: true,
        error: Quantity {
            name: "error of the eye's directions",
            unit: "radians",
            limit: (0.5 / PIXELS, "½ px of 800"),
        },
        measure: stability,
    },
    wrong: &["listing"],
    advice: &[
        ("lookat", "with centres within some thousand times the size of what is looked at"),
        ("relative", "with centres farther away: a subtraction more for each point"),
    ],
};

fn point(random: &mut Rng) -> Vec3 {
    Vec3::from_array([0; 3].map(|_| random.f32() * 2.0 - 1.0))
}

/// A random eye and the centre it looks at: up to `far` from the origin, any power of ten with the same chance.
fn eye_and_center(random: &mut Rng, far: f32) -> (Vec3, Vec3) {
    loop {
        let (center, direction) = (point(random) * far.powf(random.f32()), point(random));
        let length = direction.length();
        // Nearer to up or down than a thousandth of a radian is the stability chart's.
        if (0.1..1.0).contains(&length) && direction.reject_from_normalized(Vec3::Y).length() > 1e-3 * length
        {
            return (center + direction / length * 10f32.powf(random.f32()), center);
        }
    }
}

/// How far the corners of a cube about the centre are off, 2 high, in pixels: the largest and the mean.
fn off(got: Option<View>, eye: Vec3, center: Vec3) -> (f64, f64) {
    let Some(View { origin, matrix }) = got else { return (f64::INFINITY, f64::INFINITY) };
    let distances = cube(center).map(|corner| {
        let there = matrix.transform_point3(corner - origin).as_dvec3();
        (there - seen(corner.as_dvec3(), eye, center, Vec3::Y)).length() * PIXELS
    });
    (distances.into_iter().fold(0.0, f64::max), distances.iter().sum::<f64>() / 8.0)
}

/// The corners of a cube about a point, as f32 has them there.
fn cube(center: Vec3) -> [Vec3; 8] {
    [0_u8, 1, 2, 3, 4, 5, 6, 7].map(|n| {
        center + Vec3::from_array([n & 1, (n >> 1) & 1, n >> 2].map(|bit| f32::from(bit) * 2.0 - 1.0))
    })
}

fn errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(200_000) {
        let (eye, center) = eye_and_center(&mut random, 1e6);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let (largest, mean) = off((method.run)(eye, center, Vec3::Y), eye, center);
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

/// Views, and so many points through each, which are written down.
fn work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let inputs: Vec<(Vec3, Vec3)> =
        (0..(20_000 / size).max(1)).map(|_| eye_and_center(&mut random, 1.0)).collect();
    let points: Vec<Vec3> = (0..size).map(|_| point(&mut random)).collect();
    let nothing = seeing(0, &inputs, &points, |_, _, points, seen| seen.copy_from_slice(points));
    let work = |&Method { run: look, .. }: &Method<Look>| {
        seeing(inputs.len() * size, &inputs, &points, move |eye, center, points, seen| {
            let Some(View { origin, matrix }) = look(eye, center, Vec3::Y) else { return };
            let pairs = points.iter().zip(seen);
            // Who builds a whole matrix subtracts nothing.
            if origin == Vec3::ZERO {
                pairs.for_each(|(point, seen)| *seen = matrix.transform_point3(*point));
            } else {
                pairs.for_each(|(point, seen)| *seen = matrix.transform_point3(*point - origin));
            }
        })
    };
    std::iter::once(nothing).chain(METHODS.iter().map(work)).collect()
}

/// For each eye and centre, all points, and where they are seen.
fn seeing(
    amount: usize,
    inputs: &[(Vec3, Vec3)],
    points: &[Vec3],
    see: impl Fn(Vec3, Vec3, &[Vec3], &mut [Vec3]) + 'static,
) -> Work {
    let (inputs, points, mut seen) = (inputs.to_vec(), points.to_vec(), points.to_vec());
    Work::new(amount as f64, move || {
        for &(eye, center) in &inputs {
            see(eye, center, &points, black_box(&mut seen));
        }
    })
}

/// Eyes that look along up more and more nearly, from all sides. (With up along an axis of the coordinates the
/// products of small numbers lose nothing, and the error would stay at f32's rounding.)
fn stability(effort: Effort) -> Vec<Series> {
    let angles = (0..=14).map(|half| 10f64.powf(-f64::from(half) / 2.0));
    let worst = |method: &Method<Look>, angle: f64| {
        let mut random = effort.random();
        let views = (0..effort.samples(400)).map(|_| {
            let up = direction(&mut random);
            let side = up.cross(direction(&mut random)).normalize();
            let eye = ((side * angle.sin() + up * angle.cos()) * 2.0).as_vec3();
            let up = up.as_vec3();
            let Some(got) = (method.run)(eye, Vec3::ZERO, up) else { return f64::INFINITY };
            let exact = basis(eye, Vec3::ZERO, up);
            let rows = [0, 1, 2].map(|row| (got.matrix.row(row).truncate().as_dvec3() - exact[row]).length());
            rows.into_iter().fold(0.0, f64::max)
        });
        views.fold(0.0, f64::max)
    };
    METHODS.iter().map(|method| angles.clone().map(|angle| (angle, worst(method, angle))).collect()).collect()
}

fn direction(random: &mut Rng) -> DVec3 {
    loop {
        let v = point(random).as_dvec3();
        if (0.01..1.0).contains(&v.length_squared()) {
            return v.normalize();
        }
    }
}
