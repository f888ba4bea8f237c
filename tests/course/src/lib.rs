//! A learner's way through the course: which missions there are and how far one is with them, and the hints of their
//! chapters.
//!
//! The missions are the lessons' folders, their marks are what the missions' programs kept
//! ([`judge::marks`]), and the hints are read from the chapters, so that none of it stands in two places.
//! Nothing here reads a solution.

mod formula;
pub mod hints;
pub mod list;
mod text;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use common::printable::shown;
use judge::marks::{self, ENOUGH, Standing};
use tasks::{name, number};

/// The missions of a course, and how far a learner is with each.
pub struct Missions {
    course: PathBuf,
    all: Vec<Standing>,
}

impl Missions {
    /// Those of the course in that folder.
    ///
    /// # Errors
    /// Where it is not the course.
    pub fn read(course: &Path) -> anyhow::Result<Self> {
        Ok(Self { course: course.into(), all: marks::standings(course)? })
    }

    /// The mission of that name or number, such as `triangles`, `my-triangles`, `03-triangles` or `3`; without one,
    /// the mission at hand.
    ///
    /// # Errors
    /// Where there is no such mission, or none that is not done.
    pub fn find(&self, which: Option<&str>) -> anyhow::Result<&Standing> {
        let Some(word) = which else {
            return marks::current(&self.all).with_context(|| {
                format!("all {} missions are done; name one to see it again", self.all.len())
            });
        };
        let own = word.strip_prefix("my-").unwrap_or(word);
        let is = |lesson: &str| [lesson, name(lesson), number(lesson)].contains(&own.trim_start_matches('0'));
        let found = self.all.iter().find(|one| one.lesson == own || is(&one.lesson));
        let Some(found) = found else {
            let names: Vec<&str> = self.all.iter().map(|one| name(&one.lesson)).collect();
            bail!("there is no mission {word:?}; there are {}", names.join(", "));
        };
        Ok(found)
    }

    /// The mission, and the file that is its learner's.
    #[must_use]
    pub fn place(&self, mission: &Standing) -> String {
        let lesson = &mission.lesson;
        format!("Mission {}, {}: lessons/{lesson}/mission/src/lib.rs", number(lesson), name(lesson))
    }

    /// Where the lesson's own code is explained.
    ///
    /// # Errors
    /// Before there are 8 of 10 points.
    pub fn solution(&self, which: Option<&str>) -> anyhow::Result<String> {
        let mission = self.find(which)?;
        let lesson = &mission.lesson;
        let earned = mission.mark.as_ref().map_or(0, |mark| mark.earned);
        ensure!(
            mission.is_enough(),
            "mission {}, {}, has {earned} of 10 points: our own code is told of from {ENOUGH} on",
            number(lesson),
            name(lesson)
        );
        Ok(format!(
            "Our own code is explained line by line in chapter {}, under \"Our solution\", folded:\n  \
             cargo run -p course -- book {}\nIt is in lessons/{lesson}/src/. Compare it with yours.\n",
            number(lesson),
            name(lesson)
        ))
    }

    /// The chapter of a mission, in Markdown.
    fn chapter(&self, mission: &Standing) -> anyhow::Result<String> {
        let path = Path::new("book/lessons").join(&mission.lesson).join("chapter.md");
        fs::read_to_string(self.course.join(&path)).with_context(|| format!("cannot read {}", shown(&path)))
    }
}
