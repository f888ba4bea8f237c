//! Draws lesson 1's picture: `cargo run -p lines`.

use std::process::ExitCode;

use common::program::{Lesson, LineFlag, run};
use common::{Color, IVec2};

/// The slides' two lines.
const LINES: [LineFlag; 2] = [
    LineFlag { ends: [IVec2::new(13, 20), IVec2::new(80, 40)], color: Color::WHITE },
    LineFlag { ends: [IVec2::new(20, 13), IVec2::new(40, 80)], color: Color::RED },
];

fn main() -> ExitCode {
    run(&Lesson {
        name: "01-lines",
        about: "Lesson 1: the pixels of a line segment.",
        methods: lines::METHODS,
        default: "bresenham",
        flags: &["line"],
        draw: |flags, method| {
            let mut image = flags.canvas(100, 100);
            let lines = if flags.line.is_empty() { LINES.as_slice() } else { &flags.line };
            for &LineFlag { ends: [a, b], color } in lines {
                (method.draw)(a, b, &mut image, color);
            }
            Ok(image.into())
        },
        turntable: None,
    })
}
