//! Lesson 10's ways to interpolate, chosen when the program runs: one loop over triangles for all, where the lesson has one for
//! each.

use common::{Bounds, Method, Vec4};
use perspective::division::Exact;
use perspective::interpolation::{Affine, Every, Interpolation, PerPixel, Pixels};
use shaders::shader::Varying;

use crate::input::with;

/// Any of the lesson's ways.
#[derive(Clone, Copy, Default)]
pub(crate) enum Way {
    Affine,
    Every16,
    Every8,
    #[default]
    PerPixel,
}

/// The lesson's table.
pub(crate) const WAYS: &[Method<Way>] =
    &with(perspective::METHODS, [Way::Affine, Way::Every16, Way::Every8, Way::PerPixel]);

impl Interpolation for Way {
    /// What is done with a pixel is in the code once, and each way calls it.
    fn fill<V: Varying>(
        self,
        corners: [Vec4; 3],
        varyings: [V; 3],
        bounds: Bounds,
        mut pixels: impl Pixels<V>,
    ) {
        let pixel: &mut dyn FnMut(i32, i32, f32, V) =
            &mut |x, y, depth, varying| pixels.pixel(x, y, depth, || varying);
        match self {
            Self::Affine => Affine.fill(corners, varyings, bounds, pixel),
            Self::Every16 => Every::<16>.fill(corners, varyings, bounds, pixel),
            Self::Every8 => Every::<8>.fill(corners, varyings, bounds, pixel),
            Self::PerPixel => PerPixel::<Exact>::default().fill(corners, varyings, bounds, pixel),
        }
    }
}
