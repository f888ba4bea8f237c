//! Draws lesson 13's picture: `cargo run --release -p filtering`.

use std::process::ExitCode;

use camera::flags::{TurntableFlag, ViewFlags};
use clipping::flags::CullFlag;
use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Output, Program, named, run};
use common::{Image, Lesson, Method};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Sampler, Surface, WRAPS};
use perspective::flags::CameraFlags;
use perspective::view;

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("2,0.2,3.3")))]
#[command(mut_arg("center", |arg| arg.default_value("0.3,-0.35,0")))]
#[command(mut_arg("light", |arg| arg.default_value("0.4,0.8,0.8")))]
struct Flags {
    #[command(flatten)]
    model: TexturedModelFlags,

    /// Where (u, v) leave 0 to 1: show the texture's border, the texture again, or its mirror image
    #[arg(long, value_name = "clamp|repeat|mirror", default_value = "repeat")]
    wrap: String,

    /// How smaller levels of a texture are made: box-encoded, box-linear or lanczos-linear
    #[arg(long, value_name = "NAME", default_value = "box-linear")]
    mipmaps: String,

    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    depth: DepthFlag,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    turntable: TurntableFlag,
    #[command(flatten)]
    camera: CameraFlags,
    #[command(flatten)]
    cull: CullFlag,
}

/// A head on a floor, or a model alone.
struct Scene {
    models: Vec<Filterable>,
    flags: Flags,
}

impl Program for Scene {
    type Flags = Flags;
    type Method = Sampler;

    const LESSON: Lesson = filtering::LESSON;
    const METHODS: &[Method<Sampler>] = filtering::METHODS;
    const DEFAULT: &str = "trilinear";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        // Refused before a file is read.
        flags.camera.projection(1.0)?;
        let (wrap, mipmap) = (named(WRAPS, "wrap", &flags.wrap)?, named(MIPMAPS, "mipmaps", &flags.mipmaps)?);
        let models = Filterable::read(&flags.model, flags.view.origin(), *mipmap, *wrap)?;
        Ok(Self { models, flags })
    }

    fn draw(&mut self, method: &Sampler, picture: &mut Image) -> anyhow::Result<Extras> {
        let flags = &self.flags;
        let size = picture.size();
        let to_clip = flags.camera.projection(size.x / size.y)? * flags.view.look(view)?;
        let light = flags.light.direction;
        let surfaces: Vec<Surface> = self.models.iter().map(|model| model.surface(light, to_clip)).collect();
        let drawn = (method.draw)(&surfaces, flags.cull.which, picture);
        let depth = flags.depth.picture(|| drawn.depths.picture_by(|depth| -f64::from(depth)));
        Ok(Extras { depth, left_out: drawn.counts.left_out })
    }

    fn show(&mut self, method: &Sampler, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.flags.turntable.stops else { return output.one(self, method) };
        let from = self.flags.view;
        output.series(self, method, stops, |scene, n| scene.flags.view = from.turned(n, stops))
    }
}

fn main() -> ExitCode {
    run::<Scene>()
}
