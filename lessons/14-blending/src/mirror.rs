//! A stencil put to use: a mirror.
//!
//! What is seen in a mirror is the world once more, turned over at the mirror's plane, and seen through the mirror's own shape.
//! So the pane is drawn first, and marks its pixels; then the world turned over, lit by the light turned over, only where there
//! is a mark; then the pane's depth, as if nothing were behind it; and then the world itself. (M. Kilgard, *Improving shadows
//! and reflections via the stencil buffer*, NVIDIA 1999, has the same steps.)

use clipping::{Cull, Drawn};
use common::{Color, Image, Mat4, Vec3, Vec4};
use filtering::scene::Filterable;
use lighting::PointLight;
use transforms::affine::{about, model};
use transforms::{scale, translate};

use crate::blend::Over;
use crate::compare::Compare;
use crate::depth::{DepthTest, Less};
use crate::division::TwoShift;
use crate::mask::WriteMask;
use crate::scene::{Entity, View};
use crate::state::State;
use crate::stencil::{StencilOp, StencilTest};
use crate::target::Framebuffer;

/// What turns the world over at the plane through a point, with that normal, which is 1 long: x − 2(n·x)n about the point.
// ANCHOR: reflection
#[must_use]
pub fn reflection(point: Vec3, normal: Vec3) -> Mat4 {
    let [x, y, z] =
        [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| (axis - 2.0 * axis.dot(normal) * normal).extend(0.0));
    about(point, Mat4::from_cols(x, y, z, Vec4::W))
}
// ANCHOR_END: reflection

/// A mirror: its pane, and the frame about it, which is not mirrored itself.
pub struct Mirror<'a> {
    /// A box of side 1, made flat; it mirrors in its face towards +z.
    pub pane: Entity<'a>,
    /// What holds it.
    pub frame: [Entity<'a>; 4],
}

/// The pane's own colour, by which what is seen in it is darker, and how much of it is seen.
const GLASS: Color = Color { r: 24, g: 34, b: 40, a: 56 };

impl<'a> Mirror<'a> {
    /// Of that width and height, at its place in the world; the frame is of bars so thick.
    #[must_use]
    pub fn new(wood: &'a Filterable, to_world: Mat4, [width, height]: [f32; 2], bar: f32) -> Self {
        let part = |at: Vec3, size: Vec3| Entity {
            model: wood,
            to_world: to_world * translate(at) * scale(size),
            alpha: 1.0,
        };
        let (x, y) = ((width + bar) / 2.0, (height + bar) / 2.0);
        let [upright, level] = [Vec3::new(bar, height + 2.0 * bar, bar), Vec3::new(width, bar, bar)];
        Self {
            pane: part(Vec3::ZERO, Vec3::new(width, height, bar / 4.0)),
            frame: [
                part(Vec3::new(-x, 0.0, 0.0), upright),
                part(Vec3::new(x, 0.0, 0.0), upright),
                part(Vec3::new(0.0, -y, 0.0), level),
                part(Vec3::new(0.0, y, 0.0), level),
            ],
        }
    }
}

/// The lesson's own scene: the first of these models, a head, before a mirror of that wood, and the others, its floor, where
/// they are.
#[must_use]
pub fn scene<'a>(models: &'a [Filterable], wood: &'a Filterable) -> (Mirror<'a>, Vec<Entity<'a>>) {
    let mirror =
        Mirror::new(wood, model(Vec3::new(-0.75, 0.15, -0.9), Vec3::Y * 40.0, Vec3::ONE), [1.5, 2.05], 0.12);
    let head = model(Vec3::new(0.55, 0.0, -0.25), Vec3::Y * -104.0, Vec3::ONE);
    let places = std::iter::once(head).chain(std::iter::repeat(Mat4::IDENTITY));
    let entity = |(model, to_world)| Entity { model, to_world, alpha: 1.0 };
    (mirror, models.iter().zip(places).map(entity).collect())
}

/// Draws a world and a mirror that stands in it over a picture. All of it counts as opaque. What stands behind the mirror's plane
/// would be seen in the pane as well, since nothing is cut at the plane; there should be nothing that is seen through the pane.
// ANCHOR: mirror
pub fn draw(mirror: &Mirror, world: &[Entity], view: &View, image: &mut Image) -> Drawn {
    let pane = &mirror.pane.to_world;
    let over = reflection(pane.transform_point3(Vec3::Z / 2.0), pane.z_axis.truncate().normalize());
    let mark = StencilTest { reference: 1, pass: StencilOp::Replace, ..StencilTest::ALWAYS };
    let marked = StencilTest { function: Compare::Equal, reference: 1, ..StencilTest::ALWAYS };

    // The pane's shape.
    let depth = DepthTest { function: Compare::Less, write: false };
    let state = State { scissor: (), stencil: mark, depth, blend: (), mask: WriteMask::NOTHING };
    let mut target = Framebuffer::new(image, state);
    let mut counts = mirror.pane.draw_shape(GLASS, 0.0, view, &mut target);

    // The world turned over, whose triangles are turned round.
    let light = PointLight { position: over.transform_point3(view.light.position), ..view.light };
    let mut target = target.under(State { scissor: (), stencil: marked, depth: Less, blend: (), mask: () });
    for entity in world {
        let turned = Entity { to_world: over * entity.to_world, ..*entity };
        counts += turned.draw(&View { light, ..*view }, Cull::Front, &mut target);
    }

    // The pane's glass and its depth.
    let depth = DepthTest { function: Compare::Always, write: true };
    let state = State { scissor: (), stencil: marked, depth, blend: Over(TwoShift), mask: () };
    let mut target = target.under(state);
    counts += mirror.pane.draw_shape(GLASS, 0.0, view, &mut target);

    // The world itself.
    let stencil = StencilTest::ALWAYS;
    let mut target = target.under(State { scissor: (), stencil, depth: Less, blend: (), mask: () });
    for entity in mirror.frame.iter().chain(world) {
        counts += entity.draw(view, Cull::Back, &mut target);
    }
    Drawn { depths: target.depths, counts }
}
// ANCHOR_END: mirror
