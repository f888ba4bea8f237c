//! Draws lesson 9's picture: `cargo run --release -p shaders`.

use std::process::ExitCode;

use camera::{ONE_POINT, lookat, turntable};
use common::program::{Drawing, Flags, Lesson, UsageError, run};
use common::{Attributes, Image, Method};
use gouraud::{corner_normals, report_left_out};
use shaders::{Render, Rendering, SHADERS, Scene, Target};
use transforms::{projection, viewport};

/// What the viewport leaves of the picture's side to a length of 1.
const ZOOM: f32 = 0.4;

fn main() -> ExitCode {
    run(&Lesson {
        name: "09-shaders",
        about: "Lesson 9: any look from one loop.",
        methods: shaders::METHODS,
        default: "generic",
        flags: &[
            "model",
            "light",
            "depth",
            "texture",
            "eye",
            "center",
            "up",
            "shader",
            "levels",
            "turntable",
        ],
        draw: |flags, method| match &flags.shader {
            Some(name) => {
                let names = || SHADERS.iter().map(|shader| shader.name).collect::<Vec<_>>().join(", ");
                let shader = Method::find(SHADERS, name);
                let unknown = || UsageError(format!("--shader {name}: there are {}", names()));
                let shader = shader.ok_or_else(unknown)?;
                draw(flags, &[&shader.run], *method)
            }
            None => draw(flags, &[0, 1, 2, 3].map(|n| &SHADERS[n].run), *method),
        },
        turntable: Some(turntable::run),
    })
}

/// Draws one shader over the whole picture, or four in two rows, the first ones on top.
fn draw(flags: &Flags, shaders: &[&Rendering], method: fn(&Rendering) -> Render) -> anyhow::Result<Drawing> {
    let needs = Attributes {
        normals: shaders.iter().any(|shader| shader.needs.normals),
        uvs: shaders.iter().any(|shader| shader.needs.uvs),
    };
    let model = flags.read_model(needs)?;
    let texture = needs.uvs.then(|| flags.read_texture()).transpose()?;
    let mut picture = flags.canvas(800, 800);
    let mut depth = flags.depth.as_ref().map(|_| picture.clone());

    let columns = if shaders.len() == 1 { 1 } else { 2 };
    let (width, height) = (picture.width() / columns, picture.height() / columns);
    let view = lookat(flags.eye, flags.center, flags.up).ok_or_else(|| UsageError(ONE_POINT.into()))?;
    let projection = projection(flags.eye.distance(flags.center));
    let scene = Scene {
        model: &model,
        normals: if needs.normals { corner_normals(&model) } else { Vec::new() },
        texture: texture.as_ref(),
        light: flags.light,
        to_screen: viewport(width as f32, height as f32, ZOOM) * projection * view,
        levels: flags.levels,
    };
    let mut left_out = 0;
    for (n, shader) in shaders.iter().enumerate() {
        let mut cell = Target::new(Image::new(width as u16, height as u16, picture.format()));
        // A shader may reject a triangle before anyone knows where it is: the largest count is the true one.
        left_out = left_out.max(method(shader)(&scene, &mut cell));
        let (column, row) = (n as i32 % columns, columns - 1 - n as i32 / columns);
        paste(&cell.image, &mut picture, column * width, row * height);
        if let Some(depth) = &mut depth {
            paste(&cell.depths.picture(), depth, column * width, row * height);
        }
    }
    report_left_out(left_out);
    Ok(Drawing { picture, depth })
}

/// Copies a picture into another, its bottom-left corner to (x, y).
fn paste(from: &Image, to: &mut Image, x: i32, y: i32) {
    from.pixels().for_each(|(i, j, color)| to.set(x + i, y + j, color));
}
