//! Tiles: what is drawn to stays in the cache.
//!
//! **Better:** depths and colours of a whole picture are larger than a processor's nearest cache, and triangles come from all over
//! it. Those of 64×64 pixels fit. So triangles are sorted by the tiles that they reach into, and tile after tile is drawn
//! (H. Fuchs and others, *Pixel-planes 5*, SIGGRAPH 1989; graphics chips of telephones do it to this day). A tile is cleared
//! when the first triangle is drawn to it.
//! **What it costs:** no pixel is drawn before the last triangle is known, all triangles are kept, and one that reaches over
//! many tiles is made ready in each.

use std::ops::Range;

use clipping::Counts;
use clipping::render::{Computed, Stages};
use common::Bounds;

use crate::frame::Shared;
use crate::tile::Tiles;
use crate::triangle::Ready;

/// Some of a drawing's triangles, and for each tile the numbers of those that reach into it, in the order in which they are to
/// be drawn. Memory is used again.
pub(crate) struct Sorted<C, V> {
    pub(crate) ready: Vec<Ready<C, V>>,
    pub(crate) by_tile: Vec<Vec<u32>>,
}

impl<C, V> Default for Sorted<C, V> {
    fn default() -> Self {
        Self { ready: Vec::new(), by_tile: Vec::new() }
    }
}

impl<C: Copy, V: Copy> Sorted<C, V> {
    /// Sorts those triangles.
    pub(crate) fn fill<W: Shared<Constant = C, Varying = V>>(
        &mut self,
        stages: &Stages<W>,
        vertices: &[Computed<V>],
        triangles: impl Iterator<Item = (usize, [u32; 3])>,
        tiles: &Tiles,
    ) -> Counts {
        let Self { ready, by_tile } = self;
        ready.clear();
        by_tile.resize_with(tiles.tiles.len(), Vec::new);
        by_tile.iter_mut().for_each(Vec::clear);
        stages.triangles(vertices, triangles, |constant, corners, varyings| {
            let Some(triangle) = Ready::new(corners, constant, varyings) else { return };
            let bounds = triangle.bounds(tiles.picture);
            if bounds.max.cmplt(bounds.min).any() {
                return;
            }
            let number = ready.len() as u32;
            ready.push(triangle);
            let Bounds { min, max } = tiles.touched(bounds);
            for y in min.y..=max.y {
                for x in min.x..=max.x {
                    by_tile[y as usize * tiles.across + x as usize].push(number);
                }
            }
        })
    }
}

/// Bits of a triangle's number within its part; those above tell the part.
pub(crate) const BITS: u32 = 24;

/// Splits so many triangles into parts: one for one thread, some more than threads else, so that none waits long for another,
/// and as many as keep the numbers of triangles within their bits, cuts counted.
pub(crate) fn parts(triangles: usize, threads: usize) -> Vec<Range<usize>> {
    const MOST: usize = 1 << (BITS - 3);
    const LEAST: usize = 256;
    let wanted = if threads > 1 { (4 * threads).min(triangles / LEAST) } else { 1 };
    let count = wanted.clamp(triangles.div_ceil(MOST).max(1), 255);
    (0..count).map(|n| triangles * n / count..triangles * (n + 1) / count).collect()
}
