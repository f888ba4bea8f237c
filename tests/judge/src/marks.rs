//! How far a student is: the marks of the missions' last runs, and which mission comes next.
//!
//! The mark of a mission is kept in a file of its own, `out/my-NN-name.mark`, beside the picture of the same run: two
//! missions that run at the same time write two files, a file that is broken costs one mark, and `cargo clean`, which
//! empties `target/`, costs none. Its first line is the mark; after it stands the student's file as it was judged, so
//! that it can be told whether that has changed since.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use anyhow::Context;
use common::file::write_whole;
use common::printable::shown;
use tasks::name;

/// The points from which on a student is told where the lesson's own code is explained, of 10.
pub const ENOUGH: u32 = 8;

/// The longest file that is taken for a mark, in bytes.
const LIMIT: u64 = 1 << 20;

/// What the first line of a mark says after the points.
const HEAD: &str = " points for this text:";

/// A mission, and how far the student is with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// Number and name, as in `01-lines`.
    pub lesson: String,
    /// The mark of its last run; `None` where it was not run yet.
    pub mark: Option<Mark>,
    /// Why there is no mark though there is a file for it, in a line.
    pub broken: Option<String>,
}

/// What a run was worth.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The points.
    pub earned: u32,
    /// The points that there are.
    pub of: u32,
    /// Whether the student's file is another one now.
    pub changed: bool,
    /// When that was.
    when: SystemTime,
}

impl Standing {
    /// Reads the mark of a lesson's mission in a course's folder.
    fn read(course: &Path, lesson: &str) -> Self {
        let path = file(lesson);
        let none = Self { lesson: lesson.into(), mark: None, broken: None };
        let broken = |why: &str| {
            let broken = Some(format!("{}: {why}; the mission's next run replaces it", shown(&path)));
            Self { broken, ..none.clone() }
        };
        let (text, when) = match text_of(&course.join(&path)) {
            Ok(Some(kept)) => kept,
            Ok(None) => return broken("not a mark of this course"),
            Err(error) if error.kind() == ErrorKind::NotFound => return none,
            Err(error) => return broken(&format!("cannot be read ({error})")),
        };
        let Some((earned, of, judged)) = parse(&text) else { return broken("not a mark of this course") };
        let now = fs::read_to_string(source(course, lesson));
        let mark = Mark { earned, of, changed: now.ok().as_deref() != Some(judged), when };
        Self { mark: Some(mark), ..none }
    }

    /// Whether all of it is right.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.mark.as_ref().is_some_and(|mark| mark.earned == mark.of)
    }

    /// Whether the student may be told where the lesson's own code is explained.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.mark.as_ref().is_some_and(|mark| 10 * mark.earned >= ENOUGH * mark.of)
    }
}

/// All missions of a course, in order, with their marks.
///
/// # Errors
/// Where the folder of the lessons cannot be read.
pub fn standings(course: &Path) -> anyhow::Result<Vec<Standing>> {
    let lessons = tasks::lessons(course).with_context(|| format!("{} is not the course", shown(course)))?;
    Ok(lessons.iter().map(|lesson| Standing::read(course, lesson)).collect())
}

/// The mission at hand: the one that was run last or, where that is done, the first one behind it that is not, or else
/// the first of all that is not. `None` where all are done.
#[must_use]
pub fn current(standings: &[Standing]) -> Option<&Standing> {
    let run = standings.iter().enumerate().filter_map(|(n, one)| Some((one.mark.as_ref()?.when, n)));
    let last = run.max().map_or(0, |(_, n)| n);
    standings[last..].iter().chain(&standings[..last]).find(|one| !one.is_done())
}

/// The student's file of a lesson's mission.
#[must_use]
pub fn source(course: &Path, lesson: &str) -> PathBuf {
    course.join("lessons").join(lesson).join("mission/src/lib.rs")
}

/// Keeps the mark of a run on that text.
///
/// # Errors
/// Where it cannot be written.
pub fn keep(course: &Path, lesson: &str, (earned, of): (u32, u32), text: &str) -> anyhow::Result<()> {
    fs::create_dir_all(course.join("out")).context("cannot create the folder out/")?;
    write_whole(&course.join(file(lesson)), format!("{earned} of {of}{HEAD}\n{text}").as_bytes())?;
    Ok(())
}

/// What the end of a lesson's mission says: how far one is, and what comes next.
///
/// # Errors
/// Where the folder of the lessons cannot be read.
pub(crate) fn onward(course: &Path, lesson: &str) -> anyhow::Result<String> {
    let standings = standings(course)?;
    let done = standings.iter().filter(|one| one.is_done()).count();
    let own = standings.iter().find(|one| one.lesson == lesson);
    let mut text = format!("{done} of {} missions done", standings.len());
    text += &match current(&standings) {
        None => ": that is all of them.\n".into(),
        Some(next) if next.lesson == lesson => {
            ". Stuck? `cargo run -p course -- hint` opens a hint of the chapter.\n".into()
        }
        Some(next) => format!("; next, {}: `cargo run -p course -- next`\n", name(&next.lesson)),
    };
    if own.is_some_and(Standing::is_enough) {
        text += "Where our own code is explained: `cargo run -p course -- solution ";
        text += &format!("{}`\n", name(lesson));
    }
    Ok(text)
}

/// Where a mark is kept, from the course's folder.
fn file(lesson: &str) -> PathBuf {
    Path::new("out").join(format!("my-{lesson}.mark"))
}

/// A file's text, and when it was written; `None` where it cannot be a mark.
fn text_of(path: &Path) -> std::io::Result<Option<(String, SystemTime)>> {
    let about = fs::metadata(path)?;
    if !about.is_file() || about.len() > LIMIT {
        return Ok(None);
    }
    let text = String::from_utf8(fs::read(path)?).ok();
    text.map(|text| Ok((text, about.modified()?))).transpose()
}

/// The points, those that there are, and the text that was judged.
fn parse(mark: &str) -> Option<(u32, u32, &str)> {
    let (head, text) = mark.split_once('\n')?;
    let (earned, of) = head.strip_suffix(HEAD)?.split_once(" of ")?;
    let (earned, of) = (earned.parse().ok()?, of.parse().ok()?);
    (earned <= of && of > 0).then_some((earned, of, text))
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use tempfile::{TempDir, tempdir};

    use super::*;

    /// A course of three lessons.
    fn course() -> TempDir {
        let course = tempdir().unwrap();
        for lesson in ["01-one", "02-two", "03-three"] {
            let mission = course.path().join("lessons").join(lesson).join("mission");
            fs::create_dir_all(mission.join("src")).unwrap();
            fs::write(mission.join("Cargo.toml"), "").unwrap();
            fs::write(mission.join("src/lib.rs"), "mine\n").unwrap();
        }
        course
    }

    /// Keeps marks in this order, a minute after each other.
    fn run(course: &Path, marks: &[(&str, u32)]) {
        for (minutes, (lesson, points)) in marks.iter().enumerate() {
            keep(course, lesson, (*points, 10), "mine\n").unwrap();
            let file = fs::File::options().append(true).open(course.join(file(lesson))).unwrap();
            file.set_modified(SystemTime::UNIX_EPOCH + Duration::from_secs(60 * minutes as u64)).unwrap();
        }
    }

    #[test]
    fn a_mark_is_of_a_text() {
        let course = course();
        let course = course.path();
        assert_eq!(Standing::read(course, "02-two").mark, None);
        run(course, &[("02-two", 7)]);
        let mark = || Standing::read(course, "02-two").mark.unwrap();
        assert_eq!((mark().earned, mark().of, mark().changed), (7, 10, false));
        fs::write(source(course, "02-two"), "mine, better\n").unwrap();
        assert_eq!((mark().earned, mark().of, mark().changed), (7, 10, true));
        fs::remove_file(source(course, "02-two")).unwrap();
        assert!(mark().changed);
    }

    #[test]
    fn what_is_no_mark_is_one_line() {
        let course = course();
        let course = course.path();
        run(course, &[("01-one", 10)]);
        let file = course.join(file("01-one"));
        let long = format!("1 of 10{HEAD}\n{}", "x".repeat(LIMIT as usize));
        for bytes in [
            &b""[..],
            b"10 of 10 points for this text:",
            b"11 of 10 points for this text:\n",
            b"0 of 0 points for this text:\n",
            b"-1 of 10 points for this text:\n",
            b"99999999999 of 10 points for this text:\n",
            b"fn main() {}\n",
            b"5 of 10 points for this text:\n\xff\xfe",
            long.as_bytes(),
        ] {
            fs::write(&file, bytes).unwrap();
            let one = &standings(course).unwrap()[0];
            let said = one.broken.as_deref().unwrap();
            assert!(one.mark.is_none() && said.lines().count() == 1, "{said}");
            assert!(
                said.ends_with(
                    "my-01-one.mark: not a mark of this course; the mission's next run replaces it"
                )
            );
        }
        fs::remove_file(&file).unwrap();
        fs::create_dir(&file).unwrap();
        assert!(Standing::read(course, "01-one").broken.is_some());
        // The others' marks are theirs.
        run(course, &[("02-two", 10)]);
        assert!(standings(course).unwrap()[1].is_done());
    }

    #[test]
    fn the_mission_at_hand() {
        for (marks, expected) in [
            (&[][..], Some("01-one")),
            (&[("01-one", 9)], Some("01-one")),
            (&[("01-one", 10)], Some("02-two")),
            (&[("01-one", 9), ("02-two", 10)], Some("03-three")),
            (&[("02-two", 0), ("01-one", 9)], Some("01-one")),
            (&[("01-one", 9), ("02-two", 3)], Some("02-two")),
            (&[("01-one", 9), ("03-three", 10)], Some("01-one")),
            (&[("02-two", 10), ("03-three", 10), ("01-one", 10)], None),
        ] {
            let course = course();
            run(course.path(), marks);
            let all = standings(course.path()).unwrap();
            assert_eq!(current(&all).map(|one| one.lesson.as_str()), expected, "{marks:?}");
        }
    }

    #[test]
    fn the_end_of_a_run_says_what_comes_next() {
        let course = course();
        let told = |marks: &[(&str, u32)], lesson: &str| {
            run(course.path(), marks);
            onward(course.path(), lesson).unwrap()
        };
        let hint =
            "0 of 3 missions done. Stuck? `cargo run -p course -- hint` opens a hint of the chapter.\n";
        let solution = "Where our own code is explained: `cargo run -p course -- solution one`\n";
        assert_eq!(told(&[("01-one", 7)], "01-one"), hint);
        assert_eq!(told(&[("01-one", 8)], "01-one"), hint.to_string() + solution);
        let next = "1 of 3 missions done; next, two: `cargo run -p course -- next`\n";
        assert_eq!(told(&[("01-one", 10)], "01-one"), next.to_string() + solution);
        let all = told(&[("02-two", 10), ("03-three", 10)], "03-three");
        assert!(all.starts_with("3 of 3 missions done: that is all of them.\n"), "{all}");
    }
}
