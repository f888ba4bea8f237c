//! Mission 10: the matrix of a frustum, and weights in perspective, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use perspective_tasks::{MISSION, Perspective};

const JUDGE: Judge<Perspective> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Perspective = Perspective {
    frustum: |l, r, b, t, n, f| perspective::frustum(l, r, b, t, n, f).ok(),
    perspective_weights: perspective::perspective_weights,
};

fn main() -> ExitCode {
    JUDGE.run()
}
