//! Tries what you wrote in `lib.rs`: `cargo run -p my-shaders`.

use std::process::ExitCode;

use checks::missions::run;
use checks::missions::shaders::{self as mission, draw};
use my_shaders::{Gouraud, Quantized, Texture};
use shaders::source::White;

fn main() -> ExitCode {
    let student = mission::Shaders {
        gouraud: |scene, target| draw(scene, target, White, Gouraud::new(scene)),
        gouraud_texture: |scene, target| draw(scene, target, Texture::new(scene), Gouraud::new(scene)),
        quantized: |scene, target| draw(scene, target, White, Quantized::new(scene)),
    };
    run(&mission::MISSION, &student, cfg!(test))
}
