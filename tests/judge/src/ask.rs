//! Gets answers out of a program that may crash or never end.
//!
//! A child process appends its answers to a file, a line each; when it dies, or is stopped since no answer came for
//! a while, the task at hand gets that as its answer, and another child does the rest.

use std::fs::File;
use std::path::Path;
use std::process::Child;
use std::time::{Duration, Instant};

use anyhow::Context;
use tasks::Answer;

/// How long a task may take. The references need less than a tenth of it on a slow machine.
const PATIENCE: Duration = Duration::from_secs(5);

/// How long one may take after another took too long: whoever has an endless loop need not wait for each check.
const LITTLE_PATIENCE: Duration = Duration::from_secs(1);

/// How long all tasks may take together, however often an answer comes.
const LONGEST: Duration = Duration::from_secs(30);

/// How often a waiting process looks around.
const PAUSE: Duration = Duration::from_millis(5);

/// All answers, from as many children as it takes, to checks of so many questions each. `start(file, from)` starts
/// one that does the tasks from that number on and appends their answers to that file, which is in `folder` while
/// it is needed.
///
/// # Errors
/// Where a child cannot be started, or a file not be made and read.
pub fn ask(
    questions: &[usize],
    folder: &Path,
    mut start: impl FnMut(&Path, usize) -> anyhow::Result<Child>,
) -> anyhow::Result<Vec<Answer>> {
    // Where each check's questions end.
    let ends: Vec<usize> = questions
        .iter()
        .scan(0, |end, questions| {
            *end += questions;
            Some(*end)
        })
        .collect();
    let count = ends.last().copied().unwrap_or(0);
    let mut answers: Vec<Answer> = Vec::new();
    let mut patience = PATIENCE;
    let until = Instant::now() + LONGEST;
    while answers.len() < count {
        // Another one for each child: what a dead one started may live on, and write.
        let file = folder.join(format!("answers-{}.txt", answers.len()));
        File::create_new(&file).context("cannot make a file for the answers")?;
        let child = start(&file, answers.len())?;
        let end = wait(child, &file, patience, until)?;
        let text = std::fs::read(&file).context("cannot read the answers")?;
        std::fs::remove_file(&file).context("cannot remove a file of answers")?;
        let text = String::from_utf8_lossy(&text);
        let lines: Vec<Answer> = text.lines().map_while(|line| line.parse().ok()).collect();
        answers.extend(lines);
        if answers.len() < count {
            let skipped = if end == Answer::OutOfTime {
                patience = LITTLE_PATIENCE;
                // The rest of the check is not tried.
                let over = Instant::now() >= until;
                ends.iter().copied().find(|&end| end > answers.len() && !over).unwrap_or(count)
            } else {
                answers.len() + 1
            };
            answers.resize(skipped, end);
        }
    }
    answers.truncate(count);
    Ok(answers)
}

/// Waits for a child that appends to a file. Returns how it ended, as the answer to the task that it left.
fn wait(mut child: Child, file: &Path, patience: Duration, until: Instant) -> anyhow::Result<Answer> {
    let (mut length, mut since) = (0, Instant::now());
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Answer::Crashed(format!("the program ended ({status})")));
        }
        let now = std::fs::metadata(file)?.len();
        if now > length && Instant::now() < until {
            (length, since) = (now, Instant::now());
        } else if since.elapsed() > patience || Instant::now() >= until {
            child.kill()?;
            child.wait()?;
            return Ok(Answer::OutOfTime);
        }
        std::thread::sleep(PAUSE);
    }
}
