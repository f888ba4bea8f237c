//! Mission 1: the pixels of a segment, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use lines_tasks::{Lines, MISSION};

const JUDGE: Judge<Lines> =
    Judge { mission: MISSION, reference: Lines { line: lines::line }, faults: faults::FAULTS };

fn main() -> ExitCode {
    JUDGE.run()
}
