//! Mission 9: three shaders.
//!
//! Write the bodies of the methods, then see what is right: `cargo run -p my-shaders`. A look is a colour
//! source under a lighting: white or [`Texture`] under [`Gouraud`], white under [`Quantized`].
//!
//! What you need:
//!
//! - [`Uniforms`] are what all shaders read: `model.uv(face, corner)`, a `Vec2`; `normals[face][corner]`, a `Vec3`;
//!   `texture: Option<&Image>`; `light: Vec3`; `levels: u16`. `face` and `corner` are `usize`, a corner 0, 1 or 2.
//! - What a method returns for a corner is interpolated, and comes back at each pixel.
//! - [`textures::texel`]`(texture: &Image, uv: Vec2) -> Color`.
//! - `option.map_or(other, |value| …)`: what the closure makes of the value, or the other where there is none.
//! - `Gouraud.corner(…)` calls a method of the trait on a value of the type `Gouraud`; the type has no fields, so its name
//!   is the value.

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
        let _ = (uniforms, face, corner);
        todo!("a dot product; do not clamp it, what is dark counts when it is interpolated");
    }

    /// The brightness at a pixel, from what was interpolated; below 0 the fragment is dropped, and under a light
    /// longer than 1 it may be more than 1.
    fn intensity(&self, (): (), varying: f32) -> f32 {
        let _ = varying;
        todo!("what was interpolated is the brightness: leave it below 0 where it is");
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
        let _ = (uniforms, face, corner);
        todo!("ask Gouraud");
    }

    /// ⌊N·min(i, 1)⌋ / N for an interpolated brightness i and N levels.
    fn intensity(&self, levels: f32, varying: f32) -> f32 {
        let _ = (levels, varying);
        todo!("after interpolation, at each pixel: cut down to the nearest lower step, with floor()");
    }
}

/// The texture.
pub struct Texture;

impl Source for Texture {
    type Varying = Vec2;

    /// The corner's (u, v).
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Vec2 {
        let _ = (uniforms, face, corner);
        todo!("the model knows it");
    }

    /// The texel at the interpolated (u, v); black without a texture.
    fn color(&self, uniforms: &Uniforms, uv: Vec2) -> Color {
        let _ = (uniforms, uv);
        todo!("look it up in the texture, which is an Option");
    }
}
