//! A smooth sphere under a light, by its equation.

use common::DVec3;

/// The brightness of the unit sphere where it is seen at (x, y) from along z, by Lambert's cosine law: 0 on
/// the dark side. `light` points to the light and has length 1. `None` beside the sphere.
#[must_use]
pub fn intensity(x: f64, y: f64, light: DVec3) -> Option<f64> {
    let square = 1.0 - x * x - y * y;
    // The normal of a unit sphere is the point itself.
    (square >= 0.0).then(|| (x * light.x + y * light.y + square.sqrt() * light.z).max(0.0))
}
