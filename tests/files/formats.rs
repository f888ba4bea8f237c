//! Pictures as people have them: what the formats allow beyond what this course writes, each put together by hand
//! from the specification.

use common::file::Encoding;
use common::{Color, Image};

/// A TGA file: image type, colour map (its first index and its entries), size, bits a pixel, descriptor, data.
pub(crate) fn tga(
    kind: u8,
    map: Option<(u16, &[&[u8]])>,
    (width, height): (u16, u16),
    bits: u8,
    descriptor: u8,
    data: &[u8],
) -> Vec<u8> {
    let name = b"made by hand";
    let mut bytes = vec![name.len() as u8, u8::from(map.is_some()), kind];
    let (first, entries) = map.unwrap_or((0, &[]));
    bytes.extend(first.to_le_bytes());
    bytes.extend((entries.len() as u16).to_le_bytes());
    bytes.push(entries.first().map_or(0, |entry| entry.len() as u8 * 8));
    bytes.extend([0; 4]);
    bytes.extend(width.to_le_bytes());
    bytes.extend(height.to_le_bytes());
    bytes.extend([bits, descriptor]);
    bytes.extend(name);
    entries.iter().for_each(|entry| bytes.extend(*entry));
    bytes.extend(data);
    bytes
}

/// A PNG file: size, bits a sample, colour type, interlacing, palette, and its rows (or those of its seven passes),
/// each with a filter's number before it. The data are stored, not compressed.
pub(crate) fn png(
    (width, height): (u32, u32),
    [bits, color, interlace]: [u8; 3],
    palette: &[u8],
    rows: &[u8],
) -> Vec<u8> {
    let mut header = [width.to_be_bytes(), height.to_be_bytes()].concat();
    header.extend([bits, color, 0, 0, interlace]);
    let length = rows.len() as u16;
    let mut data = vec![0x78, 0x01, 1];
    data.extend([length.to_le_bytes(), (!length).to_le_bytes()].concat());
    data.extend(rows);
    data.extend(adler(rows).to_be_bytes());
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    bytes.extend(chunk(b"IHDR", &header));
    if !palette.is_empty() {
        bytes.extend(chunk(b"PLTE", palette));
    }
    bytes.extend(chunk(b"IDAT", &data));
    bytes.extend(chunk(b"IEND", &[]));
    bytes
}

fn chunk(name: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let named = [&name[..], data].concat();
    [&(data.len() as u32).to_be_bytes()[..], &named, &crc(&named).to_be_bytes()].concat()
}

/// The checksum of a PNG chunk (ISO 3309).
pub(crate) fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1)))
    })
}

/// The checksum of zlib's data (RFC 1950).
fn adler(bytes: &[u8]) -> u32 {
    let (a, b) = bytes.iter().fold((1, 0), |(a, b), &byte| {
        let a = (a + u32::from(byte)) % 65_521;
        (a, (b + a) % 65_521)
    });
    b << 16 | a
}

/// The colours of a picture from its top row on.
fn colors(bytes: &[u8], encoding: Encoding) -> Vec<Color> {
    let image = Image::decode(bytes, encoding).unwrap();
    (0..image.height())
        .rev()
        .flat_map(|y| (0..image.width()).map(move |x| (x, y)))
        .filter_map(|(x, y)| image.get(x, y))
        .collect()
}

const RED: Color = Color::RED;
const GREEN: Color = Color::GREEN;
const BLUE: Color = Color::rgb(0, 0, 255);
const WHITE: Color = Color::WHITE;

/// Bits of the descriptor: rows from the top.
const TOP: u8 = 0x20;

#[test]
fn tga_with_a_colour_map() {
    let bgr: [&[u8]; 3] = [&[0, 0, 255], &[0, 255, 0], &[255, 0, 0]];
    let bgra: [&[u8]; 3] = [&[0, 0, 255, 255], &[0, 255, 0, 255], &[255, 0, 0, 255]];
    for (entries, first) in [(bgr, 0), (bgra, 0), (bgr, 5)] {
        let data = [first as u8, first as u8 + 1, first as u8 + 2, first as u8];
        let file = tga(1, Some((first, &entries)), (2, 2), 8, TOP, &data);
        assert_eq!(
            colors(&file, Encoding::TgaRle),
            [RED, GREEN, BLUE, RED],
            "{} bytes, from {first}",
            entries[0].len()
        );
    }
    let packets = [0x81, 0, 0x01, 1, 2];
    let file = tga(9, Some((0, &bgr)), (2, 2), 8, TOP, &packets);
    assert_eq!(colors(&file, Encoding::TgaRle), [RED, RED, GREEN, BLUE]);
    // A true-colour picture may bring a map that is not used.
    let file = tga(2, Some((0, &bgr)), (1, 1), 24, TOP, &[0, 255, 0]);
    assert_eq!(colors(&file, Encoding::TgaRle), [GREEN]);
}

#[test]
fn tga_of_15_and_16_bits_and_attribute_bits() {
    let data = [0x00, 0x7c, 0xe0, 0x03, 0x1f, 0x00, 0xff, 0x7f];
    for bits in [15, 16] {
        let file = tga(2, None, (2, 2), bits, TOP, &data);
        assert_eq!(colors(&file, Encoding::TgaRle), [RED, GREEN, BLUE, WHITE], "{bits}");
    }
    // 32 bits a pixel: the last 8 are alpha, as the descriptor says.
    let file = tga(2, None, (1, 1), 32, TOP | 8, &[0, 0, 255, 128]);
    assert_eq!(colors(&file, Encoding::TgaRle), [Color { a: 128, ..RED }]);
}

/// The format advises against it, but writers do it, and readers must cope.
#[test]
fn tga_whose_packets_go_on_in_the_next_row() {
    let file = tga(10, None, (2, 2), 24, TOP, &[0x82, 0, 0, 255, 0x00, 0, 255, 0]);
    assert_eq!(colors(&file, Encoding::TgaRle), [RED, RED, RED, GREEN]);
    let file = tga(11, None, (3, 1), 8, TOP, &[0x82, 7]);
    assert_eq!(colors(&file, Encoding::TgaRle), [Color::rgb(7, 7, 7); 3]);
    // A packet that is longer than the picture is no reason to write beyond it.
    let long = tga(11, None, (3, 1), 8, TOP, &[0xff, 7]);
    assert!(
        Image::decode(&long, Encoding::TgaRle).is_err_and(|error| !error.to_string().is_empty())
            || colors(&long, Encoding::TgaRle).len() == 3
    );
}

#[test]
fn png_of_every_depth() {
    let grey = |level: u8| Color::rgb(level, level, level);
    for (bits, row, expected) in [
        (1, &[0b1010_0000][..], [255, 0, 255]),
        (2, &[0b1101_0000], [255, 85, 0]),
        (4, &[0xf3, 0x00], [255, 51, 0]),
        (8, &[255, 7, 0], [255, 7, 0]),
        // Of 16 bits the lower 8 are lost.
        (16, &[255, 255, 7, 7, 0, 0], [255, 7, 0]),
    ] {
        let file = png((3, 1), [bits, 0, 0], &[], &[&[0], row].concat());
        assert_eq!(colors(&file, Encoding::Png), expected.map(grey), "{bits}");
    }
    let file = png((2, 1), [8, 4, 0], &[], &[0, 9, 255, 20, 128]);
    assert_eq!(colors(&file, Encoding::Png), [grey(9), Color { a: 128, ..grey(20) }]);
    let file = png((1, 1), [16, 6, 0], &[], &[0, 255, 255, 0, 0, 0, 0, 128, 128]);
    assert_eq!(colors(&file, Encoding::Png), [Color { a: 128, ..RED }]);
}

#[test]
fn png_with_a_palette() {
    let palette = [255, 0, 0, 0, 255, 0, 0, 0, 255];
    for (bits, row) in [(2, &[0b0001_1000][..]), (4, &[0x01, 0x20]), (8, &[0, 1, 2])] {
        let file = png((3, 1), [bits, 3, 0], &palette, &[&[0], row].concat());
        assert_eq!(colors(&file, Encoding::Png), [RED, GREEN, BLUE], "{bits}");
    }
    // A palette that ends within a colour is an error, whether or not that colour is used.
    for length in [4, 5, 7, 8] {
        let file = png((1, 1), [8, 3, 0], &palette[..length], &[0, 0]);
        assert!(Image::decode(&file, Encoding::Png).is_err(), "{length}");
    }
    // An index beyond the palette is an error or black, and never another's memory.
    let file = png((1, 1), [8, 3, 0], &palette, &[0, 200]);
    assert!(Image::decode(&file, Encoding::Png).is_err() || colors(&file, Encoding::Png) == [Color::BLACK]);
}

/// Adam7: a picture of 3×2 has pixels in its first, fifth, sixth and seventh pass.
#[test]
fn png_interlaced() {
    let rows = [0, 1, 0, 3, 0, 2, 0, 4, 5, 6];
    let file = png((3, 2), [8, 0, 1], &[], &rows);
    let grey = [1, 2, 3, 4, 5, 6].map(|level| Color::rgb(level, level, level));
    assert_eq!(colors(&file, Encoding::Png), grey);
}

/// A small file that says it is a large picture is refused before the picture is made.
#[test]
fn png_bombs_are_refused() {
    for (size, bits, color) in
        [((16_384, 16_384), 16, 6), ((u32::MAX >> 1, 1), 8, 0), ((16_385, 1), 8, 0), ((0, 1), 8, 0)]
    {
        let file = png(size, [bits, color, 0], &[], &[0; 9]);
        let counted =
            allocation_counter::measure(|| assert!(Image::decode(&file, Encoding::Png).is_err(), "{size:?}"));
        assert!(counted.bytes_max < 1 << 20, "{size:?}: {} bytes", counted.bytes_max);
    }
}
