//! Shaders that compute with the same types, one for each `N`. Of equal depths the first drawn stays.

use common::{Color, Format, Image, Vec4};
use shaders::Framebuffer;
use shaders::shader::{Fragment, Shader};

/// One grey all over the picture.
pub(crate) struct Grey<const N: u8>;

impl<const N: u8> Shader for Grey<N> {
    type Constant = ();
    type Varying = ();
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        [Vec4::new(-1.0, -1.0, 0.0, 1.0), Vec4::new(3.0, -1.0, 0.0, 1.0), Vec4::new(-1.0, 3.0, 0.0, 1.0)]
            [vertex]
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, (): (), _: Fragment<()>) -> Option<Color> {
        Some(Color::rgb(N, N, N))
    }
}

/// A small picture.
pub(crate) fn target() -> Framebuffer {
    Framebuffer::new(Image::new(4, 4, Format::Rgb))
}
