//! Mission 8: looking at a point.
//!
//! Write the bodies of [`basis`] and [`lookat`], then see what is right: `cargo run -p my-camera`.
//!
//! What you need:
//!
//! - `Mat3::from_cols(x: Vec3, y: Vec3, z: Vec3)` takes columns, `m.transpose()` makes them rows, `Mat4::from_mat3(m)` a
//!   matrix for points.
//! - `a.cross(b)`, which is not 1 long; `v.try_normalize()`: `Some` vector 1 long, or `None` where there is no length. A `?`
//!   behind it returns `None` from your function as well.
//! - [`transforms::translate`]`(by: Vec3) -> Mat4` moves points.

use common::{Mat3, Mat4, Vec3};

/// The matrix whose rows are the eye's basis: z' points from the centre to the eye, x' is at right angles to up
/// and z' and points to the right, y' to both; each is 1 long. `None` where eye and centre are one point.
///
/// The checks have no up along the view; lesson 8 says what to do then.
#[must_use]
pub fn basis(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat3> {
    let _ = (eye, center, up);
    todo!("z' first, then x' and y' as cross products: a × b points to you if b is to the left of a");
}

/// The view matrix of an eye that looks at a centre: a point P gets the coordinates (x'·(P − C), y'·(P − C),
/// z'·(P − C)). The centre becomes the origin. `None` where eye and centre are one point.
#[must_use]
pub fn lookat(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat4> {
    let _ = (eye, center, up);
    todo!("a product of the basis and a translation: which one has to act first?");
}
