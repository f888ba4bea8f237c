//! Measures every row of every table of methods, and draws the charts.
//!
//! A table has its file here, named after its lesson, with a [`Chart`]: what is measured, against what, over
//! which inputs. `CHARTS` lists them; the rest is the same for all.

mod draw;
mod figures;
mod finish;
mod frame;
mod frontier;
mod head;
mod machine;
pub(crate) mod measure;
pub(crate) mod models;
mod needs;
mod place;
pub(crate) mod scene;
mod summary;
pub(crate) mod table;

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, bail, ensure};
use common::file::write_whole;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use crate::lessons;
use figures::{known_digits, last_digit, three_digits};
use machine::Machine;
use measure::{Effort, alternate};
use table::{Chart, Point, Series, number, rows, write_points, write_rows};

/// The tables of methods, in the order of the lessons.
const CHARTS: &[Chart] = &[
    lessons::lines::charts::CHART,
    lessons::wireframe::charts::CHART,
    lessons::triangles::charts::CHART,
    lessons::zbuffer::charts::CHART,
    lessons::textures::charts::CHART,
    lessons::gouraud::charts::CHART,
    lessons::transforms::charts::METHODS_CHART,
    lessons::transforms::charts::ROTATIONS_CHART,
    lessons::transforms::charts::INVERSES_CHART,
    lessons::camera::charts::CHART,
    lessons::shaders::charts::METHODS_CHART,
    lessons::shaders::charts::SHADERS_CHART,
];

/// Where the book's charts are.
const COMMITTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/pages/charts");

/// What says in short which method to take.
const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../README.md");

/// What to measure, and where to put it.
#[derive(clap::Args)]
pub(crate) struct Flags {
    /// The folder for the charts [default: the book's own; with --quick out/charts]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// One lesson alone, by its number
    #[arg(long, value_name = "NN")]
    lesson: Option<String>,

    /// Take a twentieth of the samples and of the time; the charts say so
    #[arg(long)]
    quick: bool,

    /// What the random inputs follow from
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// Draw nothing; check instead that another seed moves no printed mean by more than its last digit
    #[arg(long)]
    second_seed: bool,
}

/// Measures and draws what the flags ask for.
pub(crate) fn run(flags: &Flags) -> anyhow::Result<()> {
    ensure!(
        !cfg!(debug_assertions),
        "speed is measured in optimised programs: cargo run --release -p book -- charts"
    );
    let effort = Effort { quick: flags.quick, seed: flags.seed };
    let wanted =
        |name: &str| flags.lesson.as_ref().is_none_or(|lesson| name.starts_with(&format!("{lesson:0>2}-")));
    let charts: Vec<&Chart> = CHARTS.iter().filter(|chart| wanted(chart.name)).collect();
    ensure!(
        !charts.is_empty(),
        "--lesson {}: no lesson of that number has a table",
        flags.lesson.as_deref().unwrap_or_default()
    );
    if flags.second_seed {
        return second_seed(&charts, effort);
    }
    measure_into(&folder(flags)?, &charts, effort, flags.lesson.is_none())
}

/// Measures those of the book's charts that are not there.
pub(crate) fn measure_missing(quick: bool) -> anyhow::Result<()> {
    let folder = Path::new(COMMITTED);
    let is_missing = |name: &str| !folder.join(format!("{name}.svg")).is_file();
    let missing: Vec<&Chart> = CHARTS.iter().filter(|chart| is_missing(chart.name)).collect();
    let scenes = [
        "needs-outline",
        "needs-shading",
        "needs-head-outline",
        "needs-head-shading",
        "finish",
        "finish-flip",
    ]
    .iter()
    .any(|name| is_missing(name));
    if missing.is_empty() && !scenes {
        return Ok(());
    }
    std::fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    measure_into(folder, &missing, Effort { quick, seed: 1 }, scenes)
}

/// Measures charts into a folder and, if asked, whole scenes.
fn measure_into(folder: &Path, charts: &[&Chart], effort: Effort, scenes: bool) -> anyhow::Result<()> {
    let machine = Machine::find(effort)?;
    let bar = progress(charts.len() * 4 + if scenes { 2 } else { 0 })?;
    for chart in charts {
        measure(chart, effort, &machine, folder, &bar)?;
        bar.suspend(|| println!("{}", folder.join(chart.name).with_extension("svg").display()));
    }
    if scenes {
        bar.set_message("no more than the scene needs");
        needs::measure(effort, &machine, folder)?;
        head::measure(effort, &machine, folder)?;
        bar.inc(1);
        bar.set_message("the finished picture");
        finish::measure(effort, &machine, folder)?;
        bar.inc(1);
        if same(folder, Path::new(COMMITTED)) {
            write_summary()?;
        } else {
            summary::write(CHARTS, folder)?;
        }
    }
    bar.finish_and_clear();
    Ok(())
}

/// Writes which method to take when, from the figures of the book's charts: there and in the README.
pub(crate) fn write_summary() -> anyhow::Result<()> {
    let folder = Path::new(COMMITTED);
    summary::write(CHARTS, folder)?;
    summary::write_readme(folder, Path::new(README))
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

/// Measures one table and writes its files.
fn measure(
    chart: &Chart,
    effort: Effort,
    machine: &Machine,
    folder: &Path,
    bar: &ProgressBar,
) -> anyhow::Result<()> {
    /// For the chart, and for each size of the work.
    const USUAL: Duration = Duration::from_secs(10);
    const OTHERS: Duration = Duration::from_secs(2);

    let step = |what: &str| {
        bar.inc(1);
        bar.set_message(format!("{}: {what}", chart.name));
    };
    bar.set_message(format!("{}: errors", chart.name));
    let errors = (chart.errors)(effort);
    step("speed");
    let throughputs = alternate(&mut (chart.work)(chart.sizes.usual, effort), USUAL, effort);
    let rows = rows(chart, &errors, &throughputs);
    step("growth");
    let growth = growth(chart, effort, OTHERS);
    step("stability");
    let series = (chart.stability.measure)(effort);
    ensure!(series.len() == rows.len(), "{}: a method has no stability", chart.name);

    let path = |ending: &str| folder.join(format!("{}{ending}", chart.name));
    let caption = machine.caption();
    write_rows(&rows, chart.further, &path(".csv"))?;
    write_points(&growth, ["method", "size", "nanoseconds"], &path("-growth.csv"))?;
    write_points(&points(chart, &series), ["method", "stress", "error"], &path("-stability.csv"))?;
    write_whole(&path(".svg"), draw::table(chart, &rows, &caption)?.as_bytes())?;
    write_whole(&path("-stability.svg"), draw::stability(chart, &series, &caption)?.as_bytes())?;
    let samples: Vec<usize> = errors.iter().map(measure::Errors::samples).collect();
    let facts = json!({
        "machine": machine,
        "quick": effort.quick,
        "seed": effort.seed,
        "job": chart.job,
        "error": { "what": chart.error.name, "unit": chart.error.unit, "limit": chart.error.limit.0, "limit_name": chart.error.limit.1 },
        "error_max": if chart.exhaustive { "exhaustive: a maximum" } else { "sampled: a lower bound" },
        "samples": { "of": chart.samples, "number": samples },
        "throughput": { "unit": chart.throughput, "timed": chart.timed, "rounds": throughputs.iter().map(|found| found.rounds).collect::<Vec<_>>() },
        "growth": { "size": chart.sizes.name, "in_the_chart": chart.sizes.usual, "nanoseconds": format!("per {}", chart.throughput.trim_start_matches('M').trim_end_matches("/s")) },
        "stability": { "stress": chart.stability.stress, "error": chart.stability.error.name, "unit": chart.stability.error.unit, "failure_above": chart.stability.error.limit.0 },
    });
    write_whole(&path(".json"), format!("{facts:#}\n").as_bytes())?;
    step("done");
    Ok(())
}

/// The time for a unit of work, at each size.
fn growth(chart: &Chart, effort: Effort, limit: Duration) -> Vec<Point> {
    /// A quick run leaves out what takes long to make.
    const QUICK: usize = 10_000;
    let sizes = chart.sizes.all.iter().filter(|&&size| !effort.quick || size <= QUICK);
    let names = (chart.methods)();
    sizes
        .flat_map(|&size| {
            let found = alternate(&mut (chart.work)(size, effort), limit, effort);
            let point = |(name, found): (&&str, measure::Throughput)| Point {
                method: (*name).into(),
                at: size.to_string(),
                value: three_digits(1e9 / found.median),
            };
            names.iter().zip(found).map(point).collect::<Vec<_>>()
        })
        .collect()
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

#[cfg(test)]
mod tests {
    use super::frontier::frontier;
    use super::table::read_rows;
    use super::*;

    /// The committed charts, by name.
    fn pictures() -> Vec<(String, String)> {
        let files = std::fs::read_dir(COMMITTED).unwrap().map(|file| file.unwrap().path());
        let charts = files.filter(|path| path.extension().is_some_and(|ending| ending == "svg"));
        charts.map(|path| (path.display().to_string(), std::fs::read_to_string(&path).unwrap())).collect()
    }

    /// What a level line of text covers, if letters are `width` times as wide as high; and the text.
    fn texts(svg: &str, width: f64) -> Vec<(place::Rect, String)> {
        let document = roxmltree::Document::parse(svg).unwrap();
        let level = |node: &roxmltree::Node| node.has_tag_name("text") && !node.has_attribute("transform");
        let measured = |node: roxmltree::Node| {
            let value = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
            let text = node.text().unwrap_or_default().trim().to_string();
            let (x, y, size) = (value("x"), value("y"), value("font-size"));
            let length = text.chars().count() as f64 * size * width;
            let left = match node.attribute("text-anchor") {
                Some("middle") => x - length / 2.0,
                Some("end") => x - length,
                _ => x,
            };
            // Letters stand on, below or about the given height.
            let middle = match node.attribute("dy") {
                Some("0.76em") => y + 0.38 * size,
                Some("-0.5ex") => y - 0.6 * size,
                _ => y,
            };
            (place::Rect::about([left + length / 2.0, middle], length, 0.9 * size), text)
        };
        document.descendants().filter(level).map(measured).collect()
    }

    #[test]
    fn no_text_covers_another_or_leaves_the_card() {
        let (width, height) = (f64::from(frame::SIZE.0), f64::from(frame::SIZE.1));
        assert!(pictures().len() > 2 * CHARTS.len());
        for (chart, svg) in pictures() {
            let texts = texts(&svg, 0.55);
            assert!(texts.len() > 10, "{chart}: text is no text");
            for (n, (place, text)) in texts.iter().enumerate() {
                assert!(
                    place.left >= 0.0 && place.right <= width && place.bottom <= height,
                    "{chart}: {text}"
                );
                for (other, covered) in &texts[..n] {
                    assert!(!place.overlaps(other), "{chart}: {text} covers {covered}");
                }
            }
        }
    }

    #[test]
    fn advice_is_about_methods_that_have_a_result() {
        for (chart, rows) in committed() {
            assert!(!chart.advice.is_empty(), "{}", chart.name);
            for (name, _) in chart.advice {
                let row = rows.iter().find(|row| row.method == *name);
                let row = row.unwrap_or_else(|| panic!("{}: there is no method {name}", chart.name));
                assert!(number(&row.error_max).is_finite(), "{}, {name}", chart.name);
            }
        }
    }

    #[test]
    fn the_summary_is_that_of_the_committed_figures() {
        for (name, text) in summary::pages(CHARTS, Path::new(COMMITTED)).unwrap() {
            let committed = std::fs::read_to_string(Path::new(COMMITTED).join(name)).unwrap();
            assert_eq!(committed, text, "{name}: measure the charts again");
            if name == "methods-short.md" {
                let readme = std::fs::read_to_string(README).unwrap();
                assert_eq!(summary::in_readme(&readme, &text).unwrap(), readme);
            }
        }
    }

    /// The rows of every table, as committed.
    fn committed() -> impl Iterator<Item = (&'static Chart, Vec<table::Row>)> {
        CHARTS.iter().map(|chart| {
            let path = Path::new(COMMITTED).join(format!("{}.csv", chart.name));
            (chart, read_rows(&path).unwrap())
        })
    }

    #[test]
    fn every_method_has_its_row() {
        for (chart, rows) in committed() {
            let methods: Vec<&str> = rows.iter().map(|row| row.method.as_str()).collect();
            assert_eq!(methods, (chart.methods)(), "{}: measure the charts again", chart.name);
        }
    }

    #[test]
    fn the_frontier_is_that_of_the_printed_figures() {
        for (chart, rows) in committed() {
            let figures: Vec<(f64, f64)> =
                rows.iter().map(|row| (number(&row.error_max), number(&row.throughput_median))).collect();
            let printed: Vec<bool> = rows.iter().map(|row| row.frontier).collect();
            assert_eq!(printed, frontier(&figures), "{}", chart.name);
        }
    }

    #[test]
    fn quartiles_are_in_order_and_means_below_worst_cases() {
        for (chart, rows) in committed() {
            for row in rows {
                let [p25, median, p75] = [&row.throughput_p25, &row.throughput_median, &row.throughput_p75]
                    .map(|text| number(text));
                assert!(0.0 < p25 && p25 <= median && median <= p75, "{}, {}", chart.name, row.method);
                assert!(
                    number(&row.error_mean) <= 1.05 * number(&row.error_max),
                    "{}, {}",
                    chart.name,
                    row.method
                );
            }
        }
    }
}
