//! A map of how much of a highlight each part of a surface shows.

use common::{Image, Vec2};

use crate::scene::Scene;
use crate::surface::{Shape, Surface};

/// A surface whose highlights a map dims: a grey texture, white where all is shown and black where nothing is.
#[derive(Clone, Copy)]
pub struct Shining<'a, S> {
    /// Where its normals come from.
    pub surface: S,
    /// The map.
    pub map: &'a Image,
}

// ANCHOR: shining
impl<S: Surface> Surface for Shining<'_, S> {
    type Constant = S::Constant;
    type Varying = S::Varying;

    #[inline]
    fn triangle(&self, scene: &Scene, face: usize) -> S::Constant {
        self.surface.triangle(scene, face)
    }

    #[inline]
    fn corner(&self, scene: &Scene, face: usize, corner: usize) -> S::Varying {
        self.surface.corner(scene, face, corner)
    }

    #[inline]
    fn at(&self, scene: &Scene, constant: S::Constant, uv: Vec2, varying: S::Varying) -> Shape {
        let Shape { normal, gloss } = self.surface.at(scene, constant, uv, varying);
        let share = f32::from(scene.uniforms.wrap.texel(self.map, uv).luma()) / 255.0;
        Shape { normal, gloss: gloss * share }
    }
}
// ANCHOR_END: shining
