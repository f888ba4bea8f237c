//! Draws lesson 14's pictures: `cargo run --release -p blending`.

use std::process::ExitCode;

use blending::crates::CRATE;
use blending::flags::{StateFlags, TriangleFlags};
use blending::scene::{Entity, View};
use blending::{Divide, Framebuffer, crates, mirror, outline, plain, sheet};
use camera::flags::{TurntableFlag, ViewFlags};
use clipping::Drawn;
use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE, TexturedModelFlags};
use common::program::{Extras, Output, Program, named, run};
use common::{Attributes, Color, Format, Image, Lesson, Mat4, Method, Vec2};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use lighting::flags::PointLightFlags;
use perspective::flags::CameraFlags;
use perspective::scene::Loaded;
use perspective::view;

/// What the program draws where no triangles are asked for.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Show {
    /// A large crate, and a smaller one at half alpha before it.
    Crates,
    /// The head in a light, by a stencil.
    Outline,
    /// The head before a mirror, by a stencil.
    Mirror,
    /// Colours, normals, distances, and what is made of them.
    Outputs,
}

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("0.6,1.2,3.25")))]
#[command(mut_arg("light_at", |arg| arg.default_value("-0.8,2.3,2.8")))]
#[command(mut_arg("ambient", |arg| arg.default_value("0.3")))]
#[command(mut_arg("diffuse", |arg| arg.default_value("1")))]
#[command(mut_arg("light", |arg| arg.hide(true)))]
struct Flags {
    #[command(flatten)]
    triangles: TriangleFlags,

    /// What to draw instead of the crates
    #[arg(long, value_enum, default_value_t = Show::Crates)]
    show: Show,

    #[command(flatten)]
    state: StateFlags,
    #[command(flatten)]
    model: TexturedModelFlags,
    #[command(flatten)]
    depth: DepthFlag,
    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    lamp: PointLightFlags,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    turntable: TurntableFlag,
    #[command(flatten)]
    camera: CameraFlags,
}

/// What is to be drawn, and how.
struct Blending {
    scene: Scene,
    /// Where nothing is drawn.
    stencil: Option<Image>,
    flags: Flags,
}

/// What was read of a scene.
enum Scene {
    /// Triangles in the window, which the flags hold.
    Triangles,
    /// The model of both crates.
    Crates(Filterable),
    /// The head.
    Outline(Filterable),
    /// The head and its floor, and the wood of the frame.
    Mirror(Vec<Filterable>, Filterable),
    /// The head and its floor.
    Outputs(Vec<Filterable>),
}

impl Scene {
    fn read(flags: &Flags) -> anyhow::Result<Self> {
        if !flags.triangles.triangles.is_empty() {
            return Ok(Self::Triangles);
        }
        let origin = flags.view.origin();
        let mipmap = *named(MIPMAPS, "mipmaps", "box-linear")?;
        let read = |model: &TexturedModelFlags, default: [&str; 2]| {
            let (model, texture) =
                model.read_instead(default, origin, Attributes { normals: true, uvs: true })?;
            let loaded = Loaded::new(model, texture, Default::default());
            anyhow::Ok(Filterable::new(loaded, mipmap, Wrap::Repeat))
        };
        let on_floor = || Filterable::read(&flags.model, origin, mipmap, Wrap::Repeat);
        Ok(match flags.show {
            Show::Crates => Self::Crates(read(&flags.model, CRATE)?),
            Show::Outline => Self::Outline(read(&flags.model, [DEFAULT_MODEL, DEFAULT_TEXTURE])?),
            Show::Mirror => Self::Mirror(on_floor()?, read(&TexturedModelFlags::default(), CRATE)?),
            Show::Outputs => Self::Outputs(on_floor()?),
        })
    }
}

impl Program for Blending {
    type Flags = Flags;
    type Method = Divide;

    const LESSON: Lesson = blending::LESSON;
    const METHODS: &[Method<Divide>] = blending::METHODS;
    const DEFAULT: &str = "two-shift";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        // Refused before a file is read.
        flags.camera.projection(1.0)?;
        Ok(Self { scene: Scene::read(&flags)?, stencil: flags.state.read_stencil()?, flags })
    }

    fn draw(&mut self, method: &Divide, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        plain::clear_to(picture, self.flags.triangles.background);
        let view = self.view(size)?;
        let drawn = match &self.scene {
            Scene::Triangles => self.draw_under_state(method, &[], &view, picture)?,
            Scene::Crates(model) if self.flags.state.are_given() => {
                self.draw_under_state(method, &crates::entities(model), &view, picture)?
            }
            Scene::Crates(model) => (method.entities)(&crates::entities(model), &view, picture),
            Scene::Outline(head) => outline::draw(&standing(head), &view, LIGHT, picture),
            Scene::Mirror(models, wood) => {
                let (mirror, world) = mirror::scene(models, wood);
                mirror::draw(&mirror, &world, &view, picture)
            }
            Scene::Outputs(models) => {
                sheet::draw(&models.iter().map(standing).collect::<Vec<_>>(), &view, picture)
            }
        };
        let depth = self.flags.depth.picture(|| drawn.depths.picture_by(|depth| -f64::from(depth)));
        Ok(Extras { depth, left_out: drawn.counts.left_out })
    }

    fn show(&mut self, method: &Divide, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.flags.turntable.stops else { return output.one(self, method) };
        let from = self.flags.view;
        output.series(self, method, stops, |scene, n| scene.flags.view = from.turned(n, stops))
    }
}

/// The colour of the light around the head.
const LIGHT: Color = Color::rgb(255, 196, 96);

/// A model as it stands.
fn standing(model: &Filterable) -> Entity<'_> {
    Entity { model, to_world: Mat4::IDENTITY, alpha: 1.0 }
}

impl Blending {
    fn view(&self, size: Vec2) -> anyhow::Result<View> {
        let flags = &self.flags;
        let origin = flags.view.origin();
        let to_clip = flags.camera.projection(size.x / size.y)? * flags.view.look(view)?;
        let eye = (flags.view.eye - origin).as_vec3();
        Ok(View { to_clip, eye, light: flags.lamp.light(origin) })
    }

    /// Draws entities, and the triangles that were asked for, under the state that the flags describe. The picture gets an
    /// alpha, which is opaque at first, as destination alphas count.
    fn draw_under_state(
        &self,
        method: &Divide,
        entities: &[Entity],
        view: &View,
        picture: &mut Image,
    ) -> anyhow::Result<Drawn> {
        let Flags { triangles, state, .. } = &self.flags;
        let mut image = with_alpha(picture);
        let mut target = Framebuffer::new(&mut image, state.state());
        if let Some(stencil) = &self.stencil {
            target.stencils = state.stencils(stencil, picture)?;
        }
        let (target, counts) = (method.entities_under)(target, entities, view);
        let Framebuffer { depths, .. } = (method.triangles_under)(target, &triangles.triangles);
        *picture = image;
        Ok(Drawn { depths, counts })
    }
}

/// A picture with an alpha channel.
fn with_alpha(picture: &Image) -> Image {
    let mut image = Image::new(picture.width() as u16, picture.height() as u16, Format::Rgba);
    picture.pixels().for_each(|(x, y, color)| image.set(x, y, color));
    image
}

fn main() -> ExitCode {
    run::<Blending>()
}
