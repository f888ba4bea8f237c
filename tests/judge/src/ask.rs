//! Gets answers out of a program that may crash or never end.
//!
//! A child process appends its answers to a file, a line each; when it dies, or is stopped since no answer came for
//! a while, the task at hand gets that as its answer, and another child does the rest.

use std::fs::File;
use std::io::{ErrorKind, Read, Write};
use std::path::Path;
use std::process::{Child, ExitStatus};
use std::time::Duration;

use anyhow::Context;
use tasks::Answer;

use crate::message;

/// How long a task may take. The references need less than a tenth of it on a slow machine.
const PATIENCE: Duration = Duration::from_secs(5);

/// How long one may take after another took too long: whoever has an endless loop need not wait for each check.
const LITTLE_PATIENCE: Duration = Duration::from_secs(1);

/// How long all tasks may take together, however often an answer comes.
const LONGEST: Duration = Duration::from_secs(20);

/// How often a waiting process looks around.
const PAUSE: Duration = Duration::from_millis(5);

/// Bytes of all answers together. Those of a mission are at most some 10 MB.
const LARGEST: u64 = 64 << 20;

/// What children answered.
pub struct Answered {
    /// An answer for each question.
    pub answers: Vec<Answer>,
    /// How those children ended that were not stopped.
    pub ends: Vec<ExitStatus>,
}

/// Tells a program, on its standard input, from which seed the tasks are made.
///
/// # Errors
/// Where the child cannot be told, though it lives.
pub fn tell_seed(child: &mut Child, seed: u64) -> std::io::Result<()> {
    let Some(mut input) = child.stdin.take() else { return Ok(()) };
    match writeln!(input, "{seed}") {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        told => told,
    }
}

/// All answers, from as many children as it takes, to checks of so many questions each. `start(file, from)` starts
/// one that does the tasks from that number on and appends their answers to that file, which is in `folder` while
/// it is needed. `time(child)` says how much time a child has taken until now, by a clock of the caller's choice.
///
/// # Errors
/// Where a child cannot be started, its time not be told, or a file not be made and read.
pub fn ask(
    questions: &[usize],
    folder: &Path,
    mut start: impl FnMut(&Path, usize) -> anyhow::Result<Child>,
    time: impl Fn(&Child) -> anyhow::Result<Duration>,
) -> anyhow::Result<Answered> {
    // Where each check's questions end.
    let ends: Vec<usize> = questions
        .iter()
        .scan(0, |end, questions| {
            *end += questions;
            Some(*end)
        })
        .collect();
    let count = ends.last().copied().unwrap_or(0);
    let mut all = Answered { answers: Vec::new(), ends: Vec::new() };
    let (mut patience, mut left, mut room) = (PATIENCE, LONGEST, LARGEST);
    while all.answers.len() < count {
        let answers = &mut all.answers;
        // Another one for each child: what a dead one started may live on, and write.
        let path = folder.join(format!("answers-{}.txt", answers.len()));
        File::create_new(&path).context("cannot make a file for the answers")?;
        let mut child = start(&path, answers.len())?;
        let end = wait(&mut child, &path, patience, &mut left, &time);
        if !matches!(end, Ok(Some(_))) {
            child.kill()?;
            child.wait()?;
        }
        let end = end?;
        all.ends.extend(end);
        let mut text = Vec::new();
        File::open(&path)
            .and_then(|file| file.take(room).read_to_end(&mut text))
            .context("cannot read the answers")?;
        std::fs::remove_file(&path).context("cannot remove a file of answers")?;
        room -= text.len() as u64;
        let text = String::from_utf8_lossy(&text);
        let lines = text.lines().map_while(|line| line.parse().ok()).map(short);
        answers.extend(lines.take(count - answers.len()));
        let next = answers.len() + 1;
        if next > count {
            break;
        }
        let (end, skipped) = match end {
            _ if room == 0 => (Answer::Crashed("the answers are larger than 64 MiB".into()), count),
            Some(status) => (Answer::Crashed(format!("the program ended ({status})")), next),
            None if left.is_zero() => (Answer::OutOfTime, count),
            // The rest of the check is not tried.
            None => (Answer::OutOfTime, ends.iter().copied().find(|&end| end >= next).unwrap_or(count)),
        };
        if end == Answer::OutOfTime {
            patience = LITTLE_PATIENCE;
        }
        answers.resize(skipped, end);
    }
    Ok(all)
}

/// An answer of which what was said is cut.
fn short(answer: Answer) -> Answer {
    match answer {
        Answer::Crashed(said) => Answer::Crashed(message::cut(&said)),
        Answer::Unwritten(said) => Answer::Unwritten(message::cut(&said)),
        answer => answer,
    }
}

/// Waits for a child that appends to a file, and takes its time from what is left. Returns how it ended, or nothing
/// if it is to be stopped.
fn wait(
    child: &mut Child,
    file: &Path,
    patience: Duration,
    left: &mut Duration,
    time: impl Fn(&Child) -> anyhow::Result<Duration>,
) -> anyhow::Result<Option<ExitStatus>> {
    let (mut length, mut since, mut last) = (0, time(child)?, time(child)?);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        let (now, written) = (time(child)?, std::fs::metadata(file)?.len());
        *left = left.saturating_sub(now.saturating_sub(last));
        last = now;
        if written > length {
            (length, since) = (written, now);
        }
        if left.is_zero() || now.saturating_sub(since) > patience {
            return Ok(None);
        }
        std::thread::sleep(PAUSE);
    }
}
