//! Tries what you wrote in `lib.rs`: `cargo run -p my-shaders`.

use std::process::ExitCode;

use my_shaders::{Gouraud, Quantized, Texture};
use shaders_tasks::given::{White, draw};
use shaders_tasks::{MISSION, Shaders};

fn main() -> ExitCode {
    let student = Shaders {
        gouraud: |uniforms, target| draw(uniforms, White, Gouraud, target),
        gouraud_texture: |uniforms, target| draw(uniforms, Texture, Gouraud, target),
        quantized: |uniforms, target| draw(uniforms, White, Quantized, target),
        quantized_texture: |uniforms, target| draw(uniforms, Texture, Quantized, target),
    };
    MISSION.run(&student, cfg!(test))
}
