//! Measures every row of every table of methods, and draws the charts.
//!
//! A table has its file, named after its lesson, with a `Chart`: what is measured, against what, over which
//! inputs. `LESSONS` lists them; the rest is the same for all. Figures are measured once and kept as CSV and JSON;
//! the charts are drawn from these, whenever they should look otherwise.

mod builds;
mod card;
mod counts;
mod digits;
mod draw;
mod edges;
mod far;
mod fast;
mod finding;
pub(crate) mod finish;
mod flight;
mod frontier;
mod head;
mod lit;
mod machine;
mod maps;
pub(crate) mod measure;
pub(crate) mod models;
mod needs;
mod place;
mod savings;
pub(crate) mod scene;
mod scenes;
mod speed;
mod summary;
pub(crate) mod table;
mod timer;
mod walks;

use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use anyhow::{Context, bail, ensure};
use common::file::write_whole;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use crate::lessons::all_charts;

use builds::Builds;
use card::{LAYOUTS, hues};
use digits::{known_digits, last_digit, three_digits};
use frontier::{Figure, close, contradicted};
use machine::{Machine, processor};
use measure::{Effort, Errors, Work};
use speed::spread;
use table::{
    Chart, Point, Row, Series, number, read_points, read_rows, rows, series_of, write_points, write_rows,
};

pub use timer::serve;

/// A comparison that is no table's, most of them of whole pictures: its pieces of work, how it is measured, and how it is drawn.
struct Comparison {
    name: &'static str,
    works: fn(usize) -> anyhow::Result<Vec<Work>>,
    measure: fn(&mut Run) -> anyhow::Result<()>,
    draw: fn(&Path) -> anyhow::Result<Pictures>,
}

/// The comparisons that are no table's.
const COMPARISONS: &[Comparison] = &[
    far::COMPARISON,
    savings::COMPARISON,
    lit::COMPARISON,
    maps::COMPARISON,
    flight::COMPARISON,
    walks::COMPARISON,
    edges::COMPARISON,
    scenes::FRAME,
    scenes::OUTSIDE,
    scenes::HEADS,
    fast::FRONT,
    fast::BACK,
    fast::THREADS,
    fast::ROOFLINE,
    needs::COMPARISON,
    head::COMPARISON,
    finish::COMPARISON,
];

/// Charts: what is behind the name of each file, and the SVG.
type Pictures = Vec<(String, String)>;

/// Where the book's charts are.
const COMMITTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../pages/charts");

/// What says in short which method to take.
const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../README.md");

/// What to measure, and where to put it.
#[derive(clap::Args)]
pub struct Flags {
    /// The folder for the charts [default: the book's own; with --quick out/charts]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// One lesson alone, by its number
    #[arg(long, value_name = "NN")]
    lesson: Option<String>,

    /// Take a twentieth of the samples and an eighth of the time; the charts say so
    #[arg(long)]
    quick: bool,

    /// What the random inputs follow from
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// For how many seconds to time a table [default: 8; with --quick 1]
    #[arg(long, value_name = "S")]
    seconds: Option<f64>,

    /// Measure nothing; draw the charts again from the figures that are there
    #[arg(long, conflicts_with_all = ["quick", "seconds"])]
    draw: bool,

    /// Measure and draw nothing; write again which method to take when, from the figures of the book's charts
    #[arg(long, exclusive = true)]
    methods: bool,

    /// Draw nothing; check instead that another seed moves no printed mean by more than its last digit
    #[arg(long)]
    second_seed: bool,

    /// Draw nothing; measure N times instead and tell where other methods are beaten by none than in the book's charts
    #[arg(long, value_name = "N")]
    again: Option<u32>,
}

/// A run that measures: how much, with what, and for which folder.
struct Run {
    effort: Effort,
    /// For how long a table is timed.
    time: Duration,
    machine: Machine,
    builds: Builds,
    folder: PathBuf,
}

impl Run {
    fn start(effort: Effort, seconds: Option<f64>, folder: PathBuf) -> anyhow::Result<Self> {
        let time = Duration::from_secs_f64(seconds.unwrap_or(if effort.quick { 1.0 } else { 8.0 }));
        let builds = Builds::start(!effort.quick)?;
        let machine = Machine::find(effort, builds.placements())?;
        Ok(Self { effort, time, machine, builds, folder })
    }

    /// How fast each piece of work of that name and size is, timed for a share of the time of a table. For less than a
    /// whole one, newer processors are left out.
    fn speeds(&mut self, name: &str, size: usize, share: f64) -> anyhow::Result<Vec<speed::Speed>> {
        self.builds.time(name, size, self.effort.seed, self.time.mul_f64(share), share >= 1.0)
    }

    /// Writes the facts about a measurement, with those of the machine.
    fn write_facts(&self, name: &str, mut facts: serde_json::Value) -> anyhow::Result<()> {
        facts["machine"] = serde_json::to_value(&self.machine)?;
        facts["caption"] = self.machine.caption().into();
        facts["quick"] = self.effort.quick.into();
        facts["seed"] = self.effort.seed.into();
        let path = self.folder.join(name).with_extension("json");
        Ok(write_whole(&path, format!("{facts:#}\n").as_bytes())?)
    }
}

/// Measures and draws what the flags ask for.
///
/// # Errors
/// What cannot be measured or written, in one line.
pub fn run(flags: &Flags) -> anyhow::Result<()> {
    if flags.methods {
        return write_summary();
    }
    ensure!(
        !cfg!(debug_assertions),
        "speed is measured in optimised programs: cargo run --release -p book -- charts"
    );
    let effort = Effort { quick: flags.quick || flags.again.is_some(), seed: flags.seed };
    let wanted =
        |name: &str| flags.lesson.as_ref().is_none_or(|lesson| name.starts_with(&format!("{lesson:0>2}-")));
    let charts: Vec<&Chart> = all_charts().into_iter().filter(|chart| wanted(chart.name)).collect();
    ensure!(
        !charts.is_empty(),
        "--lesson {}: no lesson of that number has a table",
        flags.lesson.as_deref().unwrap_or_default()
    );
    if flags.second_seed {
        return second_seed(&charts, effort);
    }
    if let Some(times) = flags.again {
        return again(&charts, times, Run::start(effort, flags.seconds, PathBuf::new())?);
    }
    let folder = folder(flags)?;
    let comparisons: Vec<&Comparison> =
        COMPARISONS.iter().filter(|comparison| wanted(comparison.name)).collect();
    if !flags.draw {
        let mut run = Run::start(effort, flags.seconds, folder.clone())?;
        if same(&folder, Path::new(COMMITTED)) {
            run.machine.ensure_reproducible()?;
        }
        measure_all(&mut run, &charts, &comparisons)?;
    }
    draw_all(&folder, &charts, &comparisons)
}

/// Measures, and writes the figures.
fn measure_all(run: &mut Run, charts: &[&Chart], comparisons: &[&Comparison]) -> anyhow::Result<()> {
    let bar = progress(charts.len() * 3 + comparisons.len())?;
    let wrong = all_errors(charts, run.effort, &bar);
    for (chart, (errors, series)) in charts.iter().zip(wrong) {
        measure(run, chart, &errors, &series, &bar)?;
    }
    for comparison in comparisons {
        bar.set_message(comparison.name);
        (comparison.measure)(run)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

/// How wrong the methods of a table are: over samples, and under stress.
type Wrong = (Vec<Errors>, Vec<Series>);

/// The errors of all tables and how they grow under stress, on all of the machine's cores, while nothing is timed.
fn all_errors(charts: &[&Chart], effort: Effort, bar: &ProgressBar) -> Vec<Wrong> {
    bar.set_message("errors");
    let next = AtomicUsize::new(0);
    let found: Mutex<BTreeMap<usize, Wrong>> = Mutex::default();
    let work = || {
        loop {
            let n = next.fetch_add(1, Ordering::Relaxed);
            let Some(chart) = charts.get(n) else { return };
            let wrong = ((chart.errors)(effort), (chart.stability.measure)(effort));
            bar.inc(1);
            found.lock().unwrap_or_else(PoisonError::into_inner).insert(n, wrong);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, NonZero::get) {
            scope.spawn(work);
        }
    });
    found.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().collect()
}

/// Draws the charts of the figures that are in a folder, and writes which method to take when.
fn draw_all(folder: &Path, charts: &[&Chart], comparisons: &[&Comparison]) -> anyhow::Result<()> {
    let drawn =
        charts.iter().map(|chart| table_pictures(chart, folder).map(|pictures| (chart.name, pictures)));
    let others =
        comparisons.iter().map(|comparison| (comparison.draw)(folder).map(|pictures| ("", pictures)));
    for pictures in drawn.chain(others) {
        let (name, pictures) = pictures?;
        for (ending, svg) in pictures {
            let path = folder.join(format!("{name}{ending}.svg"));
            write_whole(&path, svg.as_bytes())?;
            println!("{}", path.display());
        }
    }
    if same(folder, Path::new(COMMITTED)) {
        write_summary()
    } else if charts.len() == all_charts().len() {
        summary::write(&all_charts(), folder)
    } else {
        Ok(())
    }
}

/// Writes which method to take when, from the figures of the book's charts: there and in the README.
///
/// # Errors
/// Figures that are not there.
fn write_summary() -> anyhow::Result<()> {
    let folder = Path::new(COMMITTED);
    summary::write(&all_charts(), folder)?;
    summary::write_readme(folder, Path::new(README))
}

/// What a worst error is a bound of.
fn bound(chart: &Chart) -> &'static str {
    if chart.exhaustive { "exhaustive: a maximum" } else { "sampled: a lower bound" }
}

/// The folder for the charts. Quick ones are not to be mistaken for the book's.
fn folder(flags: &Flags) -> anyhow::Result<PathBuf> {
    let committed = Path::new(COMMITTED);
    let folder = match &flags.out {
        Some(folder) => {
            ensure!(folder.is_dir(), "--out {}: there is no such folder", folder.display());
            folder.clone()
        }
        None => {
            let folder = if flags.quick { PathBuf::from("out/charts") } else { committed.into() };
            std::fs::create_dir_all(&folder)
                .with_context(|| format!("cannot create the folder {}", folder.display()))?;
            folder
        }
    };
    ensure!(
        !(flags.quick && same(&folder, committed)),
        "--quick does not overwrite the book's charts: give another --out"
    );
    Ok(folder)
}

/// Whether two paths lead to one folder.
fn same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// A bar for so many steps.
fn progress(steps: usize) -> anyhow::Result<ProgressBar> {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} {elapsed}")?;
    Ok(ProgressBar::new(steps as u64).with_style(style))
}

/// The pieces of work of that name and size: of a table or of a comparison.
fn works(name: &str, size: usize, effort: Effort) -> Option<Vec<Work>> {
    let table =
        all_charts().into_iter().find(|chart| chart.name == name).map(|chart| (chart.work)(size, effort));
    table.or_else(|| {
        let comparison = COMPARISONS.iter().find(|comparison| comparison.name == name)?;
        (comparison.works)(size).ok()
    })
}

/// Times one table and writes its figures.
fn measure(
    run: &mut Run,
    chart: &Chart,
    errors: &[Errors],
    series: &[Series],
    bar: &ProgressBar,
) -> anyhow::Result<()> {
    bar.set_message(format!("{}: speed", chart.name));
    let speeds = run.speeds(chart.name, chart.sizes.usual, 1.0)?;
    let rows = rows(chart, errors, &speeds);
    bar.inc(1);
    bar.set_message(format!("{}: growth", chart.name));
    let growth = growth(chart, run)?;
    ensure!(series.len() == rows.len(), "{}: a method has no stability", chart.name);

    let path = |ending: &str| run.folder.join(format!("{}{ending}", chart.name));
    write_rows(&rows, chart.further, &path(".csv"))?;
    write_points(&growth, ["method", "size", "nanoseconds"], &path("-growth.csv"))?;
    write_points(&points(chart, series), ["method", "stress", "error"], &path("-stability.csv"))?;
    let samples: Vec<usize> = errors.iter().map(Errors::samples).collect();
    let facts = json!({
        "job": chart.job,
        "error": { "what": chart.error.name, "unit": chart.error.unit, "limit": chart.error.limit.0, "limit_name": chart.error.limit.1 },
        "error_max": bound(chart),
        "proved_exact": chart.proved,
        "another_job": chart.wrong,
        "samples": { "of": chart.samples, "number": samples },
        "throughput": { "unit": chart.throughput, "timed": chart.timed, "seconds": run.time.as_secs_f64(), "bursts": speeds[0].bursts },
        "growth": { "size": chart.sizes.name, "in_the_chart": chart.sizes.usual, "nanoseconds": per(chart) },
        "stability": { "stress": chart.stability.stress, "error": chart.stability.error.name, "unit": chart.stability.error.unit, "failure_above": chart.stability.error.limit.0 },
    });
    bar.inc(1);
    run.write_facts(chart.name, facts)
}

/// What a time is for, as `per px`.
fn per(chart: &Chart) -> String {
    format!("per {}", chart.throughput.trim_start_matches('M').trim_end_matches("/s"))
}

/// The time for a unit of work, at each size.
fn growth(chart: &Chart, run: &mut Run) -> anyhow::Result<Vec<Point>> {
    /// A quick run leaves out what takes long to make.
    const QUICK: usize = 10_000;
    let mut points = Vec::new();
    if let [_] = chart.sizes.all {
        return Ok(points);
    }
    let quick = run.effort.quick;
    for &size in chart.sizes.all.iter().filter(|&&size| !quick || size <= QUICK) {
        let speeds = run.speeds(chart.name, size, 0.15)?;
        let names = (chart.methods)().into_iter();
        points.extend(names.zip(speeds).map(|(name, speed)| Point::of_time(name, size, &speed)));
    }
    Ok(points)
}

/// The points of a stability chart, as printed.
fn points(chart: &Chart, series: &[Series]) -> Vec<Point> {
    let names = (chart.methods)();
    let point = |name: &str, &(at, value): &(f64, f64)| Point {
        method: name.into(),
        at: three_digits(at),
        value: three_digits(value),
    };
    names
        .iter()
        .zip(series)
        .flat_map(|(name, points)| points.iter().map(move |found| point(name, found)))
        .collect()
}

/// The charts of one table, in both layouts, from its figures.
fn table_pictures(chart: &Chart, folder: &Path) -> anyhow::Result<Pictures> {
    let path = |ending: &str| folder.join(format!("{}{ending}", chart.name));
    let rows = read_rows(&path(".csv"))?;
    let growth = read_points(&path("-growth.csv"))?;
    let stability = read_points(&path("-stability.csv"))?;
    let caption = caption(folder, chart.name)?;
    let mut pictures = Vec::new();
    for layout in &LAYOUTS {
        let mut add = |ending: &str, svg: String| pictures.push((format!("{ending}{}", layout.ending), svg));
        add("", draw::speed(&speed_chart(chart, &rows, &caption), layout)?);
        add("-stability", draw::lines(&stability_chart(chart, &stability, &caption), layout)?);
        if !growth.is_empty() {
            add("-growth", draw::lines(&growth_chart(chart, &growth, &caption), layout)?);
        }
    }
    Ok(pictures)
}

/// What a measurement was made on and with, from its facts.
fn caption(folder: &Path, name: &str) -> anyhow::Result<String> {
    let path = folder.join(name).with_extension("json");
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let facts: serde_json::Value = serde_json::from_str(&text).with_context(|| path.display().to_string())?;
    Ok(facts["caption"].as_str().unwrap_or_default().into())
}

fn speed_chart<'a>(chart: &'a Chart, rows: &[Row], caption: &str) -> draw::Speed<'a> {
    let bound = if chart.exhaustive { "these are all" } else { "worst cases are lower bounds" };
    let close = close(&rows.iter().map(Row::figure).collect::<Vec<_>>());
    let hues = hues(rows.iter().map(|row| row.does_the_job));
    let dot = |((row, close), hue): ((&Row, &bool), &Option<usize>)| draw::Dot {
        name: row.method.clone(),
        hue: *hue,
        worst: row.error_max.clone(),
        mean: row.error_mean.clone(),
        exact: row.is_exact(chart),
        speed: spread(&row.figure().builds),
        frontier: row.frontier,
        close: *close,
        does_it: row.does_the_job,
    };
    let none = rows.iter().filter(|row| row.error_max == "0").all(|row| row.is_exact(chart));
    let mut lines = vec![
        format!("{}. Errors over {}; {bound}.", chart.job, chart.samples),
        format!("Timed: {}.", chart.timed),
        caption.into(),
    ];
    lines.extend(summary::otherwise(rows).map(|order| format!("Built for x86-64-v3, {order}.")));
    draw::Speed {
        name: chart.name,
        title: finding::table(chart, rows),
        error: &chart.error,
        none: if none { "exact" } else { "none found" },
        speed: chart.throughput.into(),
        times: false,
        dots: rows.iter().zip(&close).zip(&hues).map(dot).collect(),
        caption: lines,
    }
}

/// The points of each method, in order.
fn series(chart: &Chart, points: &[Point]) -> Vec<Series> {
    (chart.methods)().into_iter().map(|method| series_of(method, points)).collect()
}

/// Error against stress, methods that behave alike as one line, their first failures ringed.
fn stability_chart<'a>(chart: &'a Chart, points: &[Point], caption: &str) -> draw::Lines<'a> {
    let error = &chart.stability.error;
    let mut lines = draw::alike(&(chart.methods)(), chart.wrong, &series(chart, points));
    for line in &mut lines {
        line.ringed = line.points.iter().position(|point| point.1 > error.limit.0);
    }
    let ringed = lines.iter().any(|line| line.ringed.is_some());
    draw::Lines {
        name: chart.name,
        title: finding::stability(&lines, chart.stability.stress),
        reading: format!(
            "{}Methods with the same figures share a line.",
            if ringed { "◯ the first failure. " } else { "" }
        ),
        across: format!("{}; harder →", chart.stability.stress),
        falling: chart.stability.falling,
        what: error.name,
        unit: error.unit,
        limit: Some(error.limit),
        lines,
        caption: vec![format!("{}.", chart.job), caption.into()],
    }
}

/// The cost of a unit of work against the size of the work.
fn growth_chart<'a>(chart: &'a Chart, points: &[Point], caption: &str) -> draw::Lines<'a> {
    let methods = (chart.methods)().into_iter().zip(series(chart, points));
    let doing = methods.filter(|(name, _)| !chart.wrong.contains(name));
    let line = |(hue, (name, points)): (usize, (&str, Series))| draw::Line {
        name: name.into(),
        hue: Some(hue),
        points,
        ringed: None,
        does_it: true,
    };
    let others = if chart.wrong.is_empty() { "" } else { " What does another job is left out." };
    draw::Lines {
        name: chart.name,
        title: finding::growth(chart, points),
        reading: format!("The time {}, for work of each size.{others}", per(chart)),
        across: format!("{} →", chart.sizes.name),
        falling: false,
        what: "time",
        unit: "ns",
        limit: None,
        lines: doing.enumerate().map(line).collect(),
        caption: vec![format!("{}.", chart.job), caption.into()],
    }
}

/// Measures all errors with this seed and the next, and compares what would be printed.
fn second_seed(charts: &[&Chart], effort: Effort) -> anyhow::Result<()> {
    let bar = progress(charts.len())?;
    let mut moved = Vec::new();
    for chart in charts {
        bar.set_message(chart.name);
        let printed = |seed| -> Vec<String> {
            let errors = (chart.errors)(Effort { seed, ..effort });
            errors.iter().map(|errors| known_digits(errors.mean(), errors.standard_error())).collect()
        };
        let (first, second) = (printed(effort.seed), printed(effort.seed + 1));
        for (method, (a, b)) in (chart.methods)().iter().zip(first.iter().zip(&second)) {
            if a != b && (number(a) - number(b)).abs() > 1.01 * last_digit(a).max(last_digit(b)) {
                moved.push(format!("{}, {method}: {a}, then {b}", chart.name));
            }
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    if !moved.is_empty() {
        bail!("means moved by more than their last digit, take more samples: {}", moved.join("; "));
    }
    println!("no printed mean moved by more than its last digit");
    Ok(())
}

/// Measures tables so many times, and compares each time which methods none beats with the book's figures. A method has
/// moved where both are sure of it, and of opposite things, in three measurements in a row. That is told, and is no error:
/// functions lie elsewhere in each build, of which there are only three, and machines of one name differ. What was measured
/// on another processor is told apart.
fn again(charts: &[&Chart], times: u32, mut run: Run) -> anyhow::Result<()> {
    const IN_A_ROW: u32 = 3;
    let bar = progress(charts.len() * times as usize)?;
    let figures = |rows: &[Row]| rows.iter().map(Row::figure).collect::<Vec<_>>();
    let (mut moved, mut elsewhere) = (BTreeSet::new(), BTreeSet::new());
    let (mut all, mut unsure, mut repeated) = (0, 0, 0);
    for chart in charts {
        bar.set_message(chart.name);
        let expected = figures(&read_rows(&Path::new(COMMITTED).join(format!("{}.csv", chart.name)))?);
        all += expected.len();
        unsure += close(&expected).into_iter().filter(|close| *close).count();
        // Another processor may be faster at other things.
        let here = committed_processor(chart.name)? == processor();
        let found = if here { &mut moved } else { &mut elsewhere };
        for _ in 0..times {
            let mut contradict = vec![true; expected.len()];
            for n in 0..IN_A_ROW {
                repeated += u32::from(n > 0);
                let speeds = run.speeds(chart.name, chart.sizes.usual, 1.0)?;
                // It is times that are measured again: a quick run's errors would be those of fewer samples.
                let now = expected
                    .iter()
                    .zip(speeds)
                    .map(|(then, now)| Figure { builds: now.builds, ..then.clone() });
                let now = contradicted(&expected, &now.collect::<Vec<_>>());
                contradict.iter_mut().zip(now).for_each(|(all, now)| *all &= now);
                if !contradict.contains(&true) {
                    break;
                }
            }
            let names = (chart.methods)().into_iter().zip(contradict).filter(|(_, is)| *is);
            found.extend(names.map(|(name, _)| format!("{}: {name}", chart.name)));
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    println!(
        "measured {times} times; {unsure} of {all} methods are close calls; {repeated} measurements were repeated"
    );
    let [moved, elsewhere] = [moved, elsewhere].map(|names| names.into_iter().collect::<Vec<String>>());
    if !elsewhere.is_empty() {
        println!("on another processor than the book's it is otherwise with these: {}", elsewhere.join("; "));
    }
    if moved.is_empty() {
        println!(
            "the methods that none beats are those of the book's charts, where these were measured on this processor"
        );
    } else {
        println!("the book's charts say otherwise of these, measure them again: {}", moved.join("; "));
    }
    Ok(())
}

/// The processor on which a chart of the book was measured.
fn committed_processor(chart: &str) -> anyhow::Result<String> {
    let path = Path::new(COMMITTED).join(format!("{chart}.json"));
    let facts: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(&path)?)?;
    Ok(facts["machine"]["processor"].as_str().unwrap_or_default().into())
}

#[cfg(test)]
mod tests;
