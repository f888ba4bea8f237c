//! What fragments are tested against and written to: before shading, or after.

use common::{Bounds, Color, IVec2, Image};
use shaders::target::Target;
use zbuffer::DepthBuffer;

use crate::state::Operations;

/// A picture, its depths, its stencil, and what happens to fragments on their way there.
pub struct Framebuffer<'a, S: Operations> {
    /// The picture.
    pub image: &'a mut Image,
    /// The depths of what is seen, 1 at first.
    pub depths: DepthBuffer<f32>,
    /// What the stencil keeps of each pixel, rows from the bottom. Where there is no stencil it takes no memory, but
    /// which pixel it is is checked nevertheless.
    pub stencils: Vec<S::Stencil>,
    /// What happens to fragments.
    pub state: S,
}

impl<'a, S: Operations> Framebuffer<'a, S> {
    /// Over a picture as it is: nothing was drawn yet.
    #[must_use]
    pub fn new(image: &'a mut Image, state: S) -> Self {
        let depths = DepthBuffer::new(image, 1.0);
        let pixels = image.width() as usize * image.height() as usize;
        Self { image, depths, stencils: vec![S::Stencil::default(); pixels], state }
    }

    /// The same picture, depths and stencil, under another state: the next pass.
    #[must_use]
    pub fn under<T: Operations<Stencil = S::Stencil>>(self, state: T) -> Framebuffer<'a, T> {
        let Self { image, depths, stencils, .. } = self;
        Framebuffer { image, depths, stencils, state }
    }
}

// ANCHOR: framebuffer
impl<S: Operations> Target<Color> for Framebuffer<'_, S> {
    fn bounds(&self) -> Bounds {
        self.depths.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        let kept = self.depths.get(x, y);
        let place = y as usize * self.image.width() as usize + x as usize;
        self.state.test(IVec2::new(x, y), depth, kept, &mut self.stencils[place])
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        if self.state.writes_depth() {
            self.depths.set(x, y, depth);
        }
        if let Some(destination) = self.image.get(x, y) {
            self.image.set(x, y, self.state.color(color, destination));
        }
    }

    fn clear(&mut self) {
        self.depths.clear();
        self.stencils.fill(S::Stencil::default());
        self.image.clear();
    }
}
// ANCHOR_END: framebuffer

/// A target that tests after shading, whatever it is otherwise.
///
/// A shader that replaces a fragment's depth ([`Replaced`]) needs it: before shading, there is nothing that could be tested.
///
/// ```
/// # use blending::{Framebuffer, Late, Replaced, State};
/// # use common::{Color, Format, Image};
/// # use shaders::target::Target;
/// # let mut image = Image::new(1, 1, Format::Rgb);
/// let mut target = Late(Framebuffer::new(&mut image, State::OFF));
/// target.write(0, 0, 0.5, Replaced { depth: 0.25, output: Color::RED });
/// assert_eq!(target.0.depths.get(0, 0), 0.25);
/// ```
///
/// ```compile_fail,E0277
/// # use blending::{Framebuffer, Replaced, State};
/// # use common::{Color, Format, Image};
/// # use shaders::target::Target;
/// # let mut image = Image::new(1, 1, Format::Rgb);
/// let mut target = Framebuffer::new(&mut image, State::OFF);
/// target.write(0, 0, 0.5, Replaced { depth: 0.25, output: Color::RED });
/// ```
pub struct Late<T>(pub T);

/// What a shader makes that replaces the depth of its fragments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Replaced<O> {
    /// The depth that counts.
    pub depth: f32,
    /// What else it makes.
    pub output: O,
}

// ANCHOR: late
impl<T: Target<Color>> Target<Color> for Late<T> {
    fn bounds(&self) -> Bounds {
        self.0.bounds()
    }

    #[inline]
    fn test(&mut self, _: i32, _: i32, _: f32) -> bool {
        true
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        if self.0.test(x, y, depth) {
            self.0.write(x, y, depth, color);
        }
    }

    fn clear(&mut self) {
        self.0.clear();
    }
}

impl<O, T: Target<O>> Target<Replaced<O>> for Late<T> {
    fn bounds(&self) -> Bounds {
        self.0.bounds()
    }

    #[inline]
    fn test(&mut self, _: i32, _: i32, _: f32) -> bool {
        true
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, _: f32, Replaced { depth, output }: Replaced<O>) {
        if self.0.test(x, y, depth) {
            self.0.write(x, y, depth, output);
        }
    }

    fn clear(&mut self) {
        self.0.clear();
    }
}
// ANCHOR_END: late
