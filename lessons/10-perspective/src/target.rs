//! A picture and the depths of what is seen in it, whichever way they are kept.

use common::{Bounds, Color, Image};
use shaders::target::Target;
use zbuffer::DepthBuffer;

use crate::depth::Depth;

/// A picture and the depths of what is seen in it.
#[derive(Debug)]
pub struct Framebuffer<'a, D> {
    /// The picture.
    pub image: &'a mut Image,
    /// What is kept of the nearest depth in each pixel.
    pub depths: DepthBuffer<f32>,
    /// The way in which depths are kept.
    pub depth: D,
}

impl<'a, D: Depth> Framebuffer<'a, D> {
    /// With nothing in it yet but that picture.
    #[must_use]
    pub fn new(image: &'a mut Image, depth: D) -> Self {
        let depths = DepthBuffer::new(image, depth.nothing());
        Self { image, depths, depth }
    }
}

// ANCHOR: framebuffer
/// It is tested and told what was interpolated; what is kept of it is its own affair.
impl<D: Depth> Target<Color> for Framebuffer<'_, D> {
    fn bounds(&self) -> Bounds {
        self.depths.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        self.depth.is_nearer(self.depth.stored(depth), self.depths.get(x, y))
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        self.depths.set(x, y, self.depth.stored(depth));
        self.image.set(x, y, color);
    }

    fn clear(&mut self) {
        self.depths.clear();
        self.image.clear();
    }
}
// ANCHOR_END: framebuffer
