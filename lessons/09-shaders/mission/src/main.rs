//! Tries what you wrote in `lib.rs`: `cargo run -p my-shaders`.

use std::process::ExitCode;

use my_shaders::{Gouraud, Quantized, Texture};
use shaders::source::White;
use shaders_tasks::{MISSION, Shaders, draw};

fn main() -> ExitCode {
    let student = Shaders {
        gouraud: |scene, target| draw(scene, target, White, Gouraud::new(scene)),
        gouraud_texture: |scene, target| draw(scene, target, Texture::new(scene), Gouraud::new(scene)),
        quantized: |scene, target| draw(scene, target, White, Quantized::new(scene)),
    };
    MISSION.run(&student, cfg!(test))
}
