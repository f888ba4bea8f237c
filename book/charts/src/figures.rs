//! The book's figures: drawn anew whenever the book is built, by the course's own code.
//!
//! A figure is a row of a table `FIGURES` in the file beside its chapter: a name, what a reader who cannot see it
//! is told, and the function that draws it. A page shows it with `{{figure name}}`.

pub(crate) mod picture;
pub(crate) mod shape;

use std::collections::BTreeMap;
use std::num::NonZero;
use std::panic::Location;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use anyhow::Context;
use common::Image;

use crate::lessons::LESSONS;
use crate::pages;
pub use ::sheet;
use sheet::Sheet;

/// Every figure of the book.
fn all() -> impl Iterator<Item = &'static Figure> {
    let of_lessons = LESSONS.iter().map(|lesson| lesson.figures);
    of_lessons.chain([pages::front::FIGURES, pages::wrong::FIGURES]).flatten()
}

/// One figure.
pub struct Figure {
    /// Of its file, without ending.
    pub name: &'static str,
    /// What it shows, for those who do not see it.
    pub alt: &'static str,
    /// Draws it.
    pub draw: fn() -> anyhow::Result<Drawing>,
    /// Its row, for a message about it.
    pub row: &'static Location<'static>,
}

impl Figure {
    /// A row of a table of figures.
    #[must_use]
    #[track_caller]
    pub const fn new(name: &'static str, alt: &'static str, draw: fn() -> anyhow::Result<Drawing>) -> Self {
        Self { name, alt, draw, row: Location::caller() }
    }
}

/// A figure and what it draws.
pub struct Drawn {
    /// The figure.
    pub figure: &'static Figure,
    /// What it draws.
    pub drawing: Drawing,
}

impl Drawn {
    /// The name of its file.
    #[must_use]
    pub fn file(&self) -> String {
        format!("{}.{}", self.figure.name, self.drawing.ending())
    }
}

/// Draws all figures, on all of the machine's cores.
///
/// # Errors
/// Where one cannot be drawn.
pub fn draw() -> anyhow::Result<Vec<Drawn>> {
    let figures: Vec<&Figure> = all().collect();
    let next = AtomicUsize::new(0);
    let drawn: Mutex<BTreeMap<usize, anyhow::Result<Drawn>>> = Mutex::default();
    let work = || {
        loop {
            let n = next.fetch_add(1, Ordering::Relaxed);
            let Some(figure) = figures.get(n) else { return };
            let drawing = (figure.draw)().with_context(|| format!("the figure {}", figure.name));
            let one = drawing.map(|drawing| Drawn { figure, drawing });
            drawn.lock().unwrap_or_else(PoisonError::into_inner).insert(n, one);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, NonZero::get) {
            scope.spawn(work);
        }
    });
    drawn.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().collect()
}

/// Writes figures into a folder, which is made if need be.
///
/// # Errors
/// Where a file cannot be written.
pub fn write(figures: &[Drawn], folder: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    figures.iter().try_for_each(|drawn| drawn.drawing.write(&folder.join(drawn.file())))
}

/// What was drawn.
pub enum Drawing {
    /// Lines and letters.
    Svg(Sheet),
    /// Pixels, each to be shown as so many by so many.
    Pixels(Image, u16),
}

impl From<Sheet> for Drawing {
    fn from(sheet: Sheet) -> Self {
        Self::Svg(sheet)
    }
}

impl Drawing {
    /// The ending of its file's name.
    fn ending(&self) -> &'static str {
        match self {
            Self::Svg(_) => "svg",
            Self::Pixels(..) => "png",
        }
    }

    /// Width and height at which a page shows it.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        match self {
            Self::Svg(sheet) => sheet.size(),
            Self::Pixels(image, factor) => {
                let side = |pixels: i32| pixels.unsigned_abs() * u32::from(*factor);
                (side(image.width()), side(image.height()))
            }
        }
    }

    /// Writes it.
    ///
    /// # Errors
    /// Where the file cannot be written.
    fn write(&self, path: &Path) -> anyhow::Result<()> {
        match self {
            Self::Svg(sheet) => common::file::write_whole(path, sheet.to_string().as_bytes())?,
            Self::Pixels(image, factor) => {
                let side = |pixels: i32| pixels as u16 * factor;
                image.scale(side(image.width()), side(image.height())).write(path)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A colour of a sheet that has no shade for a dark page.
    fn without_dark_shade(sheet: &Sheet) -> Option<String> {
        let svg = sheet.inline();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let colors = document
            .descendants()
            .flat_map(|node| ["fill", "stroke"].into_iter().filter_map(move |name| node.attribute(name)));
        let mut rest = colors.filter(|color| *color != "none" && !sheet::has_dark_shade(color));
        rest.next().map(String::from)
    }

    #[test]
    fn every_figure_can_be_drawn_and_told() {
        let mut names = std::collections::BTreeSet::new();
        for figure in all() {
            assert!(names.insert(figure.name), "{}: two figures have this name", figure.name);
            assert!(figure.alt.len() > 20, "{}: what does it show?", figure.name);
            let drawing = (figure.draw)().unwrap_or_else(|error| panic!("{}: {error:#}", figure.name));
            if let Drawing::Svg(sheet) = &drawing {
                assert_eq!(without_dark_shade(sheet), None, "{}", figure.name);
            }
            let (width, height) = drawing.size();
            assert!(
                (200..=900).contains(&width) && (60..=900).contains(&height),
                "{}: {width}x{height}",
                figure.name
            );
        }
    }

    #[test]
    fn figures_are_the_same_in_every_run() {
        let draw = || -> Vec<String> {
            let svg = |figure: &Figure| match (figure.draw)().unwrap() {
                Drawing::Svg(sheet) => sheet.to_string(),
                Drawing::Pixels(image, _) => format!("{:?}", image.buffer()),
            };
            all().map(svg).collect()
        };
        assert!(draw() == draw());
    }
}
