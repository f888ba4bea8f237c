//! Draws lesson 11's picture: `cargo run --release -p clipping`.

use std::process::ExitCode;

use camera::flags::ViewFlags;
use clipping::flags::CullFlag;
use clipping::mesh::indexed;
use clipping::{Clipping, Mesh, SLABS, draw};
use common::program::{Extras, Program, run};
use common::{Attributes, Image, Lesson, Method};
use gouraud::flags::SceneFlags;
use perspective::flags::CameraFlags;
use perspective::scene::Loaded;
use perspective::view;

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("1.7,-0.72,2.5")))]
#[command(mut_arg("center", |arg| arg.default_value("0,-0.2,0")))]
#[command(mut_arg("light", |arg| arg.default_value("0.4,0.8,0.8")))]
struct Flags {
    #[command(flatten)]
    scene: SceneFlags,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    camera: CameraFlags,
    #[command(flatten)]
    cull: CullFlag,
}

/// A head on a floor, or a model alone, each with its vertices unified.
struct Scene {
    models: Vec<(Loaded, Mesh)>,
    flags: Flags,
}

impl Program for Scene {
    type Flags = Flags;
    type Method = Clipping;

    const LESSON: Lesson = clipping::LESSON;
    const METHODS: &[Method<Clipping>] = clipping::METHODS;
    const DEFAULT: &str = "guard-band";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        // Refused before a file is read.
        flags.camera.projection(1.0)?;
        let needs = Attributes { normals: true, uvs: true };
        let models = Loaded::read(&flags.scene, flags.view.origin(), SLABS)?;
        let with_mesh = |loaded: Loaded| (indexed(&loaded.model, &loaded.normals, needs), loaded);
        let models = models.into_iter().map(with_mesh).map(|(mesh, loaded)| (loaded, mesh)).collect();
        Ok(Self { models, flags })
    }

    fn draw(&mut self, method: &Clipping, picture: &mut Image) -> anyhow::Result<Extras> {
        let flags = &self.flags;
        let size = picture.size();
        let to_clip = flags.camera.projection(size.x / size.y)? * flags.view.look(view)?;
        let light = flags.scene.light.direction;
        let models: Vec<_> =
            self.models.iter().map(|(loaded, mesh)| (loaded.uniforms(light, to_clip), mesh)).collect();
        let drawn = draw(&models, flags.cull.which, *method, picture);
        let depth = flags.scene.depth.picture(|| drawn.depths.picture_by(|depth| -f64::from(depth)));
        Ok(Extras { depth, left_out: drawn.counts.left_out })
    }
}

fn main() -> ExitCode {
    run::<Scene>()
}
