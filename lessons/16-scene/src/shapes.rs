//! Shapes as triangles of shared vertices: a cube, a sphere, or what an OBJ file holds.

use std::f64::consts::PI;

use clipping::mesh::indexed;
use common::{Attributes, Model, Vec2, Vec3};

/// What is known at a vertex of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Where it is in the model's space.
    pub position: Vec3,
    /// The surface's unit normal, out of it.
    pub normal: Vec3,
    /// Texture coordinates, v up.
    pub uv: Vec2,
}

/// A surface: vertices, and triangles of them that run counterclockwise seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The vertices. Where normals or texture coordinates differ there are several at one place.
    pub vertices: Vec<Vertex>,
    /// For each triangle the numbers of its vertices.
    pub triangles: Vec<[u32; 3]>,
}

impl Shape {
    /// The triangles of a model with the unit normals at their corners. Texture coordinates are 0 where it has none.
    ///
    /// # Panics
    /// Where there are not as many triples of normals as triangles.
    #[must_use]
    pub fn of(model: &Model, normals: &[[Vec3; 3]]) -> Self {
        let uvs = model.face_uvs().len() > 0;
        let mesh = indexed(model, normals, Attributes { normals: true, uvs });
        let vertices = mesh.vertices.iter().map(|vertex| {
            let (face, corner) = (vertex.face as usize, vertex.corner as usize);
            Vertex {
                position: model.positions()[vertex.position as usize],
                normal: normals[face][corner],
                uv: if uvs { model.uv(face, corner) } else { Vec2::ZERO },
            }
        });
        Self {
            vertices: vertices.collect(),
            triangles: mesh.triangles().map(|(_, triangle)| triangle).collect(),
        }
    }
}

/// The faces of a cube, each by the directions to its right and up as seen from outside.
const FACES: [[Vec3; 2]; 6] = [
    [Vec3::X, Vec3::Y],
    [Vec3::NEG_Z, Vec3::Y],
    [Vec3::NEG_X, Vec3::Y],
    [Vec3::Z, Vec3::Y],
    [Vec3::X, Vec3::NEG_Z],
    [Vec3::X, Vec3::Z],
];

/// A cube of side 1 about the origin: six faces of two triangles, each with four vertices of its own, since three normals
/// meet at a corner. A texture fills each face.
// ANCHOR: cube
#[must_use]
pub fn cube() -> Shape {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for [right, up] in FACES {
        let normal = right.cross(up);
        let first = vertices.len() as u32;
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            let position = (normal + right * (2.0 * x - 1.0) + up * (2.0 * y - 1.0)) / 2.0;
            vertices.push(Vertex { position, normal, uv: Vec2::new(x, y) });
        }
        triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    Shape { vertices, triangles }
}
// ANCHOR_END: cube

/// A sphere of radius 1 about the origin, in so many belts from pole to pole, each in so many parts all around:
/// 2·longitudes·(latitudes − 1) triangles.
///
/// Row i of vertices, from the north pole at +y down, is at the angle θ = π·i/latitudes from it, column j at
/// φ = 2π·j/longitudes about the axis, from +z towards +x; (u, v) is (j/longitudes, 1 − i/latitudes). The first column is
/// there twice, with u = 0 and u = 1. A pole is a vertex for each triangle there, with u in its middle.
///
/// # Panics
/// Below two latitudes or three longitudes.
// ANCHOR: sphere
#[must_use]
pub fn sphere(latitudes: usize, longitudes: usize) -> Shape {
    assert!(latitudes >= 2 && longitudes >= 3, "a sphere takes two latitudes and three longitudes at least");
    let at_pole = |row: usize| row == 0 || row == latitudes;
    let (mut vertices, mut rows) = (Vec::new(), Vec::new());
    for i in 0..=latitudes {
        rows.push(vertices.len() as u32);
        for j in 0..longitudes + usize::from(!at_pole(i)) {
            // The column of u = 1 has just the positions of that of u = 0.
            let [theta, phi] =
                [PI * i as f64 / latitudes as f64, 2.0 * PI * (j % longitudes) as f64 / longitudes as f64];
            let across = if at_pole(i) { 0.0 } else { libm::sin(theta) };
            let normal =
                [across * libm::sin(phi), libm::cos(theta), across * libm::cos(phi)].map(|c| c as f32);
            let column = if at_pole(i) { j as f32 + 0.5 } else { j as f32 };
            let uv = Vec2::new(column / longitudes as f32, 1.0 - i as f32 / latitudes as f32);
            vertices.push(Vertex { position: normal.into(), normal: normal.into(), uv });
        }
    }
    let mut triangles = Vec::new();
    for (i, j) in (0..latitudes).flat_map(|i| (0..longitudes as u32).map(move |j| (i, j))) {
        let [upper, lower] = [rows[i] + j, rows[i + 1] + j];
        if !at_pole(i + 1) {
            triangles.push([upper, lower, lower + 1]);
        }
        if i == 0 {
            continue;
        }
        // Below is a vertex of its own for this triangle, where that is the pole.
        let below = if at_pole(i + 1) { lower } else { lower + 1 };
        triangles.push([upper, below, upper + 1]);
    }
    Shape { vertices, triangles }
}
// ANCHOR_END: sphere
