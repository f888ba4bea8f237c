//! A student's program behind walls: it does the tasks.

use std::cell::RefCell;
use std::fs::File;
use std::path::Path;
use std::process::Stdio;
use std::time::Instant;

use anyhow::{Context, bail, ensure};
use judge::ask::{Answered, ask, tell_seed};
use tasks::Answer;

use crate::file;
use crate::judge::Asked;
use crate::kit::Kit;
use crate::process;
use crate::walls::{self, Role, Terms, Walls};

/// Bytes of memory. A mission takes some 30 MB.
pub(crate) const MEMORY: u64 = 1 << 30;
/// Seconds of CPU time, of each process: all tasks of a mission take less than one. Whoever asks is to stop it before.
pub(crate) const CPU: u64 = 30;
/// The largest file, and so the largest output, in bytes. The answers of a mission are at most some 10 MB.
pub(crate) const FILE: u64 = 64 << 20;

/// Runs a program on the tasks of a seed. Returns its answers, and what it printed.
///
/// # Errors
/// Where it is no fault of the program: the clock ran out, or another one killed it.
pub(crate) fn run(
    kit: &Kit,
    program: &Path,
    asked: &[Asked],
    seed: u64,
    folder: &Path,
    terms: Terms,
) -> anyhow::Result<(Vec<Answer>, String)> {
    let printed = folder.join("printed.txt");
    File::create(&printed)?;
    let questions: Vec<usize> = asked.iter().map(|asked| asked.questions).collect();
    let begun = Instant::now();
    let time = |child: &_| {
        ensure!(
            begun.elapsed() < terms.patience,
            "the program was stopped {}",
            process::overdue(terms.patience)
        );
        process::cpu_time(child)
    };
    let processes = RefCell::new(Vec::new());
    let start = |answers: &Path, from: usize| {
        let walls = Walls {
            closed: terms.closed,
            role: Role::Program,
            read: vec![kit.assets.clone()],
            run: [walls::libraries(), vec![program.to_path_buf()]].concat(),
            write: vec![answers.to_path_buf()],
            memory: MEMORY,
            cpu: CPU,
            file: FILE,
        };
        let mut command = walls.command(program)?;
        command.arg("--answer").arg(answers).arg(from.to_string()).stdin(Stdio::piped());
        let out = || File::options().append(true).open(&printed);
        command.current_dir(folder).stdout(out()?).stderr(out()?);
        let mut child = command.spawn().context("cannot start the launcher")?;
        tell_seed(&mut child, seed)?;
        processes.borrow_mut().push(child.id());
        Ok(child)
    };
    let Answered { answers, ends } = ask(&questions, folder, start, time)?;
    if let Some(why) = ends.into_iter().find_map(process::killed) {
        bail!("the program was stopped {why}");
    }
    // Where a thread's stack overflows, its number is told, which is another one each time.
    let without = |said: String, process: u32| said.replace(&format!(" ({process})"), "");
    Ok((answers, processes.take().into_iter().fold(file::said(&printed), without)))
}
