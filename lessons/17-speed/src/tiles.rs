//! Tiles: what is drawn to stays in the cache.
//!
//! **Better:** depths and colours of a whole picture are larger than a processor's nearest cache, and triangles come from all over
//! it. Those of 64×64 pixels fit. So triangles are sorted by the tiles that they reach into, and tile after tile is drawn
//! (H. Fuchs and others, *Pixel-planes 5*, SIGGRAPH 1989). A tile is cleared when the first triangle is drawn to it.
//! **What it costs:** no pixel is drawn before the last triangle is known, all triangles are kept, and one that reaches over
//! many tiles is made ready in each.

use std::ops::Range;

use clipping::Counts;
use clipping::render::{Computed, Stages};
use common::Bounds;

use crate::frame::Shared;
use crate::tile::Canvas;
use crate::triangle::Ready;

/// Some of a drawing's triangles: for each tile those that reach into it, in the order in which they are to be drawn. They are
/// kept there themselves, not by number: of a million in random places, each one's memory would have to be waited for. Memory is
/// used again.
pub(crate) struct Sorted<C, V> {
    pub(crate) by_tile: Vec<Vec<Ready<C, V>>>,
    /// What became of the triangles.
    pub(crate) counts: Counts,
}

impl<C, V> Default for Sorted<C, V> {
    fn default() -> Self {
        Self { by_tile: Vec::new(), counts: Counts::default() }
    }
}

// ANCHOR: sort
impl<C: Copy, V: Copy> Sorted<C, V> {
    /// Sorts those triangles.
    pub(crate) fn fill<W: Shared<Constant = C, Varying = V>>(
        &mut self,
        stages: &Stages<W>,
        vertices: &[Computed<V>],
        triangles: impl Iterator<Item = (usize, [u32; 3])>,
        canvas: &Canvas,
    ) {
        let Self { by_tile, counts } = self;
        by_tile.resize_with(canvas.tiles.len(), Vec::new);
        by_tile.iter_mut().for_each(Vec::clear);
        *counts = stages.triangles(vertices, triangles, |constant, corners, varyings| {
            let Some(triangle) = Ready::new(corners, constant, varyings) else { return };
            let bounds = triangle.bounds(canvas.picture);
            if bounds.max.cmplt(bounds.min).any() {
                return;
            }
            let Bounds { min, max } = canvas.touched(bounds);
            for y in min.y..=max.y {
                for x in min.x..=max.x {
                    by_tile[y as usize * canvas.across + x as usize].push(triangle);
                }
            }
        });
    }
}
// ANCHOR_END: sort

/// Bits of a triangle's number among those of a part and a tile; the bits above tell the part.
pub(crate) const BITS: u32 = 24;

/// In how many parts so many triangles are sorted, and which are in each: one part for one thread, some more than threads else,
/// so that none waits long for another, and as many as keep a triangle's number within its bits, cuts counted.
pub(crate) fn parts(triangles: usize, threads: usize) -> (usize, impl Fn(usize) -> Range<usize>) {
    const MOST: usize = 1 << (BITS - 3);
    const LEAST: usize = 256;
    let wanted = if threads > 1 { (4 * threads).min(triangles / LEAST) } else { 1 };
    let count = wanted.clamp(triangles.div_ceil(MOST).max(1), 255);
    (count, move |n| triangles * n / count..triangles * (n + 1) / count)
}
