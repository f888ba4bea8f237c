//! Draws lesson 2's picture: `cargo run -p wireframe`.

use std::process::ExitCode;

use common::program::{Lesson, run};
use common::{Attributes, Color};

fn main() -> ExitCode {
    run(&Lesson {
        name: "02-wireframe",
        about: "Lesson 2: a model's edges.",
        methods: wireframe::METHODS,
        default: "unique-edges",
        flags: &["model"],
        draw: |flags, method| {
            let model = flags.read_model(Attributes::default())?;
            let mut image = flags.canvas(800, 800);
            (method.draw)(&model, &mut image, Color::WHITE);
            Ok(image.into())
        },
        turntable: None,
    })
}
