//! PNG files, by the `png` crate.

use std::io::Cursor;

use ::png::{BitDepth, ColorType, Compression, Decoder, Encoder, Filter, Limits, Transformations};

use super::{FILE_LIMIT, PictureError, check_size};
use crate::{Format, Image};

/// The picture in a file, in 8 bits a channel: 16 are rounded, a palette becomes RGB or RGBA, and grey with
/// alpha RGBA.
pub(super) fn decode(file: &[u8]) -> Result<Image, PictureError> {
    let limits = Limits { bytes: FILE_LIMIT as usize };
    let mut decoder = Decoder::new_with_limits(Cursor::new(file), limits);
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let (width, height) = decoder.read_header_info()?.size();
    // The least that it can take, before anything is unpacked.
    check_size(width, height, Format::Gray)?;
    let mut reader = decoder.read_info()?;
    // The decoder counts on whole colours, and panics otherwise: https://github.com/image-rs/image-png/issues/694.
    if reader.info().palette.as_ref().is_some_and(|palette| !palette.len().is_multiple_of(3)) {
        return Err(PictureError::Malformed("its palette ends within a colour"));
    }
    let (color, depth) = reader.output_color_type();
    let format = match color {
        ColorType::Grayscale => Format::Gray,
        ColorType::Rgb => Format::Rgb,
        ColorType::GrayscaleAlpha | ColorType::Rgba => Format::Rgba,
        ColorType::Indexed => return Err(PictureError::Malformed("its palette cannot be used")),
    };
    let (width, height) = check_size(width, height, format)?;
    let size = reader.output_buffer_size().filter(|&size| size as u64 <= FILE_LIMIT);
    let mut bytes = vec![0; size.ok_or(PictureError::TooLarge)?];
    reader.next_frame(&mut bytes)?;
    if depth == BitDepth::Sixteen {
        let rounded = |pair: &[u8]| ((u32::from(pair[0]) << 8 | u32::from(pair[1])) + 128) / 257;
        bytes = bytes.chunks_exact(2).map(|pair| rounded(pair) as u8).collect();
    }
    if color == ColorType::GrayscaleAlpha {
        bytes = bytes.chunks_exact(2).flat_map(|pair| [pair[0], pair[0], pair[0], pair[1]]).collect();
    }
    Ok(Image::from_rows_down(width, height, format, &bytes))
}

/// The bytes of a picture's file.
pub(super) fn encode(image: &Image) -> Result<Vec<u8>, PictureError> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, image.width() as u32, image.height() as u32);
    encoder.set_color(match image.format() {
        Format::Gray => ColorType::Grayscale,
        Format::Rgb => ColorType::Rgb,
        Format::Rgba => ColorType::Rgba,
    });
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Adaptive);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&image.rows_down().collect::<Vec<_>>().concat())?;
    writer.finish()?;
    Ok(file)
}
