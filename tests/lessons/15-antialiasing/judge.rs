//! Mission 15: the mask of covered samples and the resolve, judged.

mod faults;

use std::process::ExitCode;

use antialiasing_tasks::{Antialiasing, MISSION};
use judge::Judge;

const JUDGE: Judge<Antialiasing> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Antialiasing = Antialiasing { coverage: antialiasing::coverage, resolve: antialiasing::resolve };

fn main() -> ExitCode {
    JUDGE.run()
}
