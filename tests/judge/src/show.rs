//! Tells a student what is right and what is not.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use anyhow::Context;
use checks::picture::distance;
use common::compare::{Difference, side_by_side};
use common::terminal::{eprintln, print};
use common::{Color, Format, IVec2, Image, preview};
use tasks::{Answer, COURSE, Raw, SEED};

use super::ask::ask;
use super::{AnswerKey, Finding, Judge, Question, Verdict};

/// Judges answers to the questions of all keys in a row.
pub(crate) fn judge(keys: &[AnswerKey], answers: &[Answer]) -> Vec<Verdict> {
    let mut rest = answers;
    let verdict = |key: &AnswerKey| {
        let (own, others) = rest.split_at(key.questions.len().min(rest.len()));
        rest = others;
        key.judge(own)
    };
    keys.iter().map(verdict).collect()
}

/// What a student's program answers.
fn answers(program: &Path, keys: &[AnswerKey]) -> anyhow::Result<Vec<Answer>> {
    let folder = std::env::temp_dir().join(format!("pixel-by-pixel-{}", std::process::id()));
    std::fs::create_dir(&folder).context("cannot make a folder for the answers")?;
    let questions: Vec<usize> = keys.iter().map(|key| key.questions.len()).collect();
    let answers = ask(&questions, &folder, |file, from| {
        let mut child = Command::new(program);
        child.arg("--answer").arg(file).args([from.to_string(), SEED.to_string()]);
        child.spawn().with_context(|| format!("cannot start {}", program.display()))
    });
    std::fs::remove_dir_all(&folder).context("cannot remove the folder of the answers")?;
    answers
}

impl<F> Judge<F> {
    /// Says what is right and what is not, and shows it.
    pub(crate) fn show(&self, program: &Path, in_terminal: bool) -> anyhow::Result<ExitCode> {
        let lesson = self.mission.lesson;
        let keys = self.key(SEED);
        let answers = answers(program, &keys)?;
        let verdicts = judge(&keys, &answers);
        let unwritten = |answer: &Answer| match answer {
            Answer::Unwritten(said) => Some(said.clone()),
            _ => None,
        };
        if let Some(said) =
            answers.first().and_then(unwritten).filter(|_| answers.iter().all(|a| unwritten(a).is_some()))
        {
            eprintln(format_args!("Nothing is written yet. Begin at {said}"));
            return Ok(ExitCode::FAILURE);
        }

        if let Some((title, sheet)) = comparison(&keys, &answers, &verdicts) {
            std::fs::create_dir_all("out").context("cannot create the folder out/")?;
            let path = PathBuf::from("out").join(format!("my-{lesson}.png"));
            sheet.write(&path)?;
            if let Some(text) = preview::for_terminal(&sheet).filter(|_| in_terminal) {
                print(&text)?;
            }
            print(&format!("{}: expected | got | difference, {title}\n", path.display()))?;
        }
        print(&report(lesson, &keys, &verdicts)?)?;
        let all = verdicts.iter().all(|verdict| verdict.wrong.is_empty());
        Ok(if all { ExitCode::SUCCESS } else { ExitCode::FAILURE })
    }

    /// Tells the verdicts as `cargo test` tells those of tests, and understands what it may be asked: a part of a
    /// name, `--exact`, `--list`.
    pub(crate) fn test(&self, program: &Path, words: &[&str]) -> anyhow::Result<ExitCode> {
        let filters: Vec<&&str> = words.iter().filter(|word| !word.starts_with('-')).collect();
        let exact = words.contains(&"--exact");
        let chosen = |name: &str| {
            filters.is_empty()
                || filters.iter().any(|word| if exact { **word == name } else { name.contains(**word) })
        };
        if words.contains(&"--list") {
            let names = self.mission.checks.iter().map(|check| check.name).filter(|name| chosen(name));
            let list: String = names.map(|name| format!("{name}: test\n")).collect();
            return print(&list).map(|()| ExitCode::SUCCESS);
        }
        let mut keys = self.key(SEED);
        let answers = answers(program, &keys)?;
        let mut verdicts = judge(&keys, &answers);
        keys.retain(|key| chosen(key.name));
        verdicts.retain(|verdict| chosen(verdict.name));
        let mut text = format!("\nrunning {} tests\n", verdicts.len());
        for (verdict, key) in verdicts.iter().zip(&keys) {
            let said = verdict.wrong.first().map(|wrong| {
                format!("FAILED, {}: {}", key.questions[wrong.question].input, said(&wrong.findings))
            });
            let cause = verdict.cause.map(|cause| format!("; likely cause: {cause}")).unwrap_or_default();
            text += &format!("test {} ... {}{cause}\n", verdict.name, said.as_deref().unwrap_or("ok"));
        }
        let passed = verdicts.iter().filter(|verdict| verdict.wrong.is_empty()).count();
        let failed = verdicts.len() - passed;
        let word = if failed == 0 { "ok" } else { "FAILED" };
        text += &format!("\ntest result: {word}. {passed} passed; {failed} failed\n\n");
        print(&text)?;
        Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
    }
}

/// The verdicts as text.
fn report(lesson: &str, keys: &[AnswerKey], verdicts: &[Verdict]) -> anyhow::Result<String> {
    let width = verdicts.iter().map(|verdict| verdict.name.len()).max().unwrap_or(0);
    let mut lines = Vec::new();
    for (verdict, key) in verdicts.iter().zip(keys) {
        let Verdict { name, asks, points, wrong, cause } = verdict;
        let word = if wrong.is_empty() { "right" } else { "wrong" };
        lines.push(format!("{word}  {name:width$}  {}/{points}  {asks}", verdict.earned()));
        let Some(first) = wrong.first() else { continue };
        let count = match (wrong.len(), key.questions.len()) {
            (_, 1) => String::new(),
            (wrong, of) if wrong == of => format!("all {of} inputs; the first, "),
            (wrong, of) => format!("{wrong} of {of} inputs; the first, "),
        };
        let input = &key.questions[first.question].input;
        lines.push(format!("       {count}{input}: {}", said(&first.findings)));
        if let Some(cause) = cause {
            lines.push(format!("       likely cause: {cause}"));
        }
    }
    let [earned, of] = [Verdict::earned, |verdict: &Verdict| verdict.points]
        .map(|points: fn(&Verdict) -> u32| verdicts.iter().map(points).sum::<u32>());
    lines.push(format!("{lesson}: {earned} of {of} points"));
    if earned == of {
        let next = tasks::lessons(Path::new(COURSE))?.into_iter().find(|next| next.as_str() > lesson);
        lines.push(match next {
            Some(next) => format!(
                "Next: lessons/{next}/mission/src/lib.rs, and `cargo run -p my-{}`",
                tasks::name(&next)
            ),
            None => "That was the last mission of this part.".into(),
        });
    }
    Ok(lines.join("\n") + "\n")
}

/// Findings in one line.
fn said(findings: &[Finding]) -> String {
    findings.iter().map(Finding::to_string).collect::<Vec<_>>().join("; ")
}

/// The picture to look at, and what it shows: the first one that is wrong, or else that of the lesson.
fn comparison(keys: &[AnswerKey], answers: &[Answer], verdicts: &[Verdict]) -> Option<(String, Image)> {
    let asked = keys.iter().zip(verdicts).flat_map(|(key, verdict)| {
        (key.questions.iter().enumerate()).map(move |(n, question)| {
            let wrong = verdict.wrong.iter().any(|wrong| wrong.question == n);
            (key.name, question, wrong)
        })
    });
    let pictures: Vec<_> = asked
        .zip(answers)
        .filter_map(|((name, question, wrong), answer)| {
            Some((name, question, wrong, pictures(question, answer)?))
        })
        .collect();
    let wrong = pictures.iter().find(|&&(_, _, wrong, _)| wrong);
    let (name, question, _, [expected, got, off]) =
        wrong.or_else(|| pictures.iter().find(|&&(name, ..)| name == "picture"))?;
    Some((format!("{name}: {}", question.input), side_by_side(&[expected, got, off]).ok()?))
}

/// The pictures of a question that asks for one: expected, got, and their difference. Without a result, what
/// was got is black.
pub(crate) fn pictures(question: &Question, answer: &Answer) -> Option<[Image; 3]> {
    let expected = image(&question.expected, &question.expected)?;
    let got = match answer {
        Answer::Raw(raw) => image(raw, &question.expected)?,
        _ => Image::new(expected.width() as u16, expected.height() as u16, Format::Rgb),
    };
    let mut off = Difference::between(&expected, &got);
    let near = |at: &IVec2| {
        let colors = (expected.get(at.x, at.y), got.get(at.x, at.y));
        let tolerance = question.precision.tolerance as u8;
        matches!(colors, (Some(a), Some(b)) if distance(a, b) <= tolerance)
    };
    for list in [&mut off.missing, &mut off.extra, &mut off.recolored] {
        list.retain(|at| !near(at));
    }
    let off = off.picture(&expected);
    Some([expected, got, off])
}

/// A result as a picture, if it is one; depths in grey, as far as they lie between those expected.
fn image(raw: &Raw, expected: &Raw) -> Option<Image> {
    match (raw, expected) {
        (Raw::Picture(image), _) => Some(image.clone()),
        (Raw::Depths { width, values }, Raw::Depths { values: expected, .. }) => {
            let finite = || expected.iter().copied().filter(|depth| depth.is_finite());
            let (far, near) =
                (finite().fold(f32::INFINITY, f32::min), finite().fold(f32::NEG_INFINITY, f32::max));
            let mut image = Image::new(*width as u16, (values.len() / width) as u16, Format::Rgb);
            for (n, &depth) in values.iter().enumerate().filter(|(_, depth)| depth.is_finite()) {
                let level = Color::gray(0.1 + 0.9 * (depth - far) / (near - far).max(f32::MIN_POSITIVE));
                image.set((n % width) as i32, (n / width) as i32, level);
            }
            Some(image)
        }
        _ => None,
    }
}
