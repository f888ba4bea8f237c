//! A copy of the workspace, to be changed and built.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tasks::COURSE;

/// There is one copy, so that what one test builds need not be built by the next: they take turns.
static TURN: Mutex<()> = Mutex::new(());

/// A copy of the workspace, in the folder of build products, and what was built of it in earlier runs.
pub(crate) struct Copy {
    pub(crate) root: PathBuf,
    _turn: MutexGuard<'static, ()>,
}

impl Copy {
    pub(crate) fn new() -> Self {
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let root = Path::new(COURSE).join("target/missions");
        copy(Path::new(COURSE), &root, &[".git", "target", "out"]);
        Self { root, _turn: turn }
    }

    /// `cargo` with these arguments, in the copy.
    pub(crate) fn cargo(&self, arguments: &[&str]) -> Output {
        self.within(Command::new(env!("CARGO")).args(arguments)).output().expect("cargo can be started")
    }

    /// The copy's book, whose figures move by the course's code if they do.
    pub(crate) fn book(&self, arguments: &[&str]) -> Output {
        let mut cargo = Command::new(env!("CARGO"));
        let code = target().join("wasm32-unknown-unknown/live/live_wasm.wasm");
        if code.exists() {
            cargo.env("LIVE_CODE", code);
        }
        let book = cargo.args(["run", "--package=book", "--"]).args(arguments);
        self.within(book).output().expect("cargo can be started")
    }

    /// Has a program run in the copy, and what it builds built for a short wait. Other people's crates are those that were built
    /// for the course itself.
    pub(crate) fn within<'a>(&self, program: &'a mut Command) -> &'a mut Command {
        program
            .current_dir(&self.root)
            .env("CARGO_TARGET_DIR", target())
            .env("CARGO_PROFILE_DEV_OPT_LEVEL", "1")
            .env("CARGO_PROFILE_DEV_DEBUG", "none")
            .env("CARGO_TERM_COLOR", "never")
    }

    /// One of the copy's programs, once it is built.
    pub(crate) fn program(name: &str) -> PathBuf {
        target().join("debug").join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
    }
}

/// Where all is built.
fn target() -> PathBuf {
    Path::new(COURSE).join("target")
}

/// Makes a folder a copy of another, but for what is left out of both. A file that is the same already is left alone,
/// so that cargo does not build it again.
pub(crate) fn copy(from: &Path, to: &Path, left_out: &[&str]) {
    let names = |folder: &Path| -> Vec<_> {
        let entries = fs::read_dir(folder).expect("the folder can be read");
        let names = entries.map(|entry| entry.expect("the folder can be read").file_name());
        names.filter(|name| !left_out.iter().any(|left_out| name == left_out)).collect()
    };
    fs::create_dir_all(to).expect("a folder can be made");
    for name in names(to) {
        let (path, original) = (to.join(&name), from.join(&name));
        if path.is_dir() && !original.is_dir() {
            fs::remove_dir_all(path).expect("it is ours");
        } else if path.is_file() && !original.is_file() {
            fs::remove_file(path).expect("it is ours");
        }
    }
    for name in names(from) {
        let (path, original) = (to.join(&name), from.join(&name));
        if original.is_dir() {
            copy(&original, &path, &[]);
        } else {
            let bytes = fs::read(original).expect("the file can be read");
            if fs::read(&path).ok().as_ref() != Some(&bytes) {
                fs::write(path, bytes).expect("a file can be written");
            }
        }
    }
}
