//! Tries what you wrote in `lib.rs`: `cargo run -p my-shaders`.

use std::process::ExitCode;

use checks::missions::run;
use checks::missions::shaders as mission;
use my_shaders::{Gouraud, Quantized, Texture};
use shaders::draw;
use shaders::source::White;

fn main() -> ExitCode {
    let student = mission::Shaders {
        gouraud: |uniforms, target| draw(uniforms, White, Gouraud, target),
        gouraud_texture: |uniforms, target| draw(uniforms, Texture, Gouraud, target),
        quantized: |uniforms, target| draw(uniforms, White, Quantized, target),
    };
    run(&mission::MISSION, &student, cfg!(test))
}
