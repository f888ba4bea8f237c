//! What a grader is told, a line a thing, each with a word before it.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Context;
use common::Image;
use common::terminal::print;
use tasks::Answer;

use super::show::pictures;
use super::{AnswerKey, Finding, Judge, Verdict};

/// How many wrong inputs of a check are told.
const TOLD: usize = 3;

impl<F> Judge<F> {
    /// What is asked: for each check `check POINTS QUESTIONS NAME` and `asks WHAT`.
    pub(crate) fn print_checks(&self, seed: &str) -> anyhow::Result<ExitCode> {
        let tasks = self.mission.tasks(seed.parse()?);
        let rows = self.mission.checks.iter().zip(tasks).map(|(check, tasks)| {
            format!("check {} {} {}\nasks {}\n", check.points, tasks.len(), check.name, check.asks)
        });
        print(&rows.collect::<String>()).map(|()| ExitCode::SUCCESS)
    }

    /// How answers fare: for each check `check POINTS WRONG`; where it is known, `cause WHAT`; for the first wrong
    /// inputs `input WHAT` and after it lines of `finding WHAT`; and `picture INPUT` where one of them was drawn,
    /// which is then in files of the folder, see [`picture_files`].
    pub(crate) fn mark(&self, seed: &str, answers: &Path, folder: &Path) -> anyhow::Result<ExitCode> {
        let seed = seed.parse()?;
        let keys = self.key(seed);
        let text = std::fs::read_to_string(answers).context("cannot read the answers")?;
        let answers: Vec<Answer> = text.lines().map_while(|line| line.parse().ok()).collect();
        let mut rest = answers.as_slice();
        for (check, (key, verdict)) in keys.iter().zip(self.judge(seed, &keys, &answers)).enumerate() {
            let (own, others) = rest.split_at(key.questions.len().min(rest.len()));
            rest = others;
            print(&told(key, &verdict))?;
            if let Some((input, images)) = first_picture(key, own, &verdict) {
                for (image, file) in images.iter().zip(picture_files(folder, check)) {
                    image.write(&file)?;
                }
                print(&format!("picture {input}\n"))?;
            }
        }
        Ok(ExitCode::SUCCESS)
    }
}

/// Where the pictures of a check are: expected, got, and their difference.
#[must_use]
pub fn picture_files(folder: &Path, check: usize) -> [PathBuf; 3] {
    ["expected", "got", "difference"].map(|name| folder.join(format!("{check}-{name}.png")))
}

fn told(key: &AnswerKey, verdict: &Verdict) -> String {
    let mut text = format!("check {} {}\n", verdict.earned(), verdict.wrong.len());
    text.extend(verdict.cause.iter().map(|cause| format!("cause {cause}\n")));
    for wrong in verdict.wrong.iter().take(TOLD) {
        text += &format!("input {}\n", key.questions[wrong.question].input);
        text.extend(wrong.findings.iter().map(|finding| format!("finding {finding}\n")));
    }
    text
}

/// The first wrong picture, of a result that there is, and of the right size.
fn first_picture<'a>(
    key: &'a AnswerKey,
    answers: &[Answer],
    verdict: &Verdict,
) -> Option<(&'a str, [Image; 3])> {
    let drawn = verdict.wrong.iter().filter(|wrong| !wrong.findings.contains(&Finding::WrongShape));
    drawn.filter(|wrong| matches!(answers.get(wrong.question), Some(Answer::Raw(_)))).find_map(|wrong| {
        let question = &key.questions[wrong.question];
        Some((question.input.as_str(), pictures(question, &answers[wrong.question])?))
    })
}
