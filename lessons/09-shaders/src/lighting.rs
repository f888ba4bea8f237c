//! How bright a fragment is.

use triangles::flat_intensity;

use crate::Uniforms;
use crate::shader::Varying;

// ANCHOR: lighting
/// A way to light a surface.
pub trait Lighting {
    /// What is the same all over a triangle.
    type Constant: Copy;
    /// What it interpolates.
    type Varying: Varying;
    /// What is the same all over this triangle, or `None` to leave it out.
    fn triangle(&self, uniforms: &Uniforms, face: usize) -> Option<Self::Constant>;
    /// Its value at a corner.
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Self::Varying;
    /// The brightness at a pixel: 1 is full, 0 black, below 0 drops the fragment.
    fn intensity(&self, constant: Self::Constant, varying: Self::Varying) -> f32;
}
// ANCHOR_END: lighting

/// One brightness a triangle, computed and tested once.
#[derive(Clone, Copy, Debug, Default)]
pub struct Flat;

// ANCHOR: flat
impl Lighting for Flat {
    type Constant = f32;
    type Varying = ();

    #[inline]
    fn triangle(&self, uniforms: &Uniforms, face: usize) -> Option<f32> {
        let corners = [0, 1, 2].map(|corner| uniforms.model.position(face, corner));
        let intensity = flat_intensity(corners, uniforms.light);
        (intensity >= 0.0).then_some(intensity)
    }

    #[inline]
    fn corner(&self, _: &Uniforms, _: usize, _: usize) {}

    #[inline]
    fn intensity(&self, constant: f32, (): ()) -> f32 {
        constant
    }
}
// ANCHOR_END: flat

/// The brightness at the corners, interpolated.
#[derive(Clone, Copy, Debug, Default)]
pub struct Gouraud;

// ANCHOR: gouraud
impl Lighting for Gouraud {
    type Constant = ();
    type Varying = f32;

    #[inline]
    fn triangle(&self, uniforms: &Uniforms, face: usize) -> Option<()> {
        // Between three corners in the dark no fragment is lit.
        uniforms.normals[face].iter().any(|normal| normal.dot(uniforms.light) >= 0.0).then_some(())
    }

    #[inline]
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        uniforms.normals[face][corner].dot(uniforms.light)
    }

    #[inline]
    fn intensity(&self, (): (), varying: f32) -> f32 {
        varying
    }
}
// ANCHOR_END: gouraud

/// Gouraud's brightness, cut down to the nearest lower one of a few steps: ⌊N·min(i, 1)⌋ / N.
#[derive(Clone, Copy, Debug, Default)]
pub struct Quantized;

// ANCHOR: quantized
impl Lighting for Quantized {
    /// The number of steps.
    type Constant = f32;
    type Varying = f32;

    #[inline]
    fn triangle(&self, uniforms: &Uniforms, face: usize) -> Option<f32> {
        Gouraud.triangle(uniforms, face).map(|()| f32::from(uniforms.levels))
    }

    #[inline]
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        Gouraud.corner(uniforms, face, corner)
    }

    #[inline]
    fn intensity(&self, levels: f32, varying: f32) -> f32 {
        (varying.min(1.0) * levels).floor() / levels
    }
}
// ANCHOR_END: quantized
