//! Mission 5: colour from a picture, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use textures_tasks::{MISSION, Textures};

const JUDGE: Judge<Textures> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Textures = Textures {
    texel: textures::texel,
    interpolate: textures::interpolate,
    draw_textured: |model, light, image, color| textures::draw_textured(model, light, image, color),
};

fn main() -> ExitCode {
    JUDGE.run()
}
