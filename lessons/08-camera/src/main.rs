//! Draws lesson 8's picture: `cargo run -p camera`.

use std::process::ExitCode;

use camera::View;
use camera::flags::{TurntableFlag, ViewFlags};
use common::program::{Extras, Output, Program, run};
use common::{Image, Lesson, Method};
use gouraud::flags::{LoadedScene, SceneFlags};
use gouraud::gouraud;
use transforms::{place, projection, viewport};

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    scene: SceneFlags,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    turntable: TurntableFlag,
}

struct Camera {
    loaded: LoadedScene,
    view: ViewFlags,
    stops: Option<u16>,
}

impl Program for Camera {
    type Flags = Flags;
    type Method = View;

    const LESSON: Lesson = camera::LESSON;
    const METHODS: &[Method<View>] = camera::METHODS;
    const DEFAULT: &str = "lookat";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let loaded = LoadedScene::read(flags.scene, flags.view.origin())?;
        Ok(Self { loaded, view: flags.view, stops: flags.turntable.stops })
    }

    fn draw(&mut self, view: &View, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        let all =
            viewport(size.x, size.y, 0.5) * projection(self.view.distance()) * self.view.matrix(*view)?;
        let drawn = gouraud(&self.loaded.scene(), picture, |point| place(&all, point));
        Ok(self.loaded.extras(&drawn))
    }

    fn show(&mut self, view: &View, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.stops else { return output.one(self, view) };
        let from = self.view;
        output.series(self, view, stops, |camera, n| camera.view = from.turned(n, stops))
    }
}

fn main() -> ExitCode {
    run::<Camera>()
}
