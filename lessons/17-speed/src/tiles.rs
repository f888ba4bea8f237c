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
use common::{Bounds, IVec2};
use shaders::shader::Shader;

use crate::triangle::Ready;

/// A picture's tiles, row after row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    /// The picture's pixels.
    pub(crate) picture: Bounds,
    /// A tile's side in pixels.
    pub(crate) side: i32,
    /// Tiles in a row.
    pub(crate) across: usize,
    /// How many there are.
    pub(crate) count: usize,
}

impl Grid {
    /// Of a picture with so many columns and rows of pixels.
    pub(crate) fn new(size: [i32; 2], side: i32) -> Self {
        let [across, rows] = size.map(|pixels| (pixels as usize).div_ceil(side as usize));
        let picture = Bounds { min: IVec2::ZERO, max: IVec2::from_array(size) - 1 };
        Self { picture, side, across, count: across * rows }
    }

    /// A tile's pixels, as far as they are in the picture.
    pub(crate) fn tile(&self, number: usize) -> Bounds {
        let min = IVec2::new((number % self.across) as i32, (number / self.across) as i32) * self.side;
        Bounds { min, max: (min + self.side - 1).min(self.picture.max) }
    }
}

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
    /// Sorts those triangles; `pixels` tells which ones of the picture a triangle may reach, `max` below `min` where none.
    pub(crate) fn fill<S: Shader<Constant = C, Varying = V>>(
        &mut self,
        stages: &Stages<S>,
        vertices: &[Computed<V>],
        triangles: impl Iterator<Item = (usize, [u32; 3])>,
        grid: &Grid,
        pixels: impl Fn(&Ready<C, V>) -> Bounds,
    ) {
        let Self { by_tile, counts } = self;
        by_tile.resize_with(grid.count, Vec::new);
        by_tile.iter_mut().for_each(Vec::clear);
        *counts = stages.triangles(vertices, triangles, |constant, corners, varyings| {
            let Some(triangle) = Ready::new(corners, constant, varyings) else { return };
            let Bounds { min, max } = pixels(&triangle);
            if max.cmplt(min).any() {
                return;
            }
            let (first, last) = (min / grid.side, max / grid.side);
            for y in first.y..=last.y {
                for x in first.x..=last.x {
                    by_tile[y as usize * grid.across + x as usize].push(triangle);
                }
            }
        });
    }
}
// ANCHOR_END: sort

/// The first so many of a list, which becomes longer where it has to and never shorter: what it has is used again.
pub(crate) fn at_least<T: Default>(list: &mut Vec<T>, count: usize) -> &mut [T] {
    list.resize_with(list.len().max(count), T::default);
    &mut list[..count]
}

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
