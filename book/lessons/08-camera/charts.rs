//! Lesson 8: looking at a point.

use camera::{METHODS, View};
use checks::view::{basis, seen};
use common::{Mat4, Method, Vec3};
use fastrand::Rng;
use glam::DVec3;

use crate::measure::{Effort, Errors, Work};
use crate::table::{Chart, Quantity, Series, Sizes, Stability};

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
    samples: "random eyes 1 to 10 away from a random centre in the cube, up at least 10° off the view",
    exhaustive: false,
    proved: &[],
    errors,
    timed: "1,000 view matrices",
    throughput: "Mop/s",
    work,
    sizes: Sizes { name: "matrices", all: &[1000], usual: 1000 },
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
    advice: &[("lookat", "always")],
};

fn point(random: &mut Rng) -> Vec3 {
    Vec3::from_array([0; 3].map(|_| random.f32() * 2.0 - 1.0))
}

/// A random eye and the centre it looks at.
fn eye_and_center(random: &mut Rng) -> (Vec3, Vec3) {
    loop {
        let (center, direction) = (point(random), point(random));
        let length = direction.length();
        // Within 10° of up or down, other errors begin: those are the stability chart's.
        if (0.1..1.0).contains(&length) && direction.y.abs() < 0.98 * length {
            return (center + direction / length * 10f32.powf(random.f32()), center);
        }
    }
}

/// How far the corners of the cube [−1, 1]³ are off, in pixels: the largest and the mean.
fn off(got: Option<Mat4>, eye: Vec3, center: Vec3) -> (f64, f64) {
    let Some(got) = got else { return (f64::INFINITY, f64::INFINITY) };
    let distances = [0_u8, 1, 2, 3, 4, 5, 6, 7].map(|n| {
        let corner = Vec3::from_array([n & 1, n >> 1 & 1, n >> 2].map(|bit| f32::from(bit) * 2.0 - 1.0));
        let there = got.transform_point3(corner).as_dvec3();
        (there - seen(corner.as_dvec3(), eye, center, Vec3::Y)).length() * PIXELS
    });
    (distances.into_iter().fold(0.0, f64::max), distances.iter().sum::<f64>() / 8.0)
}

fn errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(200_000) {
        let (eye, center) = eye_and_center(&mut random);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let (largest, mean) = off((method.run)(eye, center, Vec3::Y), eye, center);
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

fn work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let inputs: Vec<(Vec3, Vec3)> = (0..size).map(|_| eye_and_center(&mut random)).collect();
    let work = |method: &'static Method<View>| {
        let inputs = inputs.clone();
        Work::new(size as f64, move || {
            let views = inputs.iter().filter_map(|&(eye, center)| (method.run)(eye, center, Vec3::Y));
            views.fold(Mat4::ZERO, |sum, m| sum + m)
        })
    };
    METHODS.iter().map(work).collect()
}

/// Eyes that look along up more and more nearly, from all sides. (With up along an axis of the coordinates the
/// products of small numbers lose nothing, and the error would stay at f32's rounding.)
fn stability(effort: Effort) -> Vec<Series> {
    let angles = (0..=14).map(|half| 10f64.powf(-f64::from(half) / 2.0));
    let worst = |method: &Method<View>, angle: f64| {
        let mut random = effort.random();
        let views = (0..effort.samples(400)).map(|_| {
            let up = direction(&mut random);
            let side = up.cross(direction(&mut random)).normalize();
            let eye = ((side * angle.sin() + up * angle.cos()) * 2.0).as_vec3();
            let up = up.as_vec3();
            let Some(got) = (method.run)(eye, Vec3::ZERO, up) else { return f64::INFINITY };
            let exact = basis(eye, Vec3::ZERO, up);
            let rows = [0, 1, 2].map(|row| (got.row(row).truncate().as_dvec3() - exact[row]).length());
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
