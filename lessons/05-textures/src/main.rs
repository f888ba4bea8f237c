//! Draws lesson 5's picture: `cargo run -p textures`.

use std::process::ExitCode;

use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Program, run};
use common::{Attributes, Image, Lesson, Method, Model};
use textures::Sampler;

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    model: TexturedModelFlags,
    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    depth: DepthFlag,
}

struct Textures {
    model: Model,
    texture: Image,
    flags: Flags,
}

impl Program for Textures {
    type Flags = Flags;
    type Method = Sampler;

    const LESSON: Lesson = textures::LESSON;
    const METHODS: &[Method<Sampler>] = textures::METHODS;
    const DEFAULT: &str = "nearest";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let (model, texture) = flags.model.read(Attributes::default())?;
        Ok(Self { model, texture, flags })
    }

    fn draw(&mut self, method: &Sampler, picture: &mut Image) -> anyhow::Result<Extras> {
        let depths = (method.draw)(&self.model, &self.texture, self.flags.light.direction, picture);
        Ok(Extras { depth: self.flags.depth.picture(|| depths.picture()), ..Extras::default() })
    }
}

fn main() -> ExitCode {
    run::<Textures>()
}
