//! A picture four times as wide and as high, and each pixel the mean of sixteen.

use std::array;

use blending::Operations;
use common::{Color, Image, Vec2, Vec4};
use shaders::shader::{Fragment, Varying};
use zbuffer::DepthBuffer;

use crate::canvas::Canvas;
use crate::multisampled::{Multisampled, pixels};
use crate::resolve::Resolve;
use crate::storage::{Samples, Storage};

/// How many times as wide and as high the larger picture is.
pub const TIMES: usize = 4;

/// A larger picture with one sample in each pixel, as lessons 3 to 14 draw it. Corners are rounded there: to 1/1024 px of the
/// picture itself, and a triangle with one beyond ±2⁵⁰ px is left out.
pub struct Ordered(Multisampled<1, Samples<1>>);

// ANCHOR: ordered
impl Canvas for Ordered {
    type Stencil = ();

    fn new([width, height]: [usize; 2]) -> Self {
        Self(Multisampled::new([width * TIMES, height * TIMES]))
    }

    fn clear(&mut self, background: Color, alpha_to_coverage: bool) {
        self.0.clear(background, alpha_to_coverage);
    }

    fn size(&self) -> Vec2 {
        self.0.size()
    }

    #[inline]
    fn fill<V: Varying>(
        &mut self,
        state: impl Operations<Stencil = ()>,
        corners: [Vec4; 3],
        varyings: [V; 3],
        shade: impl FnMut(Fragment<V>) -> Option<Color>,
    ) {
        self.0.fill(state, corners, varyings, shade);
    }

    fn resolve(&self, resolve: Resolve, picture: &mut Image) {
        picture.set_all(|pixel| resolve(&self.under(pixel).map(|place| self.0.colors.colors(place)[0])));
    }

    fn depths(&self, picture: &Image) -> DepthBuffer<f32> {
        let mut nearest = DepthBuffer::new(picture, 1.0);
        for (pixel, (x, y)) in pixels(picture.bounds()).enumerate() {
            let depths = self.under(pixel).map(|place| self.0.depths[place][0]);
            nearest.set(x, y, depths.into_iter().fold(1.0, f32::min));
        }
        nearest
    }
}
// ANCHOR_END: ordered

impl Ordered {
    /// Where the pixels of the larger picture are that a pixel is the mean of.
    fn under(&self, pixel: usize) -> [usize; TIMES * TIMES] {
        let width = self.0.width();
        let (x, y) = (pixel % (width / TIMES), pixel / (width / TIMES));
        let first = (y * width + x) * TIMES;
        array::from_fn(|n| first + n / TIMES * width + n % TIMES)
    }
}
