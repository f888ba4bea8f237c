//! Tiles of the picture, and their blocks.

use common::{Bounds, Color};
use fearless_simd::{Simd, f32x8, prelude::*};

use crate::blocks::SIDE;
use crate::eight::{packed, unpacked};
use crate::tiles::Grid;

/// No triangle.
pub(crate) const NONE: u32 = u32::MAX;

/// What is known of eight by eight pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    /// No pixel is nearer.
    pub(crate) nearest: f32,
    /// No pixel is farther.
    pub(crate) farthest: f32,
    /// The triangle that is seen in all of it; then the pixels' own depths and triangles are yet to be written.
    pub(crate) whole: u32,
    /// Whether there is something to be shaded.
    pub(crate) is_seen: bool,
    /// Whether a pixel has changed since `farthest` was looked for.
    pub(crate) has_changed: bool,
}

const EMPTY: Block = Block { nearest: 1.0, farthest: 1.0, whole: NONE, is_seen: false, has_changed: false };

/// A square of the picture, or what of it is in the picture, in whole blocks. Its pixels are kept row after row, and eight more
/// at the end, so that eight can be read from each.
#[derive(Debug)]
pub(crate) struct Tile {
    /// Its place among all.
    pub(crate) number: usize,
    /// Its pixels, as far as they are in the picture.
    pub(crate) bounds: Bounds,
    /// Columns.
    pub(crate) stride: usize,
    /// Whether anything was drawn since the picture was cleared.
    pub(crate) is_used: bool,
    pub(crate) blocks: Vec<Block>,
    pub(crate) depths: Vec<f32>,
    pub(crate) colors: Vec<u32>,
    /// Which triangle is seen, and yet to be shaded.
    pub(crate) seen: Vec<u32>,
    /// The weights of its corners in the picture.
    pub(crate) weights: [Vec<f32>; 3],
}

impl Tile {
    /// At those pixels; `is_deferred` where triangles are kept.
    fn new(number: usize, bounds: Bounds, is_deferred: bool) -> Self {
        const SIDE: usize = crate::blocks::SIDE as usize;
        let [columns, rows] =
            (bounds.max - bounds.min + 1).to_array().map(|side| (side as usize).next_multiple_of(SIDE));
        let pixels = columns * rows + SIDE;
        let kept = if is_deferred { pixels } else { 0 };
        Self {
            number,
            bounds,
            stride: columns,
            is_used: false,
            blocks: vec![EMPTY; columns / SIDE * (rows / SIDE)],
            depths: vec![1.0; pixels],
            colors: vec![0; pixels],
            seen: vec![NONE; kept],
            weights: [(); 3].map(|()| vec![0.0; kept]),
        }
    }

    /// Before the first triangle of a picture: forgets the last one.
    pub(crate) fn open(&mut self, background: u32) {
        if !self.is_used {
            self.is_used = true;
            self.blocks.fill(EMPTY);
            self.depths.fill(1.0);
            self.colors.fill(background);
        }
    }

    /// Where a pixel is in memory.
    #[inline(always)]
    pub(crate) fn place(&self, x: i32, y: i32) -> usize {
        (y - self.bounds.min.y) as usize * self.stride + (x - self.bounds.min.x) as usize
    }

    /// Where a block is in memory: its column and row are counted from the tile's corner.
    #[inline(always)]
    pub(crate) fn block(&self, i: i32, j: i32) -> usize {
        j as usize * (self.stride / SIDE as usize) + i as usize
    }

    /// Looks for the nearest and the farthest depth of a block if it has changed.
    #[inline(always)]
    pub(crate) fn measure<S: Simd>(&mut self, simd: S, block: usize, place: usize) {
        let block = &mut self.blocks[block];
        if !block.has_changed {
            return;
        }
        let rows = &self.depths[place..];
        let first = f32x8::from_slice(simd, &rows[..8]);
        let (mut least, mut most) = (first, first);
        for n in 1..SIDE as usize {
            let row = f32x8::from_slice(simd, &rows[n * self.stride..][..8]);
            (least, most) = (least.min(row), most.max(row));
        }
        block.nearest = least.as_array().iter().copied().fold(f32::INFINITY, f32::min);
        block.farthest = most.as_array().iter().copied().fold(f32::NEG_INFINITY, f32::max);
        block.has_changed = false;
    }
}

/// A picture in tiles.
#[derive(Debug)]
pub(crate) struct Canvas {
    pub(crate) grid: Grid,
    pub(crate) tiles: Vec<Tile>,
    pub(crate) background: u32,
    /// A tile's row where nothing was drawn.
    empty: Vec<u32>,
}

impl Canvas {
    /// Of so many pixels, in tiles of a side that is a multiple of a block's.
    pub(crate) fn new(size: [i32; 2], side: i32, is_deferred: bool) -> Self {
        let grid = Grid::new(size, side);
        let tiles = (0..grid.count).map(|number| Tile::new(number, grid.tile(number), is_deferred)).collect();
        Self { grid, tiles, background: 0, empty: vec![0; side as usize] }
    }

    /// Forgets what was drawn.
    pub(crate) fn clear(&mut self, background: Color) {
        self.background = packed(background);
        self.empty.fill(self.background);
        self.tiles.iter_mut().for_each(|tile| tile.is_used = false);
    }

    /// Copies a row to a picture, pixels of so many bytes each.
    pub(crate) fn copy_row(&self, y: usize, to: &mut [u8], bytes: usize) {
        let Grid { side, across, .. } = self.grid;
        let first = y / side as usize * across;
        let parts = to.chunks_mut(side as usize * bytes);
        for (tile, to) in self.tiles[first..first + across].iter().zip(parts) {
            if tile.is_used {
                write(&tile.colors[tile.place(tile.bounds.min.x, y as i32)..], to, bytes);
            } else {
                write(&self.empty, to, bytes);
            }
        }
    }
}

/// Writes colours as pixels of so many bytes each.
fn write(colors: &[u32], to: &mut [u8], bytes: usize) {
    match bytes {
        4 => to.as_chunks_mut().0.iter_mut().zip(colors).for_each(|(to, color)| *to = color.to_le_bytes()),
        3 => write_rgb(colors, to),
        _ => to.iter_mut().zip(colors).for_each(|(to, &color)| *to = unpacked(color).luma()),
    }
}

/// Writes colours as pixels of three bytes each: four pixels are three words.
#[inline(always)]
pub(crate) fn write_rgb(colors: &[u32], to: &mut [u8]) {
    let (fours, rest) = to.as_chunks_mut::<12>();
    let last = &colors[4 * fours.len()..];
    for (to, [a, b, c, d]) in fours.iter_mut().zip(colors.as_chunks().0) {
        let words = [a & 0x00ff_ffff | b << 24, b >> 8 & 0xffff | c << 16, c >> 16 & 0xff | d << 8];
        to.as_chunks_mut().0.copy_from_slice(&words.map(u32::to_le_bytes));
    }
    for (to, color) in rest.as_chunks_mut().0.iter_mut().zip(last) {
        let [r, g, b, _] = color.to_le_bytes();
        *to = [r, g, b];
    }
}
