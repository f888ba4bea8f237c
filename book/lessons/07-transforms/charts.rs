//! Lesson 7: rotations, many of them, and inverses.

use checks::{matrix, turn};
use common::{Mat3, Mat4, Method, Vec3};
use fastrand::Rng;
use transforms::inverse::{INVERSES, Invert};
use transforms::rotation::{ROTATIONS, Rotate};
use transforms::{Compose, METHODS};

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

/// Half a pixel where a length of 1 takes up half of 800 px.
const HALF_PIXEL: (f64, &str) = (0.5 / 400.0, "within ½ px of 800");

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "07-transforms",
    job: "Lesson 7, a million rotations composed",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "how far a unit vector ends from where it should",
        unit: "of its length",
        limit: HALF_PIXEL,
    },
    further: &["skew"],
    samples: "10⁶ products of a rotation by a random angle about a random axis",
    exhaustive: false,
    proved: &[],
    errors: compose_errors,
    timed: "10⁶ products of a rotation",
    throughput: "Mop/s",
    work: compose_work,
    sizes: Sizes { name: "products", all: &[1, 10, 100, 1000, 10_000, 100_000, 1_000_000], usual: 1_000_000 },
    stability: Stability {
        stress: "number of products",
        falling: false,
        error: Quantity {
            name: "how far a unit vector ends from where it should",
            unit: "of its length",
            limit: HALF_PIXEL,
        },
        measure: compose_stability,
    },
    wrong: &[],
    advice: &[
        ("f64", "more than some 10,000 products"),
        ("f32", "fewer"),
        ("f32-renormalised", "fewer than some 50,000, where nothing may shrink or shear"),
    ],
};

pub(crate) const ROTATIONS_CHART: Chart = Chart {
    name: "07-transforms-rotations",
    job: "Lesson 7, turning about an axis",
    methods: || ROTATIONS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "how far a unit vector ends from where it should",
        unit: "of its length",
        limit: HALF_PIXEL,
    },
    further: &[],
    samples: "random axes and angles, every fourth with a pitch within 10⁻⁴ to 1° of ±90°",
    exhaustive: false,
    proved: &[],
    errors: rotation_errors,
    timed: "1,000 matrices from axis and angle",
    throughput: "Mop/s",
    work: rotation_work,
    sizes: Sizes { name: "matrices", all: &[1000], usual: 1000 },
    stability: Stability {
        stress: "angle between the pitch and the pole at 90°, degrees",
        falling: true,
        error: Quantity {
            name: "how far a unit vector ends from where it should",
            unit: "of its length",
            limit: (1e-5, "10⁻⁵"),
        },
        measure: rotation_stability,
    },
    wrong: &[],
    advice: &[
        ("rodrigues", "an axis and an angle"),
        ("quaternion", "what is stored, interpolated or composed"),
        ("euler", "what people type, away from a pitch of ±90°"),
    ],
};

pub(crate) const INVERSES_CHART: Chart = Chart {
    name: "07-transforms-inverses",
    job: "Lesson 7, undoing a matrix",
    methods: || INVERSES.iter().map(|method| method.name).collect(),
    error: Quantity { name: "error of an entry", unit: "of the largest", limit: HALF_PIXEL },
    further: &[],
    samples: "moves × rotations × scales from ½ to 2; every other one graded: rotation × diag(1, c⁻½, 1/c) × rotation, c from 1 to 10⁶",
    exhaustive: false,
    proved: &[],
    errors: inverse_errors,
    timed: "1,000 such matrices",
    throughput: "Mop/s",
    work: inverse_work,
    sizes: Sizes { name: "matrices", all: &[1000], usual: 1000 },
    stability: Stability {
        stress: "condition number of the matrix",
        falling: false,
        error: Quantity { name: "largest error of an entry", unit: "of the largest", limit: HALF_PIXEL },
        measure: inverse_stability,
    },
    wrong: &["transpose"],
    advice: &[
        ("elimination", "anything but rotations with a move, where accuracy counts"),
        ("cofactors", "the same, with scales that differ by less than some 100"),
        ("transpose", "rotations with a move: the camera"),
    ],
};

/// A random direction, of length 1 as nearly as f32 has it.
fn direction(random: &mut Rng) -> Vec3 {
    loop {
        let v = Vec3::from_array([0; 3].map(|_| random.f32() * 2.0 - 1.0));
        if (0.01..1.0).contains(&v.length_squared()) {
            return v.as_dvec3().normalize().as_vec3();
        }
    }
}

fn angle(random: &mut Rng) -> f32 {
    (random.f32() * 2.0 - 1.0) * std::f32::consts::PI
}

/// Where many turns by an angle end, about an axis that is 1 long as nearly as f32 has it.
fn composed(method: &Method<Compose>, axis: Vec3, angle: f32, count: u32) -> (f64, f64) {
    let got = (method.run)(axis, angle, count);
    (turn::error(&got, axis.as_dvec3(), f64::from(angle) * f64::from(count)), turn::skew(&got))
}

fn compose_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), METHODS_CHART.further.len());
    for _ in 0..effort.samples(300) {
        let (axis, angle) = (direction(&mut random), angle(&mut random));
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let (off, skew) = composed(method, axis, angle, 1_000_000);
            errors.add(off, off, &[skew]);
        }
    }
    errors
}

fn compose_work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let inputs: Vec<(Vec3, f32)> =
        (0..(1000 / size).max(1)).map(|_| (direction(&mut random), angle(&mut random))).collect();
    let amount = (inputs.len() * size) as f64;
    let work = |method: &'static Method<Compose>| {
        let inputs = inputs.clone();
        let count = size as u32;
        Work::new(amount, move || {
            inputs
                .iter()
                .map(|&(axis, angle)| (method.run)(axis, angle, count))
                .fold(Mat3::ZERO, |sum, m| sum + m)
        })
    };
    METHODS.iter().map(work).collect()
}

fn compose_stability(effort: Effort) -> Vec<Series> {
    let counts =
        (0..=if effort.quick { 12 } else { 14 }).map(|half| 10f64.powf(f64::from(half) / 2.0) as u32);
    let worst = |method: &Method<Compose>, count: u32| {
        let mut random = effort.random();
        let turns = (0..12).map(|_| composed(method, direction(&mut random), angle(&mut random), count).0);
        turns.fold(0.0, f64::max)
    };
    METHODS
        .iter()
        .map(|method| counts.clone().map(|count| (f64::from(count), worst(method, count))).collect())
        .collect()
}

fn rotated(method: &Method<Rotate>, axis: Vec3, angle: f32) -> f64 {
    turn::error(&(method.run)(axis, angle), axis.as_dvec3(), f64::from(angle))
}

fn rotation_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(ROTATIONS.len(), 0);
    for n in 0..effort.samples(1_000_000) {
        let (axis, angle) = if n % 4 == 3 {
            let distance = 10f64.powf(-4.0 * random.f64());
            near_pole(&mut random, distance)
        } else {
            (direction(&mut random), angle(&mut random))
        };
        for (method, errors) in ROTATIONS.iter().zip(&mut errors) {
            let off = rotated(method, axis, angle);
            errors.add(off, off, &[]);
        }
    }
    errors
}

fn rotation_work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let inputs: Vec<(Vec3, f32)> = (0..size).map(|_| (direction(&mut random), angle(&mut random))).collect();
    let work = |rotate: Rotate, amount: usize| {
        let inputs = inputs.clone();
        Work::new(amount as f64, move || {
            inputs.iter().map(|&(axis, angle)| rotate(axis, angle)).fold(Mat3::ZERO, |sum, m| sum + m)
        })
    };
    let nothing = work(|axis, _| Mat3::from_diagonal(axis), 0);
    std::iter::once(nothing).chain(ROTATIONS.iter().map(|method| work(method.run, size))).collect()
}

/// A turn whose Euler angles have a pitch that many degrees from 90°: about x by almost a quarter turn, and then
/// about y.
fn near_pole(random: &mut Rng, distance: f64) -> (Vec3, f32) {
    let heading = random.f64() * std::f64::consts::TAU;
    let pitch = (90.0 - distance).to_radians();
    // The product of the two turns is a turn about one axis: that of the product of their quaternions.
    let q = glam::DQuat::from_rotation_y(heading) * glam::DQuat::from_rotation_x(pitch);
    let (axis, angle) = q.to_axis_angle();
    (axis.as_vec3(), angle as f32)
}

/// Turns with a pitch nearer and nearer to 90°.
fn rotation_stability(effort: Effort) -> Vec<Series> {
    let distances = (-4..=12).map(|half| 10f64.powf(-f64::from(half) / 2.0));
    let worst = |method: &Method<Rotate>, distance: f64| {
        let mut random = effort.random();
        let turns = (0..effort.samples(400)).map(|_| {
            let (axis, angle) = near_pole(&mut random, distance);
            rotated(method, axis, angle)
        });
        turns.fold(0.0, f64::max)
    };
    ROTATIONS
        .iter()
        .map(|method| distances.clone().map(|distance| (distance, worst(method, distance))).collect())
        .collect()
}

/// A matrix with entries in whole 2⁻²⁶, and the same times 2²⁶ in whole numbers.
fn whole(m: &Mat4) -> (Mat4, matrix::Whole) {
    let rows: matrix::Whole =
        [0, 1, 2, 3].map(|row| m.row(row).to_array().map(|entry| (f64::from(entry) * SCALE).round() as i128));
    let mut rounded = Mat4::ZERO;
    for (row, entries) in rows.iter().enumerate() {
        for (column, entry) in entries.iter().enumerate() {
            // f32 holds 24 bits: what has more is rounded here, and the whole number with it.
            rounded.col_mut(column)[row] = (*entry as f64 / SCALE) as f32;
        }
    }
    let exact =
        [0, 1, 2, 3].map(|row| rounded.row(row).to_array().map(|entry| (f64::from(entry) * SCALE) as i128));
    (rounded, exact)
}

/// Steps of an entry in 1.
const SCALE: f64 = (1 << 26) as f64;

/// The error of an inverse; infinite where there is none.
fn inverted(method: &Method<Invert>, m: &Mat4, exact: Option<&(matrix::Whole, i128)>) -> f64 {
    match ((method.run)(m), exact) {
        // The whole matrix is 2²⁶ times as large, so its inverse is as much smaller.
        (Some(got), Some(exact)) => matrix::error(&(got * (1.0 / SCALE) as f32), exact),
        _ => f64::INFINITY,
    }
}

/// Moves × rotation × scale.
fn affine(random: &mut Rng) -> Mat4 {
    let turned = transforms::rotation::rodrigues(direction(random), angle(random));
    let moved = transforms::translate(Vec3::from_array([0; 3].map(|_| random.f32() * 2.0 - 1.0)));
    let size = Vec3::from_array([0; 3].map(|_| 4f32.powf(random.f32() - 0.5)));
    moved * Mat4::from_mat3(turned) * transforms::scale(size)
}

fn inverse_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(INVERSES.len(), 0);
    for n in 0..effort.samples(100_000) {
        let m = if n % 2 == 0 {
            affine(&mut random)
        } else {
            let condition = 1e6f64.powf(random.f64());
            graded(&mut random, condition)
        };
        let (m, scaled) = whole(&m);
        let exact = matrix::inverse(&scaled);
        for (method, errors) in INVERSES.iter().zip(&mut errors) {
            let off = inverted(method, &m, exact.as_ref());
            errors.add(off, off, &[]);
        }
    }
    errors
}

fn inverse_work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let inputs: Vec<Mat4> = (0..size).map(|_| affine(&mut random)).collect();
    let work = |invert: Invert, amount: usize| {
        let inputs = inputs.clone();
        Work::new(amount as f64, move || inputs.iter().filter_map(invert).fold(Mat4::ZERO, |sum, m| sum + m))
    };
    let nothing = work(|m| Some(*m), 0);
    std::iter::once(nothing).chain(INVERSES.iter().map(|method| work(method.run, size))).collect()
}

/// Rotation × diag(1, c^−½, 1/c) × rotation: a matrix of condition c whose three scales are apart.
fn graded(random: &mut Rng, condition: f64) -> Mat4 {
    let turns = [(); 2].map(|()| {
        let (axis, angle) = (direction(random), angle(random));
        Mat4::from_mat3(transforms::rotation::rodrigues(axis, angle))
    });
    let scales = Vec3::new(1.0, condition.sqrt().recip() as f32, condition.recip() as f32);
    turns[0] * transforms::scale(scales) * turns[1]
}

/// Matrices of larger and larger condition.
fn inverse_stability(effort: Effort) -> Vec<Series> {
    let conditions = (0..=11).map(|half| 10f64.powf(f64::from(half) / 2.0));
    let worst = |method: &Method<Invert>, condition: f64| {
        let mut random = effort.random();
        let samples = (0..effort.samples(400)).map(|_| {
            let (m, scaled) = whole(&graded(&mut random, condition));
            inverted(method, &m, matrix::inverse(&scaled).as_ref())
        });
        samples.fold(0.0, f64::max)
    };
    INVERSES
        .iter()
        .map(|method| conditions.clone().map(|condition| (condition, worst(method, condition))).collect())
        .collect()
}
