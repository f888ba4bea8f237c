//! A student's program. It does the tasks with what the student wrote; the lesson's judge, which starts it for
//! that, says what is right and what is not.

use std::cell::RefCell;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::path::PathBuf;
use std::process::{Command, ExitCode, ExitStatus};
use std::sync::Once;
use std::time::{Duration, SystemTime};

use anyhow::{Context, bail, ensure};
use common::terminal::{eprintln, print};

use super::{Answer, COURSE, Mission, Task, name};

/// How often `--watch` looks whether a file was saved.
const GLANCE: Duration = Duration::from_millis(200);

const USAGE: &str = "flags: --watch (run again whenever you save), --quiet (no picture in the terminal), \
                     --check NAME (only this one), --input N (print an input as Rust, for a test of your own)";

impl<F> Mission<F> {
    /// Runs the mission on what a student wrote. `testing` is `cfg!(test)` of the caller: verdicts are then told
    /// in the manner of `cargo test`.
    ///
    /// The exit code is 0 if everything is right, 1 if not, 2 where the command line is at fault.
    #[must_use]
    pub fn run(&self, student: &F, testing: bool) -> ExitCode {
        let arguments: Vec<String> = std::env::args().skip(1).collect();
        let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let result = match words.as_slice() {
            ["--answer", file, from] => self.answer(student, file, from, None),
            ["--answer", file, from, check] => self.answer(student, file, from, Some(check)),
            ["--watched", folder, words @ ..] => std::env::set_current_dir(folder)
                .map_err(Into::into)
                .and_then(|()| self.judge("show", words))
                // Cargo would have something to say about a failure.
                .map(|_| ExitCode::SUCCESS),
            words if testing => self.judge("test", words),
            ["--input", number] => self.judge("input", &[number]),
            [] => self.judge("show", &[]),
            ["--quiet"] => self.judge("tell", &[]),
            ["--watch"] => self.watch(&[]),
            ["--check", check] => self.judge("show", &[check]),
            ["--check", check, "--quiet"] | ["--quiet", "--check", check] => self.judge("tell", &[check]),
            ["--check", check, "--watch"] | ["--watch", "--check", check] => self.watch(&[check]),
            _ => {
                eprintln(USAGE);
                return ExitCode::from(2);
            }
        };
        result.unwrap_or_else(|error| {
            eprintln(format_args!("error: {error:#}"));
            ExitCode::FAILURE
        })
    }

    /// Does the tasks, or those of one check, from the number `from` on and appends their answers to a file, a line
    /// each. The seed comes on the standard input: arguments can be read again by what the student wrote.
    fn answer(&self, student: &F, file: &str, from: &str, check: Option<&str>) -> anyhow::Result<ExitCode> {
        let mut file = std::fs::OpenOptions::new().append(true).open(file)?;
        let seed = std::io::read_to_string(std::io::stdin())?;
        let rows = self.checks.iter().zip(self.tasks(seed.trim().parse()?));
        let asked = rows.filter(|(own, _)| check.is_none_or(|check| own.name == check));
        for task in asked.flat_map(|(_, tasks)| tasks).skip(from.parse()?) {
            file.write_all(format!("{}\n", attempt(&task, student)).as_bytes())?;
        }
        Ok(ExitCode::SUCCESS)
    }

    /// Has the lesson's judge start this program again for its answers, and tell what it finds in a way: `show`,
    /// `tell` (without the picture) or `test`.
    fn judge(&self, way: &str, words: &[&str]) -> anyhow::Result<ExitCode> {
        let own = std::env::current_exe().context("cannot find this program")?;
        let [package, judge] = ["tests", "judge"].map(|kind| format!("{}-{kind}", name(self.lesson)));
        // The first time, building it takes a while, and Cargo says so.
        let file = format!("{judge}{}", std::env::consts::EXE_SUFFIX);
        let built = own.ancestors().skip(1).take(2).any(|folder| folder.join(&file).exists());
        if !built {
            let status = cargo("build", &package).status().context(NO_CARGO)?;
            ensure!(status.success(), "{judge} cannot be built");
        }
        let mut judging = cargo("run", &package);
        judging.arg("--quiet").arg("--").arg(way).arg(own).args(words);
        Ok(code(judging.status().context(NO_CARGO)?))
    }

    /// Runs the mission, and again whenever its source is saved.
    ///
    /// Cargo builds it as a test: a program that runs, as this one does, cannot be replaced on every system.
    fn watch(&self, words: &[&str]) -> anyhow::Result<ExitCode> {
        let package = format!("my-{}", name(self.lesson));
        let Some(folder) = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from) else {
            bail!("--watch needs cargo: cargo run -p {package} -- --watch");
        };
        let source = folder.join("src/lib.rs");
        let saved = || -> Option<SystemTime> { std::fs::metadata(&source).ok()?.modified().ok() };
        ensure!(saved().is_some(), "cannot read {}", source.display());
        loop {
            let before = saved();
            cargo("test", &package)
                .args(["--quiet", "--bin", &package, "--", "--watched"])
                .arg(std::env::current_dir()?)
                .args(words)
                .status()
                .context(NO_CARGO)?;
            print(&format!("watching {}; Ctrl+C ends\n", source.display()))?;
            while saved() == before {
                std::thread::sleep(GLANCE);
            }
        }
    }
}

/// Does a task. A panic is an answer, too, and prints nothing.
pub fn attempt<F>(task: &Task<F>, functions: &F) -> Answer {
    thread_local! {
        /// What a panic said; `None` where there is no task at hand.
        static SAID: RefCell<Option<String>> = const { RefCell::new(None) };
    }
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |panic| {
            if SAID.with_borrow(Option::is_none) {
                return usual(panic);
            }
            let place = panic.location().map(|at| format!("{}:{}", at.file().replace('\\', "/"), at.line()));
            let said = panic.payload_as_str().unwrap_or("a panic without a message");
            SAID.set(Some(format!("{}: {said}", place.unwrap_or_default())));
        }));
    });
    SAID.set(Some(String::new()));
    let result = catch_unwind(AssertUnwindSafe(|| (task.work)(functions)));
    let said = SAID.take().unwrap_or_default();
    match result {
        Ok(raw) => Answer::Raw(raw),
        // The words with which `todo!` begins.
        Err(_) => match said.split_once(": not yet implemented") {
            Some((place, hint)) => Answer::Unwritten(format!("{place}{hint}")),
            None => Answer::Crashed(said),
        },
    }
}

const NO_CARGO: &str = "cannot start cargo, which builds and runs the judge";

/// A command of Cargo's on a package of this course, built as this program was.
#[must_use]
pub fn cargo(command: &str, package: &str) -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args([command, "--manifest-path"]).arg(format!("{COURSE}/Cargo.toml")).args(["--package", package]);
    if !cfg!(debug_assertions) {
        cargo.arg("--release");
    }
    cargo
}

/// How another program ended, as the end of this one.
fn code(status: ExitStatus) -> ExitCode {
    status.code().and_then(|code| u8::try_from(code).ok()).map_or(ExitCode::FAILURE, ExitCode::from)
}
