//! Draws lesson 6's picture: `cargo run -p gouraud`.

use std::process::ExitCode;

use common::program::{Extras, Program, run};
use common::{DVec3, Image, Lesson, Method};
use gouraud::Draw;
use gouraud::flags::{LoadedScene, SceneFlags};

struct Gouraud {
    loaded: LoadedScene,
}

impl Program for Gouraud {
    type Flags = SceneFlags;
    type Method = Draw;

    const LESSON: Lesson = gouraud::LESSON;
    const METHODS: &[Method<Draw>] = gouraud::METHODS;
    const DEFAULT: &str = "gouraud";

    fn load(flags: SceneFlags) -> anyhow::Result<Self> {
        Ok(Self { loaded: LoadedScene::read(flags, DVec3::ZERO)? })
    }

    fn draw(&mut self, method: &Draw, picture: &mut Image) -> anyhow::Result<Extras> {
        let drawn = method(&self.loaded.scene(), picture);
        Ok(self.loaded.extras(&drawn))
    }
}

fn main() -> ExitCode {
    run::<Gouraud>()
}
