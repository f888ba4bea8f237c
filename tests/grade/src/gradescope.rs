//! Gradescope's autograder: the package that an instructor uploads, and what it does with a submission.
//!
//! Gradescope unpacks the zip file into `/autograder/source`, runs `setup.sh` once and `run_autograder` for each
//! submission, each in a container of its own:
//! <https://gradescope-autograders.readthedocs.io/en/latest/specs/>.

use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, anyhow, bail, ensure};
use askama::Template;
use clap::Args;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use crate::class::{self, Options};
use crate::report::Extras;
use crate::report::gradescope::{self, Visibility};
use crate::results::Outcome;
use crate::submission::Submission;
use crate::walls::Terms;
use crate::{file, kit, seed};

/// How submissions are graded there.
#[derive(Args)]
pub(crate) struct How {
    /// What the inputs are made from.
    #[arg(long)]
    seed: Option<u64>,
    /// When students see what was found in the checks; the points of those that they do not see are not told, either.
    #[arg(long, value_enum, default_value_t = Visibility::Visible)]
    visibility: Visibility,
    /// Run what students wrote without walls, should Gradescope's machines not have them: in a container that is thrown
    /// away, but beside the lessons' own solutions.
    #[arg(long)]
    unsafe_no_sandbox: bool,
}

/// `setup.sh`: installs what grading needs, and builds it.
#[derive(Template)]
#[template(path = "setup.sh", escape = "none")]
struct Setup {
    rust: &'static str,
    packages: Vec<String>,
}

/// `run_autograder`: grades a submission.
#[derive(Template)]
#[template(path = "run_autograder", escape = "none", ext = "txt")]
struct Run {
    arguments: String,
}

/// Builds the package: the same bytes for the same course, lessons and seed.
pub(crate) fn package(course: &Path, lessons: &[String], how: &How, out: &Path) -> anyhow::Result<()> {
    let seed = how.seed.map_or_else(seed::random, Ok)?;
    let numbers: Vec<&str> = lessons.iter().map(|lesson| tasks::number(lesson)).collect();
    let no_walls = if how.unsafe_no_sandbox { " --unsafe-no-sandbox" } else { "" };
    let (numbers, visibility) = (numbers.join(","), how.visibility.name());
    let arguments = format!("--lessons {numbers} --seed {seed} --visibility {visibility}{no_walls}");
    let packages = lessons.iter().flat_map(|lesson| [kit::package(lesson), kit::tests(lesson)]).collect();
    let setup = Setup { rust: env!("CARGO_PKG_RUST_VERSION"), packages };

    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let mut add = |name: &str, executable, text: &[u8]| -> anyhow::Result<()> {
        // No time of change is told, and of time to compress little is taken.
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        let options = options.compression_level(Some(1)).last_modified_time(DateTime::default());
        zip.start_file(name, options.unix_permissions(if executable { 0o755 } else { 0o644 }))?;
        Ok(zip.write_all(text)?)
    };
    add("setup.sh", true, setup.render()?.as_bytes())?;
    add("run_autograder", true, Run { arguments }.render()?.as_bytes())?;
    for (path, executable) in tracked(course)?.into_iter().filter(|(path, _)| needed(path)) {
        let text = std::fs::read(course.join(&path)).with_context(|| format!("cannot read {path}"))?;
        add(&format!("course/{path}"), executable, &text)?;
    }
    let bytes = zip.finish()?.into_inner();
    file::write(&std::path::absolute(out)?, &bytes)?;
    println!("{}: {:.1} MB, seed {seed}", out.display(), bytes.len() as f64 / 1e6);
    Ok(())
}

/// The course's files as Git knows them, in order, and whether each is a program.
fn tracked(course: &Path) -> anyhow::Result<Vec<(String, bool)>> {
    let said = kit::run(Command::new("git").current_dir(course).args(["ls-files", "--stage", "-z"]));
    let said = said.context("the package is made of the files that Git tracks")?;
    // Mode, object, stage, and behind a tab the path.
    let file = |line: &str| {
        let (about, path) = line.split_once('\t').context("Git lists files in another way")?;
        Ok((path.to_string(), about.starts_with("100755")))
    };
    let mut files = said.split_terminator('\0').map(file).collect::<anyhow::Result<Vec<_>>>()?;
    files.sort();
    files.dedup();
    ensure!(!files.is_empty(), "Git tracks no file of {}", course.display());
    Ok(files)
}

/// Whether something is built of a file: not of solutions, expected pictures, chapters, and what is for forges.
fn needed(path: &str) -> bool {
    let hidden = path.starts_with('.') && !path.starts_with(".cargo/");
    let code = path.ends_with(".rs") || path.ends_with(".toml");
    let shown = path.starts_with("book/") && !code || path.contains("/pictures/");
    !hidden && !shown && !path.ends_with("/solution.rs")
}

/// Grades what is in a folder, and writes the results that Gradescope reads.
///
/// # Errors
/// Where it could not be graded through no fault of the student. There is no file then, and Gradescope says that the autograder
/// failed, which is no 0.
pub(crate) fn autograde(
    submission: &Path,
    results: &Path,
    course: PathBuf,
    lessons: Vec<String>,
    how: &How,
) -> anyhow::Result<()> {
    let report = tempfile::tempdir().context("cannot make a temporary folder")?;
    let class = class::grade(&Options {
        submissions: vec![Submission::at(submission)],
        report: report.path().into(),
        course,
        seed: how.seed,
        lessons,
        shard: (1, 1),
        jobs: 1,
        regrade: Vec::new(),
        regrade_failed: false,
        extras: Extras::default(),
        terms: Terms { closed: !how.unsafe_no_sandbox, patience: Duration::from_secs(600) },
    })?;
    let works = class.submissions.values().next().ok_or_else(|| anyhow!("there is no submission"))?;
    let put_off =
        |work: &&crate::results::Work| matches!(work.outcome, Outcome::NotGraded(_)) && !work.text.is_empty();
    if let Some(Outcome::NotGraded(look)) = works.iter().find(put_off).map(|work| &work.outcome) {
        bail!("{look}");
    }
    let json = match gradescope::results(&class, works, how.visibility)? {
        Some(json) => json,
        None => gradescope::not_graded(&class)?,
    };
    file::write(&std::path::absolute(results)?, &json)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nothing_is_built_of_is_left_out() {
        for path in
            ["Cargo.lock", ".cargo/config.toml", "book/src/main.rs", "book/Cargo.toml", "assets/head.obj"]
        {
            assert!(needed(path), "{path}");
        }
        for path in [".ci/run", ".gitignore", "book/pages/setup.md", "tests/lessons/01-lines/solution.rs"] {
            assert!(!needed(path), "{path}");
        }
        assert!(!needed("tests/lessons/01-lines/pictures/a.png"));
    }
}
