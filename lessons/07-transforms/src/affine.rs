//! The affine maps: move, scale, shear, turn; and what they do to normals.
//!
//! A linear map fixes the origin, so moving is none. With a fourth coordinate that is 1 it becomes one: the
//! fourth column is added. A vector has w = 0, and moving leaves it alone, as it should (slides, *Coordonnées
//! homogènes*; notes, I.1).

use common::{Mat3, Mat4, Vec3};

use crate::inverse::cofactors;

// ANCHOR: translate
/// Moves points by a vector.
#[must_use]
pub fn translate(by: Vec3) -> Mat4 {
    let mut m = Mat4::IDENTITY;
    m.w_axis = by.extend(1.0);
    m
}
// ANCHOR_END: translate

/// Stretches along the axes, the origin staying where it is.
#[must_use]
pub fn scale(by: Vec3) -> Mat4 {
    Mat4::from_diagonal(by.extend(1.0))
}

/// Slants along x: x' = x + `by_y`·y + `by_z`·z.
#[must_use]
pub fn shear_x(by_y: f32, by_z: f32) -> Mat4 {
    let mut m = Mat4::IDENTITY;
    m.y_axis.x = by_y;
    m.z_axis.x = by_z;
    m
}

/// Turns about the x axis, from y towards z; the angle in degrees.
#[must_use]
pub fn rotate_x(degrees: f32) -> Mat3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Mat3::from_cols(Vec3::X, Vec3::new(0.0, cos, sin), Vec3::new(0.0, -sin, cos))
}

/// Turns about the y axis, from z towards x; the angle in degrees.
#[must_use]
pub fn rotate_y(degrees: f32) -> Mat3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Mat3::from_cols(Vec3::new(cos, 0.0, -sin), Vec3::Y, Vec3::new(sin, 0.0, cos))
}

/// Turns about the z axis, from x towards y; the angle in degrees.
#[must_use]
pub fn rotate_z(degrees: f32) -> Mat3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Mat3::from_cols(Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0), Vec3::Z)
}

// ANCHOR: euler
/// Turns by Euler angles in degrees: about z first, then x, then y.
#[must_use]
pub fn euler(degrees: Vec3) -> Mat3 {
    rotate_y(degrees.y) * rotate_x(degrees.x) * rotate_z(degrees.z)
}
// ANCHOR_END: euler

// ANCHOR: model
/// Places a model: scales it, turns it by Euler angles in degrees, moves it; T·Ry·Rx·Rz·S.
#[must_use]
pub fn model(translation: Vec3, degrees: Vec3, size: Vec3) -> Mat4 {
    translate(translation) * Mat4::from_mat3(euler(degrees)) * scale(size)
}
// ANCHOR_END: model

// ANCHOR: about
/// Does about a point what `m` does about the origin: moves the point there, applies `m`, moves it back.
#[must_use]
pub fn about(point: Vec3, m: Mat4) -> Mat4 {
    translate(point) * m * translate(-point)
}
// ANCHOR_END: about

// ANCHOR: normal_matrix
/// What turns normals as `m` turns surfaces: the inverse transpose. `None` where `m` flattens space.
///
/// A tangent t becomes M·t; n'·(M·t) must stay n·t = 0, and n' = M⁻ᵀ·n does it (notes, I.1). The length of
/// the result is not 1.
#[must_use]
pub fn normal_matrix(m: &Mat4) -> Option<Mat3> {
    cofactors(&Mat4::from_mat3(Mat3::from_mat4(*m))).map(|inverse| Mat3::from_mat4(inverse.transpose()))
}
// ANCHOR_END: normal_matrix
