//! What is written of a class.

mod csv;
mod gradescope;
mod html;
mod junit;
mod numbers;
mod roster;
mod student;
#[cfg(test)]
pub(crate) mod tests;

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::file;
use crate::results::{Class, Judged, Outcome, Work};

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

/// Writes all reports into a folder. Times aside, equal results give equal files.
pub(crate) fn write(class: &Class, mut times: Vec<Time>, folder: &Path) -> anyhow::Result<()> {
    class.write(folder)?;
    times.sort_by(|a, b| (&a.submission, &a.lesson).cmp(&(&b.submission, &b.lesson)));
    file::write(&folder.join(TIMES), &csv::times(&times)?)?;
    file::write(&folder.join("grades.csv"), &csv::grades(class)?)?;
    file::write(&folder.join("junit.xml"), junit::report(class)?.as_bytes())?;
    for (name, works) in &class.submissions {
        let path = folder.join("gradescope").join(name).join("results.json");
        match gradescope::results(class, works)? {
            Some(results) => file::write(&path, &results)?,
            // What was known is not so any more.
            None if path.exists() => std::fs::remove_file(path)?,
            None => (),
        }
        file::write(&folder.join(student::file(name)), student::page(class, name, works)?.as_bytes())?;
    }
    file::write(&folder.join(PAGE), html::page(class)?.as_bytes())
}

/// What a person has to look at, a line each; nothing if there is nothing.
pub(crate) fn looks(class: &Class) -> String {
    let looks = class.looks();
    let lines = looks.iter().map(|(name, lessons, look)| format!("  {name}, {lessons}: {look}\n"));
    let head = (!looks.is_empty()).then(|| "look here: not graded, which is no 0\n".to_string());
    head.into_iter().chain(lines).collect()
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
