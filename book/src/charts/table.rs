//! What a chart measures, the rows that come of it, and the files they are kept in.

use std::path::Path;

use anyhow::Context;
use common::file::write_whole;
use serde::{Deserialize, Serialize};

use super::figures::{known_digits, three_digits};
use super::frontier::frontier;
use super::measure::{Effort, Errors, Throughput, Work};

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
    /// Measures the errors of each method.
    pub(crate) errors: fn(Effort) -> Vec<Errors>,
    /// What is timed, in one line.
    pub(crate) timed: &'static str,
    /// The unit of throughput, in millions a second.
    pub(crate) throughput: &'static str,
    /// The work of each method at a size.
    pub(crate) work: fn(usize, Effort) -> Vec<Work>,
    /// The sizes of the work.
    pub(crate) sizes: Sizes,
    /// How methods fail.
    pub(crate) stability: Stability,
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
    pub(crate) throughput_median: String,
    pub(crate) throughput_p25: String,
    pub(crate) throughput_p75: String,
    pub(crate) unit: String,
    pub(crate) frontier: bool,
    /// Time for the same work, the fastest method's as the unit.
    pub(crate) relative_time: String,
    pub(crate) samples: usize,
    pub(crate) rounds: usize,
    pub(crate) further: Vec<String>,
}

/// The columns that every table has.
const COLUMNS: [&str; 11] = [
    "method",
    "error_max",
    "error_mean",
    "throughput_median",
    "throughput_p25",
    "throughput_p75",
    "unit",
    "frontier",
    "relative_time",
    "samples",
    "rounds",
];

/// A row of a stability or growth table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Point {
    pub(crate) method: String,
    pub(crate) at: String,
    pub(crate) value: String,
}

/// The rows of a chart, with the frontier as the printed figures have it.
pub(crate) fn rows(chart: &Chart, errors: &[Errors], throughputs: &[Throughput]) -> Vec<Row> {
    let fastest = throughputs.iter().map(|found| found.median).fold(0.0, f64::max);
    let mut rows: Vec<Row> = (chart.methods)()
        .into_iter()
        .zip(errors.iter().zip(throughputs))
        .map(|(method, (errors, found))| Row {
            method: method.into(),
            error_max: three_digits(errors.largest()),
            error_mean: known_digits(errors.mean(), errors.standard_error()),
            throughput_median: three_digits(found.median / 1e6),
            throughput_p25: three_digits(found.p25 / 1e6),
            throughput_p75: three_digits(found.p75 / 1e6),
            unit: chart.throughput.into(),
            frontier: false,
            relative_time: format!("{:.2}", fastest / found.median),
            samples: errors.samples(),
            rounds: found.rounds,
            further: errors.further().map(three_digits).collect(),
        })
        .collect();
    let figures: Vec<(f64, f64)> =
        rows.iter().map(|row| (number(&row.error_max), number(&row.throughput_median))).collect();
    rows.iter_mut().zip(frontier(&figures)).for_each(|(row, best)| row.frontier = best);
    rows
}

/// A printed figure. What is none counts as infinite.
pub(crate) fn number(text: &str) -> f64 {
    text.parse().unwrap_or(f64::INFINITY)
}

/// Writes the rows of a chart as CSV.
pub(crate) fn write_rows(rows: &[Row], further: &[&str], path: &Path) -> anyhow::Result<()> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS.iter().chain(further))?;
    for row in rows {
        let [frontier, samples, rounds] =
            [row.frontier.to_string(), row.samples.to_string(), row.rounds.to_string()];
        let shared = [
            &row.method,
            &row.error_max,
            &row.error_mean,
            &row.throughput_median,
            &row.throughput_p25,
            &row.throughput_p75,
            &row.unit,
            &frontier,
            &row.relative_time,
            &samples,
            &rounds,
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
            throughput_p25: cell(4),
            throughput_p75: cell(5),
            unit: cell(6),
            frontier: cell(7) == "true",
            relative_time: cell(8),
            samples: count(9)?,
            rounds: count(10)?,
            further: (COLUMNS.len()..record.len()).map(cell).collect(),
        });
    }
    Ok(rows)
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
