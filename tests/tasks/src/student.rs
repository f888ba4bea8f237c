//! A student's program. It does the tasks with what the student wrote; the lesson's judge, which starts it for
//! that, says what is right and what is not.

use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::process::{Command, ExitCode, ExitStatus};
use std::sync::Mutex;
use std::time::{Duration, SystemTime};

use anyhow::{Context, bail, ensure};
use common::terminal::{eprintln, print};

use super::{Answer, COURSE, Mission, name};

/// How often `--watch` looks whether a file was saved.
const GLANCE: Duration = Duration::from_millis(200);

const USAGE: &str = "flags: --watch (run again whenever you save), --quiet (no picture in the terminal)";

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
            ["--answer", file, from, seed] => self.answer(student, file, from, seed),
            ["--watched", folder] => std::env::set_current_dir(folder)
                .map_err(Into::into)
                .and_then(|()| self.judge("show", &[]))
                // Cargo would have something to say about a failure.
                .map(|_| ExitCode::SUCCESS),
            words if testing => self.judge("test", words),
            [] => self.judge("show", &[]),
            ["--quiet"] => self.judge("tell", &[]),
            ["--watch"] => self.watch(),
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

    /// Does the tasks from the number `from` on and appends their answers to a file, a line each.
    fn answer(&self, student: &F, file: &str, from: &str, seed: &str) -> anyhow::Result<ExitCode> {
        static SAID: Mutex<String> = Mutex::new(String::new());
        std::panic::set_hook(Box::new(|panic| {
            let place = panic.location().map(|at| format!("{}:{}", at.file().replace('\\', "/"), at.line()));
            let said = panic.payload_as_str().unwrap_or("a panic without a message");
            if let Ok(mut last) = SAID.lock() {
                *last = format!("{}: {said}", place.unwrap_or_default());
            }
        }));
        let mut file = std::fs::OpenOptions::new().append(true).open(file)?;
        for task in self.tasks(seed.parse()?).into_iter().flatten().skip(from.parse()?) {
            let answer = match catch_unwind(AssertUnwindSafe(|| (task.work)(student))) {
                Ok(raw) => Answer::Raw(raw),
                Err(_) => {
                    let said = SAID.lock().map(|said| said.clone()).unwrap_or_default();
                    // The words with which `todo!` begins.
                    match said.split_once(": not yet implemented") {
                        Some((place, hint)) => Answer::Unwritten(format!("{place}{hint}")),
                        None => Answer::Crashed(said),
                    }
                }
            };
            file.write_all(format!("{answer}\n").as_bytes())?;
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
    fn watch(&self) -> anyhow::Result<ExitCode> {
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
                .status()
                .context(NO_CARGO)?;
            print(&format!("watching {}; Ctrl+C ends\n", source.display()))?;
            while saved() == before {
                std::thread::sleep(GLANCE);
            }
        }
    }
}

const NO_CARGO: &str = "cannot start cargo, which builds and runs the judge";

/// A command of Cargo's on a package of this course, built as this program was.
fn cargo(command: &str, package: &str) -> Command {
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
