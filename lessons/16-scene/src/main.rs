//! Draws lesson 16's picture: `cargo run --release -p scene`.

use std::process::ExitCode;
use std::time::Duration;

use camera::flags::TurntableFlag;
use common::program::{Extras, Output, Program, run};
use common::{Image, Lesson, Method};
use scene::levels::Sizes;
use scene::{METHODS, Simulation, Target, VERSIONS};

#[derive(clap::Args)]
struct Flags {
    /// The version of the assignment, 0 to 10, or the course's own scene, 11
    #[arg(long, value_name = "N", default_value_t = 11, value_parser = clap::value_parser!(u8).range(0..=11))]
    version: u8,

    /// The scene at this second
    #[arg(long, value_name = "S", default_value_t = 0.0)]
    time: f64,

    #[command(flatten)]
    turntable: TurntableFlag,
}

struct Scenes {
    flags: Flags,
}

impl Program for Scenes {
    type Flags = Flags;
    type Method = Sizes;

    const LESSON: Lesson = scene::LESSON;
    const METHODS: &[Method<Sizes>] = METHODS;
    const DEFAULT: &str = "by-size";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        Ok(Self { flags })
    }

    fn size(&self) -> (u16, u16) {
        (1024, 768)
    }

    fn draw(&mut self, sizes: &Sizes, picture: &mut Image) -> anyhow::Result<Extras> {
        let mut simulation = Simulation::new(&VERSIONS[usize::from(self.flags.version)], sizes)?;
        simulation.advance(Duration::from_secs_f64(self.flags.time));
        let mut target = Target::new(picture.width() as u16, picture.height() as u16);
        let counts = simulation.draw(&mut target);
        *picture = target.into_picture();
        Ok(Extras { depth: None, left_out: counts.triangles.left_out })
    }

    fn show(&mut self, sizes: &Sizes, output: &Output) -> anyhow::Result<()> {
        output.one(self, sizes)
    }
}

fn main() -> ExitCode {
    run::<Scenes>()
}
