//! Draws lesson 17's picture: `cargo run --release -p speed`.

use std::process::ExitCode;
use std::thread::available_parallelism;
use std::time::Instant;

use camera::flags::ViewFlags;
use clipping::flags::CullFlag;
#[cfg(feature = "window")]
use common::program::Output;
use common::program::flags::LightFlag;
use common::program::model::TexturedModelFlags;
use common::program::{Extras, Program, UsageError, named, run};
use common::{Image, Lesson, Method};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Surface, WRAPS};
use perspective::flags::CameraFlags;
use perspective::view;
use scene::{Simulation, Target, VERSIONS};
use speed::frame::Plan;
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
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS))]
    threads: Option<u16>,

    /// Draw so many times after a first one, and print how long a picture takes
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    repeat: Option<u32>,

    /// Draw a version of lesson 16's scene instead, 0 to 11: 11 if no number is given
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "11", value_parser = clap::value_parser!(u8).range(0..=11), conflicts_with_all = OF_A_MODEL)]
    scene: Option<u8>,

    /// Open that scene's window, with lesson 16's keys; version 11 unless --scene names another one
    #[cfg(feature = "window")]
    #[arg(long, conflicts_with_all = OF_A_MODEL, conflicts_with_all = ["out", "repeat"])]
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

impl Flags {
    /// Whether lesson 16's scene is asked for.
    fn draws_scene(&self) -> bool {
        #[cfg(feature = "window")]
        if self.window {
            return true;
        }
        self.scene.is_some()
    }
}

/// What lesson 16's scene has of its own.
const OF_A_MODEL: [&str; 13] = [
    "model", "fit", "texture", "filter", "wrap", "light", "eye", "center", "up", "fov", "near", "far", "cull",
];

/// More than a picture has work for.
const MOST_THREADS: i64 = 256;

/// A head on a floor, or a model alone.
struct Scene {
    models: Vec<Filterable>,
    filter: usize,
    flags: Flags,
}

impl Scene {
    /// How many threads draw, by a method that has threads.
    fn threads(&self) -> usize {
        self.flags.threads.map_or_else(
            || available_parallelism().map_or(1, |threads| threads.get().min(MOST_THREADS as usize)),
            usize::from,
        )
    }

    /// Draws as often as is asked for, and prints how long that takes.
    fn repeat(&self, mut draw: impl FnMut()) {
        if let Some(times) = self.flags.repeat {
            let took = (0..times).map(|_| {
                let start = Instant::now();
                draw();
                start.elapsed().as_secs_f64() * 1e3
            });
            println!("{}", spread(took.collect()));
        }
    }

    /// What lesson 16's scene is drawn to: for methods without tiles by lesson 16's own renderer.
    fn target(&self, method: &Renderer, width: u16, height: u16) -> Target {
        match method.plan {
            Some(Plan { threads, .. }) => {
                let threads = if threads == 1 { 1 } else { self.threads() };
                Target::with(Box::new(Sixteen::new(threads)), width, height)
            }
            None => Target::new(width, height),
        }
    }

    /// Draws a version of lesson 16's scene.
    fn draw_scene(&self, version: u8, method: &Renderer, picture: &mut Image) -> anyhow::Result<Extras> {
        let mut simulation = simulation(version)?;
        let [width, height] = [picture.width(), picture.height()].map(|side| side as u16);
        if !simulation.fits([width, height]) {
            let why = "16 samples a pixel are too many for it; up to 4096x4096 will do";
            return Err(UsageError(format!("--size {width}x{height}: {why}")).into());
        }
        let mut target = self.target(method, width, height);
        let counts = simulation.draw(&mut target);
        self.repeat(|| {
            simulation.draw(&mut target);
        });
        *picture = target.into_picture();
        Ok(Extras { depth: None, left_out: counts.triangles.left_out })
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
        let models = if flags.draws_scene() {
            Vec::new()
        } else {
            Filterable::read(&flags.model, flags.view.origin(), *mipmap, *wrap)?
        };
        Ok(Self { models, filter, flags })
    }

    fn size(&self) -> (u16, u16) {
        if self.flags.draws_scene() { (1024, 768) } else { (800, 800) }
    }

    #[cfg(feature = "window")]
    fn show(&mut self, method: &Renderer, output: &Output) -> anyhow::Result<()> {
        if !self.flags.window {
            return output.one(self, method);
        }
        let size = output.size(self);
        scene::window::run(&mut simulation(self.flags.scene.unwrap_or(11))?, self.target(method, 0, 0), size)
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
        let mut draw = method.drawer([picture.width(), picture.height()], self.filter, self.threads());
        let counts = draw(&what, picture);
        self.repeat(|| {
            draw(&what, picture);
        });
        Ok(Extras { depth: None, left_out: counts.left_out })
    }
}

/// The middle of some times, in milliseconds, and the quarters below and above, each the time of one of the pictures.
fn spread(mut times: Vec<f64>) -> String {
    times.sort_by(f64::total_cmp);
    let at = |quarter: usize| times[(times.len() - 1) * quarter / 4];
    format!("median {:.2} ms (p25 {:.2}, p75 {:.2})", at(2), at(1), at(3))
}

fn main() -> ExitCode {
    run::<Scene>()
}
