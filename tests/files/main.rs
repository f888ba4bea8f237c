//! Bad files, bad places and bad flags, as a user meets them: one line that says what is wrong, exit code 1
//! (2 where the command line is at fault), nothing lost and nothing half-written. And the assets, made again.

mod assets;
mod formats;
mod fuzz;
mod models;
mod pictures;
mod usage;

use std::path::Path;
use std::process::Output;

/// Checks that a program failed as it should, and said why in one line.
fn assert_fails(output: &Output, code: i32, said: &[&str]) {
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{error}");
    assert_eq!(error.lines().count(), 1, "{error}");
    assert!(said.iter().all(|words| error.contains(words)), "{error}");
}

/// The names in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}
