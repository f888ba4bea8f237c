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

#[cfg(test)]
mod tests {
    use super::*;
    use common::Format;

    #[test]
    fn layers_add_up_until_the_picture_is_cleared() {
        let mut image = Image::new(2, 3, Format::Rgb);
        let depths = DepthBuffer::new(&image, 0.5);
        let mut target = Layered { image: &mut image, depths: &depths, blend: crate::Over(crate::TwoShift) };
        assert_eq!([0.4, 0.5, f32::NAN].map(|depth| target.test(1, 2, depth)), [true, false, false]);
        [0, 1].into_iter().for_each(|_| target.write(1, 2, 0.4, Color { a: 51, ..Color::RED }));
        assert_eq!(target.image.get(1, 2), Some(Color::rgb(92, 0, 0)));
        target.clear();
        assert_eq!(image, Image::new(2, 3, Format::Rgb));
    }
}
