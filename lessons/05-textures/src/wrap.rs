//! What a texture is outside of itself, for the lessons that look up `nearest`.

use common::{Color, Image, Vec2};

use crate::{repeat, texel};

/// What is found where (u, v) leave the square from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Wrap {
    /// The texel at the border, as `nearest` does.
    #[default]
    Clamp,
    /// The texture again and again, as `repeat` does.
    Repeat,
}

impl Wrap {
    /// The texel of (u, v).
    #[inline]
    #[must_use]
    pub fn texel(self, texture: &Image, uv: Vec2) -> Color {
        match self {
            Self::Clamp => texel(texture, uv),
            Self::Repeat => repeat(texture, uv),
        }
    }
}
