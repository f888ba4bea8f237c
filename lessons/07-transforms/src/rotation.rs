//! Three ways to turn about an axis.

use std::ops::{Add, Mul, Sub};

use common::{DMat3, DVec3, Mat3, Method, Quat, Vec3};

use crate::affine::euler;

/// Turns by an angle (in radians) about an axis of length 1, counterclockwise seen from its tip.
pub type Rotate = fn(Vec3, f32) -> Mat3;

/// The ways to turn about an axis.
pub const ROTATIONS: &[Method<Rotate>] = &[
    Method {
        name: "euler",
        run: by_euler,
        promise: "three numbers that people can read",
        failure: "gimbal lock: near a pitch of ±90° two of the angles are one, and precision halves",
    },
    Method {
        name: "rodrigues",
        run: rodrigues,
        promise: "one sine and one cosine; no special axis",
        failure: "1 - cos loses the digits of tiny angles",
    },
    Method {
        name: "quaternion",
        run: |axis, angle| from_quaternion(quaternion(axis, angle)),
        promise: "four numbers, easy to make 1 long and to interpolate; no special axis",
        failure: "two quaternions for each rotation: interpolation may take the long way",
    },
];

/// Rodrigues' formula: u' = cos·u + (1 − cos)·(Δ·u)·Δ + sin·Δ×u, as a matrix (notes, I.1).
#[must_use]
pub fn rodrigues(axis: Vec3, angle: f32) -> Mat3 {
    let (sin, cos) = angle.sin_cos();
    Mat3::from_cols_array(&rodrigues_columns(axis.to_array(), sin, cos))
}

/// [`rodrigues`] in f64.
#[must_use]
pub fn rodrigues_f64(axis: DVec3, angle: f64) -> DMat3 {
    let (sin, cos) = angle.sin_cos();
    DMat3::from_cols_array(&rodrigues_columns(axis.to_array(), sin, cos))
}

/// (1 − c)·ΔΔᵀ + c·I + s·\[Δ\]×, column by column.
// ANCHOR: rodrigues
fn rodrigues_columns<T>([x, y, z]: [T; 3], s: T, c: T) -> [T; 9]
where
    T: Copy + From<f32> + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    let k = T::from(1.0) - c;
    [
        k * x * x + c,
        k * x * y + s * z,
        k * x * z - s * y,
        k * x * y - s * z,
        k * y * y + c,
        k * y * z + s * x,
        k * x * z + s * y,
        k * y * z - s * x,
        k * z * z + c,
    ]
}
// ANCHOR_END: rodrigues

// ANCHOR: quaternion
/// The quaternion of a rotation: sin of half the angle along the axis, and cos of half the angle.
#[must_use]
pub fn quaternion(axis: Vec3, angle: f32) -> Quat {
    let (sin, cos) = (angle / 2.0).sin_cos();
    Quat::from_xyzw(axis.x * sin, axis.y * sin, axis.z * sin, cos)
}
// ANCHOR_END: quaternion

/// The rotation of a quaternion of length 1: the matrix of u ↦ q·u·q*.
#[must_use]
pub fn from_quaternion(q: Quat) -> Mat3 {
    let (x, y, z, w) = (q.x, q.y, q.z, q.w);
    Mat3::from_cols(
        Vec3::new(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)),
        Vec3::new(2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)),
        Vec3::new(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)),
    )
}

// ANCHOR: euler_angles
/// The Euler angles, in degrees, of a rotation: `euler` of them is the rotation again.
///
/// The third column and the second row of Ry·Rx·Rz say how: the element in both is −sin x. At x = ±90° only the
/// sum or difference of the other two is determined; z is then 0.
#[must_use]
pub fn euler_angles(m: Mat3) -> Vec3 {
    let sin_x = (-m.z_axis.y).clamp(-1.0, 1.0);
    let x = sin_x.asin();
    let (y, z) = if sin_x.abs() < 1.0 {
        (m.z_axis.x.atan2(m.z_axis.z), m.x_axis.y.atan2(m.y_axis.y))
    } else {
        ((-m.x_axis.z).atan2(m.x_axis.x), 0.0)
    };
    Vec3::new(x, y, z) * 1f32.to_degrees()
}
// ANCHOR_END: euler_angles

/// By way of the three Euler angles, as a program works that stores orientations so.
fn by_euler(axis: Vec3, angle: f32) -> Mat3 {
    euler(euler_angles(rodrigues(axis, angle)))
}
