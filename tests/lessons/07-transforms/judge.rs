//! Mission 7: viewport, projection, and where a point lands, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use transforms_tasks::{MISSION, Transforms};

const JUDGE: Judge<Transforms> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Transforms = Transforms {
    viewport: transforms::viewport,
    projection: transforms::projection,
    place: transforms::place,
};

fn main() -> ExitCode {
    JUDGE.run()
}
