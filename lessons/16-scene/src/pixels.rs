//! A picture as windows want it.

use common::{Format, Image};

// ANCHOR: show
/// Writes a picture into a window's buffer of the same size: rows from the top, each pixel 0x00RRGGBB.
///
/// # Panics
/// Where the picture is not one of red, green and blue, or the buffer has another number of pixels.
pub fn show(picture: &Image, buffer: &mut [u32]) {
    assert_eq!(picture.format(), Format::Rgb);
    let pixels = picture.buffer().as_chunks::<3>().0;
    assert_eq!(pixels.len(), buffer.len());
    let width = (picture.width() as usize).max(1);
    for (to, from) in buffer.chunks_exact_mut(width).zip(pixels.chunks_exact(width).rev()) {
        for (to, &[r, g, b]) in to.iter_mut().zip(from) {
            *to = u32::from_be_bytes([0, r, g, b]);
        }
    }
}
// ANCHOR_END: show

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;

    #[test]
    fn the_first_row_is_the_top_one_and_red_stands_before_green_before_blue() {
        let mut picture = Image::new(3, 2, Format::Rgb);
        picture.set_all(|n| Color::rgb(0x10 + n as u8, 0x20 + n as u8, 0x30 + n as u8));
        let mut buffer = [u32::MAX; 6];
        show(&picture, &mut buffer);
        assert_eq!(buffer, [0x132333, 0x142434, 0x152535, 0x102030, 0x112131, 0x122232]);
    }

    #[test]
    fn nothing_is_shown_of_a_picture_without_pixels() {
        for (width, height) in [(0, 0), (0, 7), (7, 0)] {
            show(&Image::new(width, height, Format::Rgb), &mut []);
        }
    }

    #[test]
    #[should_panic(expected = "left == right")]
    fn a_buffer_of_another_size_is_refused() {
        show(&Image::new(2, 2, Format::Rgb), &mut [0; 5]);
    }
}
