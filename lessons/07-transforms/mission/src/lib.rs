//! Mission 7: from the model to the picture, by products of matrices.
//!
//! Write the bodies of [`viewport`], [`projection`] and [`place`], then see what is right:
//! `cargo run -p my-transforms`.
//!
//! What you need:
//!
//! - Vectors are columns, `m * v`, so that of a product the rightmost matrix acts first. `Mat4::IDENTITY` is a matrix;
//!   `m.x_axis`, …, `m.w_axis` are its columns, each a `Vec4`; `m.z_axis.w` is column z, row w, an `f32`.
//! - [`translate`]`(by: Vec3) -> Mat4` moves, [`scale`]`(by: Vec3) -> Mat4` stretches.
//! - `point.extend(1.0)`: a `Vec4`, with w = 1; `*m * v` with a reference to a matrix. `v.truncate()` is the `Vec3` of x, y
//!   and z, as is `v.xyz()`, for which you write `use common::Vec4Swizzles;`.
//! - `Some(place)` and `None`; `1.0 / f32::INFINITY` is 0.

use common::{Mat4, Vec3};

// Given: moving and stretching.
pub use transforms_given::{scale, translate};

/// Stretches [−1, 1]² over a picture of that size in pixels: the middle goes to the middle, and a length of 1
/// becomes `zoom` times the side. Depth stays.
#[must_use]
pub fn viewport(width: f32, height: f32, zoom: f32) -> Mat4 {
    let _ = (width, height, zoom);
    todo!("a product of translate() and scale(): which one acts first?");
}

/// Projects onto the plane z = 0 as seen from (0, 0, d): x' = x / (1 − z/d), so w = 1 − z/d. For d = ∞ this is
/// the identity.
#[must_use]
pub fn projection(d: f32) -> Mat4 {
    let _ = d;
    todo!("Mat4::IDENTITY but for one entry: the row that makes w has to take z/d off");
}

/// The place of a point under a matrix, after division by w; `None` at the eye's height and behind it, where
/// w ≤ 1e-6.
#[must_use]
pub fn place(m: &Mat4, point: Vec3) -> Option<Vec3> {
    let _ = (m, point);
    todo!("a point has w = 1 before the product; after it, divide by what w has become");
}
