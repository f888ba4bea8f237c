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
//! last addition is off by 2⁻²⁴ of the depth, and so is the bound when it becomes an f32. Eight times 2⁻²⁴ of the sum of both is
//! more than that. In f64 large numbers may cancel, since a needle's edge functions are many times its area: fewer than 32
//! roundings by 2⁻⁵³ of the largest are less than 2⁻⁴⁸ of it. Below the least normal f32 a rounding is off by up to 2⁻¹⁵⁰,
//! however small the number is, and that least one is more than these. A block's farthest depth is one of its pixels', or more
//! where masked writes left it alone, since depths only become nearer; so what is rejected is no nearer than any pixel of the
//! block, and the test of each would have failed.

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

// ANCHOR: plane
impl Plane {
    #[inline(always)]
    pub(crate) fn new(edges: &Edges, z: Vec3) -> Self {
        let nearest = z.min_element();
        let more = (z - nearest).as_dvec3();
        let (nearest, span) = (f64::from(nearest), more.max_element());
        let per_edge: DVec3 = more * edges.per_area;
        // No picture is wider or higher.
        let largest = edges.origin.abs() + (edges.right.abs() + edges.up.abs()) * f64::from(1 << 16);
        let margin = (nearest.abs() + 2.0 * span) * (8.0 / (1 << 24) as f64)
            + per_edge.dot(largest) / (1_u64 << 48) as f64
            + f64::from(f32::MIN_POSITIVE);
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
// ANCHOR_END: plane

#[cfg(test)]
mod tests {
    use common::Vec4;
    use zbuffer::depth_at;

    use super::*;
    use crate::triangle::Ready;

    /// Lesson 4's depths of all pixels that a triangle covers in a block are within the block's bounds, however near the corners'
    /// depths are to each other and however far the corners; and the bounds tell more than the corners do.
    #[test]
    fn no_pixel_is_nearer_or_farther_than_its_block_says() {
        // From 0 to 1, by Knuth's generator.
        let mut state = 17_u64;
        let mut share = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f32 / (1 << 24) as f32
        };
        let (mut pixels, mut blocks, mut tighter) = (0, 0, 0);
        for round in 0..30_000 {
            let reach = [12.0, 40.0, 3000.0, 30_000.0][round % 4];
            let tilt = [1.0, 1e-3, 1e-6, 2e-7, 6e-8, 0.0][round % 6];
            let base = [0.0, 0.1, 0.5, 0.999][round % 5 % 4];
            let corners = [(); 3].map(|()| {
                let [x, y] = [share(), share()].map(|share| 16.0 + reach * (share - 0.5));
                Vec4::new(x, y, (base + tilt * share()).min(1.0), 1.0)
            });
            let Some(triangle) = Ready::new(corners, (), [(); 3]) else { continue };
            let Some(edges) = triangle.edges() else { continue };
            let plane = Plane::new(&edges, triangle.z);
            let nearest = triangle.z.min_element();
            for (x, y) in (0..4).flat_map(|j| (0..4).map(move |i| (SIDE * i, SIDE * j))) {
                let [least, most] = plane.bounds(x, y);
                blocks += 1;
                tighter += u32::from(least > nearest);
                for (x, y) in (y..y + SIDE).flat_map(|y| (x..x + SIDE).map(move |x| (x, y))) {
                    let here = edges.at(x, y);
                    if here.cmpge(edges.inside).all() {
                        let depth = depth_at(triangle.z, (here * edges.per_area).as_vec3());
                        assert!(
                            (least..=most).contains(&depth),
                            "({x}, {y}), {corners:?}: {least} {depth} {most}"
                        );
                        pixels += 1;
                    }
                }
            }
        }
        assert!(pixels > 1_000_000 && tighter * 4 > blocks, "{pixels}, {tighter} of {blocks}");
    }

    /// Needles of hardly any area, up to the rim of a large picture, that cover the centre of a pixel: numbers that cancel
    /// are as large as can be. The pixel is a corner of its block, where nothing else keeps the bound low.
    #[test]
    fn no_covered_pixel_is_beyond_the_bounds() {
        let mut state = 17_u64;
        let mut random = |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % below) as i64
        };
        let mut covered = 0;
        for _ in 0..20_000 {
            let pixel = [0; 2].map(|_| (random(3800) * 8 + 7 * random(2)) as i32);
            let [x, y] = pixel.map(|place| i64::from(place) * 256 + 128);
            // In the middle of a side along (u, v), and from there far away a point next to its line.
            let (u, v) = (random(40) - 20, random(40) - 20);
            let near = (-40..40).flat_map(|s| (-40..40).map(move |t| [s, t]));
            let Some([s, t]) = near.into_iter().find(|&[s, t]| u * t - v * s == 1) else { continue };
            let far = random(1 << 18);
            let [b, c] = [[x - u, y - v], [x + u, y + v]];
            let a = [x + far * u + s, y + far * v + t];
            let depths = [0; 3].map(|_| random(1 << 20) as f32 / (1 << 20) as f32);
            let corner = |[x, y]: [i64; 2], z: f32| Vec4::new(x as f32 / 256.0, y as f32 / 256.0, z, 1.0);
            let corners = [corner(a, depths[0]), corner(b, depths[1]), corner(c, depths[2])];
            let Some(edges) = Ready::new(corners, (), [(); 3]).and_then(|ready| ready.edges()) else {
                continue;
            };
            let at = edges.at(pixel[0], pixel[1]);
            if at.cmplt(edges.inside).any() {
                continue;
            }
            covered += 1;
            let z = Vec3::from(depths);
            let depth = depth_at(z, (at * edges.per_area).as_vec3());
            let block = pixel.map(|place| place / SIDE * SIDE);
            let [least, most] = Plane::new(&edges, z).bounds(block[0], block[1]);
            assert!(least <= depth && depth <= most, "{corners:?}: {depth} is not within {least} and {most}");
        }
        assert!(covered > 1000, "{covered}");
    }
}
