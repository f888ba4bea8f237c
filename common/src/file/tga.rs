//! TGA files, after Truevision's specification (version 2.0, 1991).

use super::{PictureError, check_size};
use crate::{Format, Image};

/// Bytes before everything else.
const HEADER: usize = 18;
/// The bit of a kind that says that pixels come in packets.
const RLE: u8 = 8;
/// The bits of the descriptor that say where the first pixel is.
const RIGHT: u8 = 1 << 4;
const TOP: u8 = 1 << 5;
/// The most pixels in a packet.
const PACKET: usize = 128;

/// How a pixel, or an entry of a colour map, is stored: blue first, as little-endian numbers.
#[derive(Clone, Copy)]
enum Pixel {
    Gray,
    GrayAlpha,
    /// Five bits each. The sixteenth is an attribute that programs fill as they please: it is no alpha.
    Bgr555,
    Bgr,
    Bgra,
}

impl Pixel {
    /// With so many bits, of which so many are the descriptor's "attribute bits".
    fn of(color: bool, bits: u8, attributes: u8) -> Option<Self> {
        Some(match (color, bits, attributes) {
            // 32 bits without attributes are written by programs that mean alpha all the same.
            (true, 32, 0 | 8) => Self::Bgra,
            (true, 24, 0) => Self::Bgr,
            (true, 15, 0) | (true, 16, 0 | 1) => Self::Bgr555,
            (false, 16, 8) => Self::GrayAlpha,
            // A picture of nothing but alpha is shown as grey.
            (false, 8, 0 | 8) => Self::Gray,
            _ => return None,
        })
    }

    fn format(self) -> Format {
        match self {
            Self::Gray => Format::Gray,
            Self::Bgr555 | Self::Bgr => Format::Rgb,
            Self::GrayAlpha | Self::Bgra => Format::Rgba,
        }
    }

    /// Bytes that are stored.
    fn size(self) -> usize {
        match self {
            Self::Gray => 1,
            Self::GrayAlpha | Self::Bgr555 => 2,
            Self::Bgr => 3,
            Self::Bgra => 4,
        }
    }

    /// The channels in our order, as many as the format has.
    fn channels(self, stored: &[u8]) -> [u8; 4] {
        match (self, stored) {
            (Self::Gray, &[v]) => [v, 0, 0, 0],
            (Self::GrayAlpha, &[v, a]) => [v, v, v, a],
            (Self::Bgr555, &[low, high]) => {
                let bits = u16::from_le_bytes([low, high]);
                // 31 becomes 255, and the rest in proportion, rounded.
                let channel = |shift: u16| (((bits >> shift & 31) * 255 + 15) / 31) as u8;
                [channel(10), channel(5), channel(0), 0]
            }
            (Self::Bgr, &[b, g, r]) => [r, g, b, 0],
            (Self::Bgra, &[b, g, r, a]) => [r, g, b, a],
            _ => unreachable!("a stored pixel has its size"),
        }
    }
}

/// The picture in a file.
pub(super) fn decode(file: &[u8]) -> Result<Image, PictureError> {
    let mut rest = file;
    let header = take(&mut rest, HEADER)?;
    let word = |at: usize| u16::from_le_bytes([header[at], header[at + 1]]);
    let (kind, depth, descriptor) = (header[2], header[16], header[17]);
    let (first, entries, entry_bits) = (usize::from(word(3)), usize::from(word(5)), header[7]);
    let (mapped, color) = match kind & !RLE {
        1 => (true, true),
        2 => (false, true),
        3 => (false, false),
        _ => return Err(PictureError::Malformed("it is of no kind that TGA pictures are")),
    };
    if mapped && (header[1] != 1 || !matches!(depth, 8 | 16)) {
        return Err(PictureError::Malformed("its colour map cannot be used"));
    }
    let pixel = Pixel::of(color, if mapped { entry_bits } else { depth }, descriptor & 15)
        .ok_or(PictureError::Malformed("its pixels have a number of bits that is not known"))?;
    let (width, height) = check_size(word(12).into(), word(14).into(), pixel.format())?;

    take(&mut rest, header[0].into())?;
    // A picture that needs no map may have one.
    let map_size = if header[1] == 1 { entries * usize::from(entry_bits.div_ceil(8)) } else { 0 };
    let map = take(&mut rest, map_size)?.chunks_exact(pixel.size());

    let mut image = Image::new(width, height, pixel.format());
    let (width, height, bytes) = (usize::from(width), usize::from(height), pixel.format() as usize);
    let size = usize::from(depth.div_ceil(8));
    // ANCHOR: packets
    let (mut left, mut run, mut stored) = (0, false, &[][..]);
    for n in 0..width * height {
        let begins = kind & RLE != 0 && left == 0;
        if begins {
            let head = usize::from(take(&mut rest, 1)?[0]);
            (left, run) = (head % PACKET + 1, head >= PACKET);
        }
        if begins || !run {
            stored = take(&mut rest, size)?;
        }
        left = left.saturating_sub(1);
        // ANCHOR_END: packets
        let channels = pixel.channels(if mapped {
            let index = stored.iter().rev().fold(0, |index, &byte| index << 8 | usize::from(byte));
            let entry = index.checked_sub(first).and_then(|index| map.clone().nth(index));
            entry.ok_or(PictureError::Malformed("a pixel's colour is not in its colour map"))?
        } else {
            stored
        });
        let (column, row) = (n % width, n / width);
        let x = if descriptor & RIGHT == 0 { column } else { width - 1 - column };
        let y = if descriptor & TOP == 0 { row } else { height - 1 - row };
        image.buffer_mut()[(y * width + x) * bytes..][..bytes].copy_from_slice(&channels[..bytes]);
    }
    Ok(image)
}

/// The first bytes, which are then no longer there.
fn take<'a>(rest: &mut &'a [u8], count: usize) -> Result<&'a [u8], PictureError> {
    rest.split_off(..count).ok_or(PictureError::Truncated)
}

/// The bytes of a picture's file. It begins at the top left, as every reader we know understands, and no packet
/// crosses the end of a row, which some refuse (Python's Pillow is one).
// ANCHOR: encode
pub(super) fn encode(image: &Image, packed: bool) -> Result<Vec<u8>, PictureError> {
    let size = image.bytes_per_pixel();
    let [width, height] = [image.width(), image.height()].map(|side| (side as u16).to_le_bytes());
    if image.buffer().is_empty() {
        return Err(PictureError::Empty);
    }
    let kind = if image.format() == Format::Gray { 3 } else { 2 } | if packed { RLE } else { 0 };
    let alpha = if image.format() == Format::Rgba { 8 } else { 0 };
    let mut file = vec![0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    file.extend([width, height].concat());
    file.extend([8 * size as u8, TOP | alpha]);
    for row in image.rows_down() {
        let mut row = row.to_vec();
        if size > 1 {
            row.chunks_exact_mut(size).for_each(|pixel| pixel.swap(0, 2));
        }
        if packed { pack(&row, size, &mut file) } else { file.extend(row) }
    }
    Ok(file)
}
// ANCHOR_END: encode

/// Appends a row in packets: runs of one colour and what lies between them, by turns.
// ANCHOR: pack
fn pack(row: &[u8], size: usize, file: &mut Vec<u8>) {
    let pixels: Vec<&[u8]> = row.chunks_exact(size).collect();
    let (mut rest, mut run) = (pixels.as_slice(), true);
    while let Some(first) = rest.first() {
        let pairs = rest.windows(2).take(PACKET - 1);
        let count = 1 + pairs.take_while(|pair| (pair[0] == pair[1]) == run).count();
        file.push((if run { PACKET } else { 0 } + count - 1) as u8);
        if run {
            file.extend(*first);
        } else {
            file.extend(rest[..count].concat());
        }
        rest = &rest[count..];
        // A full packet may have ended anywhere: what comes next may be a run again.
        run = !run || count == PACKET;
    }
}
// ANCHOR_END: pack

#[cfg(test)]
mod tests {
    use image::{DynamicImage, ImageFormat};

    use super::*;

    /// Bytes that are the same in every run: a linear congruential generator with Knuth's constants.
    fn noise(seed: u64) -> impl Iterator<Item = u8> {
        let next = |state: &u64| {
            Some(state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407))
        };
        std::iter::successors(Some(seed), next).skip(1).map(|state| (state >> 56) as u8)
    }

    /// What the `image` crate reads, in our formats.
    fn reference(file: &[u8]) -> Option<(Format, Vec<u8>)> {
        let picture = image::load_from_memory_with_format(file, ImageFormat::Tga).ok()?;
        Some(match picture {
            DynamicImage::ImageLuma8(picture) => (Format::Gray, picture.into_raw()),
            DynamicImage::ImageRgb8(picture) => (Format::Rgb, picture.into_raw()),
            picture => (Format::Rgba, picture.into_rgba8().into_raw()),
        })
    }

    /// Every kind, depth, number of attribute bits and origin, with and without a colour map, and noise for
    /// pixels and packets: read as the `image` crate reads it, or refused as it refuses it.
    #[test]
    fn it_reads_what_the_image_crate_reads() {
        let mut read = 0;
        for kind in [1, 2, 3, 9, 10, 11] {
            for depth in [8, 15, 16, 24, 32] {
                for (attributes, entry_bits) in
                    [0, 1, 8].iter().flat_map(|&a| [(a, 0), (a, 16), (a, 24), (a, 32)])
                {
                    for origin in [0, RIGHT, TOP, RIGHT | TOP] {
                        let map = u8::from(entry_bits > 0);
                        // Indices of 8 bits all find an entry; of those with 16, most do not.
                        let (first, entries) = if map == 1 { ([0, 0], [0, 1]) } else { ([0, 0], [0, 0]) };
                        let mut file = vec![3, map, kind];
                        file.extend([first, entries].concat());
                        file.extend([entry_bits, 0, 0, 0, 0, 7, 0, 5, 0, depth, attributes | origin]);
                        file.extend(noise(u64::from(kind) << 8 | u64::from(depth)).take(3000));
                        let expected = reference(&file);
                        let got = decode(&file)
                            .ok()
                            .map(|image| (image.format(), image.rows_down().collect::<Vec<_>>().concat()));
                        assert_eq!(
                            got, expected,
                            "kind {kind} depth {depth} attributes {attributes} entries of {entry_bits} origin {origin}"
                        );
                        read += usize::from(got.is_some());
                    }
                }
            }
        }
        assert!(read > 300, "{read} were pictures");
    }

    /// Packets are the `image` crate's, but for those that would cross the end of a row.
    #[test]
    fn it_packs_as_the_image_crate_does() {
        for (n, width) in (1..=400_u16).step_by(7).enumerate() {
            let mut image = Image::new(width, 1, Format::Rgb);
            // Mostly runs, mostly different neighbours, or long runs.
            let share = [2, 200, 250][n % 3];
            let mut color = [0; 3];
            for (pixel, byte) in image.buffer_mut().chunks_exact_mut(3).zip(noise(n as u64)) {
                if byte >= share {
                    color = [byte, 255 - byte, 7];
                }
                pixel.copy_from_slice(&color);
            }
            let mut expected = Vec::new();
            image::codecs::tga::TgaEncoder::new(&mut expected)
                .encode(image.buffer(), width.into(), 1, image::ExtendedColorType::Rgb8)
                .unwrap();
            assert_eq!(encode(&image, true).unwrap(), expected, "{width}");
        }
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        let header = |kind, depth| [0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, depth, 0];
        for (kind, depth) in [(0, 24), (4, 24), (26, 24), (2, 30), (2, 8), (3, 24), (1, 8)] {
            let file = [&header(kind, depth)[..], &[0; 99]].concat();
            assert!(matches!(decode(&file), Err(PictureError::Malformed(_))), "kind {kind} depth {depth}");
        }
        assert!(matches!(decode(&header(2, 24)[..17]), Err(PictureError::Truncated)));
        // A colour map of one entry of 24 bits: it must be there, and an index has 8 bits or 16.
        for (map, depth, good) in [(1, 8, true), (1, 16, true), (0, 8, false), (1, 24, false), (1, 15, false)]
        {
            let header = [0, map, 1, 0, 0, 1, 0, 24, 0, 0, 0, 0, 1, 0, 1, 0, depth, 0];
            let read = decode(&[&header[..], &[0; 99]].concat());
            assert!(
                if good { read.is_ok() } else { matches!(read, Err(PictureError::Malformed(_))) },
                "{map} {depth}"
            );
        }
    }
}
