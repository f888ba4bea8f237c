//! The book, opened at a mission's chapter.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, bail, ensure};
use common::printable::shown;
use common::terminal::print;

use super::Missions;

/// Programs that open a file in the browser that its user has chosen: the first one that there is does it. `wslview` is
/// that of Linux in Windows.
const OPENERS: &[&str] = if cfg!(windows) {
    &["explorer"]
} else if cfg!(target_os = "macos") {
    &["open"]
} else {
    &["xdg-open", "wslview"]
};

/// Opens the chapter of a mission, or of the one at hand, in a browser. Where the book is not there, or older than that
/// chapter, it is built first.
///
/// # Errors
/// Where there is no such mission, or the book cannot be built or opened.
pub fn open(missions: &Missions, which: Option<&str>) -> anyhow::Result<()> {
    let mission = missions.find(which)?;
    let page = missions.course.join("target/book").join(&mission.lesson).with_extension("html");
    let chapter = missions.course.join("book/lessons").join(&mission.lesson).join("chapter.md");
    if !is_newer(&page, &chapter) {
        print("The book is not built yet, or older than this chapter. That takes a minute or two, once.\n")?;
        ensure!(
            tasks::cargo("run", "book").status().context("cannot start cargo")?.success(),
            "the book cannot be built"
        );
    }
    // Windows' canonical paths begin in a way that browsers do not know.
    let page = if cfg!(windows) { std::path::absolute(&page) } else { page.canonicalize() };
    let page = page.context("cannot find the page")?;
    print(&format!("{}\n", shown(&page)))?;
    browse(&page)
}

fn browse(page: &Path) -> anyhow::Result<()> {
    for opener in OPENERS {
        let quiet = Stdio::null;
        let status = Command::new(opener).arg(page).stdin(quiet()).stdout(quiet()).stderr(quiet()).status();
        match status {
            // Windows' opener ends with 1 whatever happened.
            Ok(status) if status.success() || cfg!(windows) => return Ok(()),
            _ => (),
        }
    }
    bail!("no browser could be started ({}); open that page in one", OPENERS.join(", "))
}

fn is_newer(file: &Path, than: &Path) -> bool {
    let modified = |path: &Path| fs::metadata(path).and_then(|about| about.modified()).ok();
    modified(file).is_some_and(|file| modified(than).is_none_or(|than| file >= than))
}
