//! What mission 16 gives: shapes made of vertices and triangles, a cube, the matrices of lesson 7, what keys do to a camera,
//! and a loop over entities. All of it is made of lessons 3 to 11, so that the program in which a submission runs has nothing
//! of lesson 16.

use clipping::assembly::Topology;
use clipping::{Clipping, Cull, Mesh, render};
use common::{Color, Image, Mat4, Vec2, Vec3, Vec4};
use perspective::depth::ZF32;
use perspective::{Framebuffer, perspective};
use shaders::shader::{Fragment, Shader};
use transforms::inverse::elimination;

pub use transforms::affine::{rotate_x, rotate_y, rotate_z, translate};

/// A vertex of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Where it is.
    pub position: Vec3,
    /// Which way the surface faces there, 1 long.
    pub normal: Vec3,
    /// Where it lies in a texture; v is up.
    pub uv: Vec2,
}

/// A surface of triangles that share vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// The vertices.
    pub vertices: Vec<Vertex>,
    /// For each triangle the numbers of its three vertices, counterclockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// A cube of side 1 about the origin. Each face has four vertices of its own, as each has another normal.
#[must_use]
pub fn cube() -> Shape {
    let mut cube = Shape::default();
    // What is to the right and what is up, as seen by one who looks at the face.
    for (right, up) in [
        (Vec3::X, Vec3::Y),
        (Vec3::NEG_Z, Vec3::Y),
        (Vec3::NEG_X, Vec3::Y),
        (Vec3::Z, Vec3::Y),
        (Vec3::X, Vec3::NEG_Z),
        (Vec3::X, Vec3::Z),
    ] {
        let first = cube.vertices.len() as u32;
        let normal = right.cross(up);
        let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        cube.vertices.extend(corners.map(|uv| {
            let position = (normal + right * (2.0 * uv.x - 1.0) + up * (2.0 * uv.y - 1.0)) / 2.0;
            Vertex { position, normal, uv }
        }));
        cube.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|triangle| triangle.map(|corner| first + corner)));
    }
    cube
}

/// Makes a unit sphere of so many rows and columns.
pub type Sphere = fn(usize, usize) -> Shape;

/// Makes a camera's matrix from azimuth and elevation, in degrees, and a distance.
pub type Orbit = fn(f32, f32, f32) -> Mat4;

/// Azimuth, elevation and distance of a camera that starts at (0, 0, 4), after keys: each `Right` and `Up` turns it by 10°, each
/// `W` brings it nearer by a tenth; `Left`, `Down` and `S` undo these.
///
/// # Panics
/// Where there is no such key.
#[must_use]
pub fn after(keys: &[&str]) -> (f32, f32, f32) {
    let (mut azimuth, mut elevation, mut distance) = (0.0, 0.0, 4.0);
    for &key in keys {
        match key {
            "Left" => azimuth -= 10.0,
            "Right" => azimuth += 10.0,
            "Down" => elevation -= 10.0,
            "Up" => elevation += 10.0,
            "W" => distance *= 0.9,
            "S" => distance /= 0.9,
            other => panic!("there is no key {other}"),
        }
    }
    (azimuth, elevation, distance)
}

/// Draws shapes, each moved by a vector, as a camera with that matrix sees them: a field of view of 45°, chequered by their
/// texture coordinates, lit by their normals from the upper left of the camera.
///
/// # Panics
/// Where a triangle has a vertex that does not exist.
pub fn draw(entities: &[(&Shape, Vec3)], camera: Mat4, image: &mut Image) {
    let size = image.size();
    let Ok(projection) = perspective(45.0, size.x / size.y, 0.1, 100.0) else { return };
    let Some(inverse_camera) = elimination(&camera) else { return };
    let light = camera.transform_vector3(Vec3::new(-0.5, 0.6, 0.8));
    let mut target = Framebuffer::new(image, ZF32);
    for &(shape, place) in entities {
        let to_clip = projection * inverse_camera * translate(place);
        render(
            &Chequered { shape, to_clip, light },
            &mesh(shape),
            Cull::Back,
            Clipping::GuardBand,
            &mut target,
        );
    }
}

/// The triangles of a shape for lesson 11's loop: each of its vertices once, with a corner that it is.
fn mesh(shape: &Shape) -> Mesh {
    let count = shape.vertices.len();
    let mut vertices: Vec<_> =
        (0..count as u32).map(|position| clipping::mesh::Vertex { position, face: 0, corner: 0 }).collect();
    for (face, triangle) in (0..).zip(&shape.triangles) {
        for (corner, &vertex) in (0..).zip(triangle) {
            let place = vertices.get_mut(vertex as usize);
            let place =
                place.unwrap_or_else(|| panic!("triangle {face} has vertex {vertex}, there are {count}"));
            (place.face, place.corner) = (face, corner);
        }
    }
    if shape.triangles.is_empty() {
        vertices.clear();
    }
    let faces = (0..shape.triangles.len() as u32).collect();
    Mesh { vertices, topology: Topology::List, indices: shape.triangles.concat(), faces }
}

/// A shape with fields by its texture coordinates, under a light from far away.
struct Chequered<'a> {
    shape: &'a Shape,
    to_clip: Mat4,
    light: Vec3,
}

impl Shader for Chequered<'_> {
    type Constant = ();
    type Varying = (Vec2, Vec3);
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        self.to_clip * self.shape.vertices[vertex].position.extend(1.0)
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, face: usize, corner: usize) -> (Vec2, Vec3) {
        let vertex = self.shape.vertices[self.shape.triangles[face][corner] as usize];
        (vertex.uv, vertex.normal)
    }

    fn fragment(&self, (): (), fragment: Fragment<(Vec2, Vec3)>) -> Option<Color> {
        let (uv, normal) = fragment.varying;
        let [column, row] = [uv.x * 8.0, uv.y * 4.0].map(|n| n.floor() as i64);
        let base = if (column + row).rem_euclid(2) == 0 {
            Color::rgb(240, 220, 180)
        } else {
            // Each column and each row has its own hue, so that what is turned is seen.
            Color::rgb(40 + 25 * column.rem_euclid(8) as u8, 60 + 40 * row.rem_euclid(4) as u8, 190)
        };
        let lit = normal.normalize_or_zero().dot(self.light.normalize_or_zero()).max(0.0);
        Some(base.shaded(0.25 + 0.75 * lit))
    }
}
