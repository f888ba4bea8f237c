//! Lesson 16's renderer with few of its looks.

use antialiasing::canvas::{Canvas, render_with};
use antialiasing::multisampled::Multisampled;
use antialiasing::resolve;
use antialiasing::storage::Samples;
use blending::compare::Compare;
use blending::translucent::Translucent;
use blending::{DepthTest, Over, State, TwoShift};
use clipping::Counts;
use clipping::render::Vertices;
use common::{Color, Image, Vec2, Vec4};
use filtering::footprint::Gradients;
use scene::lamps::Lamps;
use scene::render::Frame;
use scene::shader::{AtPixels, Base, Look, Textured};
use scene::{Paint, Renderer};
use shaders::shader::Fragment;

/// The lesson's renderer, for surfaces that have one colour or a texture and are lit at the pixels: two loops, where the lesson
/// has one for each look.
pub struct FewLooks;

impl Renderer for FewLooks {
    fn draw(&mut self, frame: &Frame, picture: &mut Image) -> Counts {
        let mut lamps = Lamps::default();
        lamps.set(&frame.scene.lights);
        let mut canvas =
            Multisampled::<1, Samples<1>>::new([picture.width(), picture.height()].map(|side| side as usize));
        canvas.clear(frame.scene.background, false);
        let mut counts = Counts::default();
        for pass in frame.passes() {
            let mesh = pass.mesh;
            let base = match mesh.paint() {
                &Paint::Color(color) => Surface::Plain(color),
                Paint::Texture(texture) => {
                    let (filter, size) = (frame.scene.style.filter, picture.size());
                    Surface::Textured(Textured { texture, uvs: mesh.uvs(), filter, size })
                }
                Paint::Colors(_) => unreachable!("nothing here has a colour for each vertex"),
            };
            let look = Look { mesh, to_clip: pass.to_clip, base, lighting: AtPixels(pass.placed(&lamps)) };
            counts += match pass.alpha {
                None => {
                    let mut vertices = Vertices::default();
                    render_with(&mut vertices, &look, mesh.assembled(), pass.cull, State::OFF, &mut canvas)
                }
                Some(alpha) => {
                    let shader = Translucent { shader: look, alpha, vertices: () };
                    let depth = DepthTest { function: Compare::Less, write: false };
                    let blend = Over::<TwoShift>::default();
                    let state = State { scissor: (), stencil: (), depth, blend, mask: () };
                    let mut vertices = Vertices::default();
                    render_with(&mut vertices, &shader, mesh.assembled(), pass.cull, state, &mut canvas)
                }
            };
        }
        canvas.resolve(resolve, picture);
        counts
    }
}

/// Where a surface's colours come from.
enum Surface<'a> {
    Plain(Color),
    Textured(Textured<'a>),
}

impl Base for Surface<'_> {
    type Constant = Option<Gradients>;
    type Varying = Vec2;

    fn triangle(&self, vertices: [usize; 3], clip: impl FnOnce() -> [Vec4; 3]) -> Option<Gradients> {
        match self {
            Self::Plain(_) => None,
            Self::Textured(textured) => textured.triangle(vertices, clip),
        }
    }

    fn vertex(&self, vertex: usize) -> Vec2 {
        match self {
            Self::Plain(_) => Vec2::ZERO,
            Self::Textured(textured) => textured.vertex(vertex),
        }
    }

    fn color(&self, gradients: Option<Gradients>, fragment: Fragment<Vec2>) -> Color {
        match self {
            Self::Plain(color) => *color,
            Self::Textured(textured) => textured.color(gradients, fragment),
        }
    }
}
