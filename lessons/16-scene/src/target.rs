//! What a scene is drawn to, kept from frame to frame.

use antialiasing::canvas::Canvas;
use antialiasing::multisampled::Multisampled;
use antialiasing::storage::{Compressed, Samples};
use common::{Format, Image, Mat3, Mat4};

use crate::frustum::Sphere;
use crate::render::{Loops, Renderer};
use crate::wireframe::Wires;

/// One sample a pixel.
pub(crate) type Single = Multisampled<1, Samples<1>>;

/// Sixteen.
pub(crate) type Many = Multisampled<16, Compressed<16>>;

/// An entity that is to be drawn: its number, how deep before the eye it is, and what of its place is computed once a frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Queued {
    pub(crate) transparent: bool,
    pub(crate) depth: f32,
    pub(crate) entity: usize,
    pub(crate) bounds: Sphere,
    pub(crate) to_world: Mat4,
    pub(crate) normals_to_world: Mat3,
}

/// A picture, and what drawing one after the other needs and should not allocate again.
pub struct Target {
    /// Whether edges are smooth: sixteen samples a pixel instead of one.
    pub antialiased: bool,
    /// Whether the sides of triangles are drawn instead of what is within them.
    pub wireframe: bool,
    pub(crate) picture: Image,
    pub(crate) queue: Vec<Queued>,
    pub(crate) wires: Box<dyn Renderer>,
    pub(crate) renderer: Box<dyn Renderer>,
}

impl Target {
    /// Black, of that size in pixels, for this lesson's renderer.
    #[must_use]
    pub fn new(width: u16, height: u16) -> Self {
        Self::with(Box::new(Loops::default()), width, height)
    }

    /// The same for any renderer.
    #[must_use]
    pub fn with(renderer: Box<dyn Renderer>, width: u16, height: u16) -> Self {
        Self::with_both([renderer, Box::<Wires>::default()], width, height)
    }

    /// The same with a renderer for wireframes as well.
    #[must_use]
    pub fn with_both([renderer, wires]: [Box<dyn Renderer>; 2], width: u16, height: u16) -> Self {
        Self {
            antialiased: false,
            wireframe: false,
            picture: Image::new(width, height, Format::Rgb),
            queue: Vec::new(),
            wires,
            renderer,
        }
    }

    /// What was drawn last.
    #[must_use]
    pub fn picture(&self) -> &Image {
        &self.picture
    }

    /// The same for whoever keeps nothing else of it.
    #[must_use]
    pub fn into_picture(self) -> Image {
        self.picture
    }

    /// Makes the picture one of another size, and black; of the same size it stays what it is.
    pub fn resize(&mut self, width: u16, height: u16) {
        if [self.picture.width(), self.picture.height()] != [width, height].map(i32::from) {
            self.picture = Image::new(width, height, Format::Rgb);
        }
    }
}

/// A canvas for such a picture, made when it is first asked for and when the size is another one.
pub(crate) fn canvas<'a, C: Canvas>(kept: &'a mut Option<C>, picture: &Image) -> &'a mut C {
    if kept.as_ref().is_some_and(|canvas| canvas.size() != picture.size()) {
        *kept = None;
    }
    kept.get_or_insert_with(|| C::new([picture.width(), picture.height()].map(|side| side as usize)))
}

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;

    #[test]
    fn another_size_keeps_what_is_switched_and_the_same_size_the_picture() {
        let mut target = Target::new(3, 2);
        target.wireframe = true;
        target.picture.set(1, 1, Color::RED);
        target.resize(3, 2);
        assert_eq!(target.picture().get(1, 1), Some(Color::RED));
        target.resize(2, 3);
        assert_eq!((target.picture().width(), target.picture().height()), (2, 3));
        assert!(target.wireframe && !target.antialiased);
        assert_eq!(target.picture().get(1, 1), Some(Color::BLACK));
    }
}
