//! Draws lesson 7's picture: `cargo run -p transforms`.

use std::f32::consts::TAU;
use std::process::ExitCode;

use common::program::{Extras, Program, run};
use common::{DVec3, Image, Lesson, Mat4, Method, Vec3};
use gouraud::flags::{LoadedScene, SceneFlags};
use gouraud::{Scene, gouraud};
use transforms::{Compose, normal_matrix, place, projection, viewport};

/// The head is turned this often, by this part of a full turn each time.
const TURNS: u32 = 12;

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    scene: SceneFlags,

    /// Distance of the eye from the origin, along z; inf is the parallel projection
    #[arg(long, value_name = "D", default_value = "2", value_parser = distance, allow_hyphen_values = true)]
    distance: f32,
}

fn distance(text: &str) -> Result<f32, String> {
    text.parse().ok().filter(|&d| d > 0.0).ok_or_else(|| "write a number above 0, or inf".into())
}

struct Transforms {
    loaded: LoadedScene,
    distance: f32,
}

impl Program for Transforms {
    type Flags = Flags;
    type Method = Compose;

    const LESSON: Lesson = transforms::LESSON;
    const METHODS: &[Method<Compose>] = transforms::METHODS;
    const DEFAULT: &str = "f32";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        Ok(Self { loaded: LoadedScene::read(flags.scene, DVec3::ZERO)?, distance: flags.distance })
    }

    fn draw(&mut self, compose: &Compose, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        let turn = Mat4::from_mat3(compose(Vec3::Y, TAU / TURNS as f32, TURNS));
        let all = viewport(size.x, size.y, 0.5) * projection(self.distance) * turn;
        let turned = normal_matrix(&turn).unwrap_or_default();
        let normals: Vec<_> = self.loaded.normals.iter().map(|corners| corners.map(|n| turned * n)).collect();

        let scene = Scene { normals: &normals, ..self.loaded.scene() };
        let drawn = gouraud(&scene, picture, |point| place(&all, point));
        Ok(self.loaded.extras(&drawn))
    }
}

fn main() -> ExitCode {
    run::<Transforms>()
}
