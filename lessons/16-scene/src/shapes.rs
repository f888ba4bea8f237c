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

#[cfg(test)]
mod tests {
    use super::*;

    /// What holds of a convex body about the origin: normals are unit vectors out of it, triangles run counterclockwise seen
    /// from outside, and there is a neighbour at each side.
    fn assert_convex(shape: &Shape, name: &str) {
        let Shape { vertices, triangles } = shape;
        let mut sides = Vec::new();
        for triangle in triangles {
            let [a, b, c] = triangle.map(|vertex| vertices[vertex as usize]);
            let across = (b.position - a.position).cross(c.position - a.position);
            for vertex in [a, b, c] {
                assert!(across.dot(vertex.position) > 0.0 && across.dot(vertex.normal) > 0.0, "{name}");
                assert!((vertex.normal.length() - 1.0).abs() < 1e-6, "{name}");
            }
            let [a, b, c] = [a, b, c].map(|vertex| (vertex.position + 0.0).to_array().map(f32::to_bits));
            sides.extend([[a, b], [b, c], [c, a]]);
        }
        let mut turned: Vec<_> = sides.iter().map(|&[from, to]| [to, from]).collect();
        sides.sort_unstable();
        turned.sort_unstable();
        assert_eq!(sides, turned, "{name}");
        sides.dedup();
        assert_eq!(sides.len(), turned.len(), "{name}");
    }

    #[test]
    fn a_cube_has_side_1_and_twelve_triangles_that_face_outwards() {
        let cube = cube();
        assert_convex(&cube, "cube");
        assert_eq!((cube.vertices.len(), cube.triangles.len()), (24, 12));
        assert!(cube.vertices.iter().all(|vertex| vertex.position.abs() == Vec3::splat(0.5)));
        // A texture stands upright and is not mirrored on each face: (u, v) turn as the corners do.
        for triangle in &cube.triangles {
            let [a, b, c] = triangle.map(|vertex| cube.vertices[vertex as usize].uv);
            assert_eq!((b - a).perp_dot(c - a), 1.0);
        }
    }

    #[test]
    fn a_sphere_has_radius_1_and_is_closed() {
        for (latitudes, longitudes) in [(2, 3), (2, 40), (3, 6), (5, 4), (31, 3), (32, 64)] {
            let name = format!("{latitudes}x{longitudes}");
            let sphere = sphere(latitudes, longitudes);
            assert_convex(&sphere, &name);
            assert_eq!(sphere.triangles.len(), 2 * longitudes * (latitudes - 1), "{name}");
            assert_eq!(sphere.vertices.len(), 2 * longitudes + (latitudes - 1) * (longitudes + 1), "{name}");
            assert!(sphere.vertices.iter().all(|vertex| vertex.normal == vertex.position), "{name}");
            assert_eq!(sphere.vertices[0].position, Vec3::Y, "{name}");
            assert_eq!(sphere.vertices[sphere.vertices.len() - 1].position, Vec3::NEG_Y, "{name}");
        }
    }

    /// In no triangle does the texture run backwards, as it would where one column had both u = 0 and u = 1.
    #[test]
    fn the_texture_of_a_sphere_has_a_seam() {
        let Shape { vertices, triangles } = sphere(6, 8);
        for triangle in &triangles {
            let [a, b, c] = triangle.map(|vertex| vertices[vertex as usize].uv);
            let area = (b - a).perp_dot(c - a) * 48.0;
            assert!((area - 1.0).abs() < 1e-5, "{area}");
        }
        // A quarter of the way round from +z is +x.
        let east = vertices.iter().find(|vertex| vertex.uv == Vec2::new(0.25, 0.5)).unwrap();
        assert!(east.position.abs_diff_eq(Vec3::X, 1e-7));
    }

    #[test]
    #[should_panic(expected = "two latitudes and three longitudes at least")]
    fn a_sphere_of_two_longitudes_would_be_flat() {
        let _ = sphere(2, 2);
    }

    /// Corners are one vertex where position and normal agree.
    #[test]
    fn a_model_becomes_vertices() {
        let square = vec![Vec3::ZERO, Vec3::X, Vec3::ONE, Vec3::Y];
        let model = Model::from_triangles(square, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let flat = Shape::of(&model, &[[Vec3::Z; 3]; 2]);
        assert_eq!((flat.vertices.len(), &flat.triangles[..]), (4, &[[0, 1, 2], [0, 2, 3]][..]));
        assert_eq!(flat.vertices[2], Vertex { position: Vec3::ONE, normal: Vec3::Z, uv: Vec2::ZERO });
        let bent = Shape::of(&model, &[[Vec3::Z; 3], [Vec3::X; 3]]);
        assert_eq!((bent.vertices.len(), &bent.triangles[..]), (6, &[[0, 1, 2], [3, 4, 5]][..]));
    }
}
