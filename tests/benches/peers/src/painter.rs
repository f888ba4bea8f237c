//! A program that draws one scene as often as it is told, and says how long it took.
//!
//! It first says what it is, in a line. Then it is given lines, and answers each with the nanoseconds that it took to
//! clear and draw a picture:
//!
//! | line | what it does besides |
//! |---|---|
//! | `draw METHOD` | nothing |
//! | `picture METHOD FILE` | writes the picture, three bytes a pixel, rows from the bottom |
//!
//! A renderer that has one method takes any for it.

use std::io::{BufRead, Write};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use speed_scenes::Scene;
use speed_scenes::methods::METHODS;

/// Something that clears a picture and draws on it by a method.
pub(crate) trait Painter {
    /// What is timed.
    fn draw(&mut self, method: &str) -> anyhow::Result<()>;
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
        let taken = timed(|| painter.draw(method))?;
        if let Some(file) = file {
            std::fs::write(file, painter.picture()).with_context(|| file.to_string())?;
        }
        writeln!(answers, "{}", taken.as_nanos())?;
    }
    Ok(())
}

fn timed(run: impl FnOnce() -> anyhow::Result<()>) -> anyhow::Result<Duration> {
    let start = Instant::now();
    run()?;
    Ok(start.elapsed())
}

/// The course's methods, on so many threads.
pub(crate) struct Ours {
    scene: Scene,
    threads: usize,
    image: common::Image,
}

impl Ours {
    pub(crate) fn new(scene: Scene, threads: usize) -> Self {
        Self { image: scene.canvas(), scene, threads }
    }
}

impl Painter for Ours {
    fn draw(&mut self, method: &str) -> anyhow::Result<()> {
        let row = METHODS.iter().find(|row| row.name == method);
        let row = row.with_context(|| format!("there is no method `{method}`"))?;
        self.image.buffer_mut().fill(0);
        let [nearest, ..] = row.draw;
        nearest(&self.scene.surface(), self.threads, &mut self.image);
        Ok(())
    }

    fn picture(&self) -> Vec<u8> {
        self.image.buffer().to_vec()
    }
}
