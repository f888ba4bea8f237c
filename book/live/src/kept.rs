//! Lesson 10's ways to keep depths, chosen when the program runs.
//!
//! The lesson has a loop for each of them and for each way to interpolate, twenty in all; a page must load them.

use common::{Method, Vec4};
use perspective::Planes;
use perspective::depth::{Depth, Logarithmic, ReversedZF32, W, Z24, ZF32};

use crate::input::with;

/// Any of the lesson's ways.
#[derive(Clone, Copy)]
pub(crate) enum Kept {
    Z24(Z24),
    ZF32(ZF32),
    ReversedZF32(ReversedZF32),
    Logarithmic(Logarithmic),
    W(W),
}

/// One of them, for a camera with these planes.
type Keep = fn(Planes) -> Kept;

/// The lesson's table.
pub(crate) const DEPTHS: &[Method<Keep>] = &with(
    perspective::DEPTHS,
    [
        |planes| Kept::Z24(Depth::new(planes)),
        |planes| Kept::ZF32(Depth::new(planes)),
        |planes| Kept::ReversedZF32(Depth::new(planes)),
        |planes| Kept::Logarithmic(Depth::new(planes)),
        |planes| Kept::W(Depth::new(planes)),
    ],
);

/// What the way that is kept makes of it.
macro_rules! by {
    ($kept:expr, $depth:ident => $made:expr) => {
        match $kept {
            Kept::Z24($depth) => $made,
            Kept::ZF32($depth) => $made,
            Kept::ReversedZF32($depth) => $made,
            Kept::Logarithmic($depth) => $made,
            Kept::W($depth) => $made,
        }
    };
}

impl Depth for Kept {
    fn new(planes: Planes) -> Self {
        Self::ZF32(Depth::new(planes))
    }

    fn nothing(self) -> f32 {
        by!(self, depth => depth.nothing())
    }

    fn corner(self, window: Vec4) -> f32 {
        by!(self, depth => depth.corner(window))
    }

    #[inline]
    fn stored(self, interpolated: f32) -> f32 {
        by!(self, depth => depth.stored(interpolated))
    }

    #[inline]
    fn is_nearer(self, depth: f32, than: f32) -> bool {
        by!(self, way => way.is_nearer(depth, than))
    }
}
