//! Draws lesson 16's picture: `cargo run --release -p scene`.

use std::process::ExitCode;
use std::time::Duration;

use camera::flags::TurntableFlag;
use common::program::{Extras, Output, Program, UsageError, run};
use common::{Image, Lesson, Method};
use scene::keys::Presses;
use scene::levels::Sizes;
use scene::{METHODS, Simulation, Target, VERSIONS, Version};

/// What `--help` says of the window.
const KEYS: &str = "\
Keys:
  Left    The eye moves to its left around the middle, from version 9 on
  Right   To its right
  Up      It rises
  Down    It sinks
  W       It comes nearer
  S       It goes farther away
  F1      Wireframe, and back, from version 7 on
  F2      Rough edges, and back to smooth ones, from version 10 on
  Space   What moves stops, or goes on; no key for --keys
  Escape  Ends it
The mouse pulls what is seen, and its wheel brings the eye nearer or farther away, from version 9 on.";

#[derive(clap::Args)]
#[command(after_help = KEYS)]
struct Flags {
    /// The version of the assignment, 0 to 10, or the course's own scene, 11
    #[arg(long, value_name = "N", default_value_t = 11, value_parser = clap::value_parser!(u8).range(0..=11))]
    version: u8,

    /// The scene at this second, up to 1000000; in a window it stands still there until Space is pressed
    #[arg(long, value_name = "S", value_parser = seconds)]
    time: Option<Duration>,

    /// Keys that are pressed first, each for a twelfth of a second, as in "F1 Left*10 W*3"
    #[arg(long, value_name = "KEYS", default_value = "", hide_default_value = true)]
    keys: Presses,

    #[command(flatten)]
    turntable: TurntableFlag,
}

/// A time from the beginning, in seconds.
fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().filter(|seconds| (0.0..=1e6).contains(seconds));
    seconds.map(Duration::from_secs_f64).ok_or_else(|| "write a number of seconds from 0 to 1000000".into())
}

struct Scenes {
    flags: Flags,
    /// The scene that was drawn last, and the sizes of its spheres.
    simulation: Option<(Sizes, Simulation)>,
}

impl Scenes {
    fn version(&self) -> &'static Version {
        &VERSIONS[usize::from(self.flags.version)]
    }

    /// The scene with spheres of those sizes, at the time and after the keys that are asked for; read once.
    fn simulation(&mut self, sizes: Sizes) -> anyhow::Result<&mut Simulation> {
        let kept = self.simulation.take().filter(|(kept, _)| *kept == sizes);
        let simulation = match kept {
            Some((_, simulation)) => simulation,
            None => self.read(sizes)?,
        };
        Ok(&mut self.simulation.insert((sizes, simulation)).1)
    }

    fn read(&self, sizes: Sizes) -> anyhow::Result<Simulation> {
        let mut simulation = Simulation::new(self.version(), sizes)?;
        if let Some(time) = self.flags.time {
            simulation.stop_at(time);
        }
        simulation.replay(&self.flags.keys)?;
        Ok(simulation)
    }
}

impl Program for Scenes {
    type Flags = Flags;
    type Method = Sizes;

    const LESSON: Lesson = scene::LESSON;
    const METHODS: &[Method<Sizes>] = METHODS;
    const DEFAULT: &str = "by-size";

    fn load(flags: Flags) -> anyhow::Result<Self> {
        Ok(Self { flags, simulation: None })
    }

    fn size(&self) -> (u16, u16) {
        (1024, 768)
    }

    fn draw(&mut self, sizes: &Sizes, picture: &mut Image) -> anyhow::Result<Extras> {
        let simulation = self.simulation(sizes)?;
        let [width, height] = [picture.width(), picture.height()].map(|side| side as u16);
        if !simulation.fits([width, height]) {
            return Err(too_large(width, height).into());
        }
        let mut target = Target::new(width, height);
        let counts = simulation.draw(&mut target);
        *picture = target.into_picture();
        Ok(Extras { depth: None, left_out: counts.triangles.left_out })
    }

    fn show(&mut self, sizes: &Sizes, output: &Output) -> anyhow::Result<()> {
        let Some(stops) = self.flags.turntable.stops else {
            #[cfg(feature = "window")]
            if !output.has_file() {
                let size = output.size(self);
                return scene::window::run(self.simulation(sizes)?, Target::new(0, 0), size);
            }
            return output.one(self, sizes);
        };
        let Some(start) = self.simulation(sizes)?.orbit() else {
            let number = self.flags.version;
            return Err(
                UsageError(format!("--turntable: version {number} has no camera that could turn")).into()
            );
        };
        output.series(self, sizes, stops, |scenes, n| {
            if let Some((_, simulation)) = &mut scenes.simulation {
                simulation.look_from(start.turned(n, stops));
            }
        })
    }
}

fn too_large(width: u16, height: u16) -> UsageError {
    UsageError(format!(
        "--size {width}x{height}: 16 samples a pixel are too many for it; up to 4096x4096 will do, or --keys F2"
    ))
}

fn main() -> ExitCode {
    run::<Scenes>()
}
