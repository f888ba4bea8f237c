//! Mission 3: the pixels that a triangle covers, and how bright it is.
//!
//! Write the bodies of [`fill`] and [`flat_intensity`], then see what is right: `cargo run -p my-triangles`.
//!
//! What you need:
//!
//! - `bounds.min` and `bounds.max`: `IVec2`, the first and the last pixel, both included. So a loop over a row is
//!   `for x in bounds.min.x..=bounds.max.x`.
//! - `a - b` of vectors, `a * n` with a number, `a.min(b)` and `a.max(b)` coordinate by coordinate; `v.floor()`,
//!   `v.as_ivec2()` makes an `IVec2` of a `Vec2`, `x as f32` an `f32` of an `i32`.
//! - `a.perp_dot(b)`: `f32`, a.x·b.y − a.y·b.x, of two `Vec2`: twice the area of the triangle that they span.
//! - Of `Vec3`: `a.cross(b)`, `a.dot(b)`, `a.normalize_or_zero()`, which is 1 long, or 0 where there is no length.
//! - `visit(x: i32, y: i32, weights: Vec3)`; to call it, write `mut visit` among the parameters.

use common::{Bounds, Vec2, Vec3};

/// Calls `visit(x, y, weights)` once for each pixel in `bounds` that the triangle covers.
///
/// Corners are in pixels and come in any order. A pixel is covered when its centre (x + ½, y + ½) is inside.
/// The weights say how much each corner counts there: each is at least 0, their sum is 1, and a point is the
/// sum of the corners times their weights. The weight of a corner is the area of the triangle that the point
/// makes with the other two corners, divided by the whole. A triangle without area covers nothing; any other may
/// cover a centre, however small it is.
///
/// A centre exactly on a side belongs to the triangle if the side is a left one or a level top one, so that of
/// two neighbours one has it: this last check is the hardest, leave it for the end.
pub fn fill(corners: [Vec2; 3], bounds: Bounds, visit: impl FnMut(i32, i32, Vec3)) {
    let _ = (corners, bounds, visit);
    todo!(
        "for each pixel of the corners' bounding box, cut down to the bounds, compute the weights and visit \
         it if none is below 0"
    );
}

/// How bright a triangle is: the cosine of the angle between its normal and the direction to the light.
///
/// 1 means that it faces the light, below 0 that it faces away. Corners run counterclockwise seen from outside.
/// `light` has length 1 and points from the surface to the light. A triangle without area has intensity 0.
#[must_use]
pub fn flat_intensity([a, b, c]: [Vec3; 3], light: Vec3) -> f32 {
    let _ = (a, b, c, light);
    todo!(
        "the normal is along the cross product of two sides, in which order? make it 1 long; the cosine is \
         a dot product"
    );
}
