//! Mission 1: the pixels of a line segment.
//!
//! Write the body of [`line()`], then see what is right: `cargo run -p my-lines`.
//!
//! What you need:
//!
//! - `a.x`, `a.y`, `b.x`, `b.y`: whole pixels, `i32`. The origin is bottom-left, y points up. For large numbers,
//!   `i64::from(a.x)` and back, `x as i32`.
//! - `image.set(x: i32, y: i32, color: Color)` colours a pixel; outside the picture it does nothing.
//! - `n.abs()` and `n.signum()` (−1, 0 or 1) of whole numbers, `std::mem::swap(&mut a, &mut b)`.

use common::{Color, IVec2, Image};

/// Draws the segment from `a` to `b`, both included.
///
/// There is one pixel at each step along the longer side: max(|dx|, |dy|) + 1 in all, none more than half a
/// pixel from the ideal line. From `b` to `a` they are the same pixels: order the ends by their coordinate on
/// the longer side first, and where the line is exactly half-way between two pixels, stay on the side of
/// the end that comes first.
///
/// The ends may be millions of pixels outside the picture, where `f32` no longer tells neighbours apart.
pub fn line(a: IVec2, b: IVec2, image: &mut Image, color: Color) {
    let _ = (a, b, image, color);
    todo!(
        "walk along the longer side, one pixel a step, and keep the error in whole numbers: add 2·rise a \
         step, and once it is more than the length, move across by one and take 2·length off"
    );
}
