//! What differs between two pictures, as lists of pixels and as a picture.
//!
//! A pixel counts as drawn where it is not black, the colour of an empty picture.

use std::fmt;

use glam::IVec2;

use crate::file::{SIDE_LIMIT, fits};
use crate::{Color, Format, Image};

// Okabe and Ito's colours, which colour-blind people can tell apart (*Color Universal Design*, 2008).
const MISSING: Color = Color::rgb(0xd5, 0x5e, 0x00);
const EXTRA: Color = Color::rgb(0x56, 0xb4, 0xe9);
const RECOLORED: Color = Color::rgb(0xf0, 0xe4, 0x42);

/// The pixels in which one picture differs from what was expected, each list in rows from the bottom.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Difference {
    /// Drawn in the expected picture only.
    pub missing: Vec<IVec2>,
    /// Drawn in the other picture only.
    pub extra: Vec<IVec2>,
    /// Drawn in both, in different colours.
    pub recolored: Vec<IVec2>,
}

impl Difference {
    /// Compares two pictures pixel by pixel. Beyond the border of either one nothing is drawn.
    #[must_use]
    pub fn between(expected: &Image, got: &Image) -> Self {
        let mut difference = Self::default();
        let (width, height) = (expected.width().max(got.width()), expected.height().max(got.height()));
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let list = match (drawn(expected, x, y), drawn(got, x, y)) {
                (Some(_), None) => &mut difference.missing,
                (None, Some(_)) => &mut difference.extra,
                (Some(a), Some(b)) if a != b => &mut difference.recolored,
                _ => continue,
            };
            list.push(IVec2::new(x, y));
        }
        difference
    }

    /// Whether the pictures show the same.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.missing.is_empty() && self.extra.is_empty() && self.recolored.is_empty()
    }

    /// The expected picture, darkened, with the differing pixels in three colours.
    #[must_use]
    pub fn picture(&self, expected: &Image) -> Image {
        let mut picture = Image::new(expected.width() as u16, expected.height() as u16, Format::Rgb);
        for (x, y, color) in expected.pixels() {
            picture.set(x, y, Color::gray(f32::from(color.luma()) / 255.0 * 0.35));
        }
        for (list, color) in [(&self.missing, MISSING), (&self.extra, EXTRA), (&self.recolored, RECOLORED)] {
            list.iter().for_each(|pixel| picture.set(pixel.x, pixel.y, color));
        }
        picture
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { missing, extra, recolored } = self;
        write!(
            f,
            "{} pixels missing (orange), {} extra (blue), {} of another colour (yellow)",
            missing.len(),
            extra.len(),
            recolored.len()
        )
    }
}

/// The pixel's colour, where there is one that is not black.
fn drawn(image: &Image, x: i32, y: i32) -> Option<Color> {
    image.get(x, y).filter(|color| (color.r, color.g, color.b) != (0, 0, 0))
}

/// Pictures side by side with a grey gap between them; small ones are enlarged by a whole factor, so that
/// single pixels can be seen.
///
/// # Errors
/// A line that says so where there is no picture, or the sheet is larger than [`fits`] allows.
pub fn side_by_side(pictures: &[&Image]) -> Result<Image, String> {
    const READABLE: i32 = 600;
    const GAP: i32 = 6;
    let height =
        pictures.iter().map(|picture| picture.height()).max().ok_or("there is no picture to show")?;
    let width: i32 = pictures.iter().map(|picture| picture.width()).sum();
    let gaps = GAP * (pictures.len() as i32 - 1);
    let factor = (READABLE / height.max(1)).min((i32::from(SIDE_LIMIT) - gaps) / width.max(1)).max(1);
    let (width, height) = (width * factor + gaps, height * factor);
    let size = u16::try_from(width).ok().zip(u16::try_from(height).ok());
    let (width, height) = size.filter(|&(width, height)| fits(width, height)).ok_or_else(|| {
        format!(
            "side by side the pictures are {width}x{height} pixels, more than can be read: draw smaller ones"
        )
    })?;
    let mut sheet = Image::new(width, height, Format::Rgb);
    sheet.buffer_mut().fill(96);
    let mut left = 0;
    for picture in pictures {
        let panel = picture.scale((picture.width() * factor) as u16, (picture.height() * factor) as u16);
        panel.pixels().for_each(|(x, y, color)| sheet.set(left + x, y, color));
        left += panel.width() + GAP;
    }
    Ok(sheet)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(pixels: &[(i32, i32, Color)]) -> Image {
        let mut image = Image::new(4, 3, Format::Rgb);
        pixels.iter().for_each(|&(x, y, color)| image.set(x, y, color));
        image
    }

    #[test]
    fn every_kind_of_difference_is_told() {
        let expected = picture(&[(0, 0, Color::RED), (1, 0, Color::RED), (2, 0, Color::RED)]);
        let got = picture(&[(0, 0, Color::RED), (1, 0, Color::GREEN), (3, 2, Color::RED)]);
        let difference = Difference::between(&expected, &got);
        assert_eq!(difference.missing, [IVec2::new(2, 0)]);
        assert_eq!(difference.extra, [IVec2::new(3, 2)]);
        assert_eq!(difference.recolored, [IVec2::new(1, 0)]);
        let shown = difference.picture(&expected);
        let colors = [(2, 0), (3, 2), (1, 0), (0, 1)].map(|(x, y)| shown.get(x, y).unwrap());
        assert_eq!(colors, [MISSING, EXTRA, RECOLORED, Color::BLACK]);
        // What is the same is shown as bright as it looks, and darkened.
        assert_eq!(shown.get(0, 0), Some(Color::gray(0.35 * f32::from(Color::RED.luma()) / 255.0)));
    }

    #[test]
    fn a_picture_equals_itself_in_any_format() {
        let image = picture(&[(1, 1, Color::WHITE)]);
        let mut gray = Image::new(4, 3, Format::Gray);
        gray.set(1, 1, Color::WHITE);
        assert!(Difference::between(&image, &gray).is_empty());
    }

    #[test]
    fn one_pixel_is_a_difference() {
        let [blank, red, green] = [&[][..], &[(1, 1, Color::RED)], &[(1, 1, Color::GREEN)]].map(picture);
        for (expected, got) in [(&blank, &red), (&red, &blank), (&red, &green)] {
            assert!(!Difference::between(expected, got).is_empty());
        }
    }

    #[test]
    fn pictures_of_other_sizes_differ_where_something_is_drawn() {
        let small = Image::new(1, 1, Format::Rgb);
        let large = picture(&[(3, 2, Color::WHITE)]);
        assert_eq!(Difference::between(&small, &large).extra, [IVec2::new(3, 2)]);
        assert_eq!(Difference::between(&large, &small).missing, [IVec2::new(3, 2)]);
    }

    #[test]
    fn panels_stand_in_order_and_small_ones_are_enlarged() {
        let [a, b] = [Color::RED, Color::GREEN].map(|color| picture(&[(0, 0, color)]));
        let sheet = side_by_side(&[&a, &b]).unwrap();
        assert_eq!((sheet.width(), sheet.height()), (4 * 200 * 2 + 6, 600));
        assert_eq!(sheet.get(199, 199), Some(Color::RED));
        assert_eq!(sheet.get(803, 300), Some(Color::rgb(96, 96, 96)));
        assert_eq!(sheet.get(806, 0), Some(Color::GREEN));
    }

    #[test]
    fn a_sheet_is_enlarged_as_far_as_it_fits_or_refused() {
        let sheet = |width, height| {
            let picture = Image::new(width, height, Format::Gray);
            side_by_side(&[&picture, &picture, &picture]).map(|sheet| (sheet.width(), sheet.height()))
        };
        assert_eq!(sheet(2000, 10), Ok((2 * 6000 + 12, 20)));
        assert_eq!(sheet(5457, 1), Ok((16_383, 1)));
        // Twice as large they would fit, but the gaps would not.
        assert_eq!(sheet(2730, 1), Ok((3 * 2730 + 12, 1)));
        assert_eq!(sheet(1, 16_384), Ok((15, 16_384)));
        assert_eq!(sheet(0, 0), Ok((12, 0)));
        for (width, height, size) in [
            (5458, 1, "16386x1"),
            (16_384, 1, "49164x1"),
            (65_535, 9, "196617x9"),
            (5000, 5000, "15012x5000"),
        ] {
            let error = sheet(width, height).unwrap_err();
            assert!(error.contains(size), "{error}");
        }
        assert!(side_by_side(&[]).is_err());
    }
}
