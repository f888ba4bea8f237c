//! What a chart measures, the rows that come of it, and the files they are kept in.

use std::path::Path;

use anyhow::Context;
use common::file::write_whole;
use serde::{Deserialize, Serialize};

use super::digits::{known_digits, three_digits};
use super::frontier::{Figure, frontier};
use super::measure::{Effort, Errors, Work};
use super::speed::Speed;

/// A table of methods, and what measures it.
pub(crate) struct Chart {
    /// Of its files, as `01-lines`.
    pub(crate) name: &'static str,
    /// The job.
    pub(crate) job: &'static str,
    /// The methods' names, in order.
    pub(crate) methods: fn() -> Vec<&'static str>,
    /// What the error is, and its unit.
    pub(crate) error: Quantity,
    /// What else is counted with the error: names of columns.
    pub(crate) further: &'static [&'static str],
    /// Over what errors are taken, in one line.
    pub(crate) samples: &'static str,
    /// Whether no input of the kind is left out, so that a largest error is a maximum, not a lower bound.
    pub(crate) exhaustive: bool,
    /// Methods of which it is proved that they are exact. Of others a sample without an error is only that.
    pub(crate) proved: &'static [&'static str],
    /// Measures the errors of each method.
    pub(crate) errors: fn(Effort) -> Vec<Errors>,
    /// What is timed, in one line.
    pub(crate) timed: &'static str,
    /// The unit of throughput, in millions a second.
    pub(crate) throughput: &'static str,
    /// The work of each method at a size; before them, where what calls them takes a share of the time that is not
    /// negligible, that of a method that does nothing.
    pub(crate) work: fn(usize, Effort) -> Vec<Work>,
    /// The sizes of the work.
    pub(crate) sizes: Sizes,
    /// How methods fail.
    pub(crate) stability: Stability,
    /// Methods that do another job than the one stated, as the slides' listings with a fault: they are shown, but
    /// neither stand on the frontier nor push others off it.
    pub(crate) wrong: &'static [&'static str],
    /// Which method, when: the first one is the usual choice. What is not named is not for use.
    pub(crate) advice: &'static [(&'static str, &'static str)],
}

/// What an axis shows.
pub(crate) struct Quantity {
    /// Its name.
    pub(crate) name: &'static str,
    /// Its unit.
    pub(crate) unit: &'static str,
    /// What the eye or the format cannot tell from 0, and its name.
    pub(crate) limit: (f64, &'static str),
}

/// Sizes of a piece of work.
pub(crate) struct Sizes {
    /// What is counted, as `pixels a segment`.
    pub(crate) name: &'static str,
    /// All of them.
    pub(crate) all: &'static [usize],
    /// The one in the chart.
    pub(crate) usual: usize,
}

/// What is put under stress, and what then happens.
pub(crate) struct Stability {
    /// What the stress is, with its unit.
    pub(crate) stress: &'static str,
    /// Whether a small stress is the hard one.
    pub(crate) falling: bool,
    /// What is measured. Above its limit it counts as a failure.
    pub(crate) error: Quantity,
    /// The error at each stress, for each method.
    pub(crate) measure: fn(Effort) -> Vec<Series>,
}

/// Stress and error, the easiest first.
pub(crate) type Series = Vec<(f64, f64)>;

/// A row of a chart's CSV file. Figures are as printed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) method: String,
    pub(crate) error_max: String,
    pub(crate) error_mean: String,
    /// The one in the middle of those that builds gave.
    pub(crate) throughput_median: String,
    /// In each build.
    pub(crate) throughput_builds: String,
    pub(crate) unit: String,
    /// Whether it does the job that the table states.
    pub(crate) does_the_job: bool,
    pub(crate) frontier: bool,
    /// Time for the same work, with the fastest method's that does the job as the unit.
    pub(crate) relative_time: String,
    /// The same in builds for newer processors; empty if there were none.
    pub(crate) relative_time_v3: String,
    pub(crate) samples: usize,
    pub(crate) bursts: usize,
    pub(crate) further: Vec<String>,
}

impl Row {
    /// Whether it has no error at all, for whatever input.
    pub(crate) fn is_exact(&self, chart: &Chart) -> bool {
        self.error_max == "0" && (chart.exhaustive || chart.proved.contains(&self.method.as_str()))
    }

    /// What decides about it.
    pub(crate) fn figure(&self) -> Figure {
        Figure {
            error: number(&self.error_max),
            builds: numbers(&self.throughput_builds),
            does_it: self.does_the_job,
        }
    }
}

/// The columns that every table has.
const COLUMNS: [&str; 12] = [
    "method",
    "error_max",
    "error_mean",
    "throughput_median",
    "throughput_builds",
    "unit",
    "does_the_job",
    "frontier",
    "relative_time",
    "relative_time_v3",
    "samples",
    "bursts",
];

/// A row of a stability or growth table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Point {
    pub(crate) method: String,
    pub(crate) at: String,
    pub(crate) value: String,
}

impl Point {
    /// How many nanoseconds a unit of work takes.
    pub(crate) fn of_time(method: &str, at: usize, speed: &Speed) -> Self {
        Self { method: method.into(), at: at.to_string(), value: three_digits(1e9 / speed.median()) }
    }
}

/// What points say of one method, in their order.
pub(crate) fn series_of(method: &str, points: &[Point]) -> Series {
    let own = points.iter().filter(|point| point.method == method);
    own.map(|point| (number(&point.at), number(&point.value))).collect()
}

/// The rows of a chart, with the frontier as the printed figures have it.
pub(crate) fn rows(chart: &Chart, errors: &[Errors], speeds: &[Speed]) -> Vec<Row> {
    let methods = (chart.methods)();
    let does_it = |n: usize| !chart.wrong.contains(&methods[n]);
    let fastest = |rate: fn(&Speed) -> f64| {
        let rates =
            speeds.iter().enumerate().filter(|(n, _)| does_it(*n) && errors[*n].largest().is_finite());
        rates.map(|(_, speed)| rate(speed)).fold(0.0, f64::max)
    };
    let [any, newer] = [fastest(Speed::median), fastest(|speed| speed.newer.unwrap_or(0.0))];
    let row = |(n, (errors, speed)): (usize, (&Errors, &Speed))| Row {
        method: methods[n].into(),
        error_max: three_digits(errors.largest()),
        error_mean: known_digits(errors.mean(), errors.standard_error()),
        throughput_median: three_digits(speed.median() / 1e6),
        throughput_builds: spaced(speed.builds.iter().map(|rate| three_digits(rate / 1e6))),
        unit: chart.throughput.into(),
        does_the_job: does_it(n),
        frontier: false,
        relative_time: ratio(any / speed.median()),
        relative_time_v3: speed.newer.map_or(String::new(), |rate| ratio(newer / rate)),
        samples: errors.samples(),
        bursts: speed.bursts,
        further: errors.further().map(three_digits).collect(),
    };
    let mut rows: Vec<Row> = errors.iter().zip(speeds).enumerate().map(row).collect();
    let figures: Vec<Figure> = rows.iter().map(Row::figure).collect();
    rows.iter_mut().zip(frontier(&figures)).for_each(|(row, best)| row.frontier = best);
    rows
}

/// A ratio of times: two digits behind the point, or three digits.
fn ratio(ratio: f64) -> String {
    if ratio < 10.0 { format!("{ratio:.2}") } else { three_digits(ratio) }
}

/// A printed figure. What is none counts as infinite.
pub(crate) fn number(text: &str) -> f64 {
    text.parse().unwrap_or(f64::INFINITY)
}

/// Between the figures of builds in one cell.
const BETWEEN: &str = " / ";

/// Printed figures in one cell.
pub(crate) fn spaced(figures: impl Iterator<Item = String>) -> String {
    figures.collect::<Vec<_>>().join(BETWEEN)
}

/// The figures in such a cell.
pub(crate) fn numbers(text: &str) -> Vec<f64> {
    text.split(BETWEEN).map(number).collect()
}

/// Writes the rows of a chart as CSV.
pub(crate) fn write_rows(rows: &[Row], further: &[&str], path: &Path) -> anyhow::Result<()> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS.iter().chain(further))?;
    for row in rows {
        let [does_the_job, frontier] = [row.does_the_job, row.frontier].map(|is| is.to_string());
        let [samples, bursts] = [row.samples, row.bursts].map(|count| count.to_string());
        let shared: [&String; COLUMNS.len()] = [
            &row.method,
            &row.error_max,
            &row.error_mean,
            &row.throughput_median,
            &row.throughput_builds,
            &row.unit,
            &does_the_job,
            &frontier,
            &row.relative_time,
            &row.relative_time_v3,
            &samples,
            &bursts,
        ];
        writer.write_record(shared.into_iter().chain(&row.further))?;
    }
    Ok(write_whole(path, &writer.into_inner()?)?)
}

/// Reads them again.
pub(crate) fn read_rows(path: &Path) -> anyhow::Result<Vec<Row>> {
    let mut reader = csv::Reader::from_path(path).with_context(|| path.display().to_string())?;
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record?;
        let cell = |n: usize| record.get(n).unwrap_or_default().to_string();
        let count = |n: usize| cell(n).parse().with_context(|| format!("{}: {}", path.display(), cell(n)));
        rows.push(Row {
            method: cell(0),
            error_max: cell(1),
            error_mean: cell(2),
            throughput_median: cell(3),
            throughput_builds: cell(4),
            unit: cell(5),
            does_the_job: cell(6) == "true",
            frontier: cell(7) == "true",
            relative_time: cell(8),
            relative_time_v3: cell(9),
            samples: count(10)?,
            bursts: count(11)?,
            further: (COLUMNS.len()..record.len()).map(cell).collect(),
        });
    }
    Ok(rows)
}

/// Reads points again.
pub(crate) fn read_points(path: &Path) -> anyhow::Result<Vec<Point>> {
    let mut reader = csv::Reader::from_path(path).with_context(|| path.display().to_string())?;
    // The columns have other names in each kind of file.
    reader.records().map(|record| Ok(record?.deserialize(None)?)).collect()
}

/// Writes points as CSV under these names of columns.
pub(crate) fn write_points(points: &[Point], columns: [&str; 3], path: &Path) -> anyhow::Result<()> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.write_record(columns)?;
    for point in points {
        writer.serialize(point)?;
    }
    Ok(write_whole(path, &writer.into_inner()?)?)
}
