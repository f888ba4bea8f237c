//! A mesh: what entities share, and what never changes.

use std::sync::Arc;

use clipping::assembly::Topology;
use clipping::mesh::Vertex;
use common::{Color, Vec2, Vec3};
use filtering::Texture;

use crate::shapes::Shape;

/// Where a mesh has its colours from.
#[derive(Clone)]
pub enum Paint {
    /// One colour all over.
    Color(Color),
    /// A colour for each vertex of the shape, interpolated between them, alpha too.
    Colors(Vec<Color>),
    /// A texture, which several meshes may share.
    Texture(Arc<Texture>),
}

/// Vertices, triangles and colours. Whatever moves an entity leaves them as they are.
// ANCHOR: mesh
pub struct Mesh {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    /// Texture coordinates, where there is a texture.
    uvs: Vec<Vec2>,
    paint: Paint,
    assembled: clipping::Mesh,
    center: Vec3,
    radius: f32,
    opaque: bool,
    mean: Color,
}
// ANCHOR_END: mesh

impl Mesh {
    /// A shape and its colours.
    ///
    /// # Panics
    /// Where a triangle has a vertex that the shape has not, or where colours are not as many as vertices.
    #[must_use]
    pub fn new(shape: &Shape, paint: Paint) -> Self {
        let Shape { vertices, triangles } = shape;
        if let Paint::Colors(colors) = &paint {
            assert_eq!(colors.len(), vertices.len(), "a colour for each vertex");
        }
        let (center, radius) = bounding_sphere(shape);
        let (opaque, mean) = paint.summary();
        Self {
            positions: vertices.iter().map(|vertex| vertex.position).collect(),
            normals: vertices.iter().map(|vertex| vertex.normal).collect(),
            uvs: match paint {
                Paint::Texture(_) => vertices.iter().map(|vertex| vertex.uv).collect(),
                Paint::Color(_) | Paint::Colors(_) => Vec::new(),
            },
            opaque,
            mean,
            paint,
            assembled: assembled(vertices.len(), triangles),
            center,
            radius,
        }
    }

    /// The positions of its vertices.
    #[inline]
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// The unit normals of its vertices.
    #[inline]
    #[must_use]
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// The texture coordinates of its vertices; none where it has no texture.
    #[inline]
    #[must_use]
    pub fn uvs(&self) -> &[Vec2] {
        &self.uvs
    }

    /// Its colours.
    #[must_use]
    pub fn paint(&self) -> &Paint {
        &self.paint
    }

    /// Whether nothing is seen through it: no colour and no texel has an alpha below 255.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.opaque
    }

    /// The mean of its colours, of their codes: one colour that stands for all of them.
    #[must_use]
    pub fn mean(&self) -> Color {
        self.mean
    }

    /// Its vertices and triangles as lesson 11's loop takes them.
    #[must_use]
    pub fn assembled(&self) -> &clipping::Mesh {
        &self.assembled
    }

    /// The number of a vertex that is a corner (0, 1 or 2) of a triangle.
    #[inline]
    #[must_use]
    pub fn vertex(&self, face: usize, corner: usize) -> usize {
        self.assembled.vertices[self.assembled.indices[3 * face + corner] as usize].position as usize
    }

    /// How many triangles it has.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.assembled.faces.len()
    }

    /// The middle of a sphere that it is within, and that sphere's radius, in the model's space.
    #[must_use]
    pub fn bounds(&self) -> (Vec3, f32) {
        (self.center, self.radius)
    }
}

impl Paint {
    /// Whether all its colours are opaque, and their mean.
    fn summary(&self) -> (bool, Color) {
        let (mut sum, mut count, mut opaque) = ([0; 4], 0, true);
        self.visit(|Color { r, g, b, a }| {
            sum = std::array::from_fn(|n| sum[n] + u64::from([r, g, b, a][n]));
            count += 1;
            opaque &= a == u8::MAX;
        });
        let [r, g, b, a] = sum.map(|sum| ((sum + count / 2) / count.max(1)) as u8);
        (opaque, Color { r, g, b, a })
    }

    fn visit(&self, mut visit: impl FnMut(Color)) {
        match self {
            Self::Color(color) => visit(*color),
            Self::Colors(colors) => colors.iter().copied().for_each(visit),
            Self::Texture(texture) => {
                let base = texture.base();
                (0..base.height()).for_each(|j| (0..base.width()).for_each(|i| visit(base.texel(i, j))));
            }
        }
    }
}

/// Lesson 11's mesh of triangles. A vertex that is in none of them is left out.
fn assembled(vertices: usize, triangles: &[[u32; 3]]) -> clipping::Mesh {
    let mut numbers = vec![None; vertices];
    let mut used = Vec::new();
    let mut indices = Vec::new();
    for (face, triangle) in (0..).zip(triangles) {
        for (corner, &position) in (0..).zip(triangle) {
            indices.push(*numbers[position as usize].get_or_insert_with(|| {
                used.push(Vertex { position, face, corner });
                used.len() as u32 - 1
            }));
        }
    }
    let faces = (0..triangles.len() as u32).collect();
    clipping::Mesh { vertices: used, topology: Topology::List, indices, faces }
}

/// The middle of the box around all vertices, and the distance of the farthest of them, rounded up.
fn bounding_sphere(shape: &Shape) -> (Vec3, f32) {
    let positions = || shape.vertices.iter().map(|vertex| vertex.position);
    let Some(first) = positions().next() else { return (Vec3::ZERO, 0.0) };
    let (low, high) = positions().fold((first, first), |(low, high), p| (low.min(p), high.max(p)));
    let center = (low + high) / 2.0;
    let farthest = positions().map(|p| p.as_dvec3().distance(center.as_dvec3())).fold(0.0, f64::max);
    (center, (farthest as f32).next_up())
}

#[cfg(test)]
mod tests {
    use common::{Format, Image};
    use filtering::Wrap;
    use filtering::light::SRGB;

    use super::*;
    use crate::shapes::{Vertex, cube};

    fn shape(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Shape {
        let vertex =
            |&position: &[f32; 3]| Vertex { position: position.into(), normal: Vec3::Z, uv: Vec2::ZERO };
        Shape { vertices: positions.iter().map(vertex).collect(), triangles: triangles.to_vec() }
    }

    #[test]
    fn a_vertex_that_no_triangle_has_is_not_computed() {
        let four = [[9.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = Mesh::new(&shape(&four, &[[3, 1, 2]]), Paint::Color(Color::RED));
        assert_eq!((mesh.assembled().vertices.len(), mesh.triangles()), (3, 1));
        assert_eq!([0, 1, 2].map(|corner| mesh.vertex(0, corner)), [3, 1, 2]);
        let empty = Mesh::new(&shape(&[], &[]), Paint::Colors(Vec::new()));
        assert_eq!((empty.triangles(), empty.bounds()), (0, (Vec3::ZERO, 0.0)));
    }

    #[test]
    fn every_vertex_is_within_the_bounding_sphere() {
        let positions = [[1.0, 2.0, 3.0], [-0.1, 7.0, 0.3], [4.0, -1.0, 1e-3], [0.7, 0.7, -2.9]];
        let (center, radius) = Mesh::new(&shape(&positions, &[[0, 1, 2]]), Paint::Color(Color::RED)).bounds();
        let far = |p: &[f32; 3]| Vec3::from(*p).as_dvec3().distance(center.as_dvec3());
        assert!(positions.iter().all(|p| far(p) <= radius.into()));
        let (center, radius) = Mesh::new(&cube(), Paint::Color(Color::RED)).bounds();
        assert!(center == Vec3::ZERO && (radius - 0.75_f32.sqrt()).abs() < 1e-6);
    }

    #[test]
    fn one_colour_or_texel_that_is_seen_through_is_enough() {
        let glass = Color { a: 254, ..Color::RED };
        let mut image = Image::new(2, 2, Format::Rgba);
        image.set_all(|n| [Color::RED, Color::RED, Color::RED, glass][n]);
        let texture = |image: &Image| Paint::Texture(Arc::new(Texture::new(image, Wrap::Clamp, &SRGB)));
        let colors = |last| Paint::Colors((0..24).map(|n| if n < 23 { Color::RED } else { last }).collect());
        let see_through = [Paint::Color(glass), colors(glass), texture(&image)];
        image.set(1, 1, Color::RED);
        let opaque = [Paint::Color(Color::RED), colors(Color::RED), texture(&image)];
        let are_opaque = |paints: [Paint; 3]| paints.map(|paint| Mesh::new(&cube(), paint).is_opaque());
        assert_eq!((are_opaque(see_through), are_opaque(opaque)), ([false; 3], [true; 3]));
    }

    #[test]
    fn the_mean_is_rounded() {
        let colors = [Color::rgb(1, 2, 30), Color::rgb(2, 2, 0), Color { a: 0, ..Color::rgb(2, 4, 1) }];
        let triangle = shape(&[[0.0; 3]; 3], &[[0, 1, 2]]);
        let mean = Mesh::new(&triangle, Paint::Colors(colors.to_vec())).mean();
        assert_eq!(mean, Color { r: 2, g: 3, b: 10, a: 170 });
    }

    #[test]
    #[should_panic(expected = "a colour for each vertex")]
    fn colours_are_as_many_as_vertices() {
        let _ = Mesh::new(&cube(), Paint::Colors(vec![Color::RED; 8]));
    }
}
