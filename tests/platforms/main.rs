//! The lessons' programs, built for another platform, draw what they draw here, byte for byte.
//!
//! `.ci/platforms` builds them and calls this with two variables: `PROGRAMS` is the folder where they are, and
//! `RUNNER` the command that runs one of them, such as `qemu-aarch64` (its words are separated by spaces).

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, thread};

use checks::picture::faults;
use common::Image;
use tasks::{COURSE, lessons};
use verify::run;

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
    ("--version", &["--version", "4", "--time", "1.5", "--size", "120x100"]),
    ("--version", &["--version", "8", "--time", "1.5", "--size", "120x100", "--keys", "F1"]),
    ("--version", &["--version", "9", "--turntable", "5", "--size", "120x100", "--keys", "Up W*3"]),
];

/// What each method draws, where a lesson draws models.
const EVERY_METHOD: &[(&str, &[&str])] = &[("--model", &["--model", CUBE])];

#[test]
#[ignore = "takes programs for another platform, which .ci/platforms builds"]
fn every_program_draws_the_same_elsewhere() {
    let variable = |name| env::var(name).unwrap_or_else(|_| panic!("{name} is not set: call .ci/platforms"));
    let runner: Vec<_> = variable("RUNNER").split_whitespace().map(String::from).collect();
    let programs = fs::canonicalize(variable("PROGRAMS")).expect("PROGRAMS is a folder");

    let folders = lessons(Path::new(COURSE)).expect("the course can be read");
    let names = folders.iter().map(|folder| folder.split_once('-').expect("number and name").1);
    let check = |lesson: &str| {
        let cases = cases(lesson);
        cases.iter().try_for_each(|case| compare(lesson, case, &runner, &programs)).map(|()| cases.len())
    };
    // A thread a lesson: an emulated program is slow.
    let results: Vec<_> = thread::scope(|scope| {
        let threads: Vec<_> = names.map(|name| scope.spawn(move || check(name))).collect();
        threads.into_iter().map(|thread| thread.join().expect("a failure is told, not panicked")).collect()
    });
    let faults: Vec<_> =
        results.iter().filter_map(|result| result.as_ref().err()).map(String::as_str).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    println!("{} runs draw the same", results.into_iter().flatten().sum::<usize>());
}

/// The command lines to try: the lesson's own picture, each method, and what other flags there are.
fn cases(lesson: &str) -> Vec<Vec<String>> {
    let ask =
        |flag| String::from_utf8(run(lesson, Path::new("."), &[flag]).stdout).expect("programs print UTF-8");
    let (help, list) = (ask("--help"), ask("--list"));
    let known = |flags: &[(&str, &[&'static str])]| {
        let has = |flag: &str| help.split_whitespace().any(|word| word == flag);
        flags
            .iter()
            .filter(|(flag, arguments)| {
                has(flag) && arguments.iter().all(|word| !word.starts_with("--") || has(word))
            })
            .map(|(_, arguments)| arguments.to_vec())
            .collect::<Vec<_>>()
    };
    // A method's name stands at the beginning of its line; what is said of it goes on indented.
    let names = list.lines().filter(|line| !line.starts_with(' ')).filter_map(|line| line.split(' ').next());
    let methods: Vec<_> = names
        .map(|name| [vec!["--method", name, "--size", "240x200"], known(EVERY_METHOD).concat()].concat())
        .collect();
    assert!(!methods.is_empty(), "{lesson} --list names no method");
    // A file is named each time: a program may else open a window.
    let others = [methods, known(MORE)].concat().into_iter();
    let others = others.map(|case| [case, vec!["--out", "picture.png"]].concat()).collect();
    let all = [vec![vec!["--out", "picture.tga"]], others].concat();
    all.into_iter().map(|case| case.into_iter().map(String::from).collect()).collect()
}

/// Draws here and elsewhere, and says in which picture the two differ, and where first.
fn compare(lesson: &str, case: &[String], runner: &[String], programs: &Path) -> Result<(), String> {
    let arguments: Vec<&str> = case.iter().map(String::as_str).chain(["--quiet"]).collect();
    let context = |what: &str| format!("{lesson} {}: {what}", arguments.join(" "));
    let [here, there] = [(); 2].map(|()| tempfile::tempdir().expect("a temporary folder can be made"));

    let native = run(lesson, here.path(), &arguments);
    let program = [lesson.into(), format!("{lesson}.exe")].map(|name| programs.join(name));
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
