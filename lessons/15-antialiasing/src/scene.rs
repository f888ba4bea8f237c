//! What this lesson draws: triangles in the window, and entities in the world.

use blending::scene::{Entity, View};
use blending::{Over, State, TwoShift};
use clipping::{Counts, Cull};
use common::{Color, Image};
use zbuffer::{DepthBuffer, Surface};

use crate::canvas::{Canvas, plain, render};
use crate::resolve::{Resolve, resolve};

/// What is drawn, and how its samples become a picture.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// What there is at first.
    pub background: Color,
    /// Triangles in the window of the picture, drawn first and in this order.
    pub triangles: &'a [Surface],
    /// What is in the world.
    pub world: Option<World<'a>>,
    /// Whether alpha is the share of the samples that a fragment covers; else what is not opaque is laid over what is there.
    pub alpha_to_coverage: bool,
    /// How samples become a pixel.
    pub resolve: Resolve,
}

/// Entities, and who looks at them.
#[derive(Clone, Copy)]
pub struct World<'a> {
    /// Models at their places; those that one sees through come last.
    pub entities: &'a [Entity<'a>],
    /// Eye and light.
    pub view: View,
    /// What is left out for the side that it shows.
    pub cull: Cull,
}

impl<'a> Scene<'a> {
    /// Triangles in the window alone, resolved encoded.
    #[must_use]
    pub fn of(triangles: &'a [Surface], background: Color) -> Self {
        Self { background, triangles, world: None, alpha_to_coverage: false, resolve }
    }

    /// Draws it into a picture.
    pub fn draw<C: Canvas<Stencil = ()>>(&self, picture: &mut Image) -> Counts {
        let (canvas, counts) = self.drawn::<C>(picture);
        canvas.resolve(self.resolve, picture);
        counts
    }

    /// The nearest depths in the pixels of such a picture.
    #[must_use]
    pub fn depths<C: Canvas<Stencil = ()>>(&self, picture: &Image) -> DepthBuffer<f32> {
        self.drawn::<C>(picture).0.depths(picture)
    }

    fn drawn<C: Canvas<Stencil = ()>>(&self, picture: &Image) -> (C, Counts) {
        let size = [picture.width(), picture.height()].map(|side| side as usize);
        let mut canvas = C::new(size);
        let counts = self.draw_to(picture, &mut canvas);
        (canvas, counts)
    }

    /// Draws it to a canvas for such a picture, which may be kept from picture to picture.
    pub fn draw_to<C: Canvas<Stencil = ()>>(&self, picture: &Image, canvas: &mut C) -> Counts {
        canvas.clear(self.background, self.alpha_to_coverage);
        let over = State::blending(Over::<TwoShift>::default());
        let scale = canvas.size() / picture.size();
        for triangle in self.triangles {
            if triangle.color.a == u8::MAX || self.alpha_to_coverage {
                plain(triangle, State::OFF, scale, canvas);
            } else {
                plain(triangle, over, scale, canvas);
            }
        }
        let mut counts = Counts::default();
        let Some(World { entities, view, cull }) = &self.world else { return counts };
        for entity in *entities {
            let Some(shader) = entity.shader(view, canvas.size()) else { continue };
            counts += if entity.is_opaque() || self.alpha_to_coverage {
                render(&shader, entity.mesh(), *cull, State::OFF, canvas)
            } else {
                render(&shader, entity.mesh(), *cull, over, canvas)
            };
        }
        counts
    }
}
