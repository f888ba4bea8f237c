//! What the shaders of this lesson read: a model at its place in the world, a light and an eye.

use common::direction::unit;
use common::{Color, Mat3, Mat4, Vec2, Vec3};
use perspective::scene::Loaded;
use shaders::Uniforms;
use shaders::source::{Source, Texture};
use transforms::normal_matrix;

use crate::light::PointLight;

/// A model in the world under a point light.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The model with its normals and its texture, and the way to clip space. The light in it has no place, and is not read.
    pub uniforms: Uniforms<'a>,
    /// From the model's space to the world: where it stands.
    pub to_world: Mat4,
    /// What turns normals likewise.
    pub normals_to_world: Mat3,
    /// The eye in the world.
    pub eye: Vec3,
    /// The light.
    pub light: PointLight,
}

impl<'a> Scene<'a> {
    /// A model where `to_world` places it, before a camera with the matrix `camera` from the world to clip space and its eye
    /// at `eye`. `None` where `to_world` flattens space.
    // ANCHOR: placed
    #[must_use]
    pub fn placed(
        loaded: &'a Loaded,
        to_world: Mat4,
        camera: Mat4,
        eye: Vec3,
        light: PointLight,
    ) -> Option<Self> {
        let uniforms = loaded.uniforms(Vec3::ZERO, camera * to_world);
        Some(Self { uniforms, to_world, normals_to_world: normal_matrix(&to_world)?, eye, light })
    }
    // ANCHOR_END: placed

    /// Where a corner of a triangle is in the world.
    #[inline]
    #[must_use]
    pub fn position(&self, face: usize, corner: usize) -> Vec3 {
        self.to_world.transform_point3(self.uniforms.model.position(face, corner))
    }

    /// The unit normal at a corner of a triangle in the world; 0 where it has none.
    #[inline]
    #[must_use]
    pub fn normal(&self, face: usize, corner: usize) -> Vec3 {
        unit(self.normals_to_world * self.uniforms.normals[face][corner]).unwrap_or_default()
    }

    /// The texture coordinates of a corner of a triangle.
    #[inline]
    #[must_use]
    pub fn uv(&self, face: usize, corner: usize) -> Vec2 {
        self.uniforms.model.uv(face, corner)
    }

    /// The texel of (u, v).
    #[inline]
    #[must_use]
    pub fn texel(&self, uv: Vec2) -> Color {
        Texture.color(&self.uniforms, uv)
    }
}
