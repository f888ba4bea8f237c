//! Mission 10: a true camera.
//!
//! Write the bodies of [`frustum`] and [`perspective_weights`], then see what is right: `cargo run -p my-perspective`.
//!
//! What you need:
//!
//! - `Mat4::from_cols(x: Vec4, y: Vec4, z: Vec4, w: Vec4)` takes **columns**, `m.transpose()` makes rows of them.
//!   `Vec4::new(x, y, z, w)`.
//! - `f32::INFINITY` is a number that one can calculate with: `1.0 / f32::INFINITY` is 0, `f32::INFINITY / f32::INFINITY`
//!   is NaN. `x.is_finite()` is false for both.
//! - A comparison with NaN is false: `!(a < b)` is true where `a` is not below `b`, and where one of the two is NaN.
//! - `Some(matrix)` and `None`; `matrix.is_finite()`, whether all of its entries are.
//! - Vectors are multiplied and divided number by number: `a * b`, `a / 2.0`; `v.element_sum()` is x + y + z.

use common::{Mat4, Vec3};

// Given: the view with the eye as its origin, the way to the window, and the loop over triangles and pixels.
pub use perspective_given::{draw, to_window, view};

/// The matrix from eye space, where the camera looks along −z, to clip space: w becomes −z, the depth before the eye;
/// the depth `n` becomes z = −w, the depth `f` z = w; and on the plane at the depth `n`, the rectangle from `l` to `r` and
/// from `b` to `t` becomes −w ≤ x ≤ w and −w ≤ y ≤ w.
///
/// `f` may be infinite, or too large to be multiplied by `n`: then the matrix is what it tends to.
///
/// `None` where there is no such matrix: unless 0 < `n` < `f`, or where `l` is `r`, or `b` is `t`, or any number but `f` is
/// infinite, or any is NaN, or an entry is too large for an `f32`. (With `l` > `r` there is one, and its picture is
/// mirrored.)
#[must_use]
pub fn frustum(l: f32, r: f32, b: f32, t: f32, n: f32, f: f32) -> Option<Mat4> {
    let _ = (l, r, b, t, n, f);
    todo!(
        "four rows: two bring [l, r] and [b, t] to [-1, 1], one has the depths' two entries, the last makes w; \
         before you write f down, divide by it"
    );
}

/// How much each corner of a triangle counts on the triangle itself, at a pixel where it counts `weights` in the picture.
/// `inverse_w` are the corners' 1/w, the reciprocals of their depths, all above 0.
///
/// The results add up to 1. Corners that are all equally deep count as in the picture; at a corner it alone counts.
#[must_use]
pub fn perspective_weights(weights: Vec3, inverse_w: Vec3) -> Vec3 {
    let _ = (weights, inverse_w);
    todo!("what is near counts more than in the picture; and what comes out has to add up to 1 again");
}
