//! Mission 2: a model's edges, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use wireframe_tasks::{MISSION, Wireframe};

const JUDGE: Judge<Wireframe> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Wireframe = Wireframe { wireframe: wireframe::wireframe, to_pixel: wireframe::to_pixel };

fn main() -> ExitCode {
    JUDGE.run()
}
