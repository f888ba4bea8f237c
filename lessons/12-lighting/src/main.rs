//! Draws lesson 12's picture: `cargo run --release -p lighting`.

use std::process::ExitCode;

use camera::flags::{TurntableFlag, ViewFlags};
use clipping::Mesh;
use clipping::flags::CullFlag;
use clipping::mesh::indexed;
use common::program::{Extras, Output, Program, UsageError, named, run};
use common::{Attributes, Image, Lesson, Method};
use gouraud::flags::SceneFlags;
use lighting::flags::{PointLightFlags, StretchFlag};
use lighting::looks::LookFlags;
use lighting::{Draw, LOOKS, Look, Maps, Scene};
use perspective::flags::CameraFlags;
use perspective::scene::Loaded;
use perspective::view;
use transforms::scale;

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("0.55,0.35,2.35")))]
#[command(mut_arg("center", |arg| arg.default_value("0,0.12,0")))]
#[command(mut_arg("light", |arg| arg.hide(true)))]
struct Flags {
    #[command(flatten)]
    scene: SceneFlags,
    #[command(flatten)]
    light: PointLightFlags,
    #[command(flatten)]
    look: LookFlags,
    #[command(flatten)]
    stretch: StretchFlag,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    camera: CameraFlags,
    #[command(flatten)]
    cull: CullFlag,

    #[command(flatten)]
    turntable: TurntableFlag,
}

/// A model under a lamp.
struct Lighting {
    loaded: Loaded,
    mesh: Mesh,
    /// What is drawn with maps, and these; `None` is the method's own, plain one.
    look: Option<(&'static Look, Maps)>,
    flags: Flags,
}

impl Program for Lighting {
    type Flags = Flags;
    type Method = Draw;

    const LESSON: Lesson = lighting::LESSON;
    const METHODS: &[Method<Draw>] = lighting::METHODS;
    const DEFAULT: &str = "blinn-phong";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        // Refused before a file is read.
        flags.camera.projection(1.0)?;
        let look = match &*flags.look.look {
            "plain" => None,
            name => {
                let look = named(LOOKS, "look", name)?;
                Some((look, flags.look.read(look, !flags.scene.model.is_given())?))
            }
        };
        let needs = Attributes { normals: true, uvs: true };
        let (model, texture) = flags.scene.model.read_about(flags.view.origin(), needs)?;
        let loaded = Loaded::new(model, texture, flags.scene.wrap);
        let mesh = indexed(&loaded.model, &loaded.normals, needs);
        Ok(Self { loaded, mesh, look, flags })
    }

    fn draw(&mut self, method: &Draw, picture: &mut Image) -> anyhow::Result<Extras> {
        let flags = &self.flags;
        let size = picture.size();
        let camera = flags.camera.projection(size.x / size.y)? * flags.view.look(view)?;
        let origin = flags.view.origin();
        let eye = (flags.view.eye - origin).as_vec3();
        let scene =
            Scene::placed(&self.loaded, scale(flags.stretch.factors), camera, eye, flags.light.light(origin))
                .ok_or_else(|| UsageError("--stretch: it flattens the model".into()))?;
        let drawn = match &self.look {
            None => method(&scene, &self.mesh, flags.cull.which, picture),
            Some((look, maps)) => (look.draw)(&scene, maps, &self.mesh, flags.cull.which, picture),
        };
        let depth = flags.scene.depth.picture(|| drawn.depths.picture_by(|depth| -f64::from(depth)));
        Ok(Extras { depth, left_out: drawn.counts.left_out })
    }

    fn show(&mut self, method: &Draw, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.flags.turntable.stops else { return output.one(self, method) };
        let from = self.flags.view;
        output.series(self, method, stops, |lighting, n| lighting.flags.view = from.turned(n, stops))
    }
}

fn main() -> ExitCode {
    run::<Lighting>()
}
