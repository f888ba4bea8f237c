//! An 8-bit picture in memory.
//!
//! The origin is the bottom-left corner and y points up, as in the mathematics; files are written the
//! right way up all the same. Pixel (x, y) is the square [x, x+1) × [y, y+1).

use std::ops::Range;

use glam::{IVec2, Vec2};

use crate::Color;

/// What a pixel consists of; as a number, its size in bytes.
// ANCHOR: format
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Grey, one byte.
    Gray = 1,
    /// Red, green, blue.
    Rgb = 3,
    /// Red, green, blue, alpha.
    Rgba = 4,
}
// ANCHOR_END: format

/// A rectangle of whole pixels, both corners included. It is empty where `max` is below `min`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// Bottom-left pixel.
    pub min: IVec2,
    /// Top-right pixel.
    pub max: IVec2,
}

impl Bounds {
    /// Every pixel that has 32-bit coordinates.
    pub const EVERYTHING: Self = Self { min: IVec2::MIN, max: IVec2::MAX };

    /// Whether the pixel (x, y) lies in the rectangle.
    #[must_use]
    pub fn contains(self, x: i32, y: i32) -> bool {
        (self.min.x..=self.max.x).contains(&x) && (self.min.y..=self.max.y).contains(&y)
    }
}

/// A picture of up to 65535×65535 pixels, black at first.
///
/// Outside the picture [`set`](Self::set) does nothing and [`get`](Self::get) finds nothing. A side may be 0,
/// which gives a picture without pixels. The one thing that can fail is memory: the largest picture takes
/// 17 GB, and a program that has less ends there. [`file::fits`](crate::file::fits) says what is reasonable.
#[derive(Clone, PartialEq, Eq)]
pub struct Image {
    width: u16,
    height: u16,
    format: Format,
    /// Rows from the bottom, pixels from the left, channels in the order of [`Format`].
    bytes: Vec<u8>,
}

impl Image {
    /// A picture all of whose bytes are 0: black and, with an alpha channel, transparent.
    ///
    /// Sides have 16 bits since TGA's header gives them as many.
    ///
    /// # Panics
    /// Where the picture's bytes cannot be counted in a `usize`: never with 64 bits, beyond 4 GB with 32.
    #[must_use]
    pub fn new(width: u16, height: u16, format: Format) -> Self {
        let bytes = vec![0; usize::from(width) * usize::from(height) * format as usize];
        Self { width, height, format, bytes }
    }

    /// Width in pixels, 0 to 65535. Signed, since coordinates are.
    #[must_use]
    pub fn width(&self) -> i32 {
        i32::from(self.width)
    }

    /// Height in pixels, 0 to 65535.
    #[must_use]
    pub fn height(&self) -> i32 {
        i32::from(self.height)
    }

    /// Width and height, as numbers to compute with.
    #[must_use]
    pub fn size(&self) -> Vec2 {
        Vec2::new(f32::from(self.width), f32::from(self.height))
    }

    /// What a pixel consists of.
    #[must_use]
    pub fn format(&self) -> Format {
        self.format
    }

    /// Bytes per pixel: 1, 3 or 4.
    #[must_use]
    pub fn bytes_per_pixel(&self) -> usize {
        self.format as usize
    }

    /// The rectangle of all its pixels.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds { min: IVec2::ZERO, max: IVec2::new(self.width() - 1, self.height() - 1) }
    }

    /// The bytes themselves: rows from the bottom, pixels from the left, channels in RGBA order.
    #[must_use]
    pub fn buffer(&self) -> &[u8] {
        &self.bytes
    }

    /// The same bytes, to write to.
    pub fn buffer_mut(&mut self) -> &mut [u8] {
        &mut self.bytes
    }

    /// Where the pixel (x, y) begins in the buffer.
    #[inline]
    fn offset(&self, x: i32, y: i32) -> Option<usize> {
        // As unsigned numbers the negative ones are too large, so that one comparison serves both ends.
        let inside = (x as u32) < u32::from(self.width) && (y as u32) < u32::from(self.height);
        inside.then(|| (y as usize * usize::from(self.width) + x as usize) * self.format as usize)
    }

    /// The colour of the pixel (x, y), or `None` outside the picture. Grey has three equal channels; without
    /// an alpha channel a pixel is opaque.
    #[inline]
    #[must_use]
    pub fn get(&self, x: i32, y: i32) -> Option<Color> {
        let at = self.offset(x, y)?;
        Some(match (self.format, &self.bytes[at..at + self.format as usize]) {
            (Format::Gray, &[v]) => Color::rgb(v, v, v),
            (Format::Rgb, &[r, g, b]) => Color::rgb(r, g, b),
            (_, bytes) => Color { r: bytes[0], g: bytes[1], b: bytes[2], a: bytes[3] },
        })
    }

    /// Colours the pixel (x, y); outside the picture, nothing happens. A grey picture keeps the colour's
    /// [`luma`](Color::luma), one without alpha drops the alpha.
    #[inline(always)]
    pub fn set(&mut self, x: i32, y: i32, color: Color) {
        let Some(at) = self.offset(x, y) else { return };
        let Color { r, g, b, a } = color;
        match self.format {
            Format::Gray => self.bytes[at] = color.luma(),
            Format::Rgb => self.bytes[at..at + 3].copy_from_slice(&[r, g, b]),
            Format::Rgba => self.bytes[at..at + 4].copy_from_slice(&[r, g, b, a]),
        }
    }

    /// Colours every pixel, as [`set`](Self::set) does: `color` is asked by the pixel's number, rows from the bottom.
    pub fn set_all(&mut self, mut color: impl FnMut(usize) -> Color) {
        match self.format {
            Format::Gray => (0..).zip(&mut self.bytes).for_each(|(n, byte)| *byte = color(n).luma()),
            Format::Rgb => {
                for (n, bytes) in self.bytes.as_chunks_mut::<3>().0.iter_mut().enumerate() {
                    let Color { r, g, b, .. } = color(n);
                    *bytes = [r, g, b];
                }
            }
            Format::Rgba => {
                for (n, bytes) in self.bytes.as_chunks_mut::<4>().0.iter_mut().enumerate() {
                    let Color { r, g, b, a } = color(n);
                    *bytes = [r, g, b, a];
                }
            }
        }
    }

    /// Lays `color` over the pixel (x, y), which it covers by `coverage` 255ths.
    #[inline]
    pub fn blend(&mut self, x: i32, y: i32, color: Color, coverage: u8) {
        if coverage == 255 {
            self.set(x, y, color);
        } else if let Some(below) = self.get(x, y) {
            self.set(x, y, below.mixed(color, coverage));
        }
    }

    /// Every pixel with its colour: x, y, colour; rows from the bottom.
    pub fn pixels(&self) -> impl Iterator<Item = (i32, i32, Color)> + '_ {
        let columns = 0..self.width();
        (0..self.height())
            .flat_map(move |y| columns.clone().map(move |x| (x, y)))
            .filter_map(|(x, y)| Some((x, y, self.get(x, y)?)))
    }

    /// Sets every byte to 0, as in a new picture.
    pub fn clear(&mut self) {
        self.bytes.fill(0);
    }

    /// Swaps left and right.
    pub fn flip_horizontally(&mut self) {
        let row = usize::from(self.width) * self.format as usize;
        let rows = self.bytes.chunks_exact(row.max(1));
        let pixels: Vec<&[u8]> = rows.flat_map(|row| row.rchunks_exact(self.format as usize)).collect();
        self.bytes = pixels.concat();
    }

    /// Swaps bottom and top.
    pub fn flip_vertically(&mut self) {
        self.bytes = self.rows_down().collect::<Vec<_>>().concat();
    }

    /// The picture stretched to another size: a smaller one averages the pixels that its own cover, a larger
    /// one repeats the nearest pixel. A picture without pixels gives a black one.
    #[must_use]
    pub fn scale(&self, width: u16, height: u16) -> Self {
        let mut scaled = Self::new(width, height, self.format);
        for y in 0..height {
            let rows = covered(y, height, self.height);
            for x in 0..width {
                let (mut sums, mut count) = ([0_u64; 4], 0);
                for row in rows.clone() {
                    for color in covered(x, width, self.width).filter_map(|column| self.get(column, row)) {
                        let Color { r, g, b, a } = color;
                        sums = [
                            sums[0] + u64::from(r),
                            sums[1] + u64::from(g),
                            sums[2] + u64::from(b),
                            sums[3] + u64::from(a),
                        ];
                        count += 1;
                    }
                }
                if count > 0 {
                    let [r, g, b, a] = sums.map(|sum| ((sum + count / 2) / count) as u8);
                    scaled.set(i32::from(x), i32::from(y), Color { r, g, b, a });
                }
            }
        }
        scaled
    }

    /// Its rows from the top, as files have them.
    pub(crate) fn rows_down(&self) -> impl Iterator<Item = &[u8]> {
        let row = usize::from(self.width) * self.format as usize;
        self.bytes.chunks_exact(row.max(1)).rev()
    }

    /// The picture with these rows, the first one on top.
    pub(crate) fn from_rows_down(width: u16, height: u16, format: Format, bytes: &[u8]) -> Self {
        let mut image = Self::new(width, height, format);
        let row = usize::from(width) * format as usize;
        for (to, from) in image.bytes.chunks_exact_mut(row.max(1)).rev().zip(bytes.chunks_exact(row.max(1))) {
            to.copy_from_slice(from);
        }
        image
    }
}

/// The columns (or rows), out of `from`, that go into column `n` of `to`.
fn covered(n: u16, to: u16, from: u16) -> Range<i32> {
    let [n, to, from] = [n, to, from].map(i64::from);
    let [begin, end] = if from > to {
        // Each into one, and into each at least one.
        [n * from / to, (n + 1) * from / to]
    } else {
        let nearest = (2 * n + 1) * from / (2 * to);
        [nearest, nearest + 1]
    };
    begin as i32..end as i32
}

impl std::fmt::Debug for Image {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Image({}×{} {:?})", self.width, self.height, self.format)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMATS: [Format; 3] = [Format::Gray, Format::Rgb, Format::Rgba];

    fn noise(width: u16, height: u16, format: Format) -> Image {
        let mut image = Image::new(width, height, format);
        for (n, byte) in image.buffer_mut().iter_mut().enumerate() {
            *byte = Color::random(n as u64).r;
        }
        image
    }

    #[test]
    fn a_new_picture_is_black_and_as_large_as_asked() {
        for (format, size) in FORMATS.into_iter().zip([1, 3, 4]) {
            let image = Image::new(3, 2, format);
            assert_eq!((image.width(), image.height(), image.bytes_per_pixel()), (3, 2, size));
            assert_eq!(image.buffer(), vec![0; 6 * size]);
        }
    }

    #[test]
    fn outside_set_does_nothing_and_get_finds_nothing() {
        for format in FORMATS {
            let mut image = Image::new(3, 2, format);
            for (x, y) in [(-1, 0), (0, -1), (3, 0), (0, 2), (i32::MIN, i32::MAX), (i32::MAX, 1)] {
                image.set(x, y, Color::WHITE);
                image.blend(x, y, Color::WHITE, 7);
                assert_eq!(image.get(x, y), None);
            }
            assert_eq!(image, Image::new(3, 2, format));
        }
    }

    #[test]
    fn what_was_set_is_what_get_finds() {
        let color = Color { r: 10, g: 20, b: 30, a: 40 };
        let kept = [Color::rgb(19, 19, 19), Color::rgb(10, 20, 30), color];
        for (format, kept) in FORMATS.into_iter().zip(kept) {
            let mut image = Image::new(5, 4, format);
            image.set(3, 2, color);
            for (x, y, found) in image.pixels() {
                let expected = if (x, y) == (3, 2) { Some(kept) } else { Image::new(1, 1, format).get(0, 0) };
                assert_eq!(Some(found), expected);
            }
        }
    }

    #[test]
    fn all_pixels_are_set_in_the_order_of_the_buffer() {
        for format in FORMATS {
            let [mut one_by_one, mut at_once] = [(); 2].map(|()| Image::new(5, 4, format));
            let color = |n: usize| Color { a: n as u8, ..Color::random(n as u64) };
            (0..20).for_each(|n| one_by_one.set(n % 5, n / 5, color(n as usize)));
            at_once.set_all(color);
            assert_eq!(at_once, one_by_one);
        }
    }

    #[test]
    fn the_bounds_hold_the_pixels_and_no_others() {
        let bounds = Image::new(3, 2, Format::Gray).bounds();
        let inside =
            (-2..5).flat_map(|y| (-2..5).map(move |x| (x, y))).filter(|&(x, y)| bounds.contains(x, y));
        assert_eq!(inside.collect::<Vec<_>>(), [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)]);
        assert!(!Image::new(0, 2, Format::Gray).bounds().contains(0, 0));
    }

    #[test]
    fn blending_mixes_with_what_lies_below() {
        let mut image = Image::new(3, 1, Format::Rgb);
        for (x, coverage) in [(0, 0), (1, 51), (2, 255)] {
            image.set(x, 0, Color::GREEN);
            image.blend(x, 0, Color::RED, coverage);
        }
        assert_eq!(image.buffer(), [0, 255, 0, 51, 204, 0, 255, 0, 0]);
        assert_eq!(format!("{image:?}"), "Image(3×1 Rgb)");
    }

    #[test]
    fn the_buffer_starts_at_the_bottom_left() {
        let mut image = Image::new(2, 2, Format::Gray);
        image.set(1, 0, Color::WHITE);
        assert_eq!(image.buffer(), [0, 255, 0, 0]);
    }

    #[test]
    fn flips_move_every_pixel_and_undo_themselves() {
        for format in FORMATS {
            let before = noise(5, 4, format);
            let mut image = before.clone();
            image.flip_horizontally();
            assert!(before.pixels().all(|(x, y, color)| image.get(4 - x, y) == Some(color)));
            image.flip_vertically();
            assert!(before.pixels().all(|(x, y, color)| image.get(4 - x, 3 - y) == Some(color)));
            image.flip_horizontally();
            image.flip_vertically();
            assert_eq!(image, before);
        }
    }

    #[test]
    fn enlarging_repeats_pixels() {
        for format in FORMATS {
            let image = noise(3, 2, format);
            let large = image.scale(9, 8);
            assert!(large.pixels().all(|(x, y, color)| image.get(x / 3, y / 4) == Some(color)));
        }
    }

    #[test]
    fn shrinking_averages() {
        let mut image = Image::new(8, 8, Format::Gray);
        for y in 0..8 {
            (0..8).filter(|x| (x + y) % 2 == 0).for_each(|x| image.set(x, y, Color::WHITE));
        }
        // A checkerboard of 0 and 255 has the mean 127.5.
        assert_eq!(image.scale(2, 2).buffer(), [128; 4]);
        assert_eq!(image.scale(8, 1).buffer(), [128; 8]);
        // Of three rows, the middle one goes to one side.
        let mut image = Image::new(1, 3, Format::Rgba);
        (0..3).for_each(|y| image.set(0, y, Color { r: 100 * y as u8, g: 0, b: 7, a: 255 }));
        assert_eq!(image.scale(1, 2).buffer(), [0, 0, 7, 255, 150, 0, 7, 255]);
    }

    #[test]
    fn every_pixel_goes_into_one_or_is_repeated_evenly() {
        for (from, to) in [(1, 1), (5, 3), (1000, 7), (65_535, 65_534), (3, 4), (7, 1000), (1, 65_535)] {
            let all: Vec<Range<i32>> = (0..to).map(|n| covered(n, to, from)).collect();
            assert!(all.iter().all(|range| !range.is_empty() && range.end <= i32::from(from)));
            if from > to {
                assert!(all.windows(2).all(|pair| pair[0].end == pair[1].start));
                assert!(all[0].start == 0 && all[all.len() - 1].end == i32::from(from));
            } else {
                let half = |n: usize, range: &Range<i32>| {
                    // Twice the distance of the two centres, in pixels of the larger picture.
                    (2 * n as i64 + 1) * i64::from(from) - i64::from(2 * range.start + 1) * i64::from(to)
                };
                assert!(all.iter().enumerate().all(|(n, range)| half(n, range).abs() <= i64::from(to)));
            }
        }
    }

    #[test]
    fn a_picture_without_pixels_is_a_picture() {
        for (width, height) in [(0, 0), (0, 5), (5, 0)] {
            let mut image = Image::new(width, height, Format::Rgb);
            image.flip_horizontally();
            image.flip_vertically();
            image.clear();
            assert_eq!(image.get(0, 0), None);
            assert_eq!(image.scale(2, 2), Image::new(2, 2, Format::Rgb));
            assert_eq!(image.pixels().count(), 0);
        }
        assert_eq!(noise(3, 3, Format::Rgb).scale(0, 4).height(), 4);
    }

    #[test]
    fn clear_makes_it_new() {
        let mut image = noise(3, 2, Format::Rgba);
        image.clear();
        assert_eq!(image, Image::new(3, 2, Format::Rgba));
    }
}
