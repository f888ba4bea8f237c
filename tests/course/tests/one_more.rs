//! What it takes to add a lesson.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use tasks::{COURSE, lessons};

use crate::copy::{Copy, copy};

/// The new lesson is this one under another name: it has all that a lesson has.
const MODEL: &str = "02-wireframe";

/// Outside of the lesson's own folders: a file, and a line that goes behind the last one that holds these words.
const LINES: &[(&str, &str, &str)] = &[
    ("Cargo.toml", "{ path = \"lessons/", "toy = { path = \"lessons/NN-toy\" }"),
    ("book/charts/Cargo.toml", "wireframe.workspace = true", "toy.workspace = true"),
    ("book/charts/src/lessons.rs", "pub(crate) mod ", "#[path = \"../../lessons/NN-toy/mod.rs\"]"),
    ("book/charts/src/lessons.rs", "#[path = ", "pub(crate) mod toy;"),
    ("book/charts/src/lessons.rs", "::LESSON,", "    toy::LESSON,"),
];

#[test]
#[ignore = "minutes; for the course's own CI"]
fn a_lesson_is_added_by_at_most_eight_lines_in_at_most_six_files_beside_its_folders() {
    let course = Copy::new();
    let number = 1 + lessons(&course.root).expect("the course can be read").len();
    let lesson = format!("{number:02}-toy");

    // Its own folders, and its measurements, as `charts` would write them.
    for parent in ["lessons", "tests/lessons", "book/lessons"] {
        copy(&course.root.join(parent).join(MODEL), &course.root.join(parent).join(&lesson), &[]);
        rename(&course.root.join(parent).join(&lesson), number);
    }
    let charts = course.root.join("book/pages/charts");
    for path in files(&charts) {
        let name = path.file_name().and_then(|name| name.to_str()).expect("names are text");
        if let Some(rest) = name.strip_prefix(MODEL) {
            fs::copy(&path, charts.join(lesson.clone() + rest)).expect("a file can be copied");
        }
    }

    // Everything else.
    for (file, words, line) in LINES {
        let path = course.root.join(file);
        let text = fs::read_to_string(&path).expect("it is text");
        let mut lines: Vec<&str> = text.lines().collect();
        let last = lines.iter().rposition(|line| line.contains(words));
        let line = line.replace("NN-toy", &lesson);
        lines.insert(last.unwrap_or_else(|| panic!("{file}: nothing like {words:?}")) + 1, &line);
        fs::write(&path, lines.join("\n") + "\n").expect("it can be written");
    }
    // The README's row is written by a command, but counts.
    succeeds(&course.book(&["methods"]));
    let added = added(&course.root, &lesson);
    let count: usize = added.values().sum();
    assert!(added.len() <= 6 && count <= 8, "{count} lines: {added:?}");
    println!("{count} lines in {} files: {added:?}", added.len());

    // It is a lesson: it draws, its tests are run and found complete, it has a mission and a chapter.
    succeeds(&course.cargo(&["run", "--package=toy", "--", "--quiet", "--out=toy.png"]));
    succeeds(&course.cargo(&["test", "--package=toy", "--package=toy-tests", "--package=toy-tasks"]));
    // One of these adds the same lesson.
    succeeds(&course.cargo(&["test", "--package=course", "--", "--skip=a_lesson_more"]));
    let mission = course.cargo(&["run", "--package=my-toy"]);
    let said = String::from_utf8_lossy(&mission.stderr).into_owned();
    assert!(said.contains("Nothing is written yet."), "{said}");
    let listed = course.cargo(&["run", "--package=course"]);
    succeeds(&listed);
    let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
    let row = |line: &str| line.contains(&format!(" {number}  Toy ")) && line.contains(" my-toy ");
    assert!(listed.contains(&format!(" of {number} missions done\n")) && listed.lines().any(row), "{listed}");
    succeeds(&course.book(&[]));
    let page = course.root.join(format!("target/book/{lesson}.html"));
    assert!(page.exists(), "{}", page.display());
}

/// Under a folder of its own, a lesson gets its own name and number.
fn rename(folder: &Path, number: usize) {
    for path in files(folder) {
        // A picture stays as it is.
        let Ok(text) = fs::read_to_string(&path) else { continue };
        let text = text
            .replace(MODEL, &format!("{number:02}-toy"))
            .replace("wireframe", "toy")
            .replace("Wireframe", "Toy")
            .replace("number: 2,", &format!("number: {number},"))
            .replace("Lesson 2", &format!("Lesson {number}"));
        fs::write(&path, text).expect("it can be written");
    }
}

/// All files in a folder and those below.
pub(crate) fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder can be read");
    let paths = entries.map(|entry| entry.expect("the folder can be read").path());
    paths.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

/// The lines of the changed course that the course has not, by file, but for those that a program writes and those in
/// the lesson's own folders.
fn added(changed: &Path, lesson: &str) -> BTreeMap<PathBuf, usize> {
    let mut added = BTreeMap::new();
    for entry in fs::read_dir(changed).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let paths = match path.file_name().and_then(|name| name.to_str()) {
            Some("target" | "out" | "Cargo.lock" | "toy.png") => continue,
            _ if path.is_dir() => files(&path),
            _ => vec![path],
        };
        for path in paths {
            let name = path.strip_prefix(changed).expect("it is below");
            let own = name.components().any(|part| part.as_os_str() == lesson);
            if own || name.starts_with("book/pages/charts") {
                continue;
            }
            let text =
                |path: &Path| String::from_utf8_lossy(&fs::read(path).unwrap_or_default()).into_owned();
            let (before, after) = (text(&Path::new(COURSE).join(name)), text(&path));
            let before: Vec<&str> = before.lines().collect();
            let count = after.lines().filter(|line| !before.contains(line)).count();
            if count > 0 {
                added.insert(name.to_path_buf(), count);
            }
        }
    }
    added
}

fn succeeds(output: &Output) {
    let said = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
    assert!(output.status.success(), "{}", said.join("\n"));
}
