//! A tile: a rectangle of the picture, with the depths, colours and triangles of its pixels.

use common::{Bounds, Color, IVec2, Image};

use crate::blocks::SIDE;
use crate::eight::packed;

/// No triangle.
pub(crate) const NONE: u32 = u32::MAX;

/// A rectangle of the picture. Rows are padded to whole blocks.
#[derive(Debug)]
pub(crate) struct Tile {
    /// Its pixels.
    pub(crate) bounds: Bounds,
    /// Pixels in a row of memory.
    pub(crate) stride: usize,
    pub(crate) depths: Vec<f32>,
    pub(crate) colors: Vec<u32>,
    /// For each pixel which triangle is seen, until it is shaded.
    pub(crate) seen: Vec<u32>,
    /// For each block how deep the farthest is that is seen in it, or less.
    pub(crate) farthest: Vec<f32>,
    /// Whether anything was drawn.
    pub(crate) is_used: bool,
}

impl Tile {
    pub(crate) fn new(bounds: Bounds) -> Self {
        let size = bounds.max - bounds.min + SIDE;
        let [stride, rows] = [size.x, size.y].map(|side| (side / SIDE * SIDE) as usize);
        let pixels = stride * rows;
        Self {
            bounds,
            stride,
            depths: vec![1.0; pixels],
            colors: vec![0; pixels],
            seen: vec![NONE; pixels],
            farthest: vec![1.0; pixels / (SIDE * SIDE) as usize],
            is_used: false,
        }
    }

    /// Before the first triangle: what is in it from an earlier picture is forgotten.
    pub(crate) fn open(&mut self, background: u32) {
        if !self.is_used {
            self.is_used = true;
            self.depths.fill(1.0);
            self.colors.fill(background);
            self.farthest.fill(1.0);
        }
    }

    /// Where a pixel is in memory.
    #[inline(always)]
    pub(crate) fn place(&self, x: i32, y: i32) -> usize {
        (y - self.bounds.min.y) as usize * self.stride + (x - self.bounds.min.x) as usize
    }

    /// The number of the block whose lower left pixel this is.
    #[inline(always)]
    pub(crate) fn block(&self, x: i32, y: i32) -> usize {
        let IVec2 { x, y } = (IVec2::new(x, y) - self.bounds.min) / SIDE;
        y as usize * (self.stride / SIDE as usize) + x as usize
    }
}

/// A picture in tiles.
#[derive(Debug)]
pub(crate) struct Tiles {
    pub(crate) picture: Bounds,
    pub(crate) side: i32,
    pub(crate) across: usize,
    pub(crate) tiles: Vec<Tile>,
    background: u32,
}

impl Tiles {
    /// Of so many pixels, tiles of that side, a multiple of a block's.
    pub(crate) fn new(width: i32, height: i32, side: i32) -> Self {
        let picture = Bounds { min: IVec2::ZERO, max: IVec2::new(width, height) - 1 };
        let starts = |end: i32| (0..end).step_by(side as usize);
        let tile = |x: i32, y: i32| {
            let min = IVec2::new(x, y);
            Tile::new(Bounds { min, max: (min + side - 1).min(picture.max) })
        };
        let tiles = starts(height).flat_map(|y| starts(width).map(move |x| tile(x, y))).collect();
        Self { picture, side, across: starts(width).len(), tiles, background: 0 }
    }

    /// Forgets what was drawn, for the price of a bit a tile.
    pub(crate) fn clear(&mut self, background: Color) {
        self.background = packed(background);
        self.tiles.iter_mut().for_each(|tile| tile.is_used = false);
    }

    pub(crate) fn background(&self) -> u32 {
        self.background
    }

    /// The tiles, from the first to the last column and row, that hold some of these pixels.
    #[inline(always)]
    pub(crate) fn touched(&self, pixels: Bounds) -> Bounds {
        Bounds { min: pixels.min / self.side, max: pixels.max / self.side }
    }

    /// Copies all pixels to a picture of that size.
    pub(crate) fn copy_to(&self, image: &mut Image) {
        let bytes = image.bytes_per_pixel();
        let width = image.width() as usize;
        for tile in &self.tiles {
            let Bounds { min, max } = tile.bounds;
            let pixels = (max.x - min.x + 1) as usize;
            for y in min.y..=max.y {
                let start = (y as usize * width + min.x as usize) * bytes;
                let to = &mut image.buffer_mut()[start..start + pixels * bytes];
                let place = tile.place(min.x, y);
                let from = &tile.colors[place..place + pixels];
                let background = [self.background; 1];
                let _ = background;
                for (to, &color) in to.chunks_exact_mut(bytes).zip(from) {
                    let color = if tile.is_used { color } else { self.background };
                    to.copy_from_slice(&color.to_le_bytes()[..bytes]);
                }
            }
        }
    }
}
