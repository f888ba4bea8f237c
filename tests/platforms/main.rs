//! The lessons' programs, built for another platform, draw what they draw here, byte for byte.
//!
//! `.ci/platforms` builds them and calls this with two variables: `PROGRAMS` is the folder where they are, and
//! `RUNNER` the command that runs one of them, such as `qemu-aarch64` (its words are separated by spaces).

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, thread};

use checks::picture::faults;
use common::{Image, Lesson};
use verify::{LESSONS, run};

/// A model that is read at once: an emulator takes seconds for the head.
const CUBE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/cube.obj");

/// What is drawn beside the default pictures, by the lessons that have the flag.
const MORE: &[(&str, &[&str])] = &[
    ("--fill", &["--model"]),
    ("--fill", &["--model", CUBE, "--fill", "random"]),
    ("--levels", &["--model", CUBE, "--shader", "quantized", "--levels", "3"]),
    ("--depth", &["--model", CUBE, "--depth", "depth.png"]),
    ("--light", &["--model", CUBE, "--light", "1,2,3"]),
    ("--turntable", &["--model", CUBE, "--turntable", "5", "--size", "100x100"]),
];

/// What each method draws, where a lesson draws models.
const EVERY_METHOD: &[(&str, &[&str])] = &[("--model", &["--model", CUBE])];

#[test]
#[ignore = "takes programs for another platform, which .ci/platforms builds"]
fn every_program_draws_the_same_elsewhere() {
    let variable = |name| env::var(name).unwrap_or_else(|_| panic!("{name} is not set: call .ci/platforms"));
    let runner: Vec<_> = variable("RUNNER").split_whitespace().map(String::from).collect();
    let programs = fs::canonicalize(variable("PROGRAMS")).expect("PROGRAMS is a folder");

    // A thread a lesson: an emulated program is slow.
    let check = |lesson: &Lesson| {
        let help = run(lesson.name, Path::new("."), &["--help"]).stdout;
        let cases = cases(lesson, &String::from_utf8_lossy(&help));
        cases
            .iter()
            .try_for_each(|arguments| compare(lesson, arguments, &runner, &programs))
            .map(|()| cases.len())
    };
    let results = thread::scope(|scope| {
        LESSONS
            .each_ref()
            .map(|lesson| scope.spawn(move || check(lesson)))
            .map(|thread| thread.join().unwrap())
    });
    let faults: Vec<_> =
        results.iter().filter_map(|result| result.as_ref().err()).map(String::as_str).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    println!("{} runs draw the same", results.into_iter().flatten().sum::<usize>());
}

/// The command lines to try: none, each method, and what other flags there are.
fn cases(lesson: &Lesson, help: &str) -> Vec<Vec<&'static str>> {
    let has = |flag: &str| help.split_whitespace().any(|word| word == flag);
    let known = |flags: &[(&str, &'static [&'static str])]| {
        flags.iter().filter(|(flag, _)| has(flag)).map(|(_, arguments)| *arguments).collect::<Vec<_>>()
    };
    let table = lesson.tables.iter().find(|table| table.name.is_empty()).expect("each lesson has `METHODS`");
    let methods = (table.rows)().into_iter().map(|row| {
        [&["--method", row.name, "--size", "240x200"], known(EVERY_METHOD).concat().as_slice()].concat()
    });
    let more = known(MORE).into_iter().map(<[_]>::to_vec);
    [vec![]].into_iter().chain(methods).chain(more).collect()
}

/// Draws here and elsewhere, and says in which picture the two differ, and where first.
fn compare(lesson: &Lesson, arguments: &[&str], runner: &[String], programs: &Path) -> Result<(), String> {
    let arguments = [arguments, &["--quiet"]].concat();
    let context = |what: &str| format!("{} {}: {what}", lesson.name, arguments.join(" "));
    let [here, there] = [(); 2].map(|()| tempfile::tempdir().expect("a temporary folder can be made"));

    let native = run(lesson.name, here.path(), &arguments);
    let program = [lesson.name.into(), format!("{}.exe", lesson.name)].map(|name| programs.join(name));
    let program = program.iter().find(|path| path.is_file()).ok_or_else(|| context("is not built"))?;
    let foreign = Command::new(&runner[0])
        .args(&runner[1..])
        .arg(program)
        .args(&arguments)
        .current_dir(there.path())
        .output()
        .map_err(|error| context(&format!("{}: {error}", runner[0])))?;
    for output in [native, foreign] {
        if !output.status.success() {
            return Err(context(&format!("{}, {}", output.status, String::from_utf8_lossy(&output.stderr))));
        }
    }

    let [expected, got] = [&here, &there].map(|folder| files(folder.path()));
    if expected.is_empty() || !expected.keys().eq(got.keys()) {
        return Err(context(&format!("{:?} were written, not {:?}", got.keys(), expected.keys())));
    }
    match expected.iter().zip(got.values()).find(|((_, expected), got)| expected != got) {
        Some(((name, _), _)) => {
            let fault = first_fault(&here.path().join(name), &there.path().join(name));
            Err(context(&format!("{} differs: {fault}", name.display())))
        }
        None => Ok(()),
    }
}

/// All files in a folder and the folders in it, with what is in them.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(current) = folders.pop() {
        for entry in fs::read_dir(current).expect("a folder of ours can be read") {
            let path = entry.expect("a folder of ours can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).expect("it is in the folder").to_path_buf();
                found.insert(name, fs::read(path).expect("what was drawn can be read"));
            }
        }
    }
    found
}

/// The first pixel in which two pictures differ, or that only their files do.
fn first_fault(expected: &Path, got: &Path) -> String {
    match [expected, got].map(Image::read) {
        [Ok(expected), Ok(got)] => match faults(&expected, &got, 0).first() {
            Some(fault) => fault.to_string(),
            None => "the same pixels, encoded in another way".into(),
        },
        [_, Err(error)] | [Err(error), _] => error.to_string(),
    }
}
