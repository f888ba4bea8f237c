//! The README's table of lessons, from what the lessons say of themselves.

use std::path::Path;

use anyhow::Context;
use common::file::write_whole;

use charts::lessons::{LESSONS, Lesson};

const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../README.md");

/// Writes the table of lessons into the README.
///
/// # Errors
/// Where the README cannot be read or written, or has no place for it.
pub(crate) fn write() -> anyhow::Result<()> {
    let text = std::fs::read_to_string(README).context("README.md")?;
    Ok(write_whole(Path::new(README), with_lessons(&text)?.as_bytes())?)
}

/// The README with the table of lessons between its marks.
fn with_lessons(readme: &str) -> anyhow::Result<String> {
    const MARKS: [&str; 2] = ["<!-- lessons -->\n", "<!-- /lessons -->"];
    let (before, rest) = readme.split_once(MARKS[0]).context("README.md: there is no <!-- lessons -->")?;
    let (_, behind) = rest.split_once(MARKS[1]).context("README.md: there is no <!-- /lessons -->")?;
    let rows: String = LESSONS.iter().map(row).collect();
    let table = format!("| | lesson | you build | methods |\n|---|---|---|---|\n{rows}");
    Ok([before, MARKS[0], &table, MARKS[1], behind].concat())
}

fn row(lesson: &Lesson) -> String {
    let common::Lesson { number, name, job, .. } = lesson.lesson;
    let (folder, picture, methods) = (lesson.lesson.folder(), lesson.picture, lesson.methods);
    format!(
        "| <img src=\"book/lessons/{folder}/picture.png\" width=\"120\" alt=\"{picture}\"> \
         | [{number:02} {name}](lessons/{folder}/src/lib.rs)<br>`cargo run -p {name}` | {job} | {methods} |\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_readme_lists_the_lessons() {
        let readme = std::fs::read_to_string(README).unwrap();
        assert!(with_lessons(&readme).unwrap() == readme, "run cargo run -p book -- methods");
    }
}
