//! Files as they arrive: cut off, joined, with bytes that were other bytes. Whatever they hold, reading one gives a
//! model or a picture, or one line that says why not; it does not panic, and takes no more memory than it may.
//!
//! 10,000 of them in these tests; `.ci/fuzz` takes a million.

use std::sync::LazyLock;

use common::file::Encoding;
use common::{Attributes, Color, Format, Image, Model, Vec3};
use proptest::prelude::*;
use proptest::sample::Index;

use crate::formats::{crc, png, tga};

/// Every kind of line that is known to have been misread by someone.
const MODELS: &[&str] = &[
    "o a\nv 0 0 0\nv 1 0 0 1\nv 1 1 -1e0\nvt 0 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf -1//-1 -2//-1 -3//-1\nf 1 2 3 1\nl 1 2 3\nmtllib a.mtl\nusemtl b\n",
    "\u{feff}v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0\r\nf 1/1 2/1 3/1\r\n# caf\u{e9} \\\r\nf 1 2\\\r\n 3",
    "v 0 0 0\rv 1 0 0\rv 1 1 0\rv .2 .1 0\rf 1 2 3 4 \\ \n1\nf\\\n1 2 3\r",
    "v 0,8 0,8 0\nv 1.0D-01 nan inf\nv 1e999 -1e-999 +.5\nvn 0 0 1,\nvn nan 0 0\nf 1 2 3\nf 0 -9 99999999999999999999\nf 1/ 2/ /3\n",
    "v 500000.37 4649776.81 212.4\nv 500001.37 4649776.81 212.4\nv 500001.37 4649777.81 213.4\nv 500000.37 4649777.81 212.4\nf 4 3 2 1\n",
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nv 2 2 0\nv 2 0 0\nf 1 7 2 3 4 5\nf 5 4 3 2 7 1\nf 1 3 2 5 4 6\nf 1 1 1 1\n",
    "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n",
    "<!DOCTYPE html><html>\nv 0 0 0\nf 1 1 1\n",
    "ply\nformat ascii 1.0\nelement vertex 3\n",
    "vp 1\np 1\ncurv 0 1 1 2\ns off\ng\no\nl 1\nl -1 -1\nv 1 2 3 4 5 6\n",
];

/// Pictures of every kind that is read, small.
static PICTURES: LazyLock<Vec<(Vec<u8>, Encoding)>> = LazyLock::new(|| {
    let mut all = Vec::new();
    for format in [Format::Gray, Format::Rgb, Format::Rgba] {
        let mut image = Image::new(7, 5, format);
        (0..20).for_each(|n| image.set(n % 7, n / 7, Color::random(n as u64 / 3)));
        for encoding in [Encoding::TgaRle, Encoding::TgaRaw, Encoding::Png] {
            all.push((image.encode(encoding).unwrap(), encoding));
        }
    }
    let map: [&[u8]; 2] = [&[0, 0, 255], &[0, 255, 0]];
    for file in [
        tga(1, Some((0, &map)), (2, 2), 8, 0x20, &[0, 1, 1, 0]),
        tga(9, Some((3, &map)), (2, 2), 8, 0, &[0x81, 3, 1, 4, 3]),
        tga(2, None, (2, 1), 16, 0x10, &[0, 0x7c, 0xe0, 3]),
        tga(10, None, (2, 2), 32, 0x38, &[0x82, 1, 2, 3, 4, 0, 5, 6, 7, 8]),
    ] {
        all.push((file, Encoding::TgaRle));
    }
    for file in [
        png((3, 1), [1, 0, 0], &[], &[0, 0b1010_0000]),
        png((3, 1), [2, 3, 0], &[255, 0, 0, 0, 255, 0], &[0, 0b0001_0000]),
        png((3, 2), [8, 0, 1], &[], &[0, 1, 0, 3, 0, 2, 0, 4, 5, 6]),
        png((1, 1), [16, 6, 0], &[], &[0, 1, 2, 3, 4, 5, 6, 7, 8]),
    ] {
        all.push((file, Encoding::Png));
    }
    all
});

/// One change of a file, at a place and with a piece of another file.
type Change = (u8, Index, Index, u8);

fn changes() -> impl Strategy<Value = Vec<Change>> {
    prop::collection::vec((0..7u8, any::<Index>(), any::<Index>(), any::<u8>()), 1..12)
}

fn changed(bytes: &mut Vec<u8>, other: &[u8], changes: &[Change]) {
    for &(kind, at, to, byte) in changes {
        if bytes.is_empty() {
            bytes.push(byte);
        }
        let (from, until) = (at.index(bytes.len()), to.index(bytes.len() + 1));
        match kind {
            0 | 1 => bytes[from] = byte,
            2 => bytes[from] ^= 1 << (byte % 8),
            3 => bytes.insert(from, byte),
            4 if from < until && until - from < 40 => drop(bytes.drain(from..until)),
            5 => {
                let begin = to.index(other.len());
                let piece = &other[begin..other.len().min(begin + usize::from(byte % 40))];
                bytes.splice(from..from, piece.iter().copied());
            }
            6 if byte < 20 => bytes.truncate(until),
            _ => bytes[from] = b"0123456789-/ \n\r\\.ef"[usize::from(byte) % 19],
        }
    }
}

/// Makes a changed PNG file's checksums right again, so that what it says is looked at.
fn mend(bytes: &mut [u8]) {
    let mut at = 8;
    while let Some(head) = bytes.get(at..at + 8) {
        let length = u32::from_be_bytes([head[0], head[1], head[2], head[3]]) as usize;
        let Some(end) = at.checked_add(12 + length).filter(|&end| end <= bytes.len()) else { return };
        let sum = crc(&bytes[at + 4..end - 4]);
        bytes[end - 4..end].copy_from_slice(&sum.to_be_bytes());
        at = end;
    }
}

/// How many files of each kind.
fn cases() -> ProptestConfig {
    let cases = std::env::var("FUZZ_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(5_000);
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn any_model_is_read_or_refused_in_one_line(
        pair in prop::array::uniform2(0..MODELS.len()),
        changes in changes(),
        normals in any::<bool>(),
        uvs in any::<bool>(),
    ) {
        let mut bytes = MODELS[pair[0]].as_bytes().to_vec();
        changed(&mut bytes, MODELS[pair[1]].as_bytes(), &changes);
        let mut result = Ok(());
        let counted = allocation_counter::measure(|| {
            result = without_panic(|| match Model::parse(&bytes, Attributes { normals, uvs }) {
                Ok(model) => check(&model),
                Err(reason) => one_line(&reason),
            });
        });
        prop_assert!(result.is_ok(), "{}: {:?}", result.unwrap_err(), String::from_utf8_lossy(&bytes));
        // What cutting a face takes, and for each byte of the file what an element of two bytes may take.
        let limit = 65_536 + 300 * bytes.len() as u64;
        prop_assert!(counted.bytes_max <= limit, "{} bytes: {:?}", counted.bytes_max, String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn any_picture_is_read_or_refused_in_one_line(
        pair in prop::array::uniform2(any::<Index>()),
        changes in changes(),
        mended in prop::bool::weighted(0.8),
    ) {
        let [(file, encoding), (other, _)] = pair.map(|index| index.get(&PICTURES));
        let mut bytes = file.clone();
        changed(&mut bytes, other, &changes);
        if mended && *encoding == Encoding::Png {
            mend(&mut bytes);
        }
        let mut result = Ok(());
        let counted = allocation_counter::measure(|| {
            result = without_panic(|| match Image::decode(&bytes, *encoding) {
                Ok(_) => Ok(()),
                Err(error) => one_line(&error.to_string()),
            });
        });
        prop_assert!(result.is_ok(), "{}: {bytes:?}", result.unwrap_err());
        // The pixels as the decoder has them, in 8 bits, and with their rows turned round.
        prop_assert!(counted.bytes_max <= 3 * (256 << 20), "{} bytes: {bytes:?}", counted.bytes_max);
    }
}

/// What a lesson relies on.
fn check(model: &Model) -> Result<(), String> {
    let faces = model.faces().len();
    let finite = model.positions().iter().copied().chain(model.face_normals().flatten()).all(Vec3::is_finite)
        && model.face_uvs().flatten().all(common::Vec2::is_finite);
    let lines = model.lines().iter().flatten().all(|&end| (end as usize) < model.positions().len());
    let whole =
        [0, faces].contains(&model.face_normals().len()) && [0, faces].contains(&model.face_uvs().len());
    if !(finite && lines && whole && faces + model.lines().len() > 0) {
        return Err("not a model".into());
    }
    model
        .remarks()
        .iter()
        .chain(model.skipped().map(|skipped| &skipped.first))
        .try_for_each(|line| one_line(line))
}

/// What a reader says, or that it panicked. A panic may not leave what counts the memory: it would go on counting
/// for all later files.
fn without_panic(read: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(read)).unwrap_or_else(|_| Err("it panicked".into()))
}

fn one_line(text: &str) -> Result<(), String> {
    if text.is_empty() || text.contains(char::is_control) {
        Err(format!("not one line: {text:?}"))
    } else {
        Ok(())
    }
}
