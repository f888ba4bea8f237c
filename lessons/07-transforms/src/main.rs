//! Draws lesson 7's picture: `cargo run -p transforms`.

use std::f32::consts::TAU;
use std::process::ExitCode;

use common::program::{Drawing, Lesson, run};
use common::{Attributes, Mat4, Vec3};
use gouraud::{Scene, corner_normals, gouraud, report_left_out};
use transforms::{normal_matrix, place, projection, viewport};

/// The head is turned this often, by this part of a full turn each time.
const TURNS: u32 = 12;

fn main() -> ExitCode {
    run(&Lesson {
        name: "07-transforms",
        about: "Lesson 7: matrices, viewport and projection.",
        methods: transforms::METHODS,
        default: "f32",
        flags: &["model", "light", "depth", "texture", "distance"],
        draw: |flags, compose| {
            let model = flags.read_model(Attributes { uvs: true, normals: true })?;
            let texture = flags.read_texture()?;
            let mut picture = flags.canvas(800, 800);
            let size = picture.size();

            let turn = Mat4::from_mat3(compose(Vec3::Y, TAU / TURNS as f32, TURNS));
            let all = viewport(size.x, size.y, 0.5) * projection(flags.distance) * turn;
            let turned = normal_matrix(&turn).unwrap_or_default();
            let normals = corner_normals(&model).iter().map(|corners| corners.map(|n| turned * n)).collect();

            let scene = Scene { model: &model, normals, texture: &texture, light: flags.light };
            let drawn = gouraud(&scene, &mut picture, |point| place(&all, point));
            report_left_out(drawn.left_out);
            Ok(Drawing { picture, depth: flags.depth.as_ref().map(|_| drawn.depths.picture()) })
        },
        turntable: None,
    })
}
