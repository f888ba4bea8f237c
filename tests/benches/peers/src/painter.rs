//! A program that draws one scene as often as it is told, and says how long it took.
//!
//! It first says what it is, in a line. Then it is given lines, and answers each with the nanoseconds that it took to
//! clear and draw a picture, by the clock on the wall, and with those for which it had processors:
//!
//! | line | what it does besides |
//! |---|---|
//! | `draw METHOD` | nothing |
//! | `picture METHOD FILE` | writes the picture, three bytes a pixel, rows from the bottom |
//!
//! A renderer that has one method takes any for it.

use std::io::{BufRead, Write};

use anyhow::{Context, bail};
use common::{Color, Image};
use speed_scenes::Scene;
use speed_scenes::clock::Clock;
use speed_scenes::methods::{Drawer, drawer};

/// Something that clears a picture and draws on it by a method.
pub(crate) trait Painter {
    /// Makes ready to draw by a method; it is not timed.
    fn ready(&mut self, method: &str);
    /// What is timed.
    fn draw(&mut self, method: &str);
    /// The picture, three bytes a pixel, rows from the bottom.
    fn picture(&self) -> Vec<u8>;
}

/// Answers lines until there are no more.
pub(crate) fn serve(
    name: &str,
    mut painter: impl Painter,
    lines: impl BufRead,
    mut answers: impl Write,
) -> anyhow::Result<()> {
    writeln!(answers, "{name}")?;
    for line in lines.lines() {
        let line = line?;
        let (method, file) = match line.splitn(3, ' ').collect::<Vec<_>>()[..] {
            ["draw", method] => (method, None),
            ["picture", method, file] => (method, Some(file)),
            _ => bail!("`{line}` means nothing"),
        };
        painter.ready(method);
        let (((), processor), wall) = Clock::Wall.time(|| Clock::Processor.time(|| painter.draw(method)));
        if let Some(file) = file {
            std::fs::write(file, painter.picture()).with_context(|| file.to_string())?;
        }
        writeln!(answers, "{} {}", wall.as_nanos(), processor.as_nanos())?;
    }
    Ok(())
}

/// The course's methods, on so many threads.
pub(crate) struct Ours {
    scene: Scene,
    threads: usize,
    image: Image,
    /// Those that were asked for, with their names.
    drawers: Vec<(String, Drawer)>,
}

impl Ours {
    pub(crate) fn new(scene: Scene, threads: usize) -> Self {
        Self { image: scene.canvas(), scene, threads, drawers: Vec::new() }
    }
}

impl Painter for Ours {
    fn ready(&mut self, method: &str) {
        if !self.drawers.iter().any(|(name, _)| name == method) {
            let drawer = drawer(method, "nearest", self.threads, self.scene.size);
            self.drawers.push((method.into(), drawer));
        }
    }

    fn draw(&mut self, method: &str) {
        let drawer = self.drawers.iter_mut().find(|(name, _)| name == method);
        drawer.expect("it is ready").1(&self.scene.surface(), &mut self.image);
    }

    fn picture(&self) -> Vec<u8> {
        self.image.pixels().flat_map(|(_, _, Color { r, g, b, .. })| [r, g, b]).collect()
    }
}
