//! Grades a class: `cargo run --release -p grade -- class DIR --out REPORT`.
//!
//! What students wrote is compiled and run behind [`walls`]; it returns raw results only. The lessons' judges, which
//! run before the walls, know what is expected, and compare.
//!
//! ```text
//! submission   finds what was handed in, and reads it without following a link
//! seed         what the inputs are made from
//! kit          what a submission to a lesson is built with, made once
//! compile      rustc and the linker behind walls
//! run          the program behind walls
//! process      CPU time, and ends
//! judge        what the lesson's judge says of its answers
//! class        all submissions, the same ones once; resumes where it was stopped
//! results      what is kept of each, and the marks
//! rules        weights and deadlines; marks: what they make of the points
//! merge        several reports into one
//! gradescope   the package of its autograder, and what that does
//! pairs        who has handed in much the same as somebody else
//! report       HTML for the class and each student, CSV, JUnit, Gradescope
//! walls        what keeps a submission in; proof: that it does
//! ```

#[cfg(target_os = "linux")]
mod class;
#[cfg(target_os = "linux")]
mod cli;
#[cfg(target_os = "linux")]
mod compile;
#[cfg(target_os = "linux")]
mod file;
#[cfg(target_os = "linux")]
mod gradescope;
#[cfg(target_os = "linux")]
mod judge;
#[cfg(target_os = "linux")]
mod kit;
#[cfg(target_os = "linux")]
mod marks;
#[cfg(target_os = "linux")]
mod merge;
#[cfg(target_os = "linux")]
mod pairs;
#[cfg(target_os = "linux")]
mod process;
#[cfg(target_os = "linux")]
mod proof;
#[cfg(target_os = "linux")]
mod report;
#[cfg(target_os = "linux")]
mod results;
#[cfg(target_os = "linux")]
mod rules;
#[cfg(target_os = "linux")]
mod run;
#[cfg(target_os = "linux")]
mod seed;
#[cfg(target_os = "linux")]
mod submission;
#[cfg(target_os = "linux")]
mod submitted;
#[cfg(target_os = "linux")]
mod walls;

use std::process::ExitCode;

#[cfg(target_os = "linux")]
fn main() -> ExitCode {
    cli::main()
}

/// Elsewhere there are no such walls.
#[cfg(not(target_os = "linux"))]
fn main() -> ExitCode {
    eprintln!(
        "error: the grader needs Linux: it keeps submissions behind walls that other systems do not have"
    );
    ExitCode::FAILURE
}
