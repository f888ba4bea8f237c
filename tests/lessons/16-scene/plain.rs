//! Lesson 15's loop with the least of shaders, written by hand: what a scene with everything switched off is measured by.

use antialiasing::{Canvas, render, resolve};
use blending::State;
use clipping::{Counts, Cull};
use common::{Color, Image, Mat4, Vec4};
use scene::Mesh;
use shaders::shader::{Fragment, Shader};

/// One colour all over a mesh.
pub(crate) struct Plain<'a> {
    pub(crate) mesh: &'a Mesh,
    pub(crate) to_clip: Mat4,
    pub(crate) color: Color,
}

impl Shader for Plain<'_> {
    type Constant = ();
    type Varying = ();
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        self.to_clip * self.mesh.positions()[vertex].extend(1.0)
    }

    #[inline]
    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    #[inline]
    fn corner(&self, _: usize, _: usize) {}

    #[inline]
    fn fragment(&self, (): (), _: Fragment<()>) -> Option<Color> {
        Some(self.color)
    }
}

impl Plain<'_> {
    /// Draws it over a background, each triangle that shows its front.
    pub(crate) fn draw(
        &self,
        background: Color,
        canvas: &mut impl Canvas<Stencil = ()>,
        picture: &mut Image,
    ) -> Counts {
        canvas.clear(background, false);
        let counts = render(self, self.mesh.assembled(), Cull::Back, State::OFF, canvas);
        canvas.resolve(resolve, picture);
        counts
    }
}
