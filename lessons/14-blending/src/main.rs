//! Draws lesson 14's pictures: `cargo run --release -p blending`.

use std::process::ExitCode;

use blending::blend::BlendStage;
use blending::crates::CRATE;
use blending::cutout::{Cutout, FERN};
use blending::flags::{StateFlags, TriangleFlags};
use blending::scene::{Entity, View};
use blending::{
    AnyFramebuffer, Blend, Divide, Framebuffer, SPACES, Space, State, TRANSPARENCY, Transparency,
};
use blending::{crates, glass, mirror, outline, plain, scene, sheet};
use camera::flags::{TurntableFlag, ViewFlags};
use clipping::{Counts, Cull, Drawn};
use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE, TexturedModelFlags};
use common::program::{Extras, Output, Program, UsageError, named, run};
use common::{Attributes, Color, Format, Image, Lesson, Mat4, Method, Vec2};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use lighting::flags::PointLightFlags;
use perspective::flags::CameraFlags;
use perspective::scene::Loaded;
use perspective::view;
use zbuffer::{DepthBuffer, Surface};

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
    /// Panes of glass that have no order, on paper.
    Glass,
    /// A fern that its alpha cuts out, enlarged, before a wall.
    Fern,
}

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("0.6,1.2,3.25")))]
#[command(mut_arg("light_at", |arg| arg.default_value("-0.4,2.4,3.1")))]
#[command(mut_arg("ambient", |arg| arg.default_value("0.34")))]
#[command(mut_arg("diffuse", |arg| arg.default_value("1.05")))]
#[command(mut_arg("light", |arg| arg.hide(true)))]
struct Flags {
    #[command(flatten)]
    triangles: TriangleFlags,

    /// What to draw instead of the crates
    #[arg(long, value_enum, default_value_t = Show::Crates)]
    show: Show,

    /// The order of what is transparent: drawn, sorted, peeling, list or weighted [default: none, as it comes and with
    /// its depths kept; for glass list]
    #[arg(long, value_name = "NAME")]
    transparency: Option<String>,

    /// What is mixed, codes or light, and how colours are kept: encoded-straight, encoded-premultiplied, linear-straight or
    /// linear-premultiplied
    #[arg(long, value_name = "NAME", default_value = "encoded-straight")]
    space: String,

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

/// The flags of the state, as a sentence lists them.
const STATE: &str = "--scissor, --stencil, --depth-test, --blend, --blend-alpha, --blend-color, --equation, --logic or --write-mask";

impl Flags {
    /// Refuses what does not go together, and what the scene cannot take.
    fn check(&self, transparency: Option<Transparency>, space: bool) -> Result<(), UsageError> {
        let state = self.state.are_given();
        if state && (transparency.is_some() || space) {
            let why = format!("--transparency and --space lay one layer over another: leave out {STATE}");
            return Err(UsageError(why));
        }
        if transparency == Some(Transparency::Weighted) && space {
            let why = "--transparency weighted lays no layer over another: leave out --space";
            return Err(UsageError(why.into()));
        }
        let (scene, [takes_state, takes_order, takes_space]) = match self.show {
            _ if !self.triangles.triangles.is_empty() => return Ok(()),
            Show::Crates => return Ok(()),
            Show::Outline => ("outline", [false, false, false]),
            Show::Mirror => ("mirror", [false, false, false]),
            Show::Outputs => ("outputs", [false, false, false]),
            Show::Glass => ("glass", [false, true, true]),
            Show::Fern => ("fern", [false, false, true]),
        };
        let given = [
            (state && !takes_state, STATE),
            (transparency.is_some() && !takes_order, "--transparency"),
            (space && !takes_space, "--space"),
        ];
        let Some((_, flag)) = given.into_iter().find(|&(refused, _)| refused) else { return Ok(()) };
        Err(UsageError(format!("--show {scene} takes no {flag}: leave it out")))
    }
}

/// What is to be drawn, and how.
struct Blending {
    scene: Scene,
    /// Where nothing is drawn.
    stencil: Option<Image>,
    /// The order of what is transparent, where one is asked for.
    transparency: Option<Transparency>,
    /// What is mixed, where it is not what the methods mix.
    space: Option<Space>,
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
    /// Nothing: it is made for each picture's size.
    Glass,
    Fern(Cutout),
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
            Show::Glass => Self::Glass,
            Show::Fern => Self::Fern(Cutout::read(FERN)?),
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
        let transparency = flags.transparency.as_deref();
        let transparency = transparency.map(|name| named(TRANSPARENCY, "transparency", name)).transpose()?;
        let space = named(SPACES, "space", &flags.space)?;
        let space = (flags.space != SPACES[0].name).then_some(*space);
        flags.check(transparency.copied(), space.is_some())?;
        let (scene, stencil) = (Scene::read(&flags)?, flags.state.read_stencil()?);
        Ok(Self { scene, stencil, transparency: transparency.copied(), space, flags })
    }

    fn draw(&mut self, method: &Divide, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        picture.set_all(|_| self.flags.triangles.background);
        let view = self.view(size)?;
        // What is as it is unless told otherwise is drawn by what is compiled for just that.
        let usual = self.transparency.is_none() && self.space.is_none() && !self.flags.state.are_given();
        let layer = self.space.map_or(Layer::Over(method.blend), Layer::In);
        let drawn = match &self.scene {
            Scene::Crates(model) if usual => (method.entities)(&crates::entities(model), &view, picture),
            Scene::Crates(model) => {
                self.draw_entities(&crates::entities(model), method, layer, &view, picture)?
            }
            Scene::Triangles => self.draw_triangles(method, layer, picture)?,
            Scene::Outline(head) => outline::draw(&standing(head), &view, LIGHT, picture),
            Scene::Mirror(models, wood) => {
                let (mirror, world) = mirror::scene(models, wood);
                mirror::draw(&mirror, &world, &view, picture)
            }
            Scene::Outputs(models) => {
                sheet::draw(&models.iter().map(standing).collect::<Vec<_>>(), &view, picture)
            }
            Scene::Glass => {
                flat(glass::draw(self.transparency.unwrap_or(Transparency::List), layer, picture))
            }
            Scene::Fern(fern) => flat(fern.enlarged(&self.space.unwrap_or(SPACES[0].run), picture)),
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

/// What leaves depths behind, and no triangles to count.
fn flat(depths: DepthBuffer<f32>) -> Drawn {
    Drawn { depths, counts: Counts::default() }
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

    /// Draws entities in one of the orders and spaces, or under the state that the flags describe.
    fn draw_entities(
        &self,
        entities: &[Entity],
        method: &Divide,
        layer: Layer,
        view: &View,
        picture: &mut Image,
    ) -> anyhow::Result<Drawn> {
        if let Some(transparency) = self.transparency {
            return Ok(scene::draw_by(transparency, entities, view, Cull::Back, layer, picture));
        }
        if self.space.is_some() {
            return Ok(scene::draw(entities, view, layer, picture));
        }
        let mut image = with_alpha(picture);
        let target = self.target(&mut image)?;
        let (Framebuffer { depths, .. }, counts) = (method.entities_under)(target, entities, view);
        *picture = image;
        Ok(Drawn { depths, counts })
    }

    /// Draws the triangles that were asked for likewise. They come in the order given, and their depths are kept; where an order
    /// is asked for, the opaque ones come first, and the others leave no depths.
    fn draw_triangles(&self, method: &Divide, layer: Layer, picture: &mut Image) -> anyhow::Result<Drawn> {
        let triangles = &self.flags.triangles.triangles;
        let mut image = with_alpha(picture);
        let depths = if let Some(transparency) = self.transparency {
            let (opaque, transparent): (Vec<Surface>, Vec<Surface>) =
                triangles.iter().partition(|surface| surface.color.a == 255);
            let mut target = Framebuffer::new(&mut image, State::OFF);
            plain::draw(&opaque, &mut target);
            let Framebuffer { image, depths, .. } = target;
            transparency.draw(&transparent, layer, image, &depths);
            depths
        } else if self.space.is_some() {
            let mut target = Framebuffer::new(&mut image, State::blending(layer));
            plain::draw(triangles, &mut target);
            target.depths
        } else {
            (method.triangles_under)(self.target(&mut image)?, triangles).depths
        };
        *picture = image;
        Ok(flat(depths))
    }

    /// A picture under the state that the flags describe.
    fn target<'a>(&self, image: &'a mut Image) -> anyhow::Result<AnyFramebuffer<'a>> {
        let stencils =
            self.stencil.as_ref().map(|stencil| self.flags.state.stencils(stencil, image)).transpose()?;
        let mut target = Framebuffer::new(image, self.flags.state.state());
        if let Some(stencils) = stencils {
            target.stencils = stencils;
        }
        Ok(target)
    }
}

/// How a layer is laid over what is there.
#[derive(Clone, Copy)]
enum Layer {
    /// By one of the ways to divide.
    Over(fn(&Blend, Color, Color) -> Color),
    /// In one of the spaces.
    In(Space),
}

impl BlendStage for Layer {
    fn color(self, source: Color, destination: Color) -> Color {
        match self {
            Self::Over(blend) => blend(&Blend::OVER, source, destination),
            Self::In(space) => space.color(space.stored(source), destination),
        }
    }
}

/// A picture with an alpha channel, as destination alphas count.
fn with_alpha(picture: &Image) -> Image {
    let mut image = Image::new(picture.width() as u16, picture.height() as u16, Format::Rgba);
    picture.pixels().for_each(|(x, y, color)| image.set(x, y, color));
    image
}

fn main() -> ExitCode {
    run::<Blending>()
}
