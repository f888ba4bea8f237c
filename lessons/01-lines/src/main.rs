//! Draws lesson 1's picture: `cargo run -p lines`.

use std::process::ExitCode;

use common::program::{Extras, Program, run, values};
use common::{Color, IVec2, Image, Lesson, Method};
use lines::Line;

/// A straight line, as `--line` gives it.
#[derive(Clone)]
struct Segment {
    /// The two ends, in whole pixels.
    ends: [IVec2; 2],
    color: Color,
}

/// The slides' two lines.
const SEGMENTS: [Segment; 2] = [
    Segment { ends: [IVec2::new(13, 20), IVec2::new(80, 40)], color: Color::WHITE },
    Segment { ends: [IVec2::new(20, 13), IVec2::new(40, 80)], color: Color::RED },
];

#[derive(clap::Args)]
struct Flags {
    /// A line instead of the lesson's two, in whole pixels; may be repeated
    #[arg(long, value_name = "x0,y0,x1,y1[,rrggbb]", value_parser = segment, allow_hyphen_values = true)]
    line: Vec<Segment>,
}

fn segment(text: &str) -> Result<Segment, String> {
    let ([x0, y0, x1, y1], color) = values::numbers_and_color(text)?;
    Ok(Segment { ends: [IVec2::new(x0, y0), IVec2::new(x1, y1)], color: color.unwrap_or(Color::WHITE) })
}

struct Lines {
    segments: Vec<Segment>,
}

impl Program for Lines {
    type Flags = Flags;
    type Method = Line;

    const LESSON: Lesson = lines::LESSON;
    const METHODS: &[Method<Line>] = lines::METHODS;
    const DEFAULT: &str = "bresenham";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        Ok(Self { segments: if flags.line.is_empty() { SEGMENTS.to_vec() } else { flags.line } })
    }

    fn size(&self) -> (u16, u16) {
        (100, 100)
    }

    fn draw(&mut self, method: &Line, picture: &mut Image) -> anyhow::Result<Extras> {
        for &Segment { ends: [a, b], color } in &self.segments {
            (method.draw)(a, b, picture, color);
        }
        Ok(Extras::default())
    }
}

fn main() -> ExitCode {
    run::<Lines>()
}
