//! Draws lesson 7's picture: `cargo run -p transforms`.

use std::f32::consts::TAU;
use std::process::ExitCode;

use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Program, run};
use common::{Attributes, Image, Lesson, Mat4, Method, Model, Vec3};
use gouraud::{Scene, corner_normals, gouraud};
use transforms::{Compose, normal_matrix, place, projection, viewport};

/// The head is turned this often, by this part of a full turn each time.
const TURNS: u32 = 12;

#[derive(clap::Args)]
struct Flags {
    #[command(flatten)]
    model: TexturedModelFlags,
    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    depth: DepthFlag,

    /// Distance of the eye from the origin, along z; inf is the parallel projection
    #[arg(long, value_name = "D", default_value = "2", value_parser = distance, allow_hyphen_values = true)]
    distance: f32,
}

fn distance(text: &str) -> Result<f32, String> {
    text.parse().ok().filter(|&d| d > 0.0).ok_or_else(|| "write a number above 0, or inf".into())
}

struct Transforms {
    model: Model,
    normals: Vec<[Vec3; 3]>,
    texture: Image,
    flags: Flags,
}

impl Program for Transforms {
    type Flags = Flags;
    type Method = Compose;

    const LESSON: Lesson = transforms::LESSON;
    const METHODS: &[Method<Compose>] = transforms::METHODS;
    const DEFAULT: &str = "f32";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        let (model, texture) = flags.model.read(Attributes { normals: true, uvs: true })?;
        Ok(Self { normals: corner_normals(&model), model, texture, flags })
    }

    fn draw(&mut self, compose: &Compose, picture: &mut Image) -> anyhow::Result<Extras> {
        let size = picture.size();
        let turn = Mat4::from_mat3(compose(Vec3::Y, TAU / TURNS as f32, TURNS));
        let all = viewport(size.x, size.y, 0.5) * projection(self.flags.distance) * turn;
        let turned = normal_matrix(&turn).unwrap_or_default();

        let scene = Scene {
            model: &self.model,
            normals: self.normals.iter().map(|corners| corners.map(|n| turned * n)).collect(),
            texture: &self.texture,
            light: self.flags.light.direction,
        };
        let drawn = gouraud(&scene, picture, |point| place(&all, point));
        let depth = self.flags.depth.picture(|| drawn.depths.picture());
        Ok(Extras { depth, left_out: drawn.left_out })
    }
}

fn main() -> ExitCode {
    run::<Transforms>()
}
