//! A texture as filters read it: its levels, each half as large as the one before.

use std::sync::OnceLock;

use common::{Color, Format, Image, Vec2, Vec4};

use crate::layout::{Layout, Rows};
use crate::light::Codes;
use crate::wrap::Wrap;

/// A picture made ready to be filtered, whatever it was made for.
///
/// A picture without pixels is one black texel here.
pub struct Level<L = Rows> {
    width: i32,
    height: i32,
    layout: L,
    lines: Vec<Line>,
    codes: &'static Codes,
    lights: OnceLock<Vec<Vec4>>,
}

/// A line of memory, 64 bytes from an address that 64 divides: what a processor fetches at once.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Line([Color; 16]);

impl<L: Layout> Level<L> {
    /// The pixels of a picture, whose codes mean light as told.
    #[must_use]
    pub fn new(image: &Image, codes: &'static Codes) -> Self {
        let (width, height) = (image.width(), image.height());
        if width == 0 || height == 0 {
            return Self::new(&Image::new(1, 1, Format::Rgb), codes);
        }
        let layout = L::new(width as u32, height as u32);
        let mut lines = vec![Line([Color::BLACK; 16]); layout.texels().div_ceil(16)];
        for (x, y, color) in image.pixels() {
            let place = layout.place(x as u32, y as u32);
            lines[place / 16].0[place % 16] = color;
        }
        Self { width, height, layout, lines, codes, lights: OnceLock::new() }
    }

    /// Columns, at least 1.
    #[inline]
    #[must_use]
    pub fn width(&self) -> i32 {
        self.width
    }

    /// Rows, at least 1.
    #[inline]
    #[must_use]
    pub fn height(&self) -> i32 {
        self.height
    }

    /// Columns and rows, as numbers to compute with.
    #[inline]
    #[must_use]
    pub fn size(&self) -> Vec2 {
        Vec2::new(self.width as f32, self.height as f32)
    }

    /// What its codes mean.
    #[inline]
    #[must_use]
    pub fn codes(&self) -> &'static Codes {
        self.codes
    }

    /// The texel in column i and row j, both from 0, rows from the bottom.
    ///
    /// # Panics
    /// Outside, unless that is the place of another texel in memory.
    #[inline]
    #[must_use]
    pub fn texel(&self, i: i32, j: i32) -> Color {
        debug_assert!((0..self.width).contains(&i) && (0..self.height).contains(&j));
        self.at(self.layout.place(i as u32, j as u32))
    }

    /// The texel at a place in memory, as the layout tells places.
    ///
    /// # Panics
    /// Beyond the last.
    #[inline]
    #[must_use]
    pub fn at(&self, place: usize) -> Color {
        self.lines[place / 16].0[place % 16]
    }

    /// The light of each texel, red, green and blue from 0 to 255, and alpha, in the layout's order: decoded when this is first
    /// asked for, 16 bytes each.
    #[inline]
    #[must_use]
    pub fn lights(&self) -> &[Vec4] {
        self.lights.get_or_init(|| {
            let texels = self.lines.iter().flat_map(|line| line.0);
            texels.map(|color| self.codes.light(color)).collect()
        })
    }
}

/// A texture: the picture itself, level 0, and, as far as they were made, smaller ones, each side of them half as long as
/// in the level before, rounded down, but at least 1 (*mipmaps*: L. Williams, *Pyramidal parametrics*, SIGGRAPH 1983).
pub struct Texture<L = Rows> {
    levels: Vec<Level<L>>,
    /// What it is outside of itself.
    pub wrap: Wrap,
}

impl<L: Layout> Texture<L> {
    /// Of a picture alone.
    #[must_use]
    pub fn new(image: &Image, wrap: Wrap, codes: &'static Codes) -> Self {
        Self::of_levels(std::slice::from_ref(image), wrap, codes)
    }

    /// Of levels that were made.
    ///
    /// # Panics
    /// Where there is none.
    #[must_use]
    pub fn of_levels(images: &[Image], wrap: Wrap, codes: &'static Codes) -> Self {
        assert!(!images.is_empty(), "a texture has at least one level");
        Self { levels: images.iter().map(|image| Level::new(image, codes)).collect(), wrap }
    }

    /// The picture itself.
    #[inline]
    #[must_use]
    pub fn base(&self) -> &Level<L> {
        &self.levels[0]
    }

    /// All its levels, from the picture itself on.
    #[inline]
    #[must_use]
    pub fn levels(&self) -> &[Level<L>] {
        &self.levels
    }
}
