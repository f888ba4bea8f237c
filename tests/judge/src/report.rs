//! Verdicts as text, for a student.

use super::{AnswerKey, Finding, Verdict};

/// The verdicts as text, on some checks or on all.
pub(crate) fn report(lesson: &str, keys: &[AnswerKey], verdicts: &[Verdict], all: bool) -> String {
    let width = verdicts.iter().map(|verdict| verdict.name.len()).max().unwrap_or(0);
    let mut lines = Vec::new();
    for (verdict, key) in verdicts.iter().zip(keys) {
        let Verdict { name, asks, points, wrong, cause, .. } = verdict;
        let word = if wrong.is_empty() { "right" } else { "wrong" };
        lines.push(format!("{word}  {name:width$}  {}/{points}  {asks}", verdict.earned()));
        let Some(first) = wrong.first() else { continue };
        let number = key.first + first.question;
        let count = match (wrong.len(), key.questions.len()) {
            (_, 1) => format!("input {number}"),
            (wrong, of) if wrong == of => format!("all {of} inputs; the first, input {number}"),
            (wrong, of) => format!("{wrong} of {of} inputs; the first, input {number}"),
        };
        let input = &key.questions[first.question].input;
        lines.push(format!("       {count}: {}", said(input, &first.findings)));
        if let Some(cause) = cause {
            lines.push(format!("       likely cause: {cause}"));
        }
        let is_first =
            verdicts.iter().find(|verdict| !verdict.wrong.is_empty()).is_some_and(|v| v.name == *name);
        if is_first && all {
            let name = if name.contains(' ') { format!("\"{name}\"") } else { (*name).to_string() };
            let alone = format!("cargo run -p my-{} -- --check {name}", tasks::name(lesson));
            lines.push(format!(
                "       mend this first; alone it is `{alone}`, as a test `… -- --input {number}`"
            ));
        }
    }
    if all {
        let (earned, of) = points(verdicts);
        lines.push(format!("{lesson}: {earned} of {of} points"));
    }
    lines.join("\n") + "\n"
}

/// The points of checks, and those that there are.
pub(crate) fn points(verdicts: &[Verdict]) -> (u32, u32) {
    (verdicts.iter().map(Verdict::earned).sum(), verdicts.iter().map(|verdict| verdict.points).sum())
}

/// An input and what is wrong with its result, in one line.
pub(crate) fn said(input: &str, findings: &[Finding]) -> String {
    let colon = if matches!(findings, [Finding::WrongValue { .. }, ..]) { "" } else { ":" };
    let findings: Vec<String> = findings.iter().map(Finding::to_string).collect();
    format!("{input}{colon} {}", findings.join("; "))
}
