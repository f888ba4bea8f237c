//! A tile: the samples of 32×32 pixels.

use blending::blend::BlendStage;
use blending::{Over, TwoShift};
use common::{Bounds, IVec2};
use fearless_simd::{Simd, mask32x8, prelude::*, u32x8};

use super::samples::{ALL, SAMPLES};
use crate::blocks::SIDE as BLOCK;
use crate::eight::{merged, packed, unpacked};
use crate::tile::write_rgb;
use crate::triangle::Ready;

/// A tile's side in pixels.
pub(crate) const SIDE: i32 = 32;

/// How many pixels it has.
pub(crate) const PIXELS: usize = (SIDE * SIDE) as usize;

/// How many blocks of 8×8 pixels it has.
const BLOCKS: usize = PIXELS / (BLOCK * BLOCK) as usize;

/// What the depths of a block's samples are.
#[derive(Clone, Copy)]
pub(crate) enum Known {
    /// All as far as can be.
    Cleared,
    /// Those of a triangle that covers the whole block.
    Of(Ready<(), ()>),
    /// What is written in the tile.
    Written,
}

/// The samples of a rectangle of the picture.
pub(crate) struct Tile {
    /// Its pixels.
    pub(crate) bounds: Bounds,
    /// The depths of each pixel's samples, in blocks where they are written.
    pub(crate) depths: Vec<[f32; SAMPLES]>,
    pub(crate) known: [Known; BLOCKS],
    /// The colour of a pixel whose samples all have it.
    one: Vec<u32>,
    /// The colours of a pixel that has several.
    several: Vec<[u32; SAMPLES]>,
    has_several: Vec<bool>,
}

impl Default for Tile {
    fn default() -> Self {
        Self {
            bounds: Bounds { min: IVec2::ZERO, max: IVec2::ZERO },
            depths: vec![[1.0; SAMPLES]; PIXELS],
            known: [Known::Cleared; BLOCKS],
            one: vec![0; PIXELS],
            several: vec![[0; SAMPLES]; PIXELS],
            has_several: vec![false; PIXELS],
        }
    }
}

impl Tile {
    /// Forgets what was drawn.
    pub(crate) fn clear(&mut self, background: u32) {
        self.known.fill(Known::Cleared);
        self.one.fill(background);
        self.has_several.fill(false);
    }

    /// Where a pixel is in memory.
    #[inline(always)]
    pub(crate) fn place(&self, x: i32, y: i32) -> usize {
        ((y - self.bounds.min.y) * SIDE + x - self.bounds.min.x) as usize
    }

    /// The number of the block that a pixel is in.
    #[inline(always)]
    pub(crate) fn block(&self, x: i32, y: i32) -> usize {
        ((y - self.bounds.min.y) / BLOCK * (SIDE / BLOCK) + (x - self.bounds.min.x) / BLOCK) as usize
    }

    /// The pixel in that place.
    #[inline(always)]
    pub(crate) fn pixel(&self, place: usize) -> IVec2 {
        self.bounds.min + IVec2::new(place as i32 % SIDE, place as i32 / SIDE)
    }

    /// Gives their colours to eight pixels of a row to which nothing was drawn yet.
    #[inline(always)]
    pub(crate) fn paint_row(&mut self, place: usize, colors: [u32; 8]) {
        self.one[place..place + 8].copy_from_slice(&colors);
    }

    /// Gives those samples of a pixel a colour whose bits are set.
    #[inline(always)]
    pub(crate) fn paint<S: Simd>(&mut self, simd: S, place: usize, samples: u32, color: u32) {
        if samples == ALL {
            self.one[place] = color;
            self.has_several[place] = false;
            return;
        }
        let several = self.split(place);
        for (n, half) in several.as_chunks_mut::<8>().0.iter_mut().enumerate() {
            let mask = mask32x8::from_bitmask(simd, (samples >> (8 * n) & 0xff).into());
            let mixed = merged(simd, mask, u32x8::splat(simd, color), u32x8::load_array(simd, *half));
            mixed.store_array(half);
        }
    }

    /// Lays a colour over those samples.
    #[inline(always)]
    pub(crate) fn blend(&mut self, place: usize, samples: u32, color: u32) {
        let over = |kept: u32| packed(Over(TwoShift).color(unpacked(color), unpacked(kept)));
        if samples == ALL && !self.has_several[place] {
            self.one[place] = over(self.one[place]);
            return;
        }
        let several = self.split(place);
        (0..SAMPLES).filter(|s| samples >> s & 1 == 1).for_each(|s| several[s] = over(several[s]));
    }

    /// The colours of a pixel, a place for each sample.
    #[inline(always)]
    fn split(&mut self, place: usize) -> &mut [u32; SAMPLES] {
        let several = &mut self.several[place];
        if !self.has_several[place] {
            self.has_several[place] = true;
            *several = [self.one[place]; SAMPLES];
        }
        several
    }

    /// Writes the tile's pixels into a row of tiles, three bytes a pixel: the mean of the samples, as lesson 15 rounds it.
    #[inline(always)]
    pub(crate) fn resolve<S: Simd>(&mut self, simd: S, row: &mut [u8], width: usize) {
        for (place, several) in self.several.iter().enumerate() {
            if self.has_several[place] {
                self.one[place] = mean(simd, several);
            }
        }
        let Bounds { min, max } = self.bounds;
        let columns = 3 * (max.x - min.x + 1) as usize;
        let rows = row.chunks_mut(3 * width).zip(self.one.chunks(SIDE as usize));
        for (row, colors) in rows.take((max.y - min.y + 1) as usize) {
            write_rgb(colors, &mut row[3 * min.x as usize..][..columns]);
        }
    }
}

/// The mean of sixteen colours: bytes 0 and 2, and bytes 1 and 3, are added up side by side, as no sum has more than 12 bits.
#[inline(always)]
fn mean<S: Simd>(simd: S, colors: &[u32; SAMPLES]) -> u32 {
    const EVEN: u32 = 0x00ff_00ff;
    let [low, high] = [0, 8].map(|n| u32x8::from_slice(simd, &colors[n..n + 8]));
    let sum = |shift: u32| {
        let halves = (low >> shift & EVEN) + (high >> shift & EVEN);
        let sum: u32 = halves.as_slice().iter().sum();
        (sum + 0x0008_0008) >> 4 & EVEN
    };
    sum(0) | sum(8) << 8
}
