//! The painter's algorithm: what is far first, what is near over it.

use common::{Image, Vec3};
use triangles::fill;

use crate::Surface;

/// Draws the surfaces in the order of their mean depths, the farthest first.
///
/// One number stands for a whole triangle. Where two triangles cut each other no order is right, nor where
/// three cover each other in a circle; and a long triangle can be nearer on the whole but farther here.
// ANCHOR: painter
pub fn painter(surfaces: &[Surface], image: &mut Image) {
    let mean_depth = |surface: &Surface| surface.corners.map(|corner| corner.z / 3.0).iter().sum::<f32>();
    let mut order: Vec<&Surface> = surfaces.iter().collect();
    // Of equal depths the first one is drawn last, so that it stays, as with a depth buffer.
    order.reverse();
    order.sort_by(|a, b| mean_depth(a).total_cmp(&mean_depth(b)));
    for surface in order {
        let corners = surface.corners.map(Vec3::truncate);
        fill(corners, image.bounds(), |x, y, _| image.set(x, y, surface.color));
    }
}
// ANCHOR_END: painter
