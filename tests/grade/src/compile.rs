//! rustc and the linker, behind walls.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use rustix::process::{Pid, Signal, kill_process_group};

use crate::file;
use crate::kit::{Kit, dependencies};
use crate::walls::{self, Role, Walls};

/// How long the compiler may take; a mission takes it half a second.
const PATIENCE: Duration = Duration::from_secs(60);
/// Seconds of CPU time for it, on all its threads.
const CPU: u64 = 20;
/// Its memory, in bytes. A mission takes it a third of a gigabyte of addresses, the linker more.
const MEMORY: u64 = 2 << 30;
/// The largest file that it may write, messages included.
const FILE: u64 = 64 << 20;
/// How much of its messages is kept, in bytes.
const KEPT: u64 = 4 << 10;
/// How often a waiting process looks around.
const PAUSE: Duration = Duration::from_millis(5);

/// What became of a text.
pub(crate) enum Compiled {
    /// A program.
    Program(PathBuf),
    /// The text did not compile, and what was said about it.
    Not(String),
}

/// Compiles a student's text into a program, in a folder of its own.
pub(crate) fn compile(kit: &Kit, text: &[u8], folder: &Path, closed: bool) -> anyhow::Result<Compiled> {
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join("lib.rs"), text)?;
    let library = format!("lib{}.rlib", kit.krate);
    let mut externs = kit.lib.clone();
    let lib = ["--crate-type=rlib", "--crate-name", &kit.krate, "-Awarnings", "-Funsafe_code", "lib.rs"];
    if let Some(said) = rustc(kit, Role::Compiler, &kit.reads, &externs, &lib, folder, closed)? {
        return Ok(Compiled::Not(said));
    }
    externs.clone_from(&kit.bin);
    externs.push(format!("{}={library}", kit.krate));
    std::fs::copy(&kit.main, folder.join("main.rs"))?;
    // The checks, which are compiled once more with the student's types, take most of the time. What is theirs
    // alone may be slower.
    let bin = ["--crate-type=bin", "--crate-name=program", "-Copt-level=1", "main.rs"];
    if let Some(said) = rustc(kit, Role::Linker, &kit.links, &externs, &bin, folder, closed)? {
        return Ok(Compiled::Not(said));
    }
    Ok(Compiled::Program(folder.join("program")))
}

/// Runs rustc. Returns what it said if it failed.
fn rustc(
    kit: &Kit,
    role: Role,
    crates: &Path,
    externs: &[String],
    arguments: &[&str],
    folder: &Path,
    closed: bool,
) -> anyhow::Result<Option<String>> {
    let mut run = walls::libraries();
    run.push(kit.sysroot.clone());
    if role == Role::Linker {
        run.append(&mut walls::tools());
    }
    let write = vec![folder.to_path_buf()];
    let walls = Walls {
        closed,
        role,
        read: vec![crates.to_path_buf()],
        run,
        write,
        memory: MEMORY,
        cpu: CPU,
        file: FILE,
    };
    let messages = folder.join("messages.txt");
    let mut command = walls.command(&kit.rustc)?;
    command.current_dir(folder).env("TMPDIR", folder).env("PATH", "/usr/bin:/bin");
    command.args(&kit.flags).args(arguments).args(["--color=never", "-L", &dependencies(crates)]);
    command.args(externs.iter().map(|named| format!("--extern={named}")));
    command.stdout(File::create(&messages)?).stderr(File::options().append(true).open(&messages)?);
    let end = finish(&mut command, PATIENCE)?;
    let said = file::beginning(&messages, KEPT);
    Ok(match end {
        End::Ran(status) if status.success() => None,
        End::Ran(status) if status.code() == Some(walls::NOT_BUILT) => bail!("{}", said.trim()),
        End::Ran(status) if status.code().is_none() => Some(format!(
            "the compiler was stopped ({status}): {}",
            crate::run::limit(status).unwrap_or("it crashed")
        )),
        End::Ran(_) => Some(said),
        End::OutOfTime => Some(format!("the compiler was stopped after {} seconds", PATIENCE.as_secs())),
    })
}

/// How a process ended.
pub(crate) enum End {
    /// By itself.
    Ran(std::process::ExitStatus),
    /// It was stopped.
    OutOfTime,
}

/// Runs a command to its end, or to ours.
pub(crate) fn finish(command: &mut Command, patience: Duration) -> anyhow::Result<End> {
    let mut child = command.spawn().context("cannot start the launcher")?;
    let since = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(End::Ran(status));
        }
        if since.elapsed() > patience {
            stop(&mut child)?;
            return Ok(End::OutOfTime);
        }
        std::thread::sleep(PAUSE);
    }
}

/// Ends a process and those that it started.
fn stop(child: &mut Child) -> anyhow::Result<()> {
    // It may have ended just now.
    let _ = kill_process_group(Pid::from_child(child), Signal::KILL);
    child.wait()?;
    Ok(())
}
