//! Draws lesson 4's picture: `cargo run -p zbuffer`.

use std::process::ExitCode;

use common::Attributes;
use common::program::{Drawing, Lesson, UsageError, run};
use zbuffer::surfaces;

fn main() -> ExitCode {
    run(&Lesson {
        name: "04-zbuffer",
        about: "Lesson 4: the nearest surface.",
        methods: zbuffer::METHODS,
        default: "z-f32",
        flags: &["model", "light", "depth"],
        draw: |flags, method| {
            let model = flags.read_model(Attributes::default())?;
            let mut picture = flags.canvas(800, 800);
            let surfaces = surfaces(&model, flags.light, &picture);
            let depth = match flags.depth {
                Some(_) => {
                    let message = "--depth: painter keeps no depths; use --method z-f32";
                    let draw = method.depth.ok_or_else(|| UsageError(message.into()))?;
                    Some(draw(&surfaces, &picture))
                }
                None => None,
            };
            (method.draw)(&surfaces, &mut picture);
            Ok(Drawing { picture, depth })
        },
        turntable: None,
    })
}
