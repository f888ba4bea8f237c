//! The lessons' pictures, drawn by the lessons' programs and brought to one size.

use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use common::Image;

use crate::cargo::cargo;
use charts::lessons::{LESSONS, Lesson};

/// The book's own folder.
const BOOK: &str = env!("CARGO_MANIFEST_DIR");

/// Width of the pictures, in pixels; most are as high.
const SIZE: u16 = 400;

/// Every picture: its lesson, its file, and the flags that draw it.
fn all() -> impl Iterator<Item = (&'static Lesson, PathBuf, &'static [&'static str])> {
    LESSONS.iter().flat_map(|lesson| {
        let more = lesson.more_pictures.iter().map(|picture| (picture.name, picture.flags));
        let file = |name: &str| Path::new(BOOK).join(lesson.folder()).join(name).with_extension("png");
        std::iter::once(("picture", [].as_slice()))
            .chain(more)
            .map(move |(name, flags)| (lesson, file(name), flags))
    })
}

/// Draws every picture, into the lessons' folders of the book.
pub(crate) fn draw_all() -> anyhow::Result<()> {
    for (lesson, file, flags) in all() {
        draw(lesson.lesson.name, flags)?.write(&file)?;
        println!("{}", file.display());
    }
    Ok(())
}

/// The picture that a lesson's program draws, made larger or smaller.
fn draw(lesson: &str, flags: &[&str]) -> anyhow::Result<Image> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("picture.png");
    let run = ["run", "--quiet", "--package", lesson, "--", "--quiet", "--out"];
    let output = cargo()
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(run)
        .arg(&path)
        .args(flags)
        .output()
        .context("cannot start cargo")?;
    ensure!(output.status.success(), "{lesson}: {}", String::from_utf8_lossy(&output.stderr).trim());
    let drawn = Image::read(&path)?;
    let height = i32::from(SIZE) * drawn.height() / drawn.width().max(1);
    Ok(drawn.scale(SIZE, height as u16))
}

#[cfg(test)]
mod tests {
    use checks::picture::faults;

    use super::*;

    /// From lesson 7 on sines and fused multiplications differ between platforms by a rounding, which may give
    /// a pixel at a side to its neighbour: one in 2,000 may differ.
    #[test]
    fn the_committed_pictures_are_what_the_lessons_draw() {
        for (lesson, file, flags) in all() {
            let allowed =
                if lesson.lesson.number < 7 { 0 } else { usize::from(SIZE) * usize::from(SIZE) / 2000 };
            let out_of_date = match Image::read(&file) {
                Ok(picture) => faults(&picture, &draw(lesson.lesson.name, flags).unwrap(), 1).len() > allowed,
                Err(_) => true,
            };
            let name = file.display();
            assert!(!out_of_date, "{name} is out of date: run cargo run -p book -- pictures, and look at it");
        }
    }
}
