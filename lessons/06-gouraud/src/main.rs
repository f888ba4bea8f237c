//! Draws lesson 6's picture: `cargo run -p gouraud`.

use std::process::ExitCode;

use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Program, run};
use common::{Attributes, Image, Lesson, Method, Model, Vec3};
use gouraud::{Draw, Scene, corner_normals};

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    model: TexturedModelFlags,
    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    depth: DepthFlag,
}

struct Gouraud {
    model: Model,
    normals: Vec<[Vec3; 3]>,
    texture: Image,
    flags: Flags,
}

impl Program for Gouraud {
    type Flags = Flags;
    type Method = Draw;

    const LESSON: Lesson = gouraud::LESSON;
    const METHODS: &[Method<Draw>] = gouraud::METHODS;
    const DEFAULT: &str = "gouraud";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let (model, texture) = flags.model.read(Attributes { normals: true, uvs: true })?;
        Ok(Self { normals: corner_normals(&model), model, texture, flags })
    }

    fn draw(&mut self, method: &Draw, picture: &mut Image) -> anyhow::Result<Extras> {
        let scene = Scene {
            model: &self.model,
            normals: self.normals.clone(),
            texture: &self.texture,
            light: self.flags.light.direction,
        };
        let drawn = method(&scene, picture);
        let depth = self.flags.depth.picture(|| drawn.depths.picture());
        Ok(Extras { depth, left_out: drawn.left_out })
    }
}

fn main() -> ExitCode {
    run::<Gouraud>()
}
