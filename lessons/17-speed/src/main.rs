//! Draws lesson 17's picture: `cargo run --release -p speed`.

use std::process::ExitCode;
use std::time::Instant;

use camera::flags::ViewFlags;
use clipping::flags::CullFlag;
use common::program::flags::LightFlag;
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Program, named, run};
use common::{Image, Lesson, Method};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Surface, WRAPS};
use perspective::flags::CameraFlags;
use perspective::view;
use scene::{Simulation, Target, VERSIONS};
use speed::sixteen::Sixteen;
use speed::{Picture, Renderer};

#[derive(clap::Args)]
#[command(mut_arg("eye", |arg| arg.default_value("2,0.2,3.3")))]
#[command(mut_arg("center", |arg| arg.default_value("0.3,-0.35,0")))]
#[command(mut_arg("light", |arg| arg.default_value("0.4,0.8,0.8")))]
struct Flags {
    #[command(flatten)]
    model: TexturedModelFlags,

    /// How textures are filtered: a row of lesson 13's table
    #[arg(long, value_name = "NAME", default_value = "trilinear")]
    filter: String,

    /// Where (u, v) leave 0 to 1: show the texture's border, the texture again, or its mirror image
    #[arg(long, value_name = "clamp|repeat|mirror", default_value = "repeat")]
    wrap: String,

    /// How many threads draw, by a method that has threads [default: as many as the machine runs at once]
    #[arg(long, value_name = "N")]
    threads: Option<usize>,

    /// Draw so many times after a first one, and print how long a picture takes
    #[arg(long, value_name = "N")]
    repeat: Option<usize>,

    /// Draw a version of lesson 16's scene instead, 0 to 11
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=11))]
    scene: Option<u8>,

    /// Show it in a window; without --scene, version 11
    #[cfg(feature = "window")]
    #[arg(long)]
    window: bool,

    #[command(flatten)]
    light: LightFlag,
    #[command(flatten)]
    view: ViewFlags,
    #[command(flatten)]
    camera: CameraFlags,
    #[command(flatten)]
    cull: CullFlag,
}

/// A head on a floor, or a model alone.
struct Scene {
    models: Vec<Filterable>,
    filter: usize,
    flags: Flags,
}

impl Scene {
    /// Draws a version of lesson 16's scene.
    fn draw_scene(&self, version: u8, method: &Renderer, picture: &mut Image) -> anyhow::Result<Extras> {
        let mut simulation = simulation(version)?;
        let [width, height] = [picture.width(), picture.height()].map(|side| side as u16);
        let mut target = self.target(method, width, height)?;
        let counts = simulation.draw(&mut target);
        if let Some(times) = self.flags.repeat {
            let mut took: Vec<f64> = (0..times)
                .map(|_| {
                    let start = Instant::now();
                    simulation.draw(&mut target);
                    start.elapsed().as_secs_f64() * 1e3
                })
                .collect();
            took.sort_by(f64::total_cmp);
            let at = |share: f64| took[((took.len() - 1) as f64 * share) as usize];
            println!(
                "median {:.2} ms (p25 {:.2}, p75 {:.2}, min {:.2})",
                at(0.5),
                at(0.25),
                at(0.75),
                at(0.0)
            );
        }
        *picture = target.into_picture();
        Ok(Extras { depth: None, left_out: counts.triangles.left_out })
    }

    /// What lesson 16's scene is drawn to, by lesson 16's own renderer or by this lesson's.
    fn target(&self, method: &Renderer, width: u16, height: u16) -> anyhow::Result<Target> {
        Ok(match method.plan {
            None => Target::new(width, height),
            Some(_) => Target::with(Box::new(Sixteen::new(self.flags.threads.unwrap_or(1))?), width, height),
        })
    }
}

/// A version of lesson 16's scene, its spheres as fine as their size asks for.
fn simulation(version: u8) -> anyhow::Result<Simulation> {
    let sizes = named(scene::METHODS, "spheres", "by-size")?;
    Simulation::new(&VERSIONS[usize::from(version)], sizes)
}

impl Program for Scene {
    type Flags = Flags;
    type Method = Renderer;

    const LESSON: Lesson = speed::LESSON;
    const METHODS: &[Method<Renderer>] = speed::METHODS;
    const DEFAULT: &str = "threads";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        // Refused before a file is read.
        flags.camera.projection(1.0)?;
        let wrap = named(WRAPS, "wrap", &flags.wrap)?;
        named(filtering::METHODS, "filter", &flags.filter)?;
        let filter = filtering::METHODS.iter().position(|row| row.name == flags.filter).unwrap_or(0);
        let mipmap = named(MIPMAPS, "mipmaps", "box-linear")?;
        let models = Filterable::read(&flags.model, flags.view.origin(), *mipmap, *wrap)?;
        Ok(Self { models, filter, flags })
    }

    fn draw(&mut self, method: &Renderer, picture: &mut Image) -> anyhow::Result<Extras> {
        let flags = &self.flags;
        if let Some(version) = flags.scene {
            return self.draw_scene(version, method, picture);
        }
        let size = picture.size();
        let to_clip = flags.camera.projection(size.x / size.y)? * flags.view.look(view)?;
        let light = flags.light.direction;
        let surfaces: Vec<Surface> = self.models.iter().map(|model| model.surface(light, to_clip)).collect();
        let what = Picture { surfaces: &surfaces, cull: flags.cull.which };
        let mut draw =
            method.drawer([picture.width(), picture.height()], self.filter, flags.threads.unwrap_or(1));
        let counts = draw(&what, picture);
        if let Some(times) = flags.repeat {
            let mut took: Vec<f64> = (0..times)
                .map(|_| {
                    let start = Instant::now();
                    draw(&what, picture);
                    start.elapsed().as_secs_f64() * 1e3
                })
                .collect();
            took.sort_by(f64::total_cmp);
            let at = |share: f64| took[((took.len() - 1) as f64 * share) as usize];
            println!("median {:.2} ms (p25 {:.2}, p75 {:.2})", at(0.5), at(0.25), at(0.75));
        }
        Ok(Extras { depth: None, left_out: counts.left_out })
    }
}

fn main() -> ExitCode {
    run::<Scene>()
}
