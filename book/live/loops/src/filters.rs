//! Lesson 13's filters, chosen when the program runs: one loop for all, where the lesson has one for each.

use clipping::{Counts, Cull};
use common::{Color, Image, Vec2};
use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Filter, Nearest, Trilinear};
use filtering::layout::Layout;
use filtering::{Footprint, Surface, Texture};

/// Any of the lesson's filters.
#[derive(Clone, Copy)]
pub enum AnyFilter {
    /// The texel that the pixel's centre is in.
    Nearest,
    /// Four texels, mixed.
    Bilinear,
    /// The same in whole numbers.
    Bilinear8,
    /// Four texels of two levels each.
    Trilinear,
    /// Several of these along the footprint.
    Anisotropic,
}

impl Filter for AnyFilter {
    type Footprint = Footprint;

    #[inline]
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        match self {
            Self::Nearest => Nearest.color(texture, uv, ()),
            Self::Bilinear => Bilinear.color(texture, uv, ()),
            Self::Bilinear8 => Bilinear8.color(texture, uv, ()),
            Self::Trilinear => Trilinear.color(texture, uv, footprint),
            Self::Anisotropic => Anisotropic.color(texture, uv, footprint),
        }
    }
}

/// Draws models as lesson 13 does.
pub fn draw(models: &[Surface], filter: AnyFilter, image: &mut Image) -> Counts {
    filtering::draw(models, filter, Cull::Back, image).counts
}
