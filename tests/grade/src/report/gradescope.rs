//! Gradescope's `results.json`, one for each submission.

use serde_json::{Value, json};

use super::{lines, not_run};
use crate::results::{Class, Outcome, Work, total};

/// The results of a submission. There are none while one is not graded: a score there must be.
pub(super) fn results(class: &Class, works: &[Work]) -> anyhow::Result<Option<Vec<u8>>> {
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
                "name": format!("{} {}: {}", lesson.name, check.name, check.asks),
                "score": earned,
                "max_score": check.points,
                "status": if earned == check.points { "passed" } else { "failed" },
                "output_format": "text",
                "output": output.join("\n").trim(),
            }));
        }
    }
    Ok(Some(serde_json::to_vec_pretty(&json!({ "score": score, "tests": tests }))?))
}
