//! Lesson 13's filters, chosen when the program runs: one loop for all, where the lesson has one for each.

use common::{Color, Method, Vec2};
use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Filter, Nearest, Trilinear};
use filtering::layout::Layout;
use filtering::{Footprint, Texture};

use crate::input::with;

/// The lesson's table.
pub(crate) const FILTERS: &[Method<AnyFilter>] = &with(
    filtering::METHODS,
    [
        AnyFilter::Nearest,
        AnyFilter::Bilinear,
        AnyFilter::Bilinear8,
        AnyFilter::Trilinear,
        AnyFilter::Anisotropic,
    ],
);

/// Any of them.
#[derive(Clone, Copy)]
pub(crate) enum AnyFilter {
    Nearest,
    Bilinear,
    Bilinear8,
    Trilinear,
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
