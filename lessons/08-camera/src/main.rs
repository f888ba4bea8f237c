//! Draws lesson 8's picture: `cargo run -p camera`.

use std::process::ExitCode;

use camera::flags::{TurntableFlag, ViewFlags};
use camera::{Look, View};
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
    type Method = Look;

    const LESSON: Lesson = camera::LESSON;
    const METHODS: &[Method<Look>] = camera::METHODS;
    const DEFAULT: &str = "lookat";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let loaded = LoadedScene::read(flags.scene, flags.view.origin())?;
        Ok(Self { loaded, view: flags.view, stops: flags.turntable.stops })
    }

    fn draw(&mut self, look: &Look, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        let View { origin, matrix } = self.view.look(*look)?;
        let all = viewport(size.x, size.y, 0.5) * projection(self.view.distance()) * matrix;
        let drawn = gouraud(&self.loaded.scene(), picture, |point| place(&all, point - origin));
        Ok(self.loaded.extras(&drawn))
    }

    fn show(&mut self, look: &Look, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.stops else { return output.one(self, look) };
        let from = self.view;
        output.series(self, look, stops, |camera, n| camera.view = from.turned(n, stops))
    }
}

fn main() -> ExitCode {
    run::<Camera>()
}
