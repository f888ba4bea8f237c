//! What is kept of each submission, and the marks.

use std::collections::{BTreeMap, BTreeSet};
use std::io::ErrorKind;
use std::path::Path;

use anyhow::{Context, bail};
use serde::{Deserialize, Serialize};

use crate::file;
use crate::proof::Wall;

/// A graded class, or a part of one. All reports are made of this, and it is kept beside them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Class {
    /// What the inputs were made from.
    pub(crate) seed: u64,
    /// What was graded.
    pub(crate) lessons: Vec<Lesson>,
    /// What kept the submissions in.
    pub(crate) walls: Vec<Wall>,
    /// By name.
    pub(crate) submissions: BTreeMap<String, Vec<Work>>,
    /// Those that Canvas has marked as late. It does not say how late, so that nothing is made of it but a hint.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    pub(crate) late: BTreeSet<String>,
}

/// A lesson and its checks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Lesson {
    /// As in `01-lines`.
    pub(crate) name: String,
    /// In the order of the verdicts.
    pub(crate) checks: Vec<Check>,
}

/// What is asked, and what it is worth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Check {
    /// A word or two.
    pub(crate) name: String,
    /// In one line.
    pub(crate) asks: String,
    /// What is earned if all is right.
    pub(crate) points: u32,
}

/// What a submission has for a lesson; in the order of [`Class::lessons`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Work {
    /// SHA-256 of the text; empty without one. Equal texts are graded once.
    pub(crate) text: String,
    /// What became of it.
    pub(crate) outcome: Outcome,
}

/// What became of a text.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) enum Outcome {
    /// There is none.
    Missing,
    /// Nobody knows yet: it is no 0.
    NotGraded(Look),
    /// It does not compile, and what was said.
    NotCompiled(String),
    /// It ran.
    Ran {
        /// One for each check.
        checks: Vec<Judged>,
        /// What it printed, the beginning of it.
        printed: String,
    },
}

/// Something that a person has to look at.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Look {
    /// What is there.
    pub(crate) found: String,
    /// Why that was not graded.
    pub(crate) because: String,
    /// What to do.
    pub(crate) cure: String,
}

impl std::fmt::Display for Look {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "found {}, not graded because {}; {}", self.found, self.because, self.cure)
    }
}

/// How a check went.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Judged {
    /// The points.
    pub(crate) earned: u32,
    /// What explains all that is wrong, if a known fault does.
    pub(crate) cause: Option<String>,
    /// How many inputs it was tried on.
    pub(crate) inputs: usize,
    /// How many of them went wrong.
    pub(crate) wrong: usize,
    /// The first of these.
    pub(crate) told: Vec<Wrong>,
    /// The first one that is a picture.
    pub(crate) pictures: Option<Pictures>,
}

/// What is wrong on one input.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Wrong {
    /// What went in.
    pub(crate) input: String,
    /// A line each.
    pub(crate) findings: Vec<String>,
}

/// Three pictures, as PNG in base 64.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Pictures {
    /// What went in.
    pub(crate) input: String,
    /// What should have been drawn.
    pub(crate) expected: String,
    /// What was drawn.
    pub(crate) got: String,
    /// Where they differ.
    pub(crate) difference: String,
}

impl Work {
    /// The points earned; nothing if it is not graded.
    pub(crate) fn earned(&self) -> Option<u32> {
        match &self.outcome {
            Outcome::Ran { checks, .. } => Some(checks.iter().map(|check| check.earned).sum()),
            Outcome::Missing | Outcome::NotCompiled(_) => Some(0),
            Outcome::NotGraded(_) => None,
        }
    }

    /// The points of a check.
    pub(crate) fn earned_in(&self, check: usize) -> Option<u32> {
        match &self.outcome {
            Outcome::Ran { checks, .. } => Some(checks.get(check).map_or(0, |judged| judged.earned)),
            Outcome::Missing | Outcome::NotCompiled(_) => Some(0),
            Outcome::NotGraded(_) => None,
        }
    }

    /// In a few words.
    pub(crate) fn state(&self) -> &'static str {
        match &self.outcome {
            Outcome::Missing => "not handed in",
            Outcome::NotGraded(_) => "not graded",
            Outcome::NotCompiled(_) => "does not compile",
            Outcome::Ran { checks, .. } if checks.iter().all(|check| check.wrong == 0) => "right",
            Outcome::Ran { checks, .. } if checks.iter().all(|check| check.earned == 0) => "wrong",
            Outcome::Ran { .. } => "partly right",
        }
    }
}

/// The points of all these; nothing if one is not graded.
pub(crate) fn total(works: &[Work]) -> Option<u32> {
    works.iter().map(Work::earned).sum()
}

impl Lesson {
    /// What it is worth.
    pub(crate) fn points(&self) -> u32 {
        self.checks.iter().map(|check| check.points).sum()
    }
}

impl Class {
    /// What everything is worth.
    pub(crate) fn points(&self) -> u32 {
        self.lessons.iter().map(Lesson::points).sum()
    }

    /// What a person has to look at: whose, of which lessons, and what. Equal things of one submission are one.
    pub(crate) fn looks(&self) -> Vec<(&str, String, &Look)> {
        let mut looks = Vec::new();
        for (name, works) in &self.submissions {
            let mut own: Vec<(&Look, Vec<&str>)> = Vec::new();
            for (work, lesson) in works.iter().zip(&self.lessons) {
                let Outcome::NotGraded(look) = &work.outcome else { continue };
                match own.iter_mut().find(|(other, _)| *other == look) {
                    Some((_, lessons)) => lessons.push(&lesson.name),
                    None => own.push((look, vec![&lesson.name])),
                }
            }
            looks.extend(own.into_iter().map(|(look, lessons)| (name.as_str(), lessons.join(", "), look)));
        }
        looks
    }

    /// Reads what [`Class::write`] wrote.
    pub(crate) fn read(report: &Path) -> anyhow::Result<Self> {
        let path = report.join(CLASS);
        let text = std::fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let class: Self = serde_json::from_slice(&text)
            .with_context(|| format!("{} is not of this grader", path.display()))?;
        // Of each a folder is made.
        let odd = |name: &&String| name.starts_with('.') || name.contains('/') || name.contains('\0');
        if let Some(name) = class.submissions.keys().find(odd) {
            bail!("{}: {name:?} cannot be a submission’s name", path.display());
        }
        Ok(class)
    }

    /// Keeps it beside the reports.
    pub(crate) fn write(&self, report: &Path) -> anyhow::Result<()> {
        file::write(&report.join(CLASS), &serde_json::to_vec(self)?)
    }
}

/// Where it is kept.
const CLASS: &str = "class.json";

/// A text that was graded, kept until everything it depends on is another. What was not graded is not kept.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct Graded {
    /// What became of it.
    pub(crate) outcome: Outcome,
    /// Seconds in the compiler and the linker.
    pub(crate) compiling: f64,
    /// Seconds in the program.
    pub(crate) running: f64,
}

impl Graded {
    /// Reads what was kept under a key, if it is there and whole.
    pub(crate) fn read(folder: &Path, key: &str) -> Option<Self> {
        serde_json::from_slice(&std::fs::read(folder.join(key)).ok()?).ok()
    }

    /// Keeps it.
    pub(crate) fn write(&self, folder: &Path, key: &str) -> anyhow::Result<()> {
        file::write(&folder.join(key), &serde_json::to_vec(self)?)
    }

    /// Keeps what is under a key no longer.
    pub(crate) fn remove(folder: &Path, key: &str) -> anyhow::Result<()> {
        let path = folder.join(key);
        match std::fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                Err(error).with_context(|| format!("cannot remove {}", path.display()))
            }
            _ => Ok(()),
        }
    }

    /// Whether nothing is wrong.
    pub(crate) fn is_right(&self) -> bool {
        matches!(&self.outcome, Outcome::Ran { checks, .. } if checks.iter().all(|check| check.wrong == 0))
    }
}
