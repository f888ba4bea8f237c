//! Mission 4: the nearest surface, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use zbuffer_tasks::{MISSION, Zbuffer};

const JUDGE: Judge<Zbuffer> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Zbuffer = Zbuffer {
    fill_nearest: |corners, depths, store, visit| zbuffer::fill_nearest(corners, depths, store, visit),
    z_f32: zbuffer::z_f32,
};

fn main() -> ExitCode {
    JUDGE.run()
}
