//! The proof that the walls hold: before anything is graded, a program of ours tries them all.

use std::fs::File;
use std::net::{TcpListener, UdpSocket};
use std::os::unix::net::UnixDatagram;
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, anyhow};
use rustix::process::{Signal, getppid, test_kill_process};
use serde::{Deserialize, Serialize};

use crate::process::{End, finish};
use crate::run::{CPU, FILE, MEMORY};
use crate::walls::{self, Role, Walls};

/// A wall, and whether it was seen to hold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Wall {
    /// Against what.
    pub(crate) against: String,
    /// What it is made of.
    pub(crate) made_of: String,
    /// Whether the attempt failed.
    pub(crate) held: bool,
}

/// What a prisoner tries: against what the wall is, what it is made of, and whether it held.
type Attempt = (&'static str, &'static str, fn(&Path) -> bool);

const ATTEMPTS: [Attempt; 8] = [
    ("reading the instructor's files", "Landlock", |folder| {
        File::open(folder.join("secret")).is_err() && std::fs::read_dir(folder).is_err()
    }),
    ("writing and deleting", "Landlock", |folder| {
        File::create(folder.join("written")).is_err() && std::fs::remove_file(folder.join("deleted")).is_err()
    }),
    ("asking which files there are", "seccomp", |folder| {
        std::fs::metadata(folder.join("secret")).is_err_and(|error| error.raw_os_error() == Some(libc::EPERM))
    }),
    ("network, TCP, UDP and local", "seccomp", |_| {
        let ip = TcpListener::bind("127.0.0.1:0").is_err() && UdpSocket::bind("127.0.0.1:0").is_err();
        ip && UnixDatagram::unbound().is_err()
    }),
    ("processes and threads", "seccomp", |_| {
        // Refused at birth: to be born and not find its program would be another error.
        let process =
            Command::new("/bin/true").spawn().is_err_and(|error| error.raw_os_error() == Some(libc::EPERM));
        process && std::thread::Builder::new().spawn(|| ()).is_err()
    }),
    ("another program in its place", "seccomp", |_| {
        // Where the wall is not up, it must not become one: this one is not there.
        Command::new("/dev/null/none").exec().raw_os_error() == Some(libc::EPERM)
    }),
    ("signals to other processes", "seccomp", |_| {
        getppid().is_some_and(|parent| test_kill_process(parent).is_err())
    }),
    ("memory", "resource limit, 1 GiB", |_| Vec::<u8>::new().try_reserve_exact(MEMORY as usize).is_err()),
];

/// Tries the walls from inside, in a folder that should be out of reach, and prints what held.
pub(crate) fn attempt(folder: &Path) -> anyhow::Result<()> {
    let held: Vec<bool> = ATTEMPTS.iter().map(|(.., attempt)| attempt(folder)).collect();
    println!("{}", serde_json::to_string(&held)?);
    Ok(())
}

/// Uses up what is limited: CPU time, or space for output.
pub(crate) fn exhaust(what: &str) -> anyhow::Result<()> {
    let line = "x".repeat(1 << 16);
    loop {
        if what == "output" {
            println!("{line}");
        }
    }
}

/// Tries all walls. Those that are meant to be open are tried, too.
pub(crate) fn prove(closed: bool) -> anyhow::Result<Vec<Wall>> {
    let folder = tempfile::tempdir().context("cannot make a temporary folder")?;
    ["secret", "deleted"].iter().try_for_each(|name| std::fs::write(folder.path().join(name), "secret"))?;
    let run = |arguments: &[&str], cpu: u64, file: u64, patience: Duration| -> anyhow::Result<_> {
        let own = std::env::current_exe().context("cannot find the grader itself")?;
        let run = [walls::libraries(), vec![own.clone()]].concat();
        let (read, write) = (vec![], vec![]);
        let walls = Walls { closed, role: Role::Program, read, run, write, memory: MEMORY, cpu, file };
        let output = tempfile::tempfile()?;
        let mut command = walls.command(&own)?;
        command.args(arguments).stdout(output.try_clone()?).stderr(output.try_clone()?);
        let end = finish(&mut command, patience)?;
        Ok((end, output))
    };
    // On a busy machine a second of CPU time is long.
    let patience = Duration::from_secs(600);

    let path = folder.path().to_str().context("the folder of temporary files is not UTF-8")?;
    let (_, mut output) = run(&["try", path], CPU, FILE, patience)?;
    std::io::Seek::rewind(&mut output)?;
    let said = std::io::read_to_string(output)?;
    // Nothing is known of walls that were not built: the launcher said why.
    let said = said.trim().trim_start_matches("error: ");
    let held: Vec<bool> = serde_json::from_str(said).map_err(|_| anyhow!("{said}"))?;
    let mut walls: Vec<Wall> = (ATTEMPTS.iter().zip(held))
        .map(|((against, made_of, _), held)| wall(against, made_of, held))
        .collect();

    let killed =
        |end: &End, by: Signal| matches!(end, End::Ran(status) if status.signal() == Some(by.as_raw()));
    let (end, _) = run(&["exhaust", "time"], 1, FILE, patience)?;
    walls.push(wall("CPU time", &format!("resource limit, {CPU} s"), killed(&end, Signal::XCPU)));
    let (end, output) = run(&["exhaust", "output"], CPU, 1 << 20, patience)?;
    let small = output.metadata()?.len() <= 1 << 20;
    let made_of = format!("resource limit, {} MiB", FILE >> 20);
    walls.push(wall("output and large files", &made_of, killed(&end, Signal::XFSZ) && small));
    let (end, _) = run(&["exhaust", "time"], CPU, FILE, Duration::from_millis(300))?;
    walls.push(wall("wall time", "the grader stops it", matches!(end, End::PutOff(_))));
    Ok(walls)
}

fn wall(against: &str, made_of: &str, held: bool) -> Wall {
    Wall { against: against.into(), made_of: made_of.into(), held }
}
