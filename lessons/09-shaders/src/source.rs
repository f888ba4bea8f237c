//! Where a fragment's colour comes from, before light.

use common::{Color, Image, Model, Vec2};
use textures::texel;

use crate::Scene;
use crate::program::Varying;

// ANCHOR: source
/// A source of colour.
pub trait Source {
    /// What it interpolates.
    type Varying: Varying;
    /// Its value at a corner.
    fn vertex(&self, face: usize, corner: usize) -> Self::Varying;
    /// The colour at a pixel.
    fn color(&self, varying: Self::Varying) -> Color;
}
// ANCHOR_END: source

/// White all over.
pub struct White;

impl White {
    /// The same for every scene.
    #[must_use]
    pub fn new(_: &Scene) -> Self {
        Self
    }
}

impl Source for White {
    type Varying = ();

    #[inline]
    fn vertex(&self, _: usize, _: usize) {}

    #[inline]
    fn color(&self, (): ()) -> Color {
        Color::WHITE
    }
}

/// The scene's texture; black without one.
pub struct Texture<'a> {
    model: &'a Model,
    texture: Option<&'a Image>,
}

impl<'a> Texture<'a> {
    /// The scene's.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        Self { model: scene.model, texture: scene.texture }
    }
}

impl Source for Texture<'_> {
    type Varying = Vec2;

    #[inline]
    fn vertex(&self, face: usize, corner: usize) -> Vec2 {
        self.model.uv(face, corner)
    }

    #[inline]
    fn color(&self, uv: Vec2) -> Color {
        self.texture.map_or(Color::BLACK, |texture| texel(texture, uv))
    }
}
