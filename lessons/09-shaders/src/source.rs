//! Where a fragment's colour comes from, before light.

use common::{Color, Vec2};

use crate::Uniforms;
use crate::shader::Varying;

// ANCHOR: source
/// A source of colour.
pub trait Source {
    /// What it interpolates.
    type Varying: Varying;
    /// Its value at a corner.
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Self::Varying;
    /// The colour at a pixel.
    fn color(&self, uniforms: &Uniforms, varying: Self::Varying) -> Color;
}
// ANCHOR_END: source

/// White all over.
#[derive(Clone, Copy, Debug, Default)]
pub struct White;

impl Source for White {
    type Varying = ();

    #[inline]
    fn corner(&self, _: &Uniforms, _: usize, _: usize) {}

    #[inline]
    fn color(&self, _: &Uniforms, (): ()) -> Color {
        Color::WHITE
    }
}

/// The texture; black without one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Texture;

impl Source for Texture {
    type Varying = Vec2;

    #[inline]
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Vec2 {
        uniforms.model.uv(face, corner)
    }

    #[inline]
    fn color(&self, uniforms: &Uniforms, uv: Vec2) -> Color {
        uniforms.texture.map_or(Color::BLACK, |texture| uniforms.wrap.texel(texture, uv))
    }
}
