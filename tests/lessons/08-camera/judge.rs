//! Mission 8: looking at a point, judged.

mod faults;

use std::process::ExitCode;

use camera_tasks::{Camera, MISSION};
use judge::Judge;

const JUDGE: Judge<Camera> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Camera = Camera { basis: camera::basis, lookat: camera::lookat };

fn main() -> ExitCode {
    JUDGE.run()
}
