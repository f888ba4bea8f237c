//! Mission 9: shaders, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use shaders::draw;
use shaders::lighting::{Gouraud, Quantized};
use shaders::source::{Texture, White};
use shaders_tasks::{MISSION, Shaders};

const JUDGE: Judge<Shaders> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Shaders = Shaders {
    gouraud: |uniforms, target| draw(uniforms, White, Gouraud, target),
    gouraud_texture: |uniforms, target| draw(uniforms, Texture, Gouraud, target),
    quantized: |uniforms, target| draw(uniforms, White, Quantized, target),
    quantized_texture: |uniforms, target| draw(uniforms, Texture, Quantized, target),
};

fn main() -> ExitCode {
    JUDGE.run()
}
