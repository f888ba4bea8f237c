//! Mission 2: a model's edges.
//!
//! Write the bodies of [`to_pixel`] and [`wireframe`], then see what is right: `cargo run -p my-wireframe`.
//!
//! `model.faces()` gives the three corners of each triangle, `[Vec3; 3]`. [`lines::line`] draws a segment;
//! write `use lines::line;` to call it by its name.

use common::{Color, IVec2, Image, Model, Vec3};

/// The pixel in which a point of the model lies: x from −1 to 1 becomes a column from 0 to width − 1, y a row
/// from 0 to height − 1; z is dropped.
///
/// The column is ⌊(x + 1)·width/2⌋. Exactly at x = 1 that is `width`, one too many: there it is width − 1. What
/// lies beyond ±1 lies beyond the picture.
#[must_use]
pub fn to_pixel(point: Vec3, image: &Image) -> IVec2 {
    let _ = (point, image);
    todo!(
        "stretch x and y from [−1, 1] to the picture's size and cut off with floor(), not with `as i32` \
         alone"
    );
}

/// Draws the three sides of each triangle of the model.
pub fn wireframe(model: &Model, image: &mut Image, color: Color) {
    let _ = (model, image, color);
    todo!(
        "turn each triangle's corners into pixels and draw three lines between them, the last one back to \
         the first"
    );
}
