//! Draws lesson 4's picture: `cargo run -p zbuffer`.

use std::process::ExitCode;

use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::ModelFlag;
use common::program::{Extras, Program, UsageError, run};
use common::{Attributes, Image, Lesson, Method, Model};
use zbuffer::{Visibility, surfaces};

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    model: ModelFlag,
    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    depth: DepthFlag,
}

struct Zbuffer {
    model: Model,
    flags: Flags,
}

impl Program for Zbuffer {
    type Flags = Flags;
    type Method = Visibility;

    const LESSON: Lesson = zbuffer::LESSON;
    const METHODS: &[Method<Visibility>] = zbuffer::METHODS;
    const DEFAULT: &str = "z-f32";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        Ok(Self { model: flags.model.read(Attributes::default())?, flags })
    }

    fn draw(&mut self, method: &Visibility, picture: &mut Image) -> anyhow::Result<Extras> {
        let surfaces = surfaces(&self.model, self.flags.light.direction, picture);
        let none = "--depth: painter keeps no depths; use --method z-f32";
        let depth = match (&self.flags.depth.file, method.depth) {
            (Some(_), None) => return Err(UsageError(none.into()).into()),
            (Some(_), Some(draw)) => self.flags.depth.picture(|| draw(&surfaces, picture)),
            (None, _) => None,
        };
        (method.draw)(&surfaces, picture);
        Ok(Extras { depth, ..Extras::default() })
    }
}

fn main() -> ExitCode {
    run::<Zbuffer>()
}
