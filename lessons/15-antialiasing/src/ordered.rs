//! A picture four times as wide and as high, and each pixel the mean of sixteen.

use blending::Operations;
use common::{Color, Image, Vec2, Vec4};
use shaders::shader::{Fragment, Varying};
use zbuffer::DepthBuffer;

use crate::canvas::Canvas;
use crate::multisampled::Multisampled;
use crate::resolve::Resolve;
use crate::storage::{Samples, Storage};

/// How many times as wide and as high.
pub const TIMES: u16 = 4;

/// A larger picture with one sample in each pixel, as lessons 3 to 14 draw it.
pub struct Ordered(Multisampled<1, Samples<1>>);

// ANCHOR: ordered
impl Canvas for Ordered {
    type Stencil = ();

    fn new(picture: &Image, alpha_to_coverage: bool) -> Self {
        let [width, height] = [picture.width(), picture.height()].map(|side| side as u16 * TIMES);
        Self(Multisampled::new(&Image::new(width, height, picture.format()), alpha_to_coverage))
    }

    fn clear(&mut self, background: Color) {
        self.0.clear(background);
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
        todo!()
    }

    fn depths(&self) -> DepthBuffer<f32> {
        todo!()
    }
}
// ANCHOR_END: ordered
