//! rustc and the linker, behind walls.

use std::fs::File;
use std::path::{Path, PathBuf};

use anyhow::bail;

use crate::file;
use crate::kit::{Kit, dependencies};
use crate::process::{self, End};
use crate::walls::{self, Role, Terms, Walls};

/// Seconds of CPU time for it, on all its threads; a mission takes it half a second.
const CPU: u64 = 20;
/// Its memory, in bytes. A mission takes it a third of a gigabyte of addresses, the linker more.
const MEMORY: u64 = 2 << 30;
/// The largest file that it may write, messages included.
const FILE: u64 = 64 << 20;

/// What became of a text.
pub(crate) enum Compiled {
    /// A program.
    Program(PathBuf),
    /// The text did not compile, and what was said about it.
    Not(String),
}

/// Compiles a student's text into a program, in a folder of its own.
///
/// # Errors
/// Where it is no fault of the text: a file cannot be written, or the clock ran out.
pub(crate) fn compile(kit: &Kit, text: &[u8], folder: &Path, terms: Terms) -> anyhow::Result<Compiled> {
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join("lib.rs"), text)?;
    let library = format!("lib{}.rlib", kit.krate);
    let mut externs = kit.lib.clone();
    let lib = ["--crate-type=rlib", "--crate-name", &kit.krate, "-Awarnings", "-Funsafe_code", "lib.rs"];
    if let Some(said) = rustc(kit, Role::Compiler, &kit.reads, &externs, &lib, folder, terms)? {
        return Ok(Compiled::Not(said));
    }
    externs.clone_from(&kit.bin);
    externs.push(format!("{}={library}", kit.krate));
    std::fs::copy(&kit.main, folder.join("main.rs"))?;
    // The checks, which are compiled once more with the student's types, take most of the time. What is theirs
    // alone may be slower.
    let bin = ["--crate-type=bin", "--crate-name=program", "-Copt-level=1", "-Cstrip=symbols", "main.rs"];
    if let Some(said) = rustc(kit, Role::Linker, &kit.links, &externs, &bin, folder, terms)? {
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
    terms: Terms,
) -> anyhow::Result<Option<String>> {
    let mut run = walls::libraries();
    run.push(kit.sysroot.clone());
    if role == Role::Linker {
        run.append(&mut walls::tools());
    }
    let write = vec![folder.to_path_buf()];
    let walls = Walls {
        closed: terms.closed,
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
    let end = process::finish(&mut command, terms.patience)?;
    let said = file::said(&messages);
    Ok(match end {
        End::Ran(status) if status.success() => None,
        End::Ran(status) if status.code() == Some(walls::NOT_BUILT) => bail!("{said}"),
        End::Ran(status) if status.code().is_none() => Some(format!(
            "the compiler was stopped ({status}): {}",
            process::limit(status).unwrap_or("it crashed")
        )),
        End::Ran(_) => Some(said),
        End::PutOff(why) => {
            bail!("{} was stopped {why}", if role == Role::Linker { "the linker" } else { "the compiler" })
        }
    })
}
