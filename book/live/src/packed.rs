//! Models and a texture of the course, packed: a page need not load a reader of their files, nor their digits.
//!
//! A test compares them with those files; `cargo test -p live -- --ignored pack` writes them.

use common::{Color, Format, Image, Model, Vec3};
use perspective::scene::Loaded;
use textures::Wrap;

/// The head in the fewest triangles that there is.
pub(crate) const HEAD: &[u8] = include_bytes!("../packed/head.bin");
/// Lesson 10's floor.
pub(crate) const FLOOR: &[u8] = include_bytes!("../packed/floor.bin");
/// Lesson 11's floor, in few large triangles.
pub(crate) const SLABS: &[u8] = include_bytes!("../packed/slabs.bin");

/// The head's texture.
const TEXTURE: &[u8] = include_bytes!("../packed/texture.bin");
/// Its side in texels.
const SIDE: u16 = 192;
/// The side of the blocks that it is packed in.
const BLOCK: u16 = 4;

/// What is left to be read of a model: lists of numbers, each after how many they are.
struct Lists<'a>(&'a [u8]);

impl Lists<'_> {
    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        let (bytes, rest) = self.0.split_first_chunk().expect("it is one of ours");
        self.0 = rest;
        *bytes
    }

    fn list<const N: usize>(&mut self) -> Vec<[u8; N]> {
        let count = u16::from_le_bytes(self.bytes());
        (0..count).map(|_| self.bytes()).collect()
    }

    fn vectors(&mut self) -> Vec<Vec3> {
        let numbers: Vec<f32> = self.list().into_iter().map(f32::from_le_bytes).collect();
        numbers.chunks_exact(3).map(Vec3::from_slice).collect()
    }

    fn triangles(&mut self) -> Vec<[u32; 3]> {
        let numbers: Vec<u32> =
            self.list().into_iter().map(|bytes| u16::from_le_bytes(bytes).into()).collect();
        numbers.as_chunks().0.to_vec()
    }
}

/// A model with its normals, and the texture that it is to have.
pub(crate) fn loaded(packed: &[u8], texture: Image, wrap: Wrap) -> Loaded {
    let mut lists = Lists(packed);
    let (positions, triangles) = (lists.vectors(), lists.triangles());
    let (uvs, uv_triangles) = (lists.vectors(), lists.triangles());
    let (normals, normal_triangles) = (lists.vectors(), lists.triangles());
    let uvs = uvs.into_iter().map(Vec3::truncate).collect();
    let model =
        Model::from_triangles(positions, triangles).and_then(|model| model.with_uvs(uvs, uv_triangles));
    Loaded {
        model: model.expect("it is one of ours"),
        normals: normal_triangles.into_iter().map(|triangle| triangle.map(|i| normals[i as usize])).collect(),
        texture,
        wrap,
    }
}

/// The head's texture, made smaller. It is packed as graphics hardware has it (BC1): each block of 4×4 texels has two colours
/// of 16 bits, and of each texel two bits say which of the four it has that divide the way between them into three.
pub(crate) fn texture() -> Image {
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    for (block, (x, y)) in TEXTURE.as_chunks::<8>().0.iter().zip(places()) {
        let &[a, b, c, d, ref bits @ ..] = block;
        let colors = between([[a, b], [c, d]].map(u16::from_le_bytes));
        let bits = u32::from_le_bytes(*bits);
        for n in 0..16 {
            image.set(x + n % 4, y + n / 4, colors[(bits >> (2 * n) & 3) as usize]);
        }
    }
    image
}

/// Where the blocks are.
fn places() -> impl Iterator<Item = (i32, i32)> {
    let starts = || (0..i32::from(SIDE)).step_by(BLOCK.into());
    starts().flat_map(move |y| starts().map(move |x| (x, y)))
}

/// A block's four colours.
fn between(ends: [u16; 2]) -> [Color; 4] {
    let [first, last] = ends.map(|end| {
        let part = |shift: u32, bits: u32| u32::from(end) >> shift & ((1 << bits) - 1);
        Vec3::new(part(11, 5) as f32 / 31.0, part(5, 6) as f32 / 63.0, part(0, 5) as f32 / 31.0)
    });
    [0.0, 1.0, 1.0 / 3.0, 2.0 / 3.0].map(|share| {
        let color = (first.lerp(last, share) * 255.0).round();
        Color::rgb(color.x as u8, color.y as u8, color.z as u8)
    })
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use common::{Attributes, Vec2};

    use super::*;

    fn course(name: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets").join(name)
    }

    fn original(name: &str) -> Loaded {
        let model = Model::read(&course(name), Attributes { normals: true, uvs: true }).unwrap();
        Loaded::new(model, Image::new(1, 1, Format::Rgb), Wrap::Clamp)
    }

    const MODELS: [(&str, &str, &[u8]); 3] = [
        ("head-low.obj", "head.bin", HEAD),
        ("floor.obj", "floor.bin", FLOOR),
        ("slabs.obj", "slabs.bin", SLABS),
    ];

    #[test]
    fn models_are_the_courses() {
        for (name, _, packed) in MODELS {
            let (original, unpacked) =
                (original(name), loaded(packed, Image::new(1, 1, Format::Rgb), Wrap::Clamp));
            assert_eq!(unpacked.model.positions(), original.model.positions(), "{name}");
            assert_eq!(unpacked.model.triangles(), original.model.triangles(), "{name}");
            assert!(unpacked.model.face_uvs().eq(original.model.face_uvs()), "{name}");
            assert_eq!(unpacked.normals, original.normals, "{name}");
        }
    }

    #[test]
    fn the_texture_is_the_courses() {
        let (original, unpacked) = (Image::read(&course("head.tga")).unwrap().scale(SIDE, SIDE), texture());
        let difference = |((_, _, a), (_, _, b)): ((i32, i32, Color), (i32, i32, Color))| distance(a, b);
        let sum: f32 = original.pixels().zip(unpacked.pixels()).map(difference).sum();
        let mean = sum / f32::from(SIDE).powi(2);
        assert!(mean < 6.0, "texels differ by {mean}");
    }

    #[test]
    #[ignore = "writes what is packed"]
    fn pack() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("packed");
        for (name, packed, _) in MODELS {
            let Loaded { model, normals, .. } = original(name);
            let mut bytes = Vec::new();
            let positions = model.positions();
            write(&mut bytes, positions, model.triangles().iter().flatten().map(|&i| i as usize).collect());
            let uvs: Vec<Vec3> = model.face_uvs().flatten().map(|uv: Vec2| uv.extend(0.0)).collect();
            for corners in [uvs, normals.into_iter().flatten().collect()] {
                let mut different: Vec<Vec3> = Vec::new();
                let mut number = |corner: Vec3| {
                    let known = different.iter().position(|&other| other == corner);
                    known.unwrap_or_else(|| {
                        different.push(corner);
                        different.len() - 1
                    })
                };
                let numbers = corners.into_iter().map(&mut number).collect();
                write(&mut bytes, &different, numbers);
            }
            std::fs::write(folder.join(packed), bytes).unwrap();
        }
        let image = Image::read(&course("head.tga")).unwrap().scale(SIDE, SIDE);
        let blocks: Vec<u8> = places().flat_map(|place| block(&image, place)).collect();
        std::fs::write(folder.join("texture.bin"), blocks).unwrap();
    }

    fn write(bytes: &mut Vec<u8>, vectors: &[Vec3], numbers: Vec<usize>) {
        bytes.extend(u16::try_from(3 * vectors.len()).unwrap().to_le_bytes());
        bytes.extend(vectors.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes));
        bytes.extend(u16::try_from(numbers.len()).unwrap().to_le_bytes());
        bytes.extend(numbers.into_iter().flat_map(|number| u16::try_from(number).unwrap().to_le_bytes()));
    }

    fn distance(a: Color, b: Color) -> f32 {
        let [a, b] = [a, b].map(|color| Vec3::new(color.r.into(), color.g.into(), color.b.into()));
        a.distance(b)
    }

    /// The two of its texels as ends that leave the smallest differences.
    fn block(image: &Image, (x, y): (i32, i32)) -> [u8; 8] {
        let texels: Vec<Color> = (0..16).map(|n| image.get(x + n % 4, y + n / 4).unwrap()).collect();
        let code = |color: Color| {
            let part = |value: u8, last: u16| (u16::from(value) * last + 127) / 255;
            part(color.r, 31) << 11 | part(color.g, 63) << 5 | part(color.b, 31)
        };
        let nearest = |ends: [u16; 2], texel: Color| {
            let differences = between(ends).map(|color| distance(color, texel).powi(2));
            differences.into_iter().enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
        };
        let pairs = texels.iter().flat_map(|&a| texels.iter().map(move |&b| [a, b].map(code)));
        let loss = |ends: &[u16; 2]| texels.iter().map(|&texel| nearest(*ends, texel).1).sum::<f32>();
        let ends = pairs.min_by(|a, b| loss(a).total_cmp(&loss(b))).unwrap();
        let choices = texels.iter().map(|&texel| nearest(ends, texel).0 as u32);
        let bits = choices.enumerate().fold(0, |bits, (n, choice)| bits | choice << (2 * n));
        let [[a, b], [c, d]] = ends.map(u16::to_le_bytes);
        let [e, f, g, h] = bits.to_le_bytes();
        [a, b, c, d, e, f, g, h]
    }
}
