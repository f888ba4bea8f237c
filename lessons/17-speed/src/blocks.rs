//! Blocks: eight by eight pixels are accepted or rejected at once.
//!
//! **Better:** lesson 3 divides three times a row to find its ends. An edge function is linear, so over a square it is largest
//! and smallest at two of the four corners, and which these are hangs on the side alone: six additions tell that a block lies
//! outside of a side, or inside of all three, and only what a side passes through is asked pixel by pixel (J. Pineda, *A
//! parallel algorithm for polygon rasterization*, SIGGRAPH 1988; M. Abrash, *Rasterization on Larrabee*, 2009).
//! **What it costs:** a block is asked for where one pixel would do: small triangles gain nothing. By itself the method is
//! slower than rows with ends; what it buys is a place for all that the next ones do once a block.

use common::{Bounds, DVec3, IVec2, Vec2, Vec3, Vec4, Vec4Swizzles};
use perspective::interpolation::{Interpolation, Pixels, relative};
use perspective::perspective_weights;
use shaders::shader::Varying;
use triangles::edges::Setup;
use zbuffer::depth_at;

/// A block's side in pixels.
pub const SIDE: i32 = 8;

/// How much of a block a triangle covers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cover {
    /// None of its pixels.
    Nothing,
    /// All of them.
    Whole,
    /// Perhaps some: they are to be asked one by one.
    Part,
}

/// How much of a block is covered, from the three edge functions at the centre of its lower left pixel, what a pixel to the
/// right and one up add to them, and the least value that is inside: see [`Setup`]. Where all are whole numbers below 2⁵³
/// nothing is rounded, so `Nothing` and `Whole` are never wrong.
// ANCHOR: cover
#[inline]
#[must_use]
pub fn cover(edges: DVec3, right: DVec3, up: DVec3, inside: DVec3) -> Cover {
    cover_within(f64::from(SIDE - 1), edges, right, up, inside)
}

/// The same of a square that is so many pixels wide, from the edge functions at its lower left corner.
#[inline]
pub(crate) fn cover_within(width: f64, edges: DVec3, right: DVec3, up: DVec3, inside: DVec3) -> Cover {
    let most = edges + (right.max(DVec3::ZERO) + up.max(DVec3::ZERO)) * width;
    let least = edges + (right.min(DVec3::ZERO) + up.min(DVec3::ZERO)) * width;
    if most.cmplt(inside).any() {
        Cover::Nothing
    } else if least.cmpge(inside).all() {
        Cover::Whole
    } else {
        Cover::Part
    }
}
// ANCHOR_END: cover

/// Calls `visit(x, y, weights)` for each pixel in `bounds` that a triangle covers, block by block, as lesson 3's `fill` does
/// row by row.
// ANCHOR: fill
pub fn fill(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    let Some(setup) = Setup::new(corners, bounds) else { return };
    if setup.is_wide() {
        return triangles::fill(corners, bounds, visit);
    }
    let Setup { bounds: Bounds { min, max }, right, up, inside, per_area, .. } = setup;
    for y in (min.y..=max.y).step_by(SIDE as usize) {
        for x in (min.x..=max.x).step_by(SIDE as usize) {
            let mut start = setup.edges + right * f64::from(x - min.x) + up * f64::from(y - min.y);
            let cover = cover(start, right, up, inside);
            if cover == Cover::Nothing {
                continue;
            }
            let end = max.min(IVec2::new(x, y) + SIDE - 1);
            for y in y..=end.y {
                let mut edges = start;
                for x in x..=end.x {
                    if cover == Cover::Whole || edges.cmpge(inside).all() {
                        visit(x, y, (edges * per_area).as_vec3());
                    }
                    edges += right;
                }
                start += up;
            }
        }
    }
}
// ANCHOR_END: fill

/// Lesson 10's way to interpolate, over blocks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Blocks;

impl Interpolation for Blocks {
    #[inline]
    fn fill<V: Varying>(
        self,
        corners: [Vec4; 3],
        varyings: [V; 3],
        bounds: Bounds,
        mut pixels: impl Pixels<V>,
    ) {
        let z = Vec3::from_array(corners.map(|corner| corner.z));
        let Some(inverse_w) = relative(corners).filter(|_| z.is_finite()) else { return };
        fill(corners.map(Vec4::xy), bounds, |x, y, weights| {
            let varying = || V::interpolate(varyings, perspective_weights(weights, inverse_w));
            pixels.pixel(x, y, depth_at(z, weights), varying);
        });
    }
}
