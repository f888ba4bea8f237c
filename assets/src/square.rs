//! A square to carry a picture.

use glam::{DVec2, DVec3};

use crate::mesh::{Corner, Mesh};

/// The square from −1 to 1 in x and y at z = 0, in 2 triangles; it faces +z, and shows the whole texture upright.
#[must_use]
pub fn square() -> Mesh {
    let uvs = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    let [a, b, c, d] = [0, 1, 2, 3].map(|n| Corner { position: n, uv: n, normal: 0 });
    Mesh {
        positions: uvs.map(|uv| (2.0 * uv - 1.0).extend(0.0)).to_vec(),
        uvs: uvs.to_vec(),
        normals: vec![DVec3::Z],
        triangles: vec![[a, b, c], [a, c, d]],
    }
}
