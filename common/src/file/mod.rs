//! Pictures in files, and files [written whole](write_whole) or not at all.
//!
//! Reading TGA, raw and run-length encoded pixels of 8, 15, 16, 24 and 32 bits are taken, colour maps, and any
//! corner as the origin; all of these become 8-bit grey, RGB or RGBA. PNG is written in 8 bits; 16-bit channels
//! are rounded to 8 when read, and a palette becomes RGB.
//!
//! TGA is ours, since it is small and the course's own format: each of its fields can be read in `file/tga.rs`. The `image`
//! crate is the second reader that tests hold it against. In every lesson's program it would be a sixth of the wait for
//! the compiler, since colour profiles come with it that no picture here has.

mod png;
mod tga;
mod whole;

use std::ffi::OsStr;
use std::fs::File;
use std::io::Read;
use std::path::Path;

pub use whole::write_whole;

use crate::{Error, Format, Image, PictureError, kind};

/// The longest picture file that is read, and the most memory that its pixels take, in bytes.
const FILE_LIMIT: u64 = 256 << 20;

/// The longest side of a picture that is read or asked for, in pixels.
pub const SIDE_LIMIT: u16 = 16_384;

/// The most pixels that are asked for: even with 4 bytes each, they can be read again.
pub const PIXEL_LIMIT: u32 = (FILE_LIMIT / 4) as u32;

/// Whether a picture of that size, in pixels, is within [`SIDE_LIMIT`] and [`PIXEL_LIMIT`].
#[must_use]
pub fn fits(width: u16, height: u16) -> bool {
    width.max(height) <= SIDE_LIMIT && u32::from(width) * u32::from(height) <= PIXEL_LIMIT
}

/// How a picture is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// TGA, run-length encoded: runs of one colour take the room of one pixel.
    TgaRle,
    /// TGA, every pixel written out.
    TgaRaw,
    /// PNG.
    Png,
}

impl Encoding {
    /// The encoding that a file's name asks for: `.tga` (run-length encoded) or `.png`, in any case.
    fn of(path: &Path) -> Result<Self, Error> {
        let small = |part: Option<&OsStr>| Some(part?.to_str()?.to_ascii_lowercase());
        let name = small(path.file_name());
        match small(path.extension()).as_deref() {
            Some("tga") => Ok(Self::TgaRle),
            Some("png") => Ok(Self::Png),
            _ if matches!(name.as_deref(), Some(".tga" | ".png")) => Err(Error::NoName { path: path.into() }),
            _ => Err(Error::Ending { path: path.into() }),
        }
    }
}

impl Image {
    /// Reads a TGA or PNG file, by its ending. A file of more than 256 MiB, or a picture with a side beyond
    /// [`SIDE_LIMIT`] or of more than 256 MiB in memory, is refused before anything is allocated for it.
    ///
    /// # Errors
    /// One that names the file where it has another ending, cannot be read, is too large, or is no picture.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let encoding = Encoding::of(path)?;
        let bytes = read_bytes(path, FILE_LIMIT)?;
        Self::decode(&bytes, encoding).map_err(|source| {
            let is_png = encoding == Encoding::Png && bytes.starts_with(kind::PNG);
            match kind::told(&bytes).filter(|_| !is_png) {
                Some(kind) => Error::Kind { path: path.into(), kind },
                None => Error::Picture { path: path.into(), source },
            }
        })
    }

    /// The picture in the bytes of a file. Either TGA encoding reads both.
    ///
    /// # Errors
    /// Where the bytes are not such a file, are too few, or describe a picture beyond the limits.
    pub fn decode(bytes: &[u8], encoding: Encoding) -> Result<Self, PictureError> {
        match encoding {
            Encoding::TgaRle | Encoding::TgaRaw => tga::decode(bytes),
            Encoding::Png => png::decode(bytes),
        }
    }

    /// Writes the picture as TGA (run-length encoded) or PNG, by the ending of the file's name. A file of
    /// that name is replaced once the new one is complete, and left alone where anything fails.
    ///
    /// # Errors
    /// One that names the file where it has another ending, its folder does not exist, the system refuses,
    /// or the picture has no pixels.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let encoding = Encoding::of(path)?;
        let bytes = self.encode(encoding).map_err(|source| Error::Encode { path: path.into(), source })?;
        write_whole(path, &bytes)
    }

    /// The bytes of the picture's file.
    ///
    /// # Errors
    /// Where the picture has no pixels.
    pub fn encode(&self, encoding: Encoding) -> Result<Vec<u8>, PictureError> {
        match encoding {
            Encoding::TgaRle => tga::encode(self, true),
            Encoding::TgaRaw => tga::encode(self, false),
            Encoding::Png => png::encode(self),
        }
    }
}

/// The sides of a picture that a file claims to have, if it may be read.
fn check_size(width: u32, height: u32, format: Format) -> Result<(u16, u16), PictureError> {
    let side = |side| u16::try_from(side).ok().filter(|&side| side <= SIDE_LIMIT);
    let (width, height) = side(width).zip(side(height)).ok_or(PictureError::TooLarge)?;
    if width.min(height) == 0 {
        return Err(PictureError::Empty);
    }
    let bytes = u64::from(width) * u64::from(height) * format as u64;
    if bytes > FILE_LIMIT { Err(PictureError::TooLarge) } else { Ok((width, height)) }
}

/// The bytes of a file that has at most `limit` of them; a pipe or a device is cut off there as well.
pub(crate) fn read_bytes(path: &Path, limit: u64) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(limit + 1).read_to_end(&mut bytes))
        .map_err(|source| Error::Read { path: path.into(), source })?;
    if bytes.len() as u64 > limit {
        return Err(Error::TooLarge { path: path.into(), limit });
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::Color;

    /// 5×3 pixels, different everywhere, with a run of equal ones for the run-length encoder.
    fn sample(format: Format) -> Image {
        let mut image = Image::new(5, 3, format);
        for (x, y) in (0..3).flat_map(|y| (0..5).map(move |x| (x, y))) {
            let color = Color::random(if y == 1 { 99 } else { (y * 5 + x) as u64 });
            image.set(x, y, Color { a: color.g, ..color });
        }
        image
    }

    #[test]
    fn every_format_survives_every_encoding() {
        for format in [Format::Gray, Format::Rgb, Format::Rgba] {
            for encoding in [Encoding::TgaRle, Encoding::TgaRaw, Encoding::Png] {
                let image = sample(format);
                let bytes = image.encode(encoding).unwrap();
                assert_eq!(Image::decode(&bytes, encoding).unwrap(), image, "{format:?} {encoding:?}");
            }
        }
    }

    /// A TGA file put together by hand from Truevision's specification (version 2.0, 1991).
    fn tga(image: &Image, rle: bool, top: bool, right: bool) -> Vec<u8> {
        let size = image.bytes_per_pixel();
        let kind = if size == 1 { 3 } else { 2 } + if rle { 8 } else { 0 };
        let (width, height) = (image.width() as u8, image.height() as u8);
        let alpha_bits = if size == 4 { 8 } else { 0 };
        let descriptor = u8::from(top) << 5 | u8::from(right) << 4 | alpha_bits;
        let mut bytes = vec![0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        bytes.extend([width, 0, height, 0, size as u8 * 8, descriptor]);
        for row in 0..image.height() {
            let y = if top { image.height() - 1 - row } else { row };
            let mut x = 0;
            while x < image.width() {
                let color = |x: i32| image.get(if right { image.width() - 1 - x } else { x }, y).unwrap();
                let run = (x..image.width()).take_while(|&next| color(next) == color(x)).count() as i32;
                if rle {
                    bytes.push(0x80 | (run - 1) as u8);
                }
                let Color { r, g, b, a } = color(x);
                bytes.extend(&[b, g, r, a][..size]);
                x += if rle { run } else { 1 };
            }
        }
        bytes
    }

    #[test]
    fn tga_is_read_in_every_depth_encoding_and_origin() {
        for format in [Format::Gray, Format::Rgb, Format::Rgba] {
            for (rle, top, right) in [false, true].iter().flat_map(|&rle| {
                [(rle, false, false), (rle, false, true), (rle, true, false), (rle, true, true)]
            }) {
                let image = sample(format);
                let read = Image::decode(&tga(&image, rle, top, right), Encoding::TgaRle);
                assert_eq!(read.unwrap(), image, "{format:?} rle {rle} top {top} right {right}");
            }
        }
    }

    #[test]
    fn a_truncated_file_is_an_error_at_every_length() {
        for encoding in [Encoding::TgaRle, Encoding::TgaRaw, Encoding::Png] {
            let bytes = sample(Format::Rgb).encode(encoding).unwrap();
            // PNG ends with 12 bytes that say no more than that it ends.
            let needed = if encoding == Encoding::Png { bytes.len() - 12 } else { bytes.len() };
            for length in 0..needed {
                assert!(Image::decode(&bytes[..length], encoding).is_err(), "{encoding:?} {length}");
            }
        }
    }

    /// The header of a TGA file of that kind (2 for colours, 3 for grey).
    fn header(kind: u8, width: u16, height: u16, bits: u8) -> [u8; 18] {
        let ([a, b], [c, d]) = (width.to_le_bytes(), height.to_le_bytes());
        [0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0, a, b, c, d, bits, 0]
    }

    #[test]
    fn a_header_that_claims_too_much_is_refused() {
        for (kind, width, height, bits) in
            [(2, u16::MAX, u16::MAX, 32), (2, 8192, 8193, 32), (3, SIDE_LIMIT + 1, 1, 8)]
        {
            let error = Image::decode(&header(kind, width, height, bits), Encoding::TgaRle).unwrap_err();
            assert!(matches!(error, PictureError::TooLarge), "{width}x{height}: {error}");
        }
    }

    #[test]
    fn what_may_be_asked_for_can_be_read() {
        for (width, height, may) in [
            (SIDE_LIMIT, 4096, true),
            (8192, 8192, true),
            (1, SIDE_LIMIT, true),
            (8192, 8193, false),
            (SIDE_LIMIT + 1, 1, false),
        ] {
            assert_eq!(fits(width, height), may, "{width}x{height}");
            if may {
                // Nothing but the pixels is missing.
                let error = Image::decode(&header(2, width, height, 32), Encoding::TgaRle).unwrap_err();
                assert!(matches!(error, PictureError::Truncated), "{width}x{height}: {error}");
            }
        }
    }

    #[test]
    fn a_file_may_have_as_many_bytes_as_the_limit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, b"12345").unwrap();
        for limit in [5, 6, 100] {
            assert_eq!(read_bytes(&path, limit).unwrap(), b"12345", "{limit}");
        }
        for limit in [0, 1, 4] {
            assert!(matches!(read_bytes(&path, limit), Err(Error::TooLarge { .. })), "{limit}");
        }
    }

    #[test]
    fn any_name_that_a_file_can_have_can_be_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x".repeat(251) + ".png");
        sample(Format::Rgb).write(&path).unwrap();
        assert_eq!(Image::read(&path).unwrap(), sample(Format::Rgb));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn threads_that_write_one_file_leave_one_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::thread::scope(|scope| {
            for n in 0..8 {
                let path = &path;
                scope.spawn(move || (0..20).for_each(|_| write_whole(path, &[n; 10_000]).unwrap()));
            }
        });
        let bytes = fs::read(&path).unwrap();
        assert_eq!(bytes, [bytes[0]; 10_000]);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_replaced_and_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let [file, link] = ["file", "link"].map(|name| folder.path().join(name));
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write_whole(&link, b"new").unwrap();
        assert_eq!([file, link].map(|path| fs::read(path).unwrap()), [b"old", b"new"]);
    }

    /// The lengths of the packets of a row sum up to its width.
    #[test]
    fn no_run_crosses_the_end_of_a_row() {
        for format in [Format::Gray, Format::Rgb, Format::Rgba] {
            // One colour: an encoder that does not heed rows makes one run of all.
            let picture = Image::new(20, 6, format);
            let bytes = picture.encode(Encoding::TgaRle).unwrap();
            let mut packets = &bytes[18..];
            let mut lengths = Vec::new();
            while let [head, rest @ ..] = packets {
                assert!(head & 0x80 != 0, "a run");
                lengths.push(1 + (head & 0x7f));
                packets = &rest[format as usize..];
            }
            assert_eq!(lengths, [20; 6], "{format:?}");
        }
    }

    #[test]
    fn a_picture_without_pixels_cannot_be_written() {
        for encoding in [Encoding::TgaRle, Encoding::TgaRaw, Encoding::Png] {
            assert!(Image::new(0, 3, Format::Rgb).encode(encoding).is_err());
        }
    }

    #[test]
    fn runs_make_a_file_small() {
        let black = Image::new(100, 100, Format::Rgb);
        let [rle, raw] =
            [Encoding::TgaRle, Encoding::TgaRaw].map(|encoding| black.encode(encoding).unwrap().len());
        assert_eq!(raw, 18 + 30_000);
        // A row of 100 pixels is one run.
        assert_eq!(rle, 18 + 100 * 4);
    }
}
