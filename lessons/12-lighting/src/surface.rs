//! What a surface brings to the light at each pixel besides its colour: the normal, and its share of the highlight.

use common::{Vec2, Vec3};
use shaders::shader::Varying;

use crate::scene::Scene;

/// A surface at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Its normal in the world, of any length.
    pub normal: Vec3,
    /// What of a highlight it shows: 1 is all of it, 0 nothing.
    pub gloss: f32,
}

// ANCHOR: surface
/// Where normals and gloss come from.
pub trait Surface {
    /// What is the same all over a triangle.
    type Constant: Copy;
    /// What it interpolates, besides texture coordinates and position, which each surface has.
    type Varying: Varying;
    /// What is the same all over this triangle.
    fn triangle(&self, scene: &Scene, face: usize) -> Self::Constant;
    /// Its value at a corner.
    fn corner(&self, scene: &Scene, face: usize, corner: usize) -> Self::Varying;
    /// The surface at a pixel.
    fn at(&self, scene: &Scene, constant: Self::Constant, uv: Vec2, varying: Self::Varying) -> Shape;
}
// ANCHOR_END: surface

/// The corners' normals, interpolated; glossy all over.
#[derive(Clone, Copy, Debug, Default)]
pub struct Smooth;

impl Surface for Smooth {
    type Constant = ();
    type Varying = Vec3;

    #[inline]
    fn triangle(&self, _: &Scene, _: usize) {}

    #[inline]
    fn corner(&self, scene: &Scene, face: usize, corner: usize) -> Vec3 {
        scene.normal(face, corner)
    }

    #[inline]
    fn at(&self, _: &Scene, (): (), _: Vec2, normal: Vec3) -> Shape {
        Shape { normal, gloss: 1.0 }
    }
}
