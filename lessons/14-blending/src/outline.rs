//! A stencil put to use: light around a shape.
//!
//! The entity is drawn, and marks its pixels. Then it is drawn again and again, in one colour, each time more swollen and
//! fainter, where there is no mark yet, and marks in its turn. So a pixel is drawn to once, however often the swollen shape
//! covers it, and what shines is the outline of the whole alone: what stands before another part of the same entity has none.

use clipping::{Cull, Drawn};
use common::{Color, Image};

use crate::blend::Over;
use crate::compare::Compare;
use crate::depth::Less;
use crate::division::TwoShift;
use crate::scene::{Entity, View};
use crate::state::State;
use crate::stencil::{StencilOp, StencilTest};
use crate::target::Framebuffer;

/// How many rings of light there are.
const RINGS: u8 = 16;

/// How wide each is, in units of the world.
const WIDTH: f32 = 0.006;

/// Draws an entity in a light of that colour, over a picture.
// ANCHOR: outline
pub fn draw(entity: &Entity, view: &View, color: Color, image: &mut Image) -> Drawn {
    let mark = StencilTest { reference: 1, pass: StencilOp::Replace, ..StencilTest::ALWAYS };
    let state = State { scissor: (), stencil: mark, depth: Less, blend: (), mask: () };
    let mut target = Framebuffer::new(image, state);
    let mut counts = entity.draw(view, Cull::Back, &mut target);

    let unmarked = StencilTest { function: Compare::Notequal, ..mark };
    let blend = Over(TwoShift);
    let mut target = target.under(State { scissor: (), stencil: unmarked, depth: (), blend, mask: () });
    for ring in 1..=RINGS {
        let left = u32::from(RINGS + 1 - ring);
        let alpha = (u32::from(color.a) * left * left / u32::from(RINGS).pow(2)) as u8;
        counts += entity.draw_shape(Color { a: alpha, ..color }, WIDTH * f32::from(ring), view, &mut target);
    }
    Drawn { depths: target.depths, counts }
}
// ANCHOR_END: outline
