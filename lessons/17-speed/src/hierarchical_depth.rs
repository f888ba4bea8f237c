//! Hierarchical depth: a block that hides a triangle hides it whole.
//!
//! **Better:** each block knows how deep the farthest of its pixels is. A triangle that is nowhere nearer in it is rejected with
//! one comparison instead of 64 (N. Greene, M. Kass and G. Miller, *Hierarchical Z-buffer visibility*, SIGGRAPH 1993).
//! **What it costs:** a maximum over a block after each triangle that changed it, and nothing is won back to front.
//!
//! **No pixel that is seen is rejected.** The depth at a pixel is n + (d₀λ₀ + d₁λ₁ + d₂λ₂), n being the nearest corner's depth
//! and d what the others have more, at least 0 like λ. Rounding is monotonic, so the sum in f32 is no less than n: that bound
//! is exact. The second bound is the plane's least depth at the block's corners, in f64. Each dᵢ, λᵢ and dᵢλᵢ is off by at most
//! 2⁻²⁴ of itself, two additions by 2⁻²⁴ each of at most the largest d, which makes 5·2⁻²⁴ of it, with terms below 2⁻⁴⁷; the
//! last addition is off by 2⁻²⁴ of the depth. Eight times 2⁻²⁴ of the sum of both is more than that and than what f64 rounds
//! here. A block's farthest depth is one of its pixels', or more where masked writes left it alone, since depths only become
//! nearer; so what is rejected is no nearer than any pixel of the block, and the test of each would have failed.

use common::{DVec3, Vec3};

use crate::blocks::SIDE;
use crate::triangle::Edges;

/// A triangle's depth as a linear function of a pixel's column and row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    origin: f64,
    right: f64,
    up: f64,
    nearest: f64,
    farthest: f64,
    margin: f64,
}

impl Plane {
    #[inline(always)]
    pub(crate) fn new(edges: &Edges, z: Vec3) -> Self {
        let nearest = z.min_element();
        let more = (z - nearest).as_dvec3();
        let (nearest, span) = (f64::from(nearest), more.max_element());
        let margin = (nearest.abs() + 2.0 * span) * (8.0 / (1 << 24) as f64);
        let per_edge: DVec3 = more * edges.per_area;
        Self {
            origin: nearest + per_edge.dot(edges.origin),
            right: per_edge.dot(edges.right),
            up: per_edge.dot(edges.up),
            nearest,
            farthest: nearest + span + margin,
            margin,
        }
    }

    /// No pixel of the block at (x, y) that the triangle covers is nearer than the first of these, or farther than the second.
    #[inline(always)]
    pub(crate) fn bounds(&self, x: i32, y: i32) -> [f32; 2] {
        const LAST: f64 = (SIDE - 1) as f64;
        let corner = self.origin + self.right * f64::from(x) + self.up * f64::from(y);
        let least = corner + (self.right.min(0.0) + self.up.min(0.0)) * LAST - self.margin;
        let most = corner + (self.right.max(0.0) + self.up.max(0.0)) * LAST + self.margin;
        [least.max(self.nearest) as f32, most.min(self.farthest) as f32]
    }
}
