//! A student's program behind walls: it does the tasks, and is judged here.

use std::fs::File;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::ExitStatus;

use anyhow::Context;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use checks::missions::judge::{Finding, Verdict};
use checks::missions::{Answer, Sheet, program};
use common::Image;
use common::file::Encoding;
use rustix::process::Signal;

use crate::file;
use crate::kit::Kit;
use crate::results::{Judged, Pictures, Wrong};
use crate::walls::{self, Role, Walls};

/// Bytes of memory. A mission takes some 30 MB.
pub(crate) const MEMORY: u64 = 1 << 30;
/// Seconds of CPU time, of each process: all tasks of a mission take less than one.
pub(crate) const CPU: u64 = 30;
/// The largest file, and so the largest output, in bytes. The answers of a mission are at most some 10 MB.
pub(crate) const FILE: u64 = 64 << 20;
/// How much of what a program printed is kept, in bytes.
const KEPT: u64 = 2 << 10;
/// How many wrong inputs of a check are told.
const TOLD: usize = 3;

/// Runs a program on the tasks of a seed, and judges it. Also returns what it printed.
pub(crate) fn judge(
    kit: &Kit,
    program: &Path,
    sheets: &[Sheet],
    seed: u64,
    folder: &Path,
    closed: bool,
) -> anyhow::Result<(Vec<Judged>, String)> {
    let printed = folder.join("printed.txt");
    File::create(&printed)?;
    let answers = program::ask(sheets, |answers, from| {
        let walls = Walls {
            closed,
            role: Role::Program,
            read: vec![kit.assets.clone()],
            run: [walls::libraries(), vec![program.to_path_buf()]].concat(),
            write: vec![answers.to_path_buf()],
            memory: MEMORY,
            cpu: CPU,
            file: FILE,
        };
        let mut command = walls.command(program)?;
        command.arg("--answer").arg(answers).args([from.to_string(), seed.to_string()]);
        let out = || File::options().append(true).open(&printed);
        command.current_dir(folder).stdout(out()?).stderr(out()?);
        command.spawn().context("cannot start the launcher")
    })?;
    let verdicts = program::judge(sheets, &answers);
    let mut rest = answers.as_slice();
    let judged = sheets.iter().zip(verdicts).map(|(sheet, verdict)| {
        let (own, others) = rest.split_at(sheet.questions.len().min(rest.len()));
        rest = others;
        told(sheet, own, &verdict)
    });
    Ok((judged.collect(), file::beginning(&printed, KEPT)))
}

/// A verdict for the reports, with the first wrong picture.
fn told(sheet: &Sheet, answers: &[Answer], verdict: &Verdict) -> Judged {
    let input = |question: usize| sheet.questions[question].input.clone();
    let wrong = verdict.wrong.iter().take(TOLD).map(|wrong| Wrong {
        input: input(wrong.question),
        findings: wrong.findings.iter().map(Finding::to_string).collect(),
    });
    // Pictures of a result that there is, and of the right size.
    let drawn = |n: &usize| {
        let shape = |wrong: &checks::missions::judge::Wrong| !wrong.findings.contains(&Finding::WrongShape);
        matches!(answers[*n], Answer::Raw(_))
            && verdict.wrong.iter().any(|wrong| wrong.question == *n && shape(wrong))
    };
    let pictures = (0..answers.len()).filter(drawn).find_map(|n| {
        let [expected, got, difference] =
            program::pictures(&sheet.questions[n], &answers[n])?.map(|image| png(&image));
        Some(Pictures { input: input(n), expected: expected?, got: got?, difference: difference? })
    });
    Judged {
        earned: verdict.earned(),
        cause: verdict.cause.map(Into::into),
        inputs: sheet.questions.len(),
        wrong: verdict.wrong.len(),
        told: wrong.collect(),
        pictures,
    }
}

/// A picture as PNG in base 64.
fn png(image: &Image) -> Option<String> {
    image.encode(Encoding::Png).ok().map(|bytes| BASE64_STANDARD.encode(bytes))
}

/// Which limit a process ran into, if it was one.
pub(crate) fn limit(status: ExitStatus) -> Option<&'static str> {
    let signal = |signal: Signal| status.signal() == Some(signal.as_raw());
    if signal(Signal::XCPU) || signal(Signal::KILL) {
        Some("it took too much CPU time")
    } else if signal(Signal::XFSZ) {
        Some("it wrote too much")
    } else if signal(Signal::ABORT) {
        Some("it ran out of memory, or aborted")
    } else {
        None
    }
}
