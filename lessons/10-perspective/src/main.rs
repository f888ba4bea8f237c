//! Draws lesson 10's picture: `cargo run --release -p perspective`.

use std::process::ExitCode;

use camera::flags::ViewFlags;
use common::program::{Extras, Program, UsageError, named, run};
use common::{Image, Lesson, Method};
use gouraud::flags::SceneFlags;
use perspective::flags::CameraFlags;
use perspective::scene::Loaded;
use perspective::{DEPTHS, FLOOR, Interpolate, Keep, view};
use shaders::Uniforms;

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("1.1,0.1,3.4")))]
#[command(mut_arg("center", |arg| arg.default_value("0,-0.1,0")))]
#[command(mut_arg("light", |arg| arg.default_value("0.3,0.7,0.7")))]
struct Flags {
    #[command(flatten)]
    scene: SceneFlags,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    camera: CameraFlags,

    /// What the depth buffer keeps: z24, z-f32, reversed-z-f32, logarithmic or w
    #[arg(long, value_name = "NAME", default_value = "z-f32")]
    projection: String,
}

/// A head on a floor, or a model alone.
struct Perspective {
    models: Vec<Loaded>,
    keep: &'static Keep,
    flags: Flags,
}

impl Program for Perspective {
    type Flags = Flags;
    type Method = Interpolate;

    const LESSON: Lesson = perspective::LESSON;
    const METHODS: &[Method<Interpolate>] = perspective::METHODS;
    const DEFAULT: &str = "per-pixel";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let keep = find(&flags)?;
        // Refused before a file is read.
        flags.camera.projection(1.0)?;
        let models = Loaded::read(&flags.scene, flags.view.origin(), FLOOR)?;
        Ok(Self { models, keep, flags })
    }

    fn draw(&mut self, method: &Interpolate, picture: &mut Image) -> anyhow::Result<Extras> {
        let flags = &self.flags;
        let size = picture.size();
        let to_clip = flags.camera.projection(size.x / size.y)? * flags.view.look(view)?;
        let light = flags.scene.light.direction;
        let models: Vec<Uniforms> =
            self.models.iter().map(|loaded| loaded.uniforms(light, to_clip)).collect();
        let drawn = (method.draw)(self.keep)(&models, flags.camera.planes(), picture);
        Ok(Extras { depth: flags.scene.depth.picture(|| drawn.picture()), left_out: drawn.left_out })
    }
}

/// The way to keep depths that is asked for.
fn find(flags: &Flags) -> Result<&'static Keep, UsageError> {
    let name = &flags.projection;
    let keep = named(DEPTHS, "projection", name)?;
    if keep.needs_far && flags.camera.far.is_infinite() {
        return Err(UsageError(format!("--projection {name}: it needs a finite --far")));
    }
    Ok(keep)
}

fn main() -> ExitCode {
    run::<Perspective>()
}
