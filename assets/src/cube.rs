//! A cube whose faces each show the whole texture.

use glam::{DVec2, DVec3};

use crate::mesh::{Corner, Mesh};

/// The cube from −½ to ½, its 6 squares cut into 2 triangles each.
///
/// The 8 positions are shared by three faces each, the 4 texture coordinates by all six; a face has one normal.
/// From outside, each side shows the texture upright, or with its top at −z on the top and at z on the bottom.
#[must_use]
pub fn cube() -> Mesh {
    // What is to the right and what is up, as seen by one who looks at the face.
    let sides = [
        (DVec3::X, DVec3::Y),
        (DVec3::NEG_Z, DVec3::Y),
        (DVec3::NEG_X, DVec3::Y),
        (DVec3::Z, DVec3::Y),
        (DVec3::X, DVec3::NEG_Z),
        (DVec3::X, DVec3::Z),
    ];
    let mut mesh = Mesh {
        positions: (0..8).map(|n| DVec3::new(bit(n, 0), bit(n, 1), bit(n, 2)) - 0.5).collect(),
        uvs: [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from).to_vec(),
        ..Mesh::default()
    };
    for (right, up) in sides {
        let out = right.cross(up);
        let normal = mesh.normals.len();
        mesh.normals.push(out);
        let corner = |uv: usize| {
            let place = out + right * (2.0 * mesh.uvs[uv].x - 1.0) + up * (2.0 * mesh.uvs[uv].y - 1.0);
            let position = (0..3).map(|axis| usize::from(place[axis] > 0.0) << axis).sum();
            Corner { position, uv, normal }
        };
        let [a, b, c, d] = [0, 1, 2, 3].map(corner);
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
    }
    mesh
}

/// A bit of a number, as 0 or 1.
fn bit(n: u8, place: u8) -> f64 {
    f64::from(n >> place & 1)
}
