//! Lesson 12's lamp as one of lesson 9's lightings, so that lesson 13's textures can be seen by it.

use common::Vec3;
use lighting::reflection::{Halfway, PointLit, Reflection};
use lighting::{PointLight, Scene};
use shaders::Uniforms;
use shaders::lighting::Lighting;

/// A point light on a matt surface, at each pixel: ambient and diffuse light, without a highlight, which would not be a
/// multiple of the surface's colour.
pub struct Lamp<'a> {
    scene: Scene<'a>,
    reflection: PointLit<Halfway>,
}

impl<'a> Lamp<'a> {
    /// On a model at its place in the world, under the scene's light.
    #[must_use]
    pub fn new(scene: Scene<'a>) -> Self {
        let light = PointLight { specular: 0.0, ..scene.light };
        Self { scene, reflection: PointLit::new(&light) }
    }
}

impl Lighting for Lamp<'_> {
    type Constant = ();
    /// The position in the world, and the normal.
    type Varying = (Vec3, Vec3);

    #[inline]
    fn triangle(&self, _: &Uniforms, _: usize) -> Option<()> {
        Some(())
    }

    #[inline]
    fn corner(&self, _: &Uniforms, face: usize, corner: usize) -> (Vec3, Vec3) {
        (self.scene.position(face, corner), self.scene.normal(face, corner))
    }

    #[inline]
    fn intensity(&self, (): (), (point, normal): (Vec3, Vec3)) -> f32 {
        self.reflection.reflect(point, normal, self.scene.eye).body
    }
}
