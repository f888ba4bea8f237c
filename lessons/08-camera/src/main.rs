//! Draws lesson 8's picture: `cargo run -p camera`.

use std::process::ExitCode;

use camera::flags::{TurntableFlag, ViewFlags};
use camera::{Look, View};
use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Output, Program, run};
use common::{Attributes, Image, Lesson, Method, Model, Vec3};
use gouraud::{Scene, corner_normals, gouraud};
use transforms::{place, projection, viewport};

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    model: TexturedModelFlags,
    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    depth: DepthFlag,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    turntable: TurntableFlag,
}

struct Camera {
    model: Model,
    normals: Vec<[Vec3; 3]>,
    texture: Image,
    flags: Flags,
}

impl Program for Camera {
    type Flags = Flags;
    type Method = Look;

    const LESSON: Lesson = camera::LESSON;
    const METHODS: &[Method<Look>] = camera::METHODS;
    const DEFAULT: &str = "lookat";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let (model, texture) =
            flags.model.read_about(flags.view.origin(), Attributes { normals: true, uvs: true })?;
        Ok(Self { normals: corner_normals(&model), model, texture, flags })
    }

    fn draw(&mut self, look: &Look, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        let flags = &self.flags;
        let View { origin, matrix } = flags.view.look(*look)?;
        let all = viewport(size.x, size.y, 0.5) * projection(flags.view.distance()) * matrix;
        let scene = Scene {
            model: &self.model,
            normals: self.normals.clone(),
            texture: &self.texture,
            light: flags.light.direction,
        };
        let drawn = gouraud(&scene, picture, |point| place(&all, point - origin));
        let depth = flags.depth.picture(|| drawn.depths.picture());
        Ok(Extras { depth, left_out: drawn.left_out })
    }

    fn show(&mut self, look: &Look, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.flags.turntable.stops else { return output.one(self, look) };
        let from = self.flags.view;
        output.series(self, look, stops, |camera, n| camera.flags.view = from.turned(n, stops))
    }
}

fn main() -> ExitCode {
    run::<Camera>()
}
