//! Brightness without dropping anything.

use shaders::Uniforms;
use shaders::lighting::{Gouraud, Lighting};

/// Gouraud's brightness, 0 where it is below: what faces away from the light is black, not missing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Clamped;

// ANCHOR: clamped
impl Lighting for Clamped {
    type Constant = ();
    type Varying = f32;

    #[inline]
    fn triangle(&self, _: &Uniforms, _: usize) -> Option<()> {
        Some(())
    }

    #[inline]
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        Gouraud.corner(uniforms, face, corner)
    }

    #[inline]
    fn intensity(&self, (): (), varying: f32) -> f32 {
        varying.max(0.0)
    }
}
// ANCHOR_END: clamped
