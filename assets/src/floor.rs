//! A floor to the horizon, and its checks.

use common::{Color, Format, Image};
use glam::{DVec2, DVec3};

use crate::mesh::{Corner, Mesh};

/// How far below the origin it lies: the head stands on it.
const BELOW: f64 = 0.996;
/// Where it is cut on either side of the middle: the farther out, the larger the cells.
const CUTS: [f64; 4] = [2.0, 8.0, 32.0, 128.0];

/// A square from −128 to 128, cut in both directions at 0, ±2, ±8, ±32 and ±128.
#[must_use]
pub fn floor() -> Mesh {
    let lines: Vec<f64> = CUTS.iter().rev().map(|x| -x).chain([0.0]).chain(CUTS).collect();
    cut_at(&lines)
}

/// The same square, cut at ±4, ±32 and ±128: the middle one of its 25 slabs is 8 wide, so that who stands near the head
/// stands on it, too.
#[must_use]
pub fn slabs() -> Mesh {
    cut_at(&[-128.0, -32.0, -4.0, 4.0, 32.0, 128.0])
}

/// A level square, cut by the same lines in both directions, each cell into two triangles. Texture coordinates are x and
/// −z, so that a texture of 2×2 texels has four in a square of side 1.
fn cut_at(lines: &[f64]) -> Mesh {
    let mut mesh = Mesh { normals: vec![DVec3::Y], ..Mesh::default() };
    for &z in lines {
        for &x in lines {
            mesh.positions.push(DVec3::new(x, -BELOW, z));
            mesh.uvs.push(DVec2::new(x, -z));
        }
    }
    let side = lines.len();
    let corner = |n: usize| Corner { position: n, uv: n, normal: 0 };
    for cell in (0..side * (side - 1)).filter(|cell| cell % side < side - 1) {
        // The row behind comes first in the list.
        let [a, b, c, d] = [cell + side, cell + side + 1, cell + 1, cell].map(corner);
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
    }
    mesh
}

/// A board of 2×2 fields, to be repeated.
#[must_use]
pub fn checks() -> Image {
    let [light, dark] = [Color::rgb(0xf2, 0xec, 0xde), Color::rgb(0x2f, 0x5d, 0x7c)];
    let mut image = Image::new(2, 2, Format::Rgb);
    for (x, y) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        image.set(x, y, if x == y { dark } else { light });
    }
    image
}
