//! How fast the course draws: `cargo bench -p verify --bench speed`, some minutes.
//!
//! Every method draws every scene of `speed_scenes`, with two filters, on one thread and, where it has threads, on two.
//! They take turns, in another order each round, so that ratios hold on a machine that is now fast and now slow. A
//! picture is cleared and drawn; both are timed.

use std::convert::Infallible;
use std::hint::black_box;
use std::iter;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Parser;
use speed_scenes::methods::{Draw, FILTERS, METHODS, Row};
use speed_scenes::rounds::{Limits, Times, rounds};
use speed_scenes::{Recipe, SCENES};

#[derive(Parser)]
struct Flags {
    /// A scene, by its name; may be given more than once
    #[arg(long, value_parser = names(SCENES.iter().map(|scene| scene.name)))]
    scene: Vec<String>,

    /// A method, by its name; may be given more than once. The first is always there
    #[arg(long, value_parser = names(METHODS.iter().map(|row| row.name)))]
    method: Vec<String>,

    /// A filter, by its name; may be given more than once
    #[arg(long, value_parser = names(FILTERS.into_iter()))]
    filter: Vec<String>,

    /// How many rounds a scene
    #[arg(long, value_name = "N", default_value_t = 21)]
    rounds: usize,

    /// Fewer rounds, but at least 3, where they would take longer than so many seconds a scene
    #[arg(long, value_name = "S", default_value_t = 20.0)]
    seconds: f64,

    /// What cargo passes
    #[arg(long, hide = true)]
    bench: bool,
}

fn names(names: impl Iterator<Item = &'static str>) -> clap::builder::PossibleValuesParser {
    names.collect::<Vec<_>>().into()
}

/// Whether a flag asks for a name, or is not given.
fn wanted(flag: &[String], name: &str) -> bool {
    flag.is_empty() || flag.iter().any(|given| given == name)
}

fn main() -> ExitCode {
    let flags = Flags::parse();
    let Ok(time) = Duration::try_from_secs_f64(flags.seconds) else {
        eprintln!("error: --seconds {}: give a time that is not negative", flags.seconds);
        return ExitCode::from(2);
    };
    let limits = Limits { rounds: flags.rounds, time };
    let (first, others) = METHODS.split_first().expect("there are methods");
    let others = others.iter().filter(|row| wanted(&flags.method, row.name));
    let methods: Vec<&Row> = iter::once(first).chain(others).collect();
    println!("Milliseconds a picture: median (p25–p75), and the median's ratio to {}'s.\n", first.name);
    let columns: Vec<String> = methods
        .iter()
        .flat_map(|row| row.threads.iter().map(|threads| format!("{}, {threads} thr.", row.name)))
        .collect();
    println!("| scene | filter | {} |", columns.join(" | "));
    println!("|---|---|{}", "---|".repeat(columns.len()));
    for recipe in SCENES.iter().filter(|recipe| wanted(&flags.scene, recipe.name)) {
        print_scene(recipe, &methods, &flags.filter, limits);
    }
    ExitCode::SUCCESS
}

/// Times a scene, and prints its lines of the table.
fn print_scene(recipe: &Recipe, methods: &[&Row], filters: &[String], limits: Limits) {
    let scene = (recipe.make)();
    let surface = scene.surface();
    let mut image = scene.canvas();
    let drawings: Vec<(Draw, usize)> = filtered(filters)
        .flat_map(|(n, _)| {
            methods.iter().flat_map(move |row| row.threads.iter().map(move |&threads| (row.draw[n], threads)))
        })
        .collect();
    let Ok(times) = rounds(drawings.len(), limits, |n| -> Result<Duration, Infallible> {
        let (draw, threads) = drawings[n];
        let start = Instant::now();
        image.buffer_mut().fill(0);
        draw(&surface, threads, &mut image);
        let taken = start.elapsed();
        black_box(&image);
        Ok(taken)
    });
    let columns = drawings.len() / filtered(filters).count();
    for ((_, filter), times) in filtered(filters).zip(times.chunks(columns)) {
        let cell = |Times { p25, median, p75 }: &Times| {
            format!("{median:.2} ({p25:.2}–{p75:.2}) {:.2}×", median / times[0].median)
        };
        let cells: Vec<String> = times.iter().map(cell).collect();
        println!("| {} | {filter} | {} |", recipe.title, cells.join(" | "));
    }
}

/// The filters that are asked for, with their numbers.
fn filtered(flag: &[String]) -> impl Iterator<Item = (usize, &'static str)> + '_ {
    FILTERS.into_iter().enumerate().filter(|(_, name)| wanted(flag, name))
}
