//! A student's program behind walls: it does the tasks.

use std::fs::File;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::ExitStatus;

use anyhow::Context;
use judge::ask::ask;
use rustix::process::Signal;
use tasks::Answer;

use crate::file;
use crate::judge::Asked;
use crate::kit::Kit;
use crate::walls::{self, Role, Walls};

/// Bytes of memory. A mission takes some 30 MB.
pub(crate) const MEMORY: u64 = 1 << 30;
/// Seconds of CPU time, of each process: all tasks of a mission take less than one.
pub(crate) const CPU: u64 = 30;
/// The largest file, and so the largest output, in bytes. The answers of a mission are at most some 10 MB.
pub(crate) const FILE: u64 = 64 << 20;
/// How much of what a program printed is kept, in bytes.
const KEPT: u64 = 2 << 10;

/// Runs a program on the tasks of a seed. Returns its answers, and what it printed.
pub(crate) fn run(
    kit: &Kit,
    program: &Path,
    asked: &[Asked],
    seed: u64,
    folder: &Path,
    closed: bool,
) -> anyhow::Result<(Vec<Answer>, String)> {
    let printed = folder.join("printed.txt");
    File::create(&printed)?;
    let questions: Vec<usize> = asked.iter().map(|asked| asked.questions).collect();
    let answers = ask(&questions, folder, |answers, from| {
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
    Ok((answers, file::beginning(&printed, KEPT)))
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
