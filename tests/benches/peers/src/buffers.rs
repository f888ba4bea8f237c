//! A scene as other renderers want it: whole vertices, and a list of indices.

use common::{Vec2, Vec3};
use speed_scenes::Scene;

/// A vertex.
#[derive(Clone, Copy)]
pub(crate) struct Corner {
    pub(crate) position: Vec3,
    /// Of length 1.
    pub(crate) normal: Vec3,
    pub(crate) uv: Vec2,
}

/// The vertices of a scene, and for each triangle the numbers of three of them.
pub(crate) fn buffers(scene: &Scene) -> (Vec<Corner>, Vec<u32>) {
    let surface = scene.surface();
    let (model, normals) = (surface.uniforms.model, surface.uniforms.normals);
    let corner = |vertex: &clipping::mesh::Vertex| {
        let (face, corner) = (vertex.face as usize, vertex.corner as usize);
        Corner {
            position: model.positions()[vertex.position as usize],
            normal: normals[face][corner],
            uv: model.uv(face, corner),
        }
    };
    let corners = surface.mesh.vertices.iter().map(corner).collect();
    (corners, surface.mesh.triangles().flat_map(|(_, triangle)| triangle).collect())
}
