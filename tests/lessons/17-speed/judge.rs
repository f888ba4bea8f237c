//! Mission 17: how much of a block a triangle covers, judged.

mod faults;

use std::process::ExitCode;

use common::DVec3;
use judge::Judge;
use speed::blocks;
use speed_tasks::given::Cover;
use speed_tasks::{MISSION, Speed};

const JUDGE: Judge<Speed> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Speed = Speed { cover };

/// The lesson's function, with the mission's answers.
fn cover(edges: DVec3, right: DVec3, up: DVec3, inside: DVec3) -> Cover {
    match blocks::cover(edges, right, up, inside) {
        blocks::Cover::Nothing => Cover::Nothing,
        blocks::Cover::Part => Cover::Part,
        blocks::Cover::Whole => Cover::Whole,
    }
}

fn main() -> ExitCode {
    JUDGE.run()
}
