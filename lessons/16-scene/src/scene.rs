//! A scene: entities, lights, and how they are drawn.

use clipping::Cull;
use common::Color;
use lighting::PointLight;

use crate::entity::Entity;

/// All that is drawn. Dropped, it drops the meshes and textures that no other scene has.
// ANCHOR: scene
pub struct Scene {
    /// What stands in the world.
    pub entities: Vec<Entity>,
    /// The lights; what they light up is added. Without any, what is to be lit is black.
    pub lights: Vec<PointLight>,
    /// What is seen where nothing stands.
    pub background: Color,
    /// How all of it is drawn.
    pub style: Style,
}
// ANCHOR_END: scene

/// How entities are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// How they are lit.
    pub shading: Shading,
    /// How their textures are filtered.
    pub filter: Filtering,
    /// Which of their triangles are left out for the side that they show.
    pub cull: Cull,
}

/// How surfaces are lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Not at all: colours as they are.
    Unlit,
    /// By Phong's model at the corners of triangles; what is reflected is interpolated.
    Phong,
    /// By Blinn's at each pixel.
    BlinnPhong,
}

/// How textures are filtered, in lesson 13's words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filtering {
    /// The texel that the pixel's centre is in.
    Nearest,
    /// Between four texels.
    Bilinear,
    /// Between four texels of two levels each.
    Trilinear,
}
