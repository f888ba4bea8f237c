//! Triangles in the window, each of one colour, and what is behind them.

use common::{Color, Image};
use shaders::target::Target;
use zbuffer::{Surface, fill_depths};

/// Draws triangles in the order given; their corners are x and y in pixels and z the depth.
// ANCHOR: plain
pub fn draw(surfaces: &[Surface], target: &mut impl Target<Color>) {
    let bounds = target.bounds();
    for &Surface { corners, color } in surfaces {
        fill_depths(corners, bounds, |x, y, depth, _| {
            if target.test(x, y, depth) {
                target.write(x, y, depth, color);
            }
        });
    }
}
// ANCHOR_END: plain

/// Fills a picture with one colour.
pub fn clear_to(image: &mut Image, color: Color) {
    let (width, height) = (image.width(), image.height());
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        image.set(x, y, color);
    }
}
