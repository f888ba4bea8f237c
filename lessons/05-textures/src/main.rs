//! Draws lesson 5's picture: `cargo run -p textures`.

use std::process::ExitCode;

use common::Attributes;
use common::program::{Drawing, Lesson, run};

fn main() -> ExitCode {
    run(&Lesson {
        name: "05-textures",
        about: "Lesson 5: colour from a picture.",
        methods: textures::METHODS,
        default: "nearest",
        flags: &["model", "light", "depth", "texture"],
        draw: |flags, method| {
            let model = flags.read_model(Attributes { uvs: true, normals: false })?;
            let texture = flags.read_texture()?;
            let mut picture = flags.canvas(800, 800);
            let depths = (method.draw)(&model, &texture, flags.light, &mut picture);
            Ok(Drawing { picture, depth: flags.depth.as_ref().map(|_| depths.picture()) })
        },
        turntable: None,
    })
}
