//! Draws lesson 15's picture: `cargo run --release -p antialiasing`.

use std::process::ExitCode;

use antialiasing::cover::{fan, magnify};
use antialiasing::resolve::Resolve;
use antialiasing::{Draw, METHODS, RESOLVES, Scene, World};
use blending::flags::TriangleFlags;
use blending::scene::{Entity, View};
use camera::flags::ViewFlags;
use clipping::flags::CullFlag;
use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Program, UsageError, named, run};
use common::{Attributes, Image, Lesson, Mat4, Method};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use lighting::flags::PointLightFlags;
use perspective::flags::CameraFlags;
use perspective::scene::Loaded;
use perspective::view;

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("3.3,0.25,1.05")))]
#[command(mut_arg("center", |arg| arg.default_value("0,-0.03,0")))]
#[command(mut_arg("light_at", |arg| arg.default_value("0.9,1.6,3")))]
#[command(mut_arg("ambient", |arg| arg.default_value("0.1")))]
#[command(mut_arg("diffuse", |arg| arg.default_value("0.9")))]
#[command(mut_arg("light", |arg| arg.hide(true)))]
#[command(mut_arg("background", |arg| arg.help("What is behind the triangles or the model; the lesson's own picture has a sky")))]
struct Flags {
    #[command(flatten)]
    triangles: TriangleFlags,

    /// How the samples of a pixel become its colour, where it has several: encoded or linear
    #[arg(long, value_name = "NAME", default_value = "encoded")]
    resolve: String,

    /// Let a texture's alpha cover its share of the samples
    #[arg(long)]
    alpha_to_coverage: bool,

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
    camera: CameraFlags,
    #[command(flatten)]
    cull: CullFlag,
}

/// The most samples of a picture: eight bytes each.
const MOST_SAMPLES: usize = 1 << 28;

/// Refuses what would take more memory than many a machine has.
fn fits(method: &Draw, picture: &Image) -> Result<(), UsageError> {
    let [width, height] = [picture.width(), picture.height()].map(|side| side as usize);
    let most = MOST_SAMPLES / method.samples;
    if width * height <= most {
        return Ok(());
    }
    let why = format!("{} samples a pixel are too many for it; up to {most} pixels will do", method.samples);
    Err(UsageError(format!("--size {width}x{height}: {why}")))
}

/// The head before rays, a model alone, or triangles.
struct Antialiasing {
    /// None where triangles are asked for.
    model: Option<Filterable>,
    resolve: Resolve,
    flags: Flags,
}

impl Program for Antialiasing {
    type Flags = Flags;
    type Method = Draw;

    const LESSON: Lesson = antialiasing::LESSON;
    const METHODS: &[Method<Draw>] = METHODS;
    const DEFAULT: &str = "msaa-16";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        // Refused before a file is read.
        flags.camera.projection(1.0)?;
        let resolve = *named(RESOLVES, "resolve", &flags.resolve)?;
        let mipmap = *named(MIPMAPS, "mipmaps", "box-linear")?;
        let needs = Attributes { normals: true, uvs: true };
        let model = if flags.triangles.triangles.is_empty() {
            let (model, texture) = flags.model.read_about(flags.view.origin(), needs)?;
            Some(Filterable::new(Loaded::new(model, texture, Default::default()), mipmap, Wrap::Repeat))
        } else {
            None
        };
        Ok(Self { model, resolve, flags })
    }

    fn draw(&mut self, method: &Draw, picture: &mut Image) -> anyhow::Result<Extras> {
        let flags = &self.flags;
        let (size, origin) = (picture.size(), flags.view.origin());
        fits(method, picture)?;
        let to_clip = flags.camera.projection(size.x / size.y)? * flags.view.look(view)?;
        let eye = (flags.view.eye - origin).as_vec3();
        let view = View { to_clip, eye, light: flags.lamp.light(origin) };
        let models = self.model.as_slice();
        let entities: Vec<Entity> =
            models.iter().map(|model| Entity { model, to_world: Mat4::IDENTITY, alpha: 1.0 }).collect();
        let is_cover = self.model.is_some() && !flags.model.is_given();
        let rays = if is_cover { fan(size) } else { flags.triangles.triangles.clone() };
        let scene = Scene {
            background: flags.triangles.background,
            triangles: &rays,
            world: Some(World { entities: &entities, view, cull: flags.cull.which }),
            alpha_to_coverage: flags.alpha_to_coverage,
            resolve: self.resolve,
        };
        let counts = (method.picture)(&scene, picture);
        let depth =
            flags.depth.picture(|| (method.depths)(&scene, picture).picture_by(|depth| -f64::from(depth)));
        if is_cover {
            let mut stairs = picture.clone();
            let draw_stairs = || {
                (METHODS[0].run.picture)(&scene, &mut stairs);
                stairs
            };
            magnify(draw_stairs, picture);
        }
        Ok(Extras { depth, left_out: counts.left_out })
    }
}

fn main() -> ExitCode {
    run::<Antialiasing>()
}
