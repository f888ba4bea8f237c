//! Triangles in the window, each of one colour.

use common::Color;
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
