//! What is written of a class.

mod anonymous;
mod csv;
pub(crate) mod gradescope;
mod html;
mod junit;
mod numbers;
mod roster;
mod student;
#[cfg(test)]
pub(crate) mod tests;

use std::path::{Path, PathBuf};

use clap::Args;
use serde::{Deserialize, Serialize};

use crate::file;
use crate::marks::{self, Marks};
use crate::results::{Class, Judged, Outcome, Work};
use crate::rules::{self, Rules};

pub(crate) use csv::harmless;
pub(crate) use roster::Roster;

/// The page to open.
pub(crate) const PAGE: &str = "index.html";

/// How long a submission took, in seconds. A text that several have handed in took that long once.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Time {
    /// Whose.
    pub(crate) submission: String,
    /// As in `01-lines`.
    pub(crate) lesson: String,
    /// In the compiler and the linker.
    pub(crate) compiling: f64,
    /// In the program.
    pub(crate) running: f64,
}

/// What else is written than points and what was found, if it is wished for.
#[derive(Default)]
pub(crate) struct Extras {
    roster: Option<Roster>,
    rules: Option<Rules>,
    anonymous: bool,
}

/// The flags that ask for it.
#[derive(Args)]
#[group(skip)]
pub(crate) struct Flags {
    /// What Canvas (gradebook, Export) or Moodle (Download grading worksheet) gave: REPORT/import.csv is the same, filled in.
    #[arg(long, value_name = "FILE")]
    roster: Option<PathBuf>,
    #[command(flatten)]
    rules: rules::Flags,
    /// Write reports without names, too, into REPORT/anonymous.
    #[arg(long)]
    anonymous: bool,
}

impl Flags {
    /// Reads the files.
    pub(crate) fn read(&self, course: &Path) -> anyhow::Result<Extras> {
        let roster = self.roster.as_deref().map(Roster::read).transpose()?;
        Ok(Extras { roster, rules: self.rules.read(course)?, anonymous: self.anonymous })
    }
}

/// Writes all reports into a folder. Times aside, equal results give equal files. Returns what a person has to look at, a
/// line each; nothing if there is nothing.
pub(crate) fn write(
    class: &Class,
    mut times: Vec<Time>,
    extras: &Extras,
    folder: &Path,
) -> anyhow::Result<String> {
    let marks = extras.rules.as_ref().map(|rules| Marks::new(class, rules)).transpose()?;
    let marks = marks.as_ref();
    class.write(folder)?;
    times.sort_by(|a, b| (&a.submission, &a.lesson).cmp(&(&b.submission, &b.lesson)));
    file::write(&folder.join(TIMES), &csv::times(&times)?)?;
    file::write(&folder.join("grades.csv"), &csv::grades(class, marks)?)?;
    file::write(&folder.join("junit.xml"), junit::report(class, &times)?.as_bytes())?;
    for (name, works) in &class.submissions {
        let path = folder.join("gradescope").join(name).join("results.json");
        match gradescope::results(class, works, gradescope::Visibility::Visible)? {
            Some(results) => file::write(&path, &results)?,
            // What was known is not so any more.
            None if path.exists() => std::fs::remove_file(path)?,
            None => (),
        }
        file::write(&folder.join(student::file(name)), student::page(class, name, works, marks)?.as_bytes())?;
    }
    file::write(&folder.join(PAGE), html::page(class, marks)?.as_bytes())?;
    if extras.anonymous {
        let others = extras.roster.as_ref().map(Roster::identities).unwrap_or_default();
        anonymous::write(class, marks, &others, folder)?;
    }
    extras.roster.as_ref().map_or(Ok(()), |roster| roster.write(class, marks, folder))?;
    Ok(looks(class, marks))
}

fn looks(class: &Class, marks: Option<&Marks>) -> String {
    let looks = class.looks();
    let lines = looks.iter().map(|(name, lessons, look)| format!("  {name}, {lessons}: {look}\n"));
    let head = (!looks.is_empty()).then(|| "look here: not graded, which is no 0\n".to_string());
    let late = late(class, marks);
    let late = (!late.is_empty()).then(|| {
        format!(
            "look here: Canvas marks as late, without a time, from whom no day was taken; \
             --submitted says when that was\n  {}\n",
            late.join(", ")
        )
    });
    head.into_iter().chain(lines).chain(late).collect()
}

/// Those that Canvas marked as late, but of which the rules know no late day.
fn late<'a>(class: &'a Class, marks: Option<&Marks>) -> Vec<&'a str> {
    let in_time = |name: &&String| {
        let marks = marks.and_then(|marks| marks.students.get(*name));
        marks.is_none_or(|own| own.iter().all(|mark| mark.days == 0))
    };
    class.late.iter().filter(in_time).map(String::as_str).collect()
}

/// The times that were written into a folder.
pub(crate) fn times(folder: &Path) -> anyhow::Result<Vec<Time>> {
    csv::read_times(&folder.join(TIMES))
}

const TIMES: &str = "times.csv";

/// Points to be shown; a dash where nothing is graded.
fn points(earned: Option<u32>) -> String {
    earned.map_or_else(|| "–".into(), |points| points.to_string())
}

/// What counts, to be shown; a dash where nothing is graded.
fn counted(hundredths: Option<u64>) -> String {
    hundredths.map_or_else(|| "–".into(), marks::decimal)
}

/// Why a work was not run, and what was said; nothing if it was.
fn not_run(work: &Work) -> Option<(&'static str, String)> {
    match &work.outcome {
        Outcome::Missing => Some(("nothing was handed in for this lesson", String::new())),
        Outcome::NotGraded(look) => Some(("it is not graded", look.to_string())),
        Outcome::NotCompiled(said) => Some(("it does not compile", said.clone())),
        Outcome::Ran { .. } => None,
    }
}

/// What is wrong in a check, a line each; nothing if it is right.
fn lines(judged: &Judged) -> Vec<String> {
    let told = judged
        .told
        .iter()
        .flat_map(|wrong| wrong.findings.iter().map(|finding| format!("{}: {finding}", wrong.input)));
    let cause = judged.cause.iter().map(|cause| format!("likely cause: {cause}"));
    let count = (judged.wrong > 1).then(|| format!("{} of {} inputs are wrong", judged.wrong, judged.inputs));
    told.chain(cause).chain(count).collect()
}
