//! What belongs to a lesson is there, and is found.

use std::fs;
use std::path::Path;

use tasks::{COURSE, lessons};

use crate::one_more::files;

#[test]
fn every_lesson_has_its_tests() {
    let course = Path::new(COURSE);
    let readme = fs::read_to_string(course.join("README.md")).expect("there is a README");
    for lesson in lessons(course).expect("the course can be read") {
        let folder = course.join("tests/lessons").join(&lesson);
        for file in ["Cargo.toml", "tasks/Cargo.toml", "judge.rs", "solution.rs", "pictures/default.snap"] {
            assert!(folder.join(file).exists(), "there is no tests/lessons/{lesson}/{file}");
        }
        let main = fs::read_to_string(folder.join("main.rs")).unwrap_or_default();
        for module in ["snapshots", "stability", "usage"] {
            let line = format!("\nmod {module};\n");
            assert!(main.contains(&line), "tests/lessons/{lesson}/main.rs has no `mod {module};`");
        }
        let judge = fs::read_to_string(folder.join("judge.rs")).unwrap_or_default();
        assert!(judge.contains("\nmod faults;\n"), "tests/lessons/{lesson}/judge.rs has no `mod faults;`");
        let row = format!("](lessons/{lesson}/src/lib.rs)");
        assert!(
            readme.lines().any(|line| line.starts_with('|') && line.contains(&row)),
            "README: no row of {lesson}"
        );
    }
}

/// Compiling a library once more for tests that it has not is waiting for nothing; leaving out those that it has would be worse.
#[test]
fn a_library_is_compiled_for_its_tests_if_it_has_some() {
    for lesson in lessons(Path::new(COURSE)).expect("the course can be read") {
        let folder = Path::new(COURSE).join("lessons").join(&lesson);
        let text = |path| fs::read_to_string(path).expect("it is text");
        let has_tests =
            files(&folder.join("src")).into_iter().any(|path| text(path).contains("#[cfg(test)]"));
        let is_tested = !text(folder.join("Cargo.toml")).contains("\n[lib]\ntest = false\n");
        assert_eq!(has_tests, is_tested, "lessons/{lesson}/Cargo.toml");
    }
}
