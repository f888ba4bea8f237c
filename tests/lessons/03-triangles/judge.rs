//! Mission 3: the pixels of a triangle, and how bright it is, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use triangles_tasks::{MISSION, Triangles};

const JUDGE: Judge<Triangles> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Triangles = Triangles {
    fill: |corners, bounds, visit| triangles::fill(corners, bounds, visit),
    flat_intensity: triangles::flat_intensity,
};

fn main() -> ExitCode {
    JUDGE.run()
}
