//! Gradescope's package, unpacked and called as Gradescope does, but that no toolchain is installed.

use std::fs::{self, File};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use zip::ZipArchive;

use crate::{FULL, grader, said};

fn package(out: &Path, more: &[&str]) -> Output {
    grader(&[&["gradescope", "1", "--seed", "7"], more].concat(), &[("--out", out)]).output().unwrap()
}

/// Calls `run_autograder` with what is handed in, and returns its results.
fn run(root: &Path, text: (&str, &str)) -> Result<Value, String> {
    let _ = fs::remove_dir_all(root.join("submission"));
    fs::create_dir(root.join("submission")).unwrap();
    fs::write(root.join("submission").join(text.0), text.1).unwrap();
    // What another run has built, of packages of the same names in another folder, is not this course's.
    let built = Path::new(env!("CARGO_TARGET_TMPDIR")).join("gradescope");
    let mut run = Command::new(root.join("run_autograder"));
    run.env("AUTOGRADER", root).env("GRADE", env!("CARGO_BIN_EXE_grade")).env("CARGO_TARGET_DIR", built);
    // A fresh machine has not got all crates yet.
    let output = run.env("CARGO_NET_OFFLINE", "false").current_dir(root).output().unwrap();
    let said = said(&output);
    println!("{said}");
    let results = fs::read(root.join("results/results.json"));
    results.map(|text| serde_json::from_slice(&text).unwrap()).map_err(|_| said)
}

#[test]
#[ignore = "a minute; for the course's own CI"]
fn the_package_grades_as_gradescope_calls_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let [a, b] = ["a.zip", "b.zip"].map(|name| {
        let output = package(&path(name), &["--visibility", "after_due_date"]);
        assert!(output.status.success(), "{}", said(&output));
        fs::read(path(name)).unwrap()
    });
    assert!(a == b, "the same package twice has the same bytes");

    // As Gradescope lays it out: the archive in `source`, and a copy of the program beside it.
    let root = path("autograder");
    fs::create_dir_all(root.join("results")).unwrap();
    ZipArchive::new(File::open(path("a.zip")).unwrap()).unwrap().extract(root.join("source")).unwrap();
    fs::copy(root.join("source/run_autograder"), root.join("run_autograder")).unwrap();
    let setup = root.join("source/setup.sh");
    assert_eq!(fs::metadata(&setup).unwrap().permissions().mode() & 0o111, 0o111);
    assert!(Command::new("bash").arg("-n").arg(&setup).status().unwrap().success());
    assert!(fs::read_to_string(&setup).unwrap().contains(" --package my-lines --package lines-tests"));
    assert!(!root.join("source/course/tests/lessons/01-lines/solution.rs").exists());

    let results = match run(&root, ("lib.rs", FULL)) {
        Ok(results) => results,
        Err(said) if said.contains("nothing was graded") => return println!("NOT TESTED, no walls here"),
        Err(said) => panic!("{said}"),
    };
    assert_eq!((&results["score"], &results["stdout_visibility"]), (&10.into(), &"hidden".into()));
    let tests = results["tests"].as_array().unwrap();
    let sum = |field: &str| tests.iter().map(|test| test[field].as_u64().unwrap()).sum::<u64>();
    assert_eq!((sum("score"), sum("max_score")), (10, 10));
    for (n, test) in tests.iter().enumerate() {
        assert_eq!(test["number"], format!("1.{}", n + 1));
        let fields = ["status", "visibility", "output_format"].map(|field| test[field].as_str().unwrap());
        assert_eq!(fields, ["passed", "after_due_date", "text"]);
    }

    // What is not clear is told at once, and can be handed in again.
    let results = run(&root, ("exercise.rs", FULL)).unwrap();
    let told = results["output"].as_str().unwrap();
    assert!(told.contains("found exercise.rs, not graded because neither its name"), "{told}");
    assert_eq!((&results["visibility"], results.get("tests")), (&"visible".into(), None));
}

#[test]
fn a_package_that_cannot_be_built_is_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("a.zip");
    for (more, words) in [
        (&["--lessons", "1"][..], "unexpected argument"),
        (&["--visibility", "sometimes"], "after_published"),
        (&["--course", "/"], "is not the course"),
    ] {
        let output = package(&out, more);
        assert!(!output.status.success() && said(&output).contains(words), "{}", said(&output));
    }
    let output = grader(&["gradescope", "99"], &[("--out", &out)]).output().unwrap();
    assert!(said(&output).contains("LESSONS: `99` is not a lesson's number"), "{}", said(&output));
    assert!(!out.exists());
}
