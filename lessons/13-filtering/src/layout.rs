//! Where a texel is in memory.
//!
//! Memory comes in lines of 64 bytes, sixteen texels of four. By rows, a line holds sixteen texels beside each other: who walks
//! along a row fetches a line for sixteen texels, who walks up a column one for each. A picture seen at an angle is walked
//! in any direction, and a filter wants squares. So textures are kept in squares, of 4×4 texels to a line, or, with the
//! bits of x and y in turn, in squares of squares of any size (G. M. Morton, *A computer oriented geodetic data base*, IBM,
//! 1966; Z. S. Hakura and A. Gupta, *The design and analysis of a cache architecture for texture mapping*, ISCA 1997).

use crate::filter::bilinear;
use crate::footprint::Footprint;
use crate::light::SRGB;
use crate::texture::Level;
use crate::wrap::Wrap;
use common::{Color, Image, Method, Vec2};

/// An order of texels.
pub trait Layout: Copy {
    /// For so many columns and rows, at least 1 each.
    fn new(width: u32, height: u32) -> Self;

    /// How many texels of memory they take, padding counted.
    fn texels(self) -> usize;

    /// Where the texel (x, y) is, below [`texels`](Self::texels).
    fn place(self, x: u32, y: u32) -> usize;
}

// ANCHOR: rows
/// Row after row.
#[derive(Clone, Copy, Debug)]
pub struct Rows {
    width: u32,
    height: u32,
}

impl Layout for Rows {
    fn new(width: u32, height: u32) -> Self {
        Self { width, height }
    }

    fn texels(self) -> usize {
        self.width as usize * self.height as usize
    }

    #[inline]
    fn place(self, x: u32, y: u32) -> usize {
        y as usize * self.width as usize + x as usize
    }
}
// ANCHOR_END: rows

// ANCHOR: tiles
/// Square after square of 4×4 texels, each by rows.
#[derive(Clone, Copy, Debug)]
pub struct Tiles {
    /// Tiles in a row, rows of tiles.
    across: u32,
    up: u32,
}

impl Layout for Tiles {
    fn new(width: u32, height: u32) -> Self {
        Self { across: width.div_ceil(4), up: height.div_ceil(4) }
    }

    fn texels(self) -> usize {
        16 * self.across as usize * self.up as usize
    }

    #[inline]
    fn place(self, x: u32, y: u32) -> usize {
        let tile = (y / 4) as usize * self.across as usize + (x / 4) as usize;
        16 * tile + (4 * (y % 4) + x % 4) as usize
    }
}
// ANCHOR_END: tiles

// ANCHOR: morton
/// The bits of x and y in turn, those of x first, as far as both sides have bits; above them, those of the longer side.
#[derive(Clone, Copy, Debug)]
pub struct Morton {
    /// Bits that both sides have.
    common: u32,
    /// Bits of both sides together.
    all: u32,
}

impl Layout for Morton {
    fn new(width: u32, height: u32) -> Self {
        // Bits of the largest number of a texel.
        let [x, y] = [width, height].map(|side| u32::BITS - (side - 1).leading_zeros());
        Self { common: x.min(y), all: x + y }
    }

    fn texels(self) -> usize {
        1 << self.all
    }

    #[inline]
    fn place(self, x: u32, y: u32) -> usize {
        let mask = (1 << self.common) - 1;
        let rest = (x | y) >> self.common;
        let square = spread(x & mask) | spread(y & mask) << 1;
        (rest as usize) << (2 * self.common) | square as usize
    }
}

/// The lower 16 bits of a number, a 0 above each.
#[inline]
fn spread(n: u32) -> u32 {
    let n = (n | n << 8) & 0x00ff_00ff;
    let n = (n | n << 4) & 0x0f0f_0f0f;
    let n = (n | n << 2) & 0x3333_3333;
    (n | n << 1) & 0x5555_5555
}
// ANCHOR_END: morton

/// Walks over a texture: from a place (u, v), a pixel's footprint at a time to the right, and after so many pixels from the
/// row's beginning up, and puts the `bilinear` colour of each into its place; the texture repeats.
pub type Walk = Box<dyn Fn(Vec2, Footprint, usize, &mut [Color])>;

/// One order of texels, as functions that share their code.
#[derive(Clone, Copy)]
pub struct Keep {
    /// Of so many columns and rows, where the texel (x, y) is.
    pub place: fn([u32; 2], [u32; 2]) -> usize,
    /// Keeps a picture so, and returns how to walk over it.
    pub walk: fn(&Image) -> Walk,
}

impl Keep {
    const fn new<L: Layout + 'static>() -> Self {
        Self { place: |[width, height], [x, y]| L::new(width, height).place(x, y), walk: walk::<L> }
    }
}

/// The ways to keep texels. All give the same colours.
pub const LAYOUTS: &[Method<Keep>] = &[
    Method {
        name: "rows",
        run: Keep::new::<Rows>(),
        promise: "a product and a sum; along a row, sixteen texels to a line of memory",
        failure: "up a column, a line of memory for each texel, up to four times as many as in squares",
    },
    Method {
        name: "tiles-4x4",
        run: Keep::new::<Tiles>(),
        promise: "a line of memory holds a square of 4×4: alike in all directions; at most 3 columns and rows of padding",
        failure: "shifts and masks for each texel; beside the arithmetic of a filter, fewer lines buy no time here",
    },
    Method {
        name: "morton",
        run: Keep::new::<Morton>(),
        promise: "squares of squares: near in the texture is near in memory, whatever the size of line or cache",
        failure: "some thirty operations for each texel; sides are padded to powers of 2, up to 4 times the memory",
    },
];

fn walk<L: Layout + 'static>(image: &Image) -> Walk {
    let level = Level::<L>::new(image, &SRGB);
    Box::new(move |from, step, width, colors| {
        for (y, row) in colors.chunks_mut(width.max(1)).enumerate() {
            for (x, color) in row.iter_mut().enumerate() {
                let uv = from + step.x * x as f32 + step.y * y as f32;
                *color = SRGB.color(bilinear(&level, uv, Wrap::Repeat));
            }
        }
    })
}
