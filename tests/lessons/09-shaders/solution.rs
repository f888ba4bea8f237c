//! All of mission 9.
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
        self.scene.normals[face][corner].dot(self.scene.light)
    }

    /// The brightness at a pixel, from what was interpolated; below 0 the fragment is dropped.
    fn intensity(&self, (): (), varying: f32) -> f32 {
        varying
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
        self.gouraud.vertex(face, corner)
    }

    /// ⌊N·min(i, 1)⌋ / N for an interpolated brightness i and N levels.
    fn intensity(&self, (): (), varying: f32) -> f32 {
        (varying.min(1.0) * self.levels).floor() / self.levels
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
        self.scene.model.uv(face, corner)
    }

    /// The texel at the interpolated (u, v); black without a texture.
    fn color(&self, uv: Vec2) -> Color {
        self.scene.texture.map_or(Color::BLACK, |texture| textures::texel(texture, uv))
    }
}
