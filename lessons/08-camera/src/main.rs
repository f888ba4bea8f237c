//! Draws lesson 8's picture: `cargo run -p camera`.

use std::process::ExitCode;

use camera::{ONE_POINT, turntable};
use common::Attributes;
use common::program::{Drawing, Lesson, UsageError, run};
use gouraud::{Scene, corner_normals, gouraud, report_left_out};
use transforms::{place, projection, viewport};

fn main() -> ExitCode {
    run(&Lesson {
        name: "08-camera",
        about: "Lesson 8: looking at a point.",
        methods: camera::METHODS,
        default: "lookat",
        flags: &["model", "light", "depth", "texture", "eye", "center", "up", "turntable"],
        draw: |flags, view| {
            let model = flags.read_model(Attributes { uvs: true, normals: true })?;
            let texture = flags.read_texture()?;
            let mut picture = flags.canvas(800, 800);
            let size = picture.size();

            let view = view(flags.eye, flags.center, flags.up).ok_or_else(|| UsageError(ONE_POINT.into()))?;
            let distance = flags.eye.distance(flags.center);
            let all = viewport(size.x, size.y, 0.5) * projection(distance) * view;

            let normals = corner_normals(&model);
            let scene = Scene { model: &model, normals, texture: &texture, light: flags.light };
            let drawn = gouraud(&scene, &mut picture, |point| place(&all, point));
            report_left_out(drawn.left_out);
            Ok(Drawing { picture, depth: flags.depth.as_ref().map(|_| drawn.depths.picture()) })
        },
        turntable: Some(turntable::run),
    })
}
