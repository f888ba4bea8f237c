//! Mission 2: a model's edges.
//!
//! Write the bodies of [`to_pixel`] and [`wireframe`], then see what is right: `cargo run -p my-wireframe`.
//!
//! What you need:
//!
//! - `point.x`, `point.y`: `f32`; `f64::from(point.x)` makes an `f64` of it. `x.floor()` is the whole number below, still
//!   a float, `x as i32` a whole number cut off towards 0, `IVec2::new(x, y)` a pixel of two `i32`.
//! - `image.width()` and `image.height()`: `i32`.
//! - `model.faces()`: an iterator over the three corners of each triangle, `[Vec3; 3]`.
//! - [`lines::line`]`(a: IVec2, b: IVec2, image: &mut Image, color: Color)` draws a segment; write `use lines::line;` to
//!   call it by its name.

use common::{Color, IVec2, Image, Model, Vec3};

/// The pixel in which a point of the model lies: x from −1 to 1 becomes a column from 0 to width − 1, y a row
/// from 0 to height − 1; z is dropped.
///
/// The column is ⌊(x + 1)·width/2⌋. Exactly at x = 1 that is `width`, one too many: there it is width − 1. What
/// lies beyond ±1 lies beyond the picture.
///
/// Compute it in `f64`: in `f32`, x + 1 drops the last bits of x, and a point next to a pixel's border moves across it.
#[must_use]
pub fn to_pixel(point: Vec3, image: &Image) -> IVec2 {
    let _ = (point, image);
    todo!(
        "stretch x and y from [−1, 1] to the picture's size and cut off with floor(), not with `as i32` \
         alone"
    );
}

/// Draws the three sides of each triangle of the model, also where a corner lies beyond the picture: `line` draws what
/// is inside.
pub fn wireframe(model: &Model, image: &mut Image, color: Color) {
    let _ = (model, image, color);
    todo!(
        "turn each triangle's corners into pixels and draw three lines between them, the last one back to \
         the first"
    );
}
