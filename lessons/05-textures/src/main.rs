//! Draws lesson 5's picture: `cargo run -p textures`.

use std::process::ExitCode;

use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Program, run};
use common::{Attributes, Image, Lesson, Method, Model};
use textures::{Sampler, Wrap, draw_textured};

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    model: TexturedModelFlags,

    /// Where (u, v) leave 0 to 1: show the texture's border, or the texture again; as --method nearest and repeat do
    #[arg(long, value_name = "clamp|repeat", value_enum, hide_possible_values = true, conflicts_with_all = ["method", "compare"])]
    wrap: Option<Wrap>,

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
        let Self { model, texture, flags } = self;
        let light = flags.light.direction;
        let depths = match flags.wrap {
            None => (method.draw)(model, texture, light, picture),
            Some(wrap) => draw_textured(model, light, picture, |uv| wrap.texel(texture, uv)),
        };
        Ok(Extras { depth: flags.depth.picture(|| depths.picture()), ..Extras::default() })
    }
}

fn main() -> ExitCode {
    run::<Textures>()
}
