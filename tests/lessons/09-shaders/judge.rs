//! Mission 9: shaders, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use shaders::lighting::{Gouraud, Lighting, Quantized};
use shaders::source::{Source, Texture, White};
use shaders_tasks::given::{Framebuffer, Uniforms};
use shaders_tasks::{MISSION, Shaders};
use textures::Wrap;

const JUDGE: Judge<Shaders> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Shaders = Shaders {
    gouraud: |uniforms, target| draw(uniforms, White, Gouraud, target),
    gouraud_texture: |uniforms, target| draw(uniforms, Texture, Gouraud, target),
    quantized: |uniforms, target| draw(uniforms, White, Quantized, target),
    quantized_texture: |uniforms, target| draw(uniforms, Texture, Quantized, target),
};

fn draw(uniforms: &Uniforms, source: impl Source, lighting: impl Lighting, target: &mut Framebuffer) {
    let &Uniforms { model, normals, texture, light, to_clip, levels } = uniforms;
    let uniforms = shaders::Uniforms { model, normals, texture, wrap: Wrap::Clamp, light, to_clip, levels };
    let mut own = shaders::Framebuffer { image: target.image.clone(), depths: target.depths.clone() };
    shaders::draw(&uniforms, source, lighting, &mut own);
    *target = Framebuffer { image: own.image, depths: own.depths };
}

fn main() -> ExitCode {
    JUDGE.run()
}
