//! The course's head and its floors: a page need not load a reader of their files, nor their digits.
//!
//! A test compares them with those files; `cargo test -p live -- --ignored pack` writes what is packed.

use std::sync::OnceLock;

use assets::floor::{checks, slabs};
use assets::mesh::{Corner, Mesh};
use common::direction::unit;
use common::{Color, DVec2, DVec3, Format, Image, Model, Vec3};
use filtering::scene::fine;
use perspective::scene::Loaded;
use textures::Wrap;

use crate::head::sound;

/// The head in the fewest triangles that there is, and after it its texture. A page has them beside the code, and hands them
/// over.
pub const HEAD: &[u8] = include_bytes!("../packed/head.bin");
/// What was handed over.
static GIVEN: OnceLock<Vec<u8>> = OnceLock::new();
/// The side of the texture in texels.
const SIDE: u16 = 192;
/// The side of the blocks that it is packed in.
const BLOCK: u16 = 4;

/// Takes [`HEAD`] from a page, before the first figure is drawn.
pub fn give(head: Vec<u8>) {
    // Whoever hands it over twice hands over the same.
    let _ = GIVEN.set(head);
}

/// The head with its texture.
pub(crate) fn head() -> Loaded {
    // The code for a page has nothing but what is given.
    let own = if cfg!(target_family = "wasm") { &[] } else { HEAD };
    let mut rest = Rest(GIVEN.get().map_or(own, Vec::as_slice));
    let mesh = unpacked(&mut rest);
    loaded(&mesh, texture(rest.0), Wrap::Clamp)
}

/// Lesson 10's floor.
pub(crate) fn floor() -> Loaded {
    loaded(&assets::floor::floor(), checks(), Wrap::Repeat)
}

/// Lesson 11's floor, in few large triangles, its texture as lesson 13 has it.
pub(crate) fn few_slabs() -> Loaded {
    loaded(&slabs(), fine(&checks()), Wrap::Repeat)
}

/// A mesh with its texture.
fn loaded(mesh: &Mesh, texture: Image, wrap: Wrap) -> Loaded {
    let triangles = |number: fn(&Corner) -> usize| {
        mesh.triangles.iter().map(|corners| corners.each_ref().map(|corner| number(corner) as u32)).collect()
    };
    let positions = mesh.positions.iter().map(|position| position.as_vec3()).collect();
    let uvs = mesh.uvs.iter().map(|uv| uv.as_vec2()).collect();
    let model = Model::from_triangles(positions, triangles(|corner| corner.position))
        .and_then(|model| model.with_uvs(uvs, triangles(|corner| corner.uv)));
    let normal = |corner: Corner| unit(mesh.normals[corner.normal].as_vec3()).unwrap_or_default();
    Loaded {
        model: sound(model),
        normals: mesh.triangles.iter().map(|corners| corners.map(normal)).collect(),
        texture,
        wrap,
    }
}

/// The head's mesh: its lists, each after how many are in it.
fn unpacked(rest: &mut Rest) -> Mesh {
    let positions = rest.list(|rest| DVec3::from_array(rest.numbers()));
    let uvs = rest.list(|rest| DVec2::from_array(rest.numbers()));
    let normals = rest.list(|rest| DVec3::from_array(rest.numbers()));
    let mut next = [0; 3];
    let mut corner = |rest: &mut Rest| {
        // What is named here first comes next in its list; else it is told how far back in the list it is.
        let [position, uv, normal] = std::array::from_fn(|n| {
            let [back] = rest.bytes();
            next[n] += usize::from(back == 0);
            next[n] - usize::from(back).max(1)
        });
        Corner { position, uv, normal }
    };
    let triangles = rest.list(|rest| [corner(rest), corner(rest), corner(rest)]);
    Mesh { positions, uvs, normals, triangles }
}

/// What is left to be read of the head.
struct Rest<'a>(&'a [u8]);

impl Rest<'_> {
    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        let (bytes, rest) = self.0.split_first_chunk().expect("it is one of ours");
        self.0 = rest;
        *bytes
    }

    /// Numbers with five decimals, as the course's files have them, in three bytes each.
    fn numbers<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| {
            let [a, b, c] = self.bytes();
            f64::from(i32::from_le_bytes([0, a, b, c]) >> 8) / 1e5
        })
    }

    fn list<T>(&mut self, mut item: impl FnMut(&mut Self) -> T) -> Vec<T> {
        let count = u16::from_le_bytes(self.bytes());
        (0..count).map(|_| item(self)).collect()
    }
}

/// The head's texture, made smaller. It is packed as graphics hardware has it (BC1): each block of 4×4 texels has two colours
/// of 16 bits, and of each texel two bits say which of the four it has that divide the way between them into three.
fn texture(packed: &[u8]) -> Image {
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    for (block, (x, y)) in packed.as_chunks::<8>().0.iter().zip(places()) {
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

    use common::Attributes;

    use super::*;

    fn course(name: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets").join(name)
    }

    #[test]
    fn models_are_the_courses() {
        for (name, own) in [("head-low.obj", head()), ("floor.obj", floor()), ("slabs.obj", few_slabs())] {
            let model = Model::read(&course(name), Attributes { normals: true, uvs: true }).unwrap();
            let Loaded { model, normals, .. } = Loaded::new(model, checks(), Wrap::Clamp);
            assert!(own.model.faces().eq(model.faces()), "{name}");
            assert!(own.model.face_uvs().eq(model.face_uvs()), "{name}");
            assert_eq!(own.normals, normals, "{name}");
        }
    }

    #[test]
    fn the_texture_is_the_courses() {
        let (original, unpacked) =
            (Image::read(&course("head.tga")).unwrap().scale(SIDE, SIDE), head().texture);
        let difference = |((_, _, a), (_, _, b)): ((i32, i32, Color), (i32, i32, Color))| distance(a, b);
        let sum: f32 = original.pixels().zip(unpacked.pixels()).map(difference).sum();
        let mean = sum / f32::from(SIDE).powi(2);
        assert!(mean < 6.0, "texels differ by {mean}");
    }

    #[test]
    #[ignore = "writes what is packed"]
    fn pack() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("packed");
        let mut all = packed(&assets::head::low_model());
        let image = Image::read(&course("head.tga")).unwrap().scale(SIDE, SIDE);
        all.extend(places().flat_map(|place| block(&image, place)));
        std::fs::write(folder.join("head.bin"), all).unwrap();
    }

    fn packed(mesh: &Mesh) -> Vec<u8> {
        let count = |list: usize| u16::try_from(list).unwrap().to_le_bytes();
        let numbers = |numbers: &[f64]| {
            // Rounded as in the file.
            let digits = |number: &f64| format!("{number:.5}").replace('.', "").parse::<i32>().unwrap();
            let bytes = |number: &f64| digits(number).to_le_bytes().into_iter().take(3);
            numbers.iter().flat_map(bytes).collect::<Vec<u8>>()
        };
        let mut all = Vec::new();
        all.extend(count(mesh.positions.len()));
        mesh.positions.iter().for_each(|position| all.extend(numbers(&position.to_array())));
        all.extend(count(mesh.uvs.len()));
        mesh.uvs.iter().for_each(|uv| all.extend(numbers(&uv.to_array())));
        all.extend(count(mesh.normals.len()));
        mesh.normals.iter().for_each(|normal| all.extend(numbers(&normal.to_array())));
        all.extend(count(mesh.triangles.len()));
        let mut next = [0; 3];
        for corner in mesh.triangles.iter().flatten() {
            for (next, number) in next.iter_mut().zip([corner.position, corner.uv, corner.normal]) {
                all.push(u8::try_from(*next - number).unwrap());
                *next = (number + 1).max(*next);
            }
        }
        all
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
