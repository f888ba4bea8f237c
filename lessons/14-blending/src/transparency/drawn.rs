//! In the order given.

use common::{Bounds, Color, Image};
use shaders::target::Target;
use zbuffer::DepthBuffer;

use super::Fill;
use crate::blend::BlendStage;

// ANCHOR: drawn
/// A picture that layers are laid over. They keep no depth: what is transparent hides nothing.
pub(super) struct Layered<'a, B> {
    pub image: &'a mut Image,
    pub depths: &'a DepthBuffer<f32>,
    pub blend: B,
}

impl<B: BlendStage> Target<Color> for Layered<'_, B> {
    fn bounds(&self) -> Bounds {
        self.image.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.depths.get(x, y)
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, _: f32, color: Color) {
        lay(color, self.blend, self.image, x, y);
    }

    fn clear(&mut self) {
        self.image.clear();
    }
}

/// Lays a colour over a pixel.
#[inline]
pub(super) fn lay(color: Color, blend: impl BlendStage, image: &mut Image, x: i32, y: i32) {
    if let Some(below) = image.get(x, y) {
        image.set(x, y, blend.color(color, below));
    }
}

/// Each triangle over what is there.
pub(super) fn draw(
    transparent: &[impl Fill],
    blend: impl BlendStage,
    image: &mut Image,
    depths: &DepthBuffer<f32>,
) {
    let mut target = Layered { image, depths, blend };
    transparent.iter().for_each(|triangle| triangle.fill(&mut target));
}
// ANCHOR_END: drawn
