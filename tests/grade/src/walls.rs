//! The walls around a compiler or a program that runs what a student wrote.
//!
//! The grader starts itself again as a launcher (`grade wall …`). The launcher limits itself and then becomes
//! the program: what Linux has taken from a process, that process cannot take back.
//!
//! | wall | made of |
//! |---|---|
//! | files: what is not named cannot be read, written, listed or run; what is written cannot be read | Landlock |
//! | files that were open: all but the standard ones are closed | the launcher |
//! | files that are looked for by name alone | a seccomp filter |
//! | network, processes, threads, signals to others, another program in its place | a seccomp filter |
//! | memory, CPU time, size of files and so of output | resource limits |
//! | time by the clock | the parent, which kills |
//! | what outlives the grader | a signal when the parent dies |

mod calls;

use std::convert::Infallible;
use std::ffi::{CString, OsStr, OsString};
use std::fs::File;
use std::os::fd::{AsRawFd, OwnedFd};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

use anyhow::{Context, ensure};
use landlock::{
    ABI, Access, AccessFs, BitFlags, CompatLevel, Compatible, PathBeneath, PathFd, Ruleset, RulesetAttr,
    RulesetCreatedAttr, RulesetStatus, path_beneath_rules,
};
use nix::fcntl::AtFlags;
use rustix::io::fcntl_dupfd_cloexec;
use rustix::process::{Resource, Rlimit, Signal, set_parent_process_death_signal, setrlimit};
use serde::{Deserialize, Serialize};

/// What the launcher's exit code is when a wall could not be built. Nothing has run then.
pub(crate) const NOT_BUILT: i32 = 125;

/// How many files a program may have open.
const DESCRIPTORS: u64 = calls::PROGRAM as u64;

/// On what terms submissions are compiled and run.
#[derive(Clone, Copy)]
pub(crate) struct Terms {
    /// Whether the walls are up.
    pub(crate) closed: bool,
    /// How long a process may take by the clock, before it is put off.
    pub(crate) patience: Duration,
}

/// A program within walls.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Walls {
    /// Whether files, network and processes are walled off. The limits always hold.
    pub(crate) closed: bool,
    /// What the program does for a living, and so which system calls it needs.
    pub(crate) role: Role,
    /// Files and folders to read.
    pub(crate) read: Vec<PathBuf>,
    /// Programs and libraries to read and run.
    pub(crate) run: Vec<PathBuf>,
    /// Files and folders to write. A compiler may read them, too, and put files into them.
    pub(crate) write: Vec<PathBuf>,
    /// Bytes of memory.
    pub(crate) memory: u64,
    /// Seconds of CPU time.
    pub(crate) cpu: u64,
    /// Bytes of the largest file it may write.
    pub(crate) file: u64,
}

/// What runs behind the walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Role {
    /// Reads what the student wrote: threads, but no other process.
    Compiler,
    /// Calls the system's linker. By now the student's text is no longer read.
    Linker,
    /// What the student wrote: it calculates.
    Program,
}

impl Walls {
    /// A command that runs a program within these walls, with an empty environment and in an empty folder.
    pub(crate) fn command(&self, program: &std::path::Path) -> anyhow::Result<Command> {
        let mut command = Command::new(std::env::current_exe().context("cannot find the grader itself")?);
        command.arg("wall").arg(serde_json::to_string(self).context("a path is not UTF-8")?).arg(program);
        command.env_clear().stdin(Stdio::null()).process_group(0);
        Ok(command)
    }

    /// Builds the walls around this process, and becomes the program.
    pub(crate) fn enter(&self, command: &[OsString]) -> anyhow::Result<Infallible> {
        let (program, arguments) = command.split_first().context("there is no program to run")?;
        set_parent_process_death_signal(Some(Signal::KILL)).context("cannot die with the parent")?;
        close_descriptors().context("cannot close what others left open")?;
        for (resource, limit, maximum) in [
            (Resource::As, self.memory, self.memory),
            // At the limit comes a signal of its own; whoever ignores it has a little time before it is killed.
            (Resource::Cpu, self.cpu, self.cpu + 2),
            (Resource::Fsize, self.file, self.file),
            (Resource::Core, 0, 0),
            (Resource::Nofile, 256, 256),
        ] {
            let limit = Rlimit { current: Some(limit), maximum: Some(maximum) };
            setrlimit(resource, limit).with_context(|| format!("cannot limit {resource:?}"))?;
        }
        if self.closed {
            let descriptor = descriptor(program)?;
            self.close_files().context("there is no Landlock, or one older than Linux 6.2's")?;
            calls::restrict(self.role)?;
            if self.role == Role::Program {
                return become_program(&descriptor, command);
            }
        }
        Err(Command::new(program).args(arguments).exec())
            .with_context(|| format!("cannot run {}", program.display()))
    }

    /// Leaves this process the named files only.
    fn close_files(&self) -> anyhow::Result<()> {
        // ABI 3 is the first one under which a file cannot be truncated; ABI 5 adds devices. Nothing less will
        // do, more is welcome.
        let (least, most) = (ABI::V3, ABI::V5);
        let read = AccessFs::ReadFile | AccessFs::ReadDir;
        let write = match self.role {
            Role::Program => AccessFs::WriteFile.into(),
            Role::Compiler | Role::Linker => read | AccessFs::from_write(least),
        };
        let ruleset = Ruleset::default()
            .set_compatibility(CompatLevel::HardRequirement)
            .handle_access(AccessFs::from_all(least))?
            .set_compatibility(CompatLevel::BestEffort)
            .handle_access(AccessFs::from_all(most))?
            .create()?
            .add_rules(path_beneath_rules(&self.read, read))?
            .add_rules(path_beneath_rules(&self.run, read | AccessFs::Execute))?
            .add_rules(path_beneath_rules(&self.write, write))?
            .add_rules([device("/dev/null", read | AccessFs::WriteFile)].into_iter().flatten())?;
        let status = ruleset.restrict_self()?;
        ensure!(status.ruleset != RulesetStatus::NotEnforced, "Landlock is not there");
        Ok(())
    }
}

/// Closes all descriptors but the standard ones: whoever started the grader may have left some open.
fn close_descriptors() -> anyhow::Result<()> {
    let names: Vec<_> =
        std::fs::read_dir("/proc/self/fd")?.map(|entry| entry.map(|e| e.file_name())).collect();
    for name in names {
        let number: i32 = name?.to_str().context("it has no name")?.parse()?;
        if number > 2 {
            // The one by which the folder was read is closed already.
            let _ = nix::unistd::close(number);
        }
    }
    Ok(())
}

/// A program's file, under a number that no file gets that is opened later: so the system call that makes this process that
/// program can be told from all later ones.
fn descriptor(program: &OsStr) -> anyhow::Result<OwnedFd> {
    let file = File::open(program).with_context(|| format!("cannot read {}", program.display()))?;
    let descriptor = fcntl_dupfd_cloexec(&file, calls::PROGRAM).context("cannot name the program")?;
    ensure!(descriptor.as_raw_fd() == calls::PROGRAM, "cannot name the program");
    let least = Rlimit { current: Some(DESCRIPTORS), maximum: Some(DESCRIPTORS) };
    setrlimit(Resource::Nofile, least).context("cannot limit Nofile")?;
    Ok(descriptor)
}

/// Becomes a program that cannot become another one.
fn become_program(descriptor: &OwnedFd, command: &[OsString]) -> anyhow::Result<Infallible> {
    let words: Vec<CString> =
        command.iter().map(|word| CString::new(word.as_bytes())).collect::<Result<_, _>>()?;
    let variables: [CString; 0] = [];
    nix::unistd::execveat(descriptor, c"", &words, &variables, AtFlags::AT_EMPTY_PATH)
        .with_context(|| format!("cannot run {}", command[0].display()))
}

/// Access to a device, if it is there.
fn device(
    path: &str,
    access: BitFlags<AccessFs>,
) -> Option<Result<PathBeneath<PathFd>, landlock::RulesetError>> {
    let access = access & AccessFs::from_file(ABI::V3);
    PathFd::new(path).ok().map(|device| Ok(PathBeneath::new(device, access)))
}

/// Folders with the system's libraries, for programs that load them when they start.
pub(crate) fn libraries() -> Vec<PathBuf> {
    existing(&["/lib", "/lib64", "/usr/lib", "/usr/lib64", "/etc/ld.so.cache"])
}

/// Folders with the system's compiler and linker.
pub(crate) fn tools() -> Vec<PathBuf> {
    existing(&["/bin", "/usr/bin", "/usr/libexec"])
}

fn existing(paths: &[&str]) -> Vec<PathBuf> {
    paths.iter().map(PathBuf::from).filter(|path| path.exists()).collect()
}
