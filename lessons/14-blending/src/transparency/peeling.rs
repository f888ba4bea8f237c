//! Depth peeling: one layer of each pixel at a time.
//!
//! A depth buffer finds the nearest of what is drawn, or the farthest. With a second one, which says how far a pixel is done,
//! the next pass finds the next. A. Mammen peels from the back and lays each layer over the picture at once (*Transparency and
//! antialiasing algorithms implemented with the virtual pixel maps technique*, IEEE Computer Graphics and Applications 9,
//! 1989); C. Everitt, on graphics hardware, from the front, and must keep the layers or mix them the other way round
//! (*Interactive order-independent transparency*, NVIDIA, 2001), but may stop after a few, having seen the nearest. Here it is
//! the back: where no two depths of a pixel are equal, it becomes that of a sorted list, to the last bit.

use common::{Bounds, Color, Image};
use shaders::target::Target;
use zbuffer::DepthBuffer;

use super::Fill;
use super::drawn::lay;
use crate::blend::BlendStage;

// ANCHOR: peeling
/// Passes over all triangles until one finds nothing any more.
pub(super) fn draw(
    transparent: &[impl Fill],
    blend: impl BlendStage,
    image: &mut Image,
    depths: &DepthBuffer<f32>,
) {
    let farthest = DepthBuffer::new(image, f32::NEG_INFINITY);
    let layer = vec![Color::BLACK; image.width() as usize * image.height() as usize];
    let mut peel = Peel { done: depths.clone(), farthest, layer, found: false };
    loop {
        transparent.iter().for_each(|triangle| triangle.fill(&mut peel));
        if !peel.found {
            return;
        }
        peel.lay_over(blend, image);
    }
}

/// The layer that a pass finds: the farthest of what is nearer than all that were found before.
struct Peel {
    /// The depth of the last layer; at first that of the opaque picture.
    done: DepthBuffer<f32>,
    /// The farthest in this pass.
    farthest: DepthBuffer<f32>,
    /// Its colours, rows from the bottom.
    layer: Vec<Color>,
    /// Whether there is any.
    found: bool,
}

impl Target<Color> for Peel {
    fn bounds(&self) -> Bounds {
        self.done.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.done.get(x, y) && depth > self.farthest.get(x, y)
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        self.farthest.set(x, y, depth);
        let width = self.bounds().max.x as usize + 1;
        self.layer[y as usize * width + x as usize] = color;
        self.found = true;
    }

    fn clear(&mut self) {
        self.farthest.clear();
        self.found = false;
    }
}

impl Peel {
    /// Lays what was found over the picture, and is ready for the next pass.
    fn lay_over(&mut self, blend: impl BlendStage, image: &mut Image) {
        let columns = 0..image.width();
        let pixels = (0..image.height()).flat_map(|y| columns.clone().map(move |x| (x, y)));
        for ((x, y), &color) in pixels.zip(&self.layer) {
            let depth = self.farthest.get(x, y);
            if depth > f32::NEG_INFINITY {
                lay(color, blend, image, x, y);
                self.done.set(x, y, depth);
            }
        }
        self.clear();
    }
}
// ANCHOR_END: peeling
