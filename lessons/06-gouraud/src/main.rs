//! Draws lesson 6's picture: `cargo run -p gouraud`.

use std::process::ExitCode;

use common::Attributes;
use common::program::{Drawing, Lesson, run};
use gouraud::{Scene, corner_normals};

fn main() -> ExitCode {
    run(&Lesson {
        name: "06-gouraud",
        about: "Lesson 6: smooth shading.",
        methods: gouraud::METHODS,
        default: "gouraud",
        flags: &["model", "light", "depth", "texture"],
        draw: |flags, method| {
            let model = flags.read_model(Attributes { uvs: true, normals: true })?;
            let texture = flags.read_texture()?;
            let scene = Scene {
                model: &model,
                normals: corner_normals(&model),
                texture: &texture,
                light: flags.light,
            };
            let mut picture = flags.canvas(800, 800);
            let drawn = method(&scene, &mut picture);
            Ok(Drawing { picture, depth: flags.depth.as_ref().map(|_| drawn.depths.picture()) })
        },
        turntable: None,
    })
}
