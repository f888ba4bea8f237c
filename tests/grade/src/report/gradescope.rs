//! Gradescope's `results.json`, one for each submission:
//! <https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format>.

use clap::ValueEnum;
use serde_json::{Value, json};

use super::{lines, not_run};
use crate::results::{Class, Outcome, Work, total};

/// When students see something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
pub(crate) enum Visibility {
    /// Never.
    Hidden,
    /// When the assignment is due, late ones included.
    AfterDueDate,
    /// When the marks are published.
    AfterPublished,
    /// At once.
    Visible,
}

impl Visibility {
    /// As Gradescope writes it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Hidden => "hidden",
            Self::AfterDueDate => "after_due_date",
            Self::AfterPublished => "after_published",
            Self::Visible => "visible",
        }
    }
}

/// The results of a submission. There are none while one is not graded: a score there must be.
pub(crate) fn results(
    class: &Class,
    works: &[Work],
    visibility: Visibility,
) -> anyhow::Result<Option<Vec<u8>>> {
    let Some(score) = total(works) else { return Ok(None) };
    let mut tests: Vec<Value> = Vec::new();
    for (work, lesson) in works.iter().zip(&class.lessons) {
        for (n, check) in lesson.checks.iter().enumerate() {
            let (earned, output) = match &work.outcome {
                Outcome::Ran { checks, .. } => {
                    checks.get(n).map(|judged| (judged.earned, lines(judged))).unwrap_or_default()
                }
                _ => (0, not_run(work).map(|(why, said)| vec![why.into(), said]).unwrap_or_default()),
            };
            tests.push(json!({
                "number": format!("{}.{}", tasks::number(&lesson.name), n + 1),
                "name": format!("{} {}: {}", lesson.name, check.name, check.asks),
                "name_format": "text",
                "score": earned,
                "max_score": check.points,
                "status": if earned == check.points { "passed" } else { "failed" },
                "output_format": "text",
                "output": output.join("\n").trim(),
                "visibility": visibility.name(),
            }));
        }
    }
    // What the grader prints is for the instructor.
    let results = json!({
        "score": score,
        "visibility": visibility.name(),
        "stdout_visibility": Visibility::Hidden.name(),
        "tests": tests,
    });
    Ok(Some(serde_json::to_vec_pretty(&results)?))
}

/// What the student is told at once where it is not clear what was handed in: there it can be handed in again.
pub(crate) fn not_graded(class: &Class) -> anyhow::Result<Vec<u8>> {
    let looks = class.looks().into_iter().map(|(_, lessons, look)| format!("{lessons}: {look}."));
    let output = ["Not graded. Hand it in again:".to_string()].into_iter().chain(looks);
    let results = json!({
        "score": 0,
        "output_format": "text",
        "output": output.collect::<Vec<_>>().join("\n"),
        "visibility": Visibility::Visible.name(),
        "stdout_visibility": Visibility::Hidden.name(),
    });
    Ok(serde_json::to_vec_pretty(&results)?)
}
