//! SIMD: eight pixels of a row go through coverage and depth at once.
//!
//! **Better:** a processor's registers hold four, eight or sixteen numbers, and an instruction for all of them takes as long as
//! one for one. Eight pixels are covered or not by three comparisons and a mask of eight bits, and are as deep as lesson 10
//! says by the same roundings in the same order, so that they are the same to the last bit.
//! **What it costs:** of eight lanes, those outside of a triangle work for nothing, which is most of them where triangles are
//! small. And code must be written for lanes: what one pixel decides by `if` is computed for all and selected.

use common::{DVec3, Vec3};
use fearless_simd::{Simd, f32x8, f64x8, prelude::*};

use crate::eight::narrow;
use crate::triangle::Edges;

/// The edge functions at eight pixels of a row.
#[derive(Clone, Copy)]
pub(crate) struct Row<S: Simd>([f64x8<S>; 3]);

// Array's own `map` would be compiled without the instructions that these functions are made of.
// ANCHOR: row
impl<S: Simd> Row<S> {
    /// From those at the first pixel.
    #[inline(always)]
    pub(crate) fn new(simd: S, first: DVec3, right: DVec3) -> Self {
        let lanes = f64x8::load_array(simd, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
        Self([lanes * right.x + first.x, lanes * right.y + first.y, lanes * right.z + first.z])
    }

    /// One row up.
    #[inline(always)]
    pub(crate) fn step(&mut self, up: DVec3) {
        let [a, b, c] = self.0;
        self.0 = [a + up.x, b + up.y, c + up.z];
    }

    /// Which of the pixels are inside of all three sides, a bit each.
    #[inline(always)]
    pub(crate) fn covered(&self, inside: DVec3) -> u8 {
        let [a, b, c] = self.0;
        (a.simd_ge(inside.x) & b.simd_ge(inside.y) & c.simd_ge(inside.z)).to_bitmask() as u8
    }

    /// The corners' weights in the picture.
    #[inline(always)]
    pub(crate) fn weights(&self, simd: S, per_area: f64) -> [f32x8<S>; 3] {
        let [a, b, c] = self.0;
        [narrow(simd, a * per_area), narrow(simd, b * per_area), narrow(simd, c * per_area)]
    }
}
// ANCHOR_END: row

/// Numbers that corners have, at eight pixels, from the weights there: measured from the least of them, as lesson 4's
/// `depth_at` has it.
// ANCHOR: from_least
#[inline(always)]
pub(crate) fn from_least<S: Simd>(simd: S, corners: Vec3, [x, y, z]: [f32x8<S>; 3]) -> f32x8<S> {
    let least = corners.min_element();
    let more = corners - least;
    f32x8::splat(simd, least) + (x * more.x + y * more.y + z * more.z)
}
// ANCHOR_END: from_least

impl Edges {
    /// The rows' edge functions from the pixel (x, y) on.
    #[inline(always)]
    pub(crate) fn row<S: Simd>(&self, simd: S, x: i32, y: i32) -> Row<S> {
        Row::new(simd, self.at(x, y), self.right)
    }
}
