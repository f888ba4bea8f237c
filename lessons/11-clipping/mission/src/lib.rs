//! Mission 11: every triangle, wherever the eye is.
//!
//! Write the bodies of [`facing`] and [`clip`], then see what is right: `cargo run -p my-clipping`.
//!
//! What you need:
//!
//! - [`ClipVertex`] has `position: Vec4` and `uv: Vec2`, and is `Copy`; `ClipVertex { position, uv }` makes one.
//! - `a.dot(b)` of two vectors; `a * t`, `a + b`, `a - b` number by number.
//! - `v.xyw()` takes x, y and w out of a `Vec4`, for which you write `use common::Vec4Swizzles;`; `v.as_dvec3()` makes an
//!   `f64` of each number of a `Vec3`. The result, a `DVec3`, has `a.cross(b)` and `a.dot(b)`.
//! - `polygon.len()`, `polygon[i]`; `(i + 1) % polygon.len()` is the corner after the last one, too.
//! - `let mut result = Vec::new();`, `result.push(corner);`.

use common::Vec4;

// Given: corners in clip space, the six planes, and the loop over triangles and pixels.
pub use clipping_given::{ClipVertex, PLANES, draw};

/// Which side of a triangle is seen, by its corners in clip space: above 0 where it faces the eye, which is where its
/// corners run counterclockwise in the picture, below 0 where it faces away, 0 where it is seen edge-on.
///
/// Corners may lie behind the eye, where w is negative, and at its height, where w is 0. Where the terms nearly cancel, the
/// sign is still right: compute in `f64`.
#[must_use]
pub fn facing(corners: [Vec4; 3]) -> f64 {
    let _ = corners;
    todo!("the determinant of three columns, one for each corner: a cross product and a dot product")
}

/// What is left of a polygon on the inner side of a plane of clip space: where `plane.dot(position)` is at least 0, so a
/// corner right on the plane is inside.
///
/// The polygon has no dents, its corners are given in order, and the last one is followed by the first. It has three
/// corners or more, as it may have been cut before, or none, and then nothing is left of it. The corners that are left keep
/// their order. Where a side passes the plane there is a new corner, with its position and its uv as far along the side as
/// the plane is.
///
/// Neighbours walk along a common side in opposite directions and must find the same corner on it, to the last bit.
#[must_use]
pub fn clip(polygon: &[ClipVertex], plane: Vec4) -> Vec<ClipVertex> {
    let _ = (polygon, plane);
    todo!("side by side: its first corner if that is inside, then the cut if only one of its ends is")
}
