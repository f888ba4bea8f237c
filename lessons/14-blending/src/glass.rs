//! A rosette of coloured glass, whose panes have no order.
//!
//! Each of six panes lies over the next, all around, so that none is the farthest. A round pane cuts through all six, and so
//! does a ring of lead, which is opaque.

use std::f32::consts::TAU;

use common::{Color, Image, Vec2};
use zbuffer::{DepthBuffer, Surface};

use crate::blend::BlendStage;
use crate::state::State;
use crate::target::Framebuffer;
use crate::transparency::{Fill, Transparency};

/// What the glass lies on.
const PAPER: Color = Color::rgb(0xf7, 0xf3, 0xe8);
const LEAD: Color = Color::rgb(0x3a, 0x3d, 0x46);

/// The panes' colours, with an alpha each.
const PANES: [Color; 6] = [
    glass(0xd9, 0x2b, 0x3a),
    glass(0xee, 0x7d, 0x16),
    glass(0xf2, 0xc2, 0x1a),
    glass(0x2f, 0x9e, 0x5b),
    glass(0x1f, 0x7f, 0xc4),
    glass(0x76, 0x3f, 0xa8),
];

const fn glass(r: u8, g: u8, b: u8) -> Color {
    Color { r, g, b, a: 150 }
}

/// Triangles in the window.
pub struct Rosette {
    /// The ring.
    pub opaque: Vec<Surface>,
    /// The panes, the round one last.
    pub transparent: Vec<Surface>,
}

// ANCHOR: rosette
impl Rosette {
    /// In the middle of a picture of that size.
    #[must_use]
    pub fn new(size: Vec2) -> Self {
        let radius = 0.47 * size.min_element();
        // So far from the middle, at that share of a turn.
        let at = |far: f32, turn: f32| {
            size / 2.0 + radius * far * Vec2::new(libm::cosf(turn * TAU), libm::sinf(turn * TAU))
        };
        let mut transparent = Vec::new();
        for (n, color) in PANES.into_iter().enumerate() {
            // Near on the side that covers the next pane, far on the one that the pane before covers.
            let corner = |far, turn: f32, depth| at(far, turn + n as f32 / 6.0).extend(depth);
            let corners = [corner(0.12, 0.65, 0.5), corner(1.0, 0.0, 0.75), corner(1.0, 0.27, 0.25)];
            transparent.push(Surface { corners, color });
        }
        let mut opaque = Vec::new();
        for n in 0..96 {
            let [from, to] = [n, n + 1].map(|n| n as f32 / 96.0);
            let [a, b, c, d] = [(0.66, from), (0.69, from), (0.69, to), (0.66, to)]
                .map(|(far, turn)| at(far, turn).extend(0.45));
            opaque.extend([[a, b, c], [a, c, d]].map(|corners| Surface { corners, color: LEAD }));
            let corners = [(0.0, from), (0.4, from), (0.4, to)].map(|(far, turn)| at(far, turn).extend(0.55));
            transparent.push(Surface { corners, color: glass(0x9a, 0xd8, 0xe8) });
        }
        Self { opaque, transparent }
    }
}

/// Draws it on paper: what is opaque first, whose depths are returned, then the panes in one of the ways there are.
pub fn draw(transparency: Transparency, blend: impl BlendStage, image: &mut Image) -> DepthBuffer<f32> {
    let Rosette { opaque, transparent } = Rosette::new(image.size());
    image.set_all(|_| PAPER);
    let mut target = Framebuffer::new(image, State::OFF);
    opaque.iter().for_each(|surface| surface.fill(&mut target));
    let Framebuffer { image, depths, .. } = target;
    transparency.draw(&transparent, blend, image, &depths);
    depths
}
// ANCHOR_END: rosette
