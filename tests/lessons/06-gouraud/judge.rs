//! Mission 6: smooth shading, judged.

mod faults;

use std::process::ExitCode;

use gouraud_tasks::{Gouraud, MISSION};
use judge::Judge;

const JUDGE: Judge<Gouraud> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Gouraud = Gouraud {
    intensities: gouraud::intensities,
    gouraud: |scene, image, place| gouraud::gouraud(scene, image, place),
};

fn main() -> ExitCode {
    JUDGE.run()
}
