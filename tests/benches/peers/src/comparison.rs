//! All renderers on all scenes, in turn.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::ensure;
use clap::builder::PossibleValuesParser;
use common::{Format, Image};
use speed_scenes::clock::Clock;
use speed_scenes::methods::{Way, ways};
use speed_scenes::rounds::{Limits, rounds};
use speed_scenes::{Recipe, SCENES, Scene};

use crate::child::Running;
use crate::facts::Facts;
use crate::table::{Cell, line, print, write_csv};
use crate::{existing, file};

/// What to compare, and for how long.
#[derive(clap::Args)]
pub(crate) struct Flags {
    /// A scene, by its name; may be given more than once
    #[arg(long, value_parser = PossibleValuesParser::from(SCENES.iter().map(|scene| scene.name).collect::<Vec<_>>()))]
    scene: Vec<String>,

    /// A method of ours, by its name; may be given more than once. The first is always there
    #[arg(long, value_parser = PossibleValuesParser::from(ways().iter().map(|way| way.name).collect::<Vec<_>>()))]
    method: Vec<String>,

    /// How many rounds a scene
    #[arg(long, value_name = "N", default_value_t = 21)]
    rounds: usize,

    /// Fewer rounds, but at least 3, where they would take longer than so many seconds a scene
    #[arg(long, value_name = "S", default_value = "30", value_parser = seconds)]
    seconds: Duration,

    /// Take for the time that for which a renderer has a processor, on one core alone: on a machine that is not quiet
    #[arg(long)]
    processor_time: bool,

    /// The two processors to draw on; the first is that on which one core draws
    #[arg(long, value_name = "N,N", default_value = "0,1", value_parser = two_processors)]
    processors: (String, String),

    /// Also write the figures as CSV, and beside them, as JSON, what they were measured on
    #[arg(long, value_name = "FILE", value_parser = in_a_folder)]
    csv: Option<PathBuf>,

    /// Also write every picture into this folder
    #[arg(long, value_name = "DIR", value_parser = existing)]
    pictures: Option<PathBuf>,

    /// This program, built as peers are fastest
    #[arg(long, value_name = "PROGRAM", value_parser = existing)]
    best: PathBuf,

    /// Ours from that build, too
    #[arg(long)]
    native: bool,

    /// llvmpipe.c, compiled
    #[arg(long, value_name = "PROGRAM", value_parser = existing)]
    llvmpipe: Option<PathBuf>,
}

impl Flags {
    fn clock(&self) -> Clock {
        if self.processor_time { Clock::Processor } else { Clock::Wall }
    }

    /// On how many cores everyone draws.
    fn cores(&self) -> &'static [usize] {
        if self.processor_time { &[1] } else { &[1, 2] }
    }
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds.ok_or_else(|| "give a number that is not negative".into())
}

/// A file that can be written once all is measured.
fn in_a_folder(text: &str) -> Result<PathBuf, String> {
    let path = std::path::absolute(text).map_err(|error| error.to_string())?;
    if path.parent().is_some_and(Path::is_dir) { Ok(path) } else { Err("there is no such folder".into()) }
}

fn two_processors(text: &str) -> Result<(String, String), String> {
    let numbers = |(a, b): (&str, &str)| a.parse::<u16>().is_ok() && b.parse::<u16>().is_ok() && a != b;
    let two = text.split_once(',').filter(|two| numbers(*two));
    two.map(|(a, b)| (a.into(), b.into())).ok_or_else(|| "give two numbers, as in 0,1".into())
}

/// Who draws, and on how many cores.
struct Contender {
    renderer: String,
    cores: usize,
    method: &'static str,
    /// Which of the running painters does it.
    painter: usize,
}

/// Compares what the flags ask for.
///
/// # Errors
/// What does not run or cannot be written, in one line.
pub(crate) fn run(flags: &Flags) -> anyhow::Result<()> {
    let limits = Limits { rounds: flags.rounds, time: flags.seconds };
    let mut facts = Facts::find();
    let mut cells = Vec::new();
    for recipe in SCENES.iter().filter(|recipe| wanted(&flags.scene, recipe.name)) {
        let measured = compare(recipe, flags, limits, &mut facts)?;
        // Whoever stops the program keeps what there is.
        eprintln!("{}", line(&measured));
        cells.extend(measured);
    }
    facts.load_after();
    print(&cells, &facts, flags.clock());
    flags.csv.as_deref().map_or(Ok(()), |path| write_csv(&cells, &facts, flags.clock(), path))
}

/// Whether a flag asks for a name, or is not given.
fn wanted(flag: &[String], name: &str) -> bool {
    flag.is_empty() || flag.iter().any(|given| given == name)
}

/// Times all renderers on one scene.
fn compare(
    recipe: &'static Recipe,
    flags: &Flags,
    limits: Limits,
    facts: &mut Facts,
) -> anyhow::Result<Vec<Cell>> {
    let folder = tempfile::tempdir()?;
    let scene = (recipe.make)();
    let (mut painters, contenders) = start(&scene, recipe.name, flags, folder.path())?;
    facts.add_renderers(painters.iter().map(|painter| painter.says.as_str()));
    let mut pictures = Vec::new();
    for Contender { renderer, cores, method, painter } in &contenders {
        let bytes = painters[*painter].picture(method, &folder.path().join("picture"))?;
        let [width, height] = scene.size;
        let mut image = Image::new(width, height, Format::Rgb);
        ensure!(bytes.len() == image.buffer().len(), "{renderer}'s picture has another size");
        image.buffer_mut().copy_from_slice(&bytes);
        if let Some(folder) = &flags.pictures {
            image.write(&folder.join(format!("{}-{renderer}-{cores}.png", recipe.name)))?;
        }
        pictures.push(image);
    }
    let times = rounds(contenders.len(), limits, |n| {
        let Contender { method, painter, .. } = contenders[n];
        painters[painter].draw(method, flags.clock())
    })?;
    let cell = |((contender, times), picture): ((Contender, _), &Image)| Cell {
        recipe,
        renderer: contender.renderer,
        cores: contender.cores,
        times,
        differing: differing(picture, &pictures[0]),
    };
    Ok(contenders.into_iter().zip(times).zip(&pictures).map(cell).collect())
}

/// Starts what draws a scene.
fn start(
    scene: &Scene,
    name: &str,
    flags: &Flags,
    folder: &Path,
) -> anyhow::Result<(Vec<Running>, Vec<Contender>)> {
    let (first, second) = &flags.processors;
    let processors = |cores: usize| if cores == 1 { first.clone() } else { format!("{first},{second}") };
    let (mut painters, mut contenders) = (Vec::new(), Vec::new());

    let mut methods = ways();
    let first = methods[0].name;
    methods.retain(|way| way.name == first || wanted(&flags.method, way.name));
    let this = std::env::current_exe()?;
    let builds = [(this.as_path(), ""), (&flags.best, " (native)")];
    for (program, note) in builds.into_iter().take(1 + usize::from(flags.native)) {
        for &cores in flags.cores() {
            let painter = painters.len();
            for Way { name: method, .. } in methods.iter().filter(|way| way.threads.contains(&cores)) {
                let renderer = format!("{method}{note}");
                contenders.push(Contender { renderer, cores, method, painter });
            }
            if contenders.last().is_some_and(|last| last.painter == painter) {
                let mut command = Command::new(program);
                command.args(["paint", "ours", name, &cores.to_string()]);
                painters.push(Running::start(&processors(cores), &command)?);
            }
        }
    }

    let mut peer = |renderer: &str, cores: usize, command: &Command| -> anyhow::Result<()> {
        let painter = painters.len();
        contenders.push(Contender { renderer: renderer.into(), cores, method: "any", painter });
        painters.push(Running::start(&processors(cores), command)?);
        Ok(())
    };
    let mut command = Command::new(&flags.best);
    peer("euc", 1, command.args(["paint", "euc", name, "1"]))?;
    if let Some(llvmpipe) = &flags.llvmpipe {
        let path = folder.join("scene");
        file::write(scene, &path)?;
        for &cores in flags.cores() {
            let mut command = Command::new(llvmpipe);
            peer("llvmpipe", cores, command.arg(&path).env("LP_NUM_THREADS", cores.to_string()))?;
        }
    }
    Ok((painters, contenders))
}

/// The share of the pixels that have a channel which differs by more than this many levels.
pub(crate) const LEVELS: u8 = 3;

fn differing(a: &Image, b: &Image) -> f64 {
    let pixels = a.buffer().chunks_exact(3).zip(b.buffer().chunks_exact(3));
    let count = pixels.len();
    let differ = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > LEVELS);
    pixels.filter(differ).count() as f64 / count as f64
}
