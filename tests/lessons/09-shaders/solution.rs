//! All of mission 9.
use common::{Color, Vec2};

// Given: the traits, what is drawn, and all other parts of a look.
pub use shaders_given::{Lighting, Source, Uniforms};

/// The brightness at the corners, interpolated.
pub struct Gouraud;

impl Lighting for Gouraud {
    type Constant = ();
    type Varying = f32;

    /// Leaves no triangle out.
    fn triangle(&self, _: &Uniforms, _: usize) -> Option<()> {
        Some(())
    }

    /// The cosine between the corner's normal and the light.
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        uniforms.normals[face][corner].dot(uniforms.light)
    }

    /// The brightness at a pixel, from what was interpolated; below 0 the fragment is dropped.
    fn intensity(&self, (): (), varying: f32) -> f32 {
        varying
    }
}

/// Gouraud's brightness in steps.
pub struct Quantized;

impl Lighting for Quantized {
    /// The number of levels N.
    type Constant = f32;
    type Varying = f32;

    /// Leaves no triangle out.
    fn triangle(&self, uniforms: &Uniforms, _: usize) -> Option<f32> {
        Some(f32::from(uniforms.levels))
    }

    /// As [`Gouraud`]'s.
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        Gouraud.corner(uniforms, face, corner)
    }

    /// ⌊N·min(i, 1)⌋ / N for an interpolated brightness i and N levels.
    fn intensity(&self, levels: f32, varying: f32) -> f32 {
        (varying.min(1.0) * levels).floor() / levels
    }
}

/// The texture.
pub struct Texture;

impl Source for Texture {
    type Varying = Vec2;

    /// The corner's (u, v).
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Vec2 {
        uniforms.model.uv(face, corner)
    }

    /// The texel at the interpolated (u, v); black without a texture.
    fn color(&self, uniforms: &Uniforms, uv: Vec2) -> Color {
        uniforms.texture.map_or(Color::BLACK, |texture| textures::texel(texture, uv))
    }
}
