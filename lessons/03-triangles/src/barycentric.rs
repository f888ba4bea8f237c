//! Barycentric weights, and the test of every pixel in the bounding box.
//!
//! Any point of the plane is *P = α·A + β·B + γ·C* with *α + β + γ = 1*, and it is inside the triangle when no
//! weight is negative. Written as *P = A + u·AB + v·AC*, the vector *(u, v, 1)* is at right angles both to
//! *(`ABx`, `ACx`, `PAx`)* and to *(`ABy`, `ACy`, `PAy`)*; so it is along their cross product (slides, *Coordonnées
//! barycentriques*).

use common::{Bounds, Vec2, Vec3};

/// The weights (α, β, γ) of a point, or `None` where the corners lie on one line or are not finite, or so far
/// apart, some 10¹⁹, that their products are not.
// ANCHOR: weights
#[must_use]
pub fn weights([a, b, c]: [Vec2; 3], p: Vec2) -> Option<Vec3> {
    let along = Vec3::new(b.x - a.x, c.x - a.x, a.x - p.x);
    let up = Vec3::new(b.y - a.y, c.y - a.y, a.y - p.y);
    let n = along.cross(up);
    let (u, v) = (n.x / n.z, n.y / n.z);
    let weights = Vec3::new(1.0 - (u + v), u, v);
    (n.z.is_finite() && weights.is_finite()).then_some(weights)
}
// ANCHOR_END: weights

/// Visits the pixels of the bounding box whose centre has no negative weight. A centre on a side is inside
/// for both of its triangles; with f32's rounding, one near a side may be inside for both or for none.
// ANCHOR: barycentric
pub fn barycentric(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    let [a, b, c] = corners;
    let low = a.min(b).min(c).floor().as_ivec2().max(bounds.min);
    let high = a.max(b).max(c).floor().as_ivec2().min(bounds.max);
    for y in low.y..=high.y {
        for x in low.x..=high.x {
            let center = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            if let Some(weights) = weights(corners, center)
                && weights.cmpge(Vec3::ZERO).all()
            {
                visit(x, y, weights);
            }
        }
    }
}
// ANCHOR_END: barycentric
