//! SIMD: eight pixels of a row go through coverage and depth at once.
//!
//! **Better:** a processor's registers hold four, eight or sixteen numbers, and an instruction for all of them takes as long as
//! one for one. Eight pixels are covered or not by three comparisons and a mask of eight bits, and are as deep as lesson 10
//! says by the same roundings in the same order, so that they are the same to the last bit.
//! **What it costs:** of eight lanes, those outside of a triangle work for nothing, which is most of them where triangles are
//! small. And code must be written for lanes: what one pixel decides by `if` is computed for all and selected.

use common::{Bounds, DVec3};
use fearless_simd::{Simd, f32x8, f64x8, mask32x8, prelude::*};

use crate::blocks::{Cover, SIDE, cover};
use crate::eight::narrow;
use crate::triangle::{Edges, Ready};

/// How deep a triangle is, as lesson 4 computes it: from the nearest corner on, by what the others are more.
#[derive(Clone, Copy)]
pub(crate) struct Depths {
    pub(crate) nearest: f32,
    pub(crate) more: [f32; 3],
}

/// Eight pixels of a row that may be covered.
#[derive(Clone, Copy)]
pub(crate) struct Group<S: Simd> {
    pub(crate) x: i32,
    pub(crate) y: i32,
    /// Those that are covered.
    pub(crate) covered: u8,
    /// The weights of the corners in the picture.
    pub(crate) weights: [f32x8<S>; 3],
}

impl Depths {
    #[inline(always)]
    pub(crate) fn new<C, V>(ready: &Ready<C, V>) -> Self {
        let nearest = ready.z.min_element();
        Self { nearest, more: (ready.z - nearest).to_array() }
    }

    /// At eight pixels.
    #[inline(always)]
    pub(crate) fn at<S: Simd>(&self, simd: S, [x, y, z]: [f32x8<S>; 3]) -> f32x8<S> {
        let [a, b, c] = self.more;
        f32x8::splat(simd, self.nearest) + (x * a + y * b + z * c)
    }
}

/// The weights in the picture at eight pixels, from the edge functions there.
#[inline(always)]
pub(crate) fn weights<S: Simd>(simd: S, edges: [f64x8<S>; 3], per_area: f64) -> [f32x8<S>; 3] {
    edges.map(|edge| narrow(simd, edge * per_area))
}

/// The edge functions at eight pixels, from those at the first.
#[inline(always)]
pub(crate) fn spread<S: Simd>(simd: S, first: DVec3, right: DVec3) -> [f64x8<S>; 3] {
    let lanes = f64x8::from_slice(simd, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    [0, 1, 2].map(|side| lanes * right[side] + first[side])
}

/// Goes through the pixels of a tile that a triangle covers. `wants` is asked once a block, with its lower left pixel and how
/// much of it is covered; `visit` gets eight pixels of a row, of which at least one is covered.
#[inline(always)]
pub(crate) fn raster<S: Simd>(
    simd: S,
    edges: &Edges,
    Bounds { min, max }: Bounds,
    tile: Bounds,
    mut wants: impl FnMut(i32, i32, Cover) -> bool,
    mut visit: impl FnMut(Group<S>),
) {
    // The first pixel of a block: blocks are counted from the tile's corner.
    let first = tile.min + ((min - tile.min) & !(SIDE - 1));
    let up = edges.up;
    for block_y in (first.y..=max.y).step_by(SIDE as usize) {
        let (low, high) = (block_y.max(min.y), max.y.min(block_y + SIDE - 1));
        for x in (first.x..=max.x).step_by(SIDE as usize) {
            let start = edges.at(x, block_y);
            let cover = cover(start, edges.right, up, edges.inside);
            if cover == Cover::Nothing || !wants(x, block_y, cover) {
                continue;
            }
            let mut here = spread(simd, start + up * f64::from(low - block_y), edges.right);
            for y in low..=high {
                let covered = if cover == Cover::Whole { u8::MAX } else { covered(here, edges.inside) };
                if covered != 0 {
                    visit(Group { x, y, covered, weights: weights(simd, here, edges.per_area) });
                }
                here = [here[0] + up.x, here[1] + up.y, here[2] + up.z];
            }
        }
    }
}

/// Which of eight pixels are inside of all three sides.
#[inline(always)]
fn covered<S: Simd>([a, b, c]: [f64x8<S>; 3], inside: DVec3) -> u8 {
    let all = a.simd_ge(inside.x) & b.simd_ge(inside.y) & c.simd_ge(inside.z);
    all.to_bitmask() as u8
}

/// A mask of lanes from bits.
#[inline(always)]
pub(crate) fn mask<S: Simd>(simd: S, bits: u8) -> mask32x8<S> {
    mask32x8::from_bitmask(simd, bits.into())
}
