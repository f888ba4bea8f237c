//! How bright a fragment is.

use common::Vec3;
use triangles::flat_intensity;

use crate::Scene;
use crate::program::Varying;

/// A way to light a surface.
pub trait Lighting {
    /// What is the same all over a triangle.
    type Constant: Copy;
    /// What it interpolates.
    type Varying: Varying;
    /// What is the same all over this triangle, or `None` to leave it out.
    fn triangle(&self, face: usize) -> Option<Self::Constant>;
    /// Its value at a corner.
    fn vertex(&self, face: usize, corner: usize) -> Self::Varying;
    /// The brightness at a pixel: 1 is full, 0 black, below 0 drops the fragment.
    fn intensity(&self, constant: Self::Constant, varying: Self::Varying) -> f32;
}

/// One brightness a triangle, computed and tested once.
pub struct Flat<'a> {
    scene: &'a Scene<'a>,
}

impl<'a> Flat<'a> {
    /// For a scene.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene }
    }
}

// ANCHOR: flat
impl Lighting for Flat<'_> {
    type Constant = f32;
    type Varying = ();

    #[inline]
    fn triangle(&self, face: usize) -> Option<f32> {
        let corner = |n| self.scene.model.position(face, n);
        let intensity = flat_intensity([corner(0), corner(1), corner(2)], self.scene.light);
        (intensity >= 0.0).then_some(intensity)
    }

    #[inline]
    fn vertex(&self, _: usize, _: usize) {}

    #[inline]
    fn intensity(&self, constant: f32, (): ()) -> f32 {
        constant
    }
}
// ANCHOR_END: flat

/// The brightness at the corners, interpolated.
pub struct Gouraud<'a> {
    normals: &'a [[Vec3; 3]],
    light: Vec3,
}

impl<'a> Gouraud<'a> {
    /// For a scene that has normals.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        Self { normals: &scene.normals, light: scene.light }
    }
}

// ANCHOR: gouraud
impl Lighting for Gouraud<'_> {
    type Constant = ();
    type Varying = f32;

    #[inline]
    fn triangle(&self, face: usize) -> Option<()> {
        // Between three corners in the dark no fragment is lit.
        self.normals[face].iter().any(|normal| normal.dot(self.light) >= 0.0).then_some(())
    }

    #[inline]
    fn vertex(&self, face: usize, corner: usize) -> f32 {
        self.normals[face][corner].dot(self.light)
    }

    #[inline]
    fn intensity(&self, (): (), varying: f32) -> f32 {
        varying
    }
}
// ANCHOR_END: gouraud

/// Gouraud's brightness, cut down to the nearest lower one of a few steps: ⌊N·min(i, 1)⌋ / N.
pub struct Quantized<'a> {
    gouraud: Gouraud<'a>,
    levels: f32,
}

impl<'a> Quantized<'a> {
    /// For a scene that has normals.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        Self { gouraud: Gouraud::new(scene), levels: f32::from(scene.levels) }
    }
}

// ANCHOR: quantized
impl Lighting for Quantized<'_> {
    type Constant = ();
    type Varying = f32;

    #[inline]
    fn triangle(&self, face: usize) -> Option<()> {
        self.gouraud.triangle(face)
    }

    #[inline]
    fn vertex(&self, face: usize, corner: usize) -> f32 {
        self.gouraud.vertex(face, corner)
    }

    #[inline]
    fn intensity(&self, constant: (), varying: f32) -> f32 {
        let intensity = self.gouraud.intensity(constant, varying);
        (intensity.min(1.0) * self.levels).floor() / self.levels
    }
}
// ANCHOR_END: quantized
