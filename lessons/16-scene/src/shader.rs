//! The look of a mesh: where its colours come from, times how they are lit. What is absent is `()` and costs nothing.
//!
//! Lesson 13's `Filtered` and lesson 9's `Lighting` look like these, but take one textured model with its uniforms, and one
//! brightness: here a mesh may have no texture, and of light there are two parts, of which the highlight takes no colour.

use common::direction::unit;
use common::{Color, Mat3, Mat4, Vec2, Vec3, Vec4};
use filtering::Texture;
use filtering::filter::{Bilinear, Filter, Nearest, Trilinear};
use filtering::footprint::{Asked, Footprint, Gradients};
use lighting::Reflected;
use shaders::shader::{Fragment, Shader, Varying};

use crate::lamps::Lamps;
use crate::mesh::Mesh;
use crate::scene::Filtering;

/// Where colours come from.
// ANCHOR: base
pub trait Base {
    /// What is the same all over a triangle.
    type Constant: Copy;
    /// What is interpolated.
    type Varying: Varying + 'static;
    /// Once a triangle, of which these are the vertices; `clip` tells where they are in clip space.
    fn triangle(&self, vertices: [usize; 3], clip: impl FnOnce() -> [Vec4; 3]) -> Self::Constant;
    /// At a vertex.
    fn vertex(&self, vertex: usize) -> Self::Varying;
    /// At a pixel.
    fn color(&self, constant: Self::Constant, fragment: Fragment<Self::Varying>) -> Color;
}
// ANCHOR_END: base

/// One colour all over.
impl Base for Color {
    type Constant = ();
    type Varying = ();

    #[inline]
    fn triangle(&self, _: [usize; 3], _: impl FnOnce() -> [Vec4; 3]) {}

    #[inline]
    fn vertex(&self, _: usize) {}

    #[inline]
    fn color(&self, (): (), _: Fragment<()>) -> Color {
        *self
    }
}

/// A colour for each vertex: red, green, blue and alpha are interpolated and rounded.
impl Base for &[Color] {
    type Constant = ();
    type Varying = (Vec3, f32);

    #[inline]
    fn triangle(&self, _: [usize; 3], _: impl FnOnce() -> [Vec4; 3]) {}

    #[inline]
    fn vertex(&self, vertex: usize) -> (Vec3, f32) {
        let [r, g, b, a] = {
            let Color { r, g, b, a } = self[vertex];
            [r, g, b, a].map(f32::from)
        };
        (Vec3::new(r, g, b), a)
    }

    #[inline]
    fn color(&self, (): (), fragment: Fragment<(Vec3, f32)>) -> Color {
        let (Vec3 { x, y, z }, a) = fragment.varying;
        let [r, g, b, a] = [x, y, z, a].map(|channel| (channel + 0.5) as u8);
        Color { r, g, b, a }
    }
}

/// A texture. How it is filtered is decided when the program runs, once a pixel: a loop for each filter would be three times as
/// many, and none of them faster.
pub struct Textured<'a> {
    /// The texture.
    pub texture: &'a Texture,
    /// The texture coordinates of the vertices.
    pub uvs: &'a [Vec2],
    /// How it is filtered.
    pub filter: Filtering,
    /// The size of the picture in pixels.
    pub size: Vec2,
}

// ANCHOR: textured
impl Base for Textured<'_> {
    /// What footprints are told by, for the filter that asks for them.
    type Constant = Option<Gradients>;
    type Varying = Vec2;

    #[inline]
    fn triangle(&self, vertices: [usize; 3], clip: impl FnOnce() -> [Vec4; 3]) -> Option<Gradients> {
        let is_asked = self.filter == Filtering::Trilinear;
        is_asked.then(|| Gradients::new(clip(), vertices.map(|vertex| self.uvs[vertex]), self.size))
    }

    #[inline]
    fn vertex(&self, vertex: usize) -> Vec2 {
        self.uvs[vertex]
    }

    #[inline(always)]
    fn color(&self, gradients: Option<Gradients>, fragment: Fragment<Vec2>) -> Color {
        let Fragment { x, y, varying: uv, .. } = fragment;
        match gradients {
            Some(gradients) => Trilinear.color(self.texture, uv, Footprint::at(gradients, x, y, uv)),
            None if self.filter == Filtering::Nearest => Nearest.color(self.texture, uv, ()),
            None => Bilinear.color(self.texture, uv, ()),
        }
    }
}
// ANCHOR_END: textured

/// A surface's place in the world, and what it is lit by.
#[derive(Clone, Copy)]
pub struct Placed<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// From the model's space to the world.
    pub to_world: Mat4,
    /// What turns normals likewise.
    pub normals_to_world: Mat3,
    /// The eye in the world.
    pub eye: Vec3,
    /// The lights.
    pub lamps: &'a Lamps,
}

// ANCHOR: placed
impl Placed<'_> {
    /// Where a vertex is in the world, and its unit normal there.
    #[inline]
    fn vertex(&self, vertex: usize) -> (Vec3, Vec3) {
        let normal = unit(self.normals_to_world * self.mesh.normals()[vertex]).unwrap_or_default();
        (self.to_world.transform_point3(self.mesh.positions()[vertex]), normal)
    }
}
// ANCHOR_END: placed

/// How colours are lit.
// ANCHOR: lighting
pub trait Lighting {
    /// What is interpolated.
    type Varying: Varying + 'static;
    /// At a vertex.
    fn vertex(&self, vertex: usize) -> Self::Varying;
    /// What is seen of a colour at a pixel.
    fn lit(&self, base: Color, varying: Self::Varying) -> Color;
}
// ANCHOR_END: lighting

/// Not at all.
impl Lighting for () {
    type Varying = ();

    #[inline]
    fn vertex(&self, _: usize) {}

    #[inline]
    fn lit(&self, base: Color, (): ()) -> Color {
        base
    }
}

/// By Phong's model at the vertices.
pub struct AtVertices<'a>(pub Placed<'a>);

impl Lighting for AtVertices<'_> {
    type Varying = (f32, f32);

    #[inline]
    fn vertex(&self, vertex: usize) -> (f32, f32) {
        let (point, normal) = self.0.vertex(vertex);
        let Reflected { body, highlight } = self.0.lamps.phong(point, normal, self.0.eye);
        (body, highlight)
    }

    #[inline]
    fn lit(&self, base: Color, (body, highlight): (f32, f32)) -> Color {
        Reflected { body, highlight }.color(base)
    }
}

/// By Blinn's model at the pixels.
pub struct AtPixels<'a>(pub Placed<'a>);

// ANCHOR: at_pixels
impl Lighting for AtPixels<'_> {
    type Varying = (Vec3, Vec3);

    #[inline]
    fn vertex(&self, vertex: usize) -> (Vec3, Vec3) {
        self.0.vertex(vertex)
    }

    #[inline(always)]
    fn lit(&self, base: Color, (point, normal): (Vec3, Vec3)) -> Color {
        self.0.lamps.blinn(point, normal, self.0.eye).color(base)
    }
}
// ANCHOR_END: at_pixels

/// The shader: colours, lit.
pub struct Look<'a, B, L> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// From the model's space to clip space.
    pub to_clip: Mat4,
    /// Where colours come from.
    pub base: B,
    /// How they are lit.
    pub lighting: L,
}

// ANCHOR: look
impl<B: Base, L: Lighting> Shader for Look<'_, B, L> {
    type Constant = B::Constant;
    type Varying = (B::Varying, L::Varying);
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        self.to_clip * self.mesh.positions()[vertex].extend(1.0)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<B::Constant> {
        let vertices = [0, 1, 2].map(|corner| self.mesh.vertex(face, corner));
        Some(self.base.triangle(vertices, || vertices.map(|vertex| self.position(vertex))))
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        let vertex = self.mesh.vertex(face, corner);
        (self.base.vertex(vertex), self.lighting.vertex(vertex))
    }

    // A call would hand the fragment over in memory, written in parts and read as a whole, for which a processor must wait.
    #[inline(always)]
    fn fragment(&self, constant: B::Constant, fragment: Fragment<Self::Varying>) -> Option<Color> {
        let Fragment { x, y, depth, varying: (base, lit) } = fragment;
        let base = self.base.color(constant, Fragment { x, y, depth, varying: base });
        Some(self.lighting.lit(base, lit))
    }
}
// ANCHOR_END: look
