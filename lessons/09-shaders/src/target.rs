//! What fragments are tested against and written to.

use common::{Bounds, Color, Image};
use zbuffer::DepthBuffer;

// ANCHOR: target
/// What takes the outputs of a shader.
pub trait Target<Output> {
    /// The rectangle of its pixels, from (0, 0) on.
    fn bounds(&self) -> Bounds;

    /// Whether a fragment of that depth would be seen at a pixel. A target may keep account of those that would not.
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool;

    /// Takes what is now seen at a pixel, and its depth.
    fn write(&mut self, x: i32, y: i32, depth: f32, output: Output);

    /// Forgets all that was drawn.
    fn clear(&mut self);
}
// ANCHOR_END: target

/// A picture and the depths of what is seen in it.
#[derive(Clone, Debug)]
pub struct Framebuffer {
    /// The picture.
    pub image: Image,
    /// The nearest depth in each pixel.
    pub depths: DepthBuffer<f32>,
}

impl Framebuffer {
    /// With nothing in it yet but that picture.
    #[must_use]
    pub fn new(image: Image) -> Self {
        let depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
        Self { image, depths }
    }
}

// ANCHOR: framebuffer
impl Target<Color> for Framebuffer {
    fn bounds(&self) -> Bounds {
        self.depths.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        self.depths.is_nearer(x, y, depth)
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        self.depths.set(x, y, depth);
        self.image.set(x, y, color);
    }

    fn clear(&mut self) {
        self.depths.clear();
        self.image.clear();
    }
}
// ANCHOR_END: framebuffer
