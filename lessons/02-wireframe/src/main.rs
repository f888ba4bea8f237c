//! Draws lesson 2's picture: `cargo run -p wireframe`.

use std::process::ExitCode;

use common::program::model::ModelFlag;
use common::program::{Extras, Program, run};
use common::{Attributes, Color, Image, Lesson, Method, Model};
use wireframe::Wireframe;

struct Edges {
    model: Model,
}

impl Program for Edges {
    type Flags = ModelFlag;
    type Method = Wireframe;

    const LESSON: Lesson = wireframe::LESSON;
    const METHODS: &[Method<Wireframe>] = wireframe::METHODS;
    const DEFAULT: &str = "unique-edges";

    fn load(flags: ModelFlag) -> anyhow::Result<Self> {
        Ok(Self { model: flags.read_lines(Attributes::default())? })
    }

    fn draw(&mut self, method: &Wireframe, picture: &mut Image) -> anyhow::Result<Extras> {
        (method.draw)(&self.model, picture, Color::WHITE);
        Ok(Extras::default())
    }
}

fn main() -> ExitCode {
    run::<Edges>()
}
