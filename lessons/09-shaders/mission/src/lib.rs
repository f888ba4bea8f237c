//! Mission 9: three shaders.
//!
//! Write the bodies of the methods, then see what is right: `cargo run -p my-shaders`. A look is a colour
//! source under a lighting: white or [`Texture`] under [`Gouraud`], white under [`Quantized`].
//!
//! A scene has `model.uv(face, corner)`, `normals[face][corner]`, `texture`, `light` and `levels`. What a method
//! returns for a corner is interpolated, and comes back at each pixel. From below comes [`textures::texel`].

use common::{Color, Vec2};

// Given: the traits, what is drawn, and all other parts of a look.
pub use shaders::{Scene, lighting::Lighting, source::Source};

/// The brightness at the corners, interpolated.
pub struct Gouraud<'a> {
    scene: &'a Scene<'a>,
}

impl<'a> Gouraud<'a> {
    /// For a scene that has normals.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene }
    }
}

impl Lighting for Gouraud<'_> {
    type Constant = ();
    type Varying = f32;

    /// Leaves no triangle out.
    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    /// The cosine between the corner's normal and the light.
    fn vertex(&self, face: usize, corner: usize) -> f32 {
        let _ = (self.scene, face, corner);
        todo!("a dot product; do not clamp it, what is dark counts when it is interpolated");
    }

    /// The brightness at a pixel, from what was interpolated; below 0 the fragment is dropped.
    fn intensity(&self, (): (), varying: f32) -> f32 {
        let _ = (self.scene, varying);
        todo!("what was interpolated is the brightness: leave it below 0 where it is");
    }
}

/// Gouraud's brightness in steps.
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

impl Lighting for Quantized<'_> {
    type Constant = ();
    type Varying = f32;

    /// Leaves no triangle out.
    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    /// As [`Gouraud`]'s.
    fn vertex(&self, face: usize, corner: usize) -> f32 {
        let _ = (&self.gouraud, face, corner);
        todo!("ask self.gouraud");
    }

    /// ⌊N·min(i, 1)⌋ / N for an interpolated brightness i and N levels.
    fn intensity(&self, (): (), varying: f32) -> f32 {
        let _ = (self.levels, varying);
        todo!("after interpolation, at each pixel: cut down to the nearest lower step, with floor()");
    }
}

/// The scene's texture.
pub struct Texture<'a> {
    scene: &'a Scene<'a>,
}

impl<'a> Texture<'a> {
    /// For a scene that has a texture.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene }
    }
}

impl Source for Texture<'_> {
    type Varying = Vec2;

    /// The corner's (u, v).
    fn vertex(&self, face: usize, corner: usize) -> Vec2 {
        let _ = (self.scene, face, corner);
        todo!("the model knows it");
    }

    /// The texel at the interpolated (u, v); black without a texture.
    fn color(&self, uv: Vec2) -> Color {
        let _ = (self.scene, uv);
        todo!("look it up in the scene's texture, which is an Option");
    }
}
