//! What a lesson's judge says: what is asked, and how answers fare. It is a program of its own, the only one that
//! knows what is expected.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail, ensure};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use judge::picture_files;
use tasks::Answer;

use crate::kit::{self, Kit};
use crate::results::{Check, Judged, Pictures, Wrong};

/// A check, and of how many questions.
pub(crate) struct Asked {
    pub(crate) check: Check,
    pub(crate) questions: usize,
}

/// What a lesson asks.
pub(crate) fn checks(kit: &Kit, seed: u64) -> anyhow::Result<Vec<Asked>> {
    let said = kit::run(Command::new(&kit.judge).args(["checks", &seed.to_string()]))?;
    read_checks(&said).with_context(|| format!("what the judge of {} asks", kit.lesson))
}

/// Judges answers. The files that this takes are in a folder.
pub(crate) fn mark(
    kit: &Kit,
    asked: &[Asked],
    answers: &[Answer],
    seed: u64,
    folder: &Path,
) -> anyhow::Result<Vec<Judged>> {
    let file = folder.join("answers.txt");
    std::fs::write(&file, answers.iter().map(|answer| format!("{answer}\n")).collect::<String>())?;
    let mut judge = Command::new(&kit.judge);
    let said = kit::run(judge.args(["mark", &seed.to_string()]).arg(file).arg(folder))?;
    let mut checks = read_marks(&said)?;
    ensure!(checks.len() == asked.len(), "{} checks, not {}", checks.len(), asked.len());
    for (n, (check, asked)) in checks.iter_mut().zip(asked).enumerate() {
        check.inputs = asked.questions;
        if let Some(pictures) = &mut check.pictures {
            let png = |file: PathBuf| std::fs::read(file).map(|bytes| BASE64_STANDARD.encode(bytes));
            let [expected, got, difference] = picture_files(folder, n).map(png);
            (pictures.expected, pictures.got, pictures.difference) = (expected?, got?, difference?);
        }
    }
    Ok(checks)
}

/// A line's first word, and the rest.
fn words(line: &str) -> (&str, &str) {
    line.split_once(' ').unwrap_or((line, ""))
}

/// The numbers with which a line begins, and the rest of it.
fn numbers(line: &str) -> Option<([usize; 2], &str)> {
    let (first, rest) = words(line);
    let (second, rest) = words(rest);
    Some(([first.parse().ok()?, second.parse().ok()?], rest))
}

fn read_checks(said: &str) -> anyhow::Result<Vec<Asked>> {
    let mut all: Vec<Asked> = Vec::new();
    for line in said.lines() {
        match (words(line), all.last_mut()) {
            (("check", rest), _) => {
                let ([points, questions], name) = numbers(rest).with_context(|| line.to_string())?;
                let check = Check { name: name.into(), asks: String::new(), points: points as u32 };
                all.push(Asked { check, questions });
            }
            (("asks", rest), Some(last)) => last.check.asks = rest.into(),
            _ => bail!("{line}"),
        }
    }
    Ok(all)
}

fn read_marks(said: &str) -> anyhow::Result<Vec<Judged>> {
    let mut all: Vec<Judged> = Vec::new();
    for line in said.lines() {
        match (words(line), all.last_mut()) {
            (("check", rest), _) => {
                let ([earned, wrong], _) = numbers(rest).with_context(|| line.to_string())?;
                let earned = earned as u32;
                all.push(Judged { earned, cause: None, inputs: 0, wrong, told: Vec::new(), pictures: None });
            }
            (("cause", rest), Some(last)) => last.cause = Some(rest.into()),
            (("input", rest), Some(last)) => {
                last.told.push(Wrong { input: rest.into(), findings: Vec::new() });
            }
            (("finding", rest), Some(Judged { told, .. })) if !told.is_empty() => {
                told.last_mut().context("an input")?.findings.push(rest.into());
            }
            (("picture", rest), Some(last)) => {
                last.pictures = Some(Pictures { input: rest.into(), ..Pictures::default() });
            }
            _ => bail!("{line}"),
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_judge_says_is_read() {
        let asked =
            read_checks("check 2 6 two sides\nasks left and right\ncheck 1 1 far\nasks more\n").unwrap();
        assert_eq!((asked.len(), asked[0].questions, asked[0].check.points), (2, 6, 2));
        assert_eq!((&*asked[0].check.name, &*asked[0].check.asks), ("two sides", "left and right"));
        let said = "check 2 0\ncheck 0 2\ncause a fault\ninput one\nfinding a\nfinding b\ninput two\nfinding c\n\
                    picture two\n";
        let marks = read_marks(said).unwrap();
        assert_eq!((marks.len(), marks[0].earned, marks[1].wrong), (2, 2, 2));
        assert_eq!(marks[1].cause.as_deref(), Some("a fault"));
        assert_eq!(marks[1].told[0].findings, ["a", "b"]);
        assert_eq!((&*marks[1].told[1].input, &*marks[1].pictures.as_ref().unwrap().input), ("two", "two"));
    }

    #[test]
    fn nonsense_is_an_error() {
        for said in ["asks first", "check two 1 name", "check 2", "check 1 1\nfinding none", "panicked"] {
            assert!(read_checks(said).is_err(), "{said}");
            assert!(read_marks(said).is_err(), "{said}");
        }
    }
}
