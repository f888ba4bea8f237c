//! Draws lesson 9's picture: `cargo run --release -p shaders`.

use std::process::ExitCode;

use camera::flags::{TurntableFlag, ViewFlags};
use camera::lookat;
use common::program::{Extras, Output, Program, named, run};
use common::{Attributes, Image, Lesson, Method, Model, Vec2, Vec3};
use gouraud::corner_normals;
use gouraud::flags::SceneFlags;
use shaders::target::Target;
use shaders::{Draw, Framebuffer, Look, SHADERS, Uniforms, fit};
use transforms::projection;

/// What a length of 1 takes up of a picture's smaller side.
const ZOOM: f32 = 0.4;

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    scene: SceneFlags,
    #[command(flatten)]
    view: ViewFlags,

    /// One shader alone instead of the sheet of four
    #[arg(long, value_name = "NAME")]
    shader: Option<String>,

    /// Steps of brightness of the quantized shader
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u16).range(1..))]
    levels: u16,

    #[command(flatten)]
    turntable: TurntableFlag,
}

/// The model under one shader, or under four in two rows, the first ones on top.
struct Shaders {
    shaders: Vec<&'static Look>,
    model: Model,
    /// Empty where no shader needs them.
    normals: Vec<[Vec3; 3]>,
    texture: Option<Image>,
    flags: Flags,
}

impl Program for Shaders {
    type Flags = Flags;
    type Method = fn(&Look) -> Draw;

    const LESSON: Lesson = shaders::LESSON;
    const METHODS: &[Method<Self::Method>] = shaders::METHODS;
    const DEFAULT: &str = "generic";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let shaders = match &flags.shader {
            Some(name) => vec![named(SHADERS, "shader", name)?],
            None => SHADERS[..4].iter().map(|shader| &shader.run).collect(),
        };
        let needs = Attributes {
            normals: shaders.iter().any(|shader| shader.needs.normals),
            uvs: shaders.iter().any(|shader| shader.needs.uvs),
        };
        let (model, texture) = if needs.uvs {
            let (model, texture) = flags.scene.model.read_about(flags.view.origin(), needs)?;
            (model, Some(texture))
        } else {
            (flags.scene.model.read_untextured(flags.view.origin(), needs)?, None)
        };
        let normals = if needs.normals { corner_normals(&model) } else { Vec::new() };
        Ok(Self { shaders, model, normals, texture, flags })
    }

    fn draw(&mut self, method: &Self::Method, picture: &mut Image) -> anyhow::Result<Extras> {
        let flags = &self.flags;
        let columns = if self.shaders.len() == 1 { 1 } else { 2 };
        let (width, height) = (picture.width() / columns, picture.height() / columns);
        let view = projection(flags.view.distance()) * flags.view.look(lookat)?;
        let uniforms = Uniforms {
            normals: &self.normals,
            texture: self.texture.as_ref(),
            wrap: flags.scene.wrap,
            light: flags.scene.light.direction,
            to_clip: fit(ZOOM, Vec2::new(width as f32, height as f32)) * view,
            levels: flags.levels,
            ..Uniforms::new(&self.model)
        };
        let mut cell = Framebuffer::new(Image::new(width as u16, height as u16, picture.format()));
        let mut depth = flags.scene.depth.picture(|| picture.clone());
        let mut left_out = 0;
        for (n, shader) in self.shaders.iter().enumerate() {
            cell.clear();
            // A shader may reject a triangle before anyone knows where it is: the largest count is the true one.
            left_out = left_out.max(method(shader)(&uniforms, &mut cell));
            let (column, row) = (n as i32 % columns, columns - 1 - n as i32 / columns);
            paste(&cell.image, picture, column * width, row * height);
            if let Some((_, depth)) = &mut depth {
                paste(&cell.depths.picture(), depth, column * width, row * height);
            }
        }
        Ok(Extras { depth, left_out })
    }

    fn show(&mut self, method: &Self::Method, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.flags.turntable.stops else { return output.one(self, method) };
        let from = self.flags.view;
        output.series(self, method, stops, |shaders, n| shaders.flags.view = from.turned(n, stops))
    }
}

/// Copies a picture into another, its bottom-left corner to (x, y).
fn paste(from: &Image, to: &mut Image, x: i32, y: i32) {
    from.pixels().for_each(|(i, j, color)| to.set(x + i, y + j, color));
}

fn main() -> ExitCode {
    run::<Shaders>()
}
