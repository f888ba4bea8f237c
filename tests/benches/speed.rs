//! How fast the course draws: `cargo bench -p verify --bench speed`, some minutes.
//!
//! Every method draws every scene of `speed_scenes`, with two filters, on one thread and, where it has threads, on two.
//! They take turns, in another order each round, so that ratios hold on a machine that is now fast and now slow. A
//! picture is cleared and drawn; both are timed. All methods must draw the same picture.
//!
//! Times are those of a quiet machine. On a busy one `--processor-time` tells those of one thread all the same.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Duration;

use clap::Parser;
use clap::builder::PossibleValuesParser;
use common::Image;
use speed_scenes::clock::Clock;
use speed_scenes::methods::{Drawer, FILTERS, drawer, ways};
use speed_scenes::rounds::{Limits, Times, rounds};
use speed_scenes::{Recipe, SCENES};

#[derive(Parser)]
struct Flags {
    /// A scene, by its name; may be given more than once
    #[arg(long, value_parser = names(SCENES.iter().map(|scene| scene.name)))]
    scene: Vec<String>,

    /// A method, by its name; may be given more than once. The first is always there
    #[arg(long, value_parser = names(ways().iter().map(|way| way.name)))]
    method: Vec<String>,

    /// A filter, by its name; may be given more than once
    #[arg(long, value_parser = names(FILTERS.into_iter()))]
    filter: Vec<String>,

    /// How many rounds a scene
    #[arg(long, value_name = "N", default_value_t = 21)]
    rounds: usize,

    /// Fewer rounds, but at least 3, where they would take longer than so many seconds a scene and filter
    #[arg(long, value_name = "S", default_value = "20", value_parser = seconds)]
    seconds: Duration,

    /// Take for the time that for which the program has a processor, on one thread alone
    #[arg(long)]
    processor_time: bool,

    /// What cargo passes
    #[arg(long, hide = true)]
    bench: bool,
}

fn names(names: impl Iterator<Item = &'static str>) -> PossibleValuesParser {
    names.collect::<Vec<_>>().into()
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds.ok_or_else(|| "give a number that is not negative".into())
}

/// Whether a flag asks for a name, or is not given.
fn wanted(flag: &[String], name: &str) -> bool {
    flag.is_empty() || flag.iter().any(|given| given == name)
}

fn main() -> ExitCode {
    let flags = Flags::parse();
    let first = ways()[0].name;
    let clock = if flags.processor_time { Clock::Processor } else { Clock::Wall };
    let methods: Vec<(&str, usize)> = ways()
        .iter()
        .filter(|way| way.name == first || wanted(&flags.method, way.name))
        .flat_map(|way| way.threads.iter().map(|&threads| (way.name, threads)))
        .filter(|(_, threads)| *threads == 1 || clock == Clock::Wall)
        .collect();
    println!("Milliseconds a picture: median (p25–p75), and the median's ratio to {first}'s.\n");
    let columns: Vec<String> =
        methods.iter().map(|(name, threads)| format!("{name}, {threads} thr.")).collect();
    println!("| scene | filter | {} |", columns.join(" | "));
    println!("|---|---|{}", "---|".repeat(columns.len()));
    let limits = Limits { rounds: flags.rounds, time: flags.seconds };
    for recipe in SCENES.iter().filter(|recipe| wanted(&flags.scene, recipe.name)) {
        if let Err(fault) = print_scene(recipe, &methods, &flags.filter, (limits, clock)) {
            eprintln!("error: {fault}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

/// Times a scene, and prints its lines of the table.
fn print_scene(
    recipe: &Recipe,
    methods: &[(&str, usize)],
    filters: &[String],
    (limits, clock): (Limits, Clock),
) -> Result<(), String> {
    let scene = (recipe.make)();
    let surface = scene.surface();
    for filter in FILTERS.into_iter().filter(|filter| wanted(filters, filter)) {
        let start = |&(method, threads): &(&str, usize)| drawer(method, filter, threads, scene.size);
        let mut drawers: Vec<Drawer> = methods.iter().map(start).collect();
        let mut expected: Option<Image> = None;
        let mut image = scene.canvas();
        let times = rounds(drawers.len(), limits, |n| {
            let (_, taken) = clock.time(|| black_box(drawers[n](&surface, &mut image)));
            if *expected.get_or_insert_with(|| image.clone()) == image {
                return Ok(taken);
            }
            let (method, threads) = methods[n];
            Err(format!("{}, {filter}: {method} on {threads} threads draws another picture", recipe.name))
        })?;
        let cell = |Times { p25, median, p75 }: &Times| {
            format!("{median:.2} ({p25:.2}–{p75:.2}) {:.2}×", median / times[0].median)
        };
        let cells: Vec<String> = times.iter().map(cell).collect();
        println!("| {} | {filter} | {} |", recipe.title, cells.join(" | "));
    }
    Ok(())
}
