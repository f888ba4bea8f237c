//! Draws lesson 3's pictures: `cargo run -p triangles`, and with `-- --model` the model.

use std::process::ExitCode;

use common::program::{Fill, Lesson, TriangleFlag, run};
use common::{Attributes, Color, Vec2};
use triangles::{draw_model, flat_intensity};

/// The slides' three triangles.
const TRIANGLES: [TriangleFlag; 3] = [
    TriangleFlag {
        corners: [Vec2::new(10.0, 70.0), Vec2::new(50.0, 160.0), Vec2::new(70.0, 80.0)],
        color: Color::RED,
    },
    TriangleFlag {
        corners: [Vec2::new(180.0, 50.0), Vec2::new(150.0, 1.0), Vec2::new(70.0, 180.0)],
        color: Color::WHITE,
    },
    TriangleFlag {
        corners: [Vec2::new(180.0, 150.0), Vec2::new(120.0, 160.0), Vec2::new(130.0, 180.0)],
        color: Color::GREEN,
    },
];

fn main() -> ExitCode {
    run(&Lesson {
        name: "03-triangles",
        about: "Lesson 3: the pixels that a triangle covers.",
        methods: triangles::METHODS,
        default: "edges",
        flags: &["triangle", "model", "fill", "light"],
        draw: |flags, method| {
            if flags.model.is_none() {
                let mut image = flags.canvas(200, 200);
                let triangles =
                    if flags.triangle.is_empty() { TRIANGLES.as_slice() } else { &flags.triangle };
                for &TriangleFlag { corners, color } in triangles {
                    (method.draw)(corners, &mut image, color);
                }
                return Ok(image.into());
            }
            let model = flags.read_model(Attributes::default())?;
            let mut image = flags.canvas(800, 800);
            match flags.fill {
                Fill::Random => draw_model(&model, method, &mut image, |n, _| Some(Color::random(n as u64))),
                Fill::Flat => draw_model(&model, method, &mut image, |_, corners| {
                    let intensity = flat_intensity(corners, flags.light);
                    (intensity >= 0.0).then(|| Color::gray(intensity))
                }),
            }
            Ok(image.into())
        },
        turntable: None,
    })
}
