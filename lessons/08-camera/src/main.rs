//! Draws lesson 8's picture: `cargo run -p camera`.

use std::process::ExitCode;

use camera::View;
use camera::flags::{TurntableFlag, ViewFlags};
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
    type Method = View;

    const LESSON: Lesson = camera::LESSON;
    const METHODS: &[Method<View>] = camera::METHODS;
    const DEFAULT: &str = "lookat";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let (model, texture) = flags.model.read(Attributes { normals: true, uvs: true })?;
        Ok(Self { normals: corner_normals(&model), model, texture, flags })
    }

    fn draw(&mut self, view: &View, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        let flags = &self.flags;
        let all =
            viewport(size.x, size.y, 0.5) * projection(flags.view.distance()) * flags.view.matrix(*view)?;
        let scene = Scene {
            model: &self.model,
            normals: self.normals.clone(),
            texture: &self.texture,
            light: flags.light.direction,
        };
        let drawn = gouraud(&scene, picture, |point| place(&all, point));
        let depth = flags.depth.picture(|| drawn.depths.picture());
        Ok(Extras { depth, left_out: drawn.left_out })
    }

    fn show(&mut self, view: &View, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.flags.turntable.stops else { return output.one(self, view) };
        let from = self.flags.view;
        output.series(self, view, stops, |camera, n| camera.flags.view = from.turned(n, stops))
    }
}

fn main() -> ExitCode {
    run::<Camera>()
}
