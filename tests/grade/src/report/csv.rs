//! Tables for a spreadsheet.

use std::path::Path;

use anyhow::{Context, anyhow};

use super::Time;
use crate::results::{Class, total};

/// A row for each submission: points and state of each lesson, points of each check, the sum. Where something is not
/// graded, the points and the sum are left empty: they are not 0.
pub(super) fn grades(class: &Class) -> anyhow::Result<Vec<u8>> {
    // The mark by which Excel knows UTF-8.
    let mut table = csv::Writer::from_writer("\u{feff}".as_bytes().to_vec());
    let mut head = vec!["submission".to_string()];
    for lesson in &class.lessons {
        head.extend([lesson.name.clone(), format!("{} state", lesson.name)]);
        head.extend(lesson.checks.iter().map(|check| format!("{} {}", lesson.name, check.name)));
    }
    table.write_record(head.iter().map(String::as_str).chain(["total", "of"]))?;
    for (name, works) in &class.submissions {
        let mut row = vec![harmless(name)];
        for (work, lesson) in works.iter().zip(&class.lessons) {
            row.extend([points(work.earned()), work.state().to_string()]);
            row.extend((0..lesson.checks.len()).map(|check| points(work.earned_in(check))));
        }
        row.push(points(total(works)));
        row.push(class.points().to_string());
        table.write_record(row)?;
    }
    table.into_inner().map_err(|error| anyhow!("{error}"))
}

pub(super) fn points(earned: Option<u32>) -> String {
    earned.map(|points| points.to_string()).unwrap_or_default()
}

/// A name that a spreadsheet does not take for a formula.
pub(crate) fn harmless(name: &str) -> String {
    if name.starts_with(['=', '+', '-', '@']) { format!("'{name}") } else { name.into() }
}

/// A row for each text that was graded.
pub(super) fn times(times: &[Time]) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    times.iter().try_for_each(|time| table.serialize(time))?;
    table.into_inner().map_err(|error| anyhow!("{error}"))
}

/// Reads what [`times`] wrote.
pub(super) fn read_times(path: &Path) -> anyhow::Result<Vec<Time>> {
    let mut table =
        csv::Reader::from_path(path).with_context(|| format!("cannot read {}", path.display()))?;
    let rows: Result<Vec<Time>, csv::Error> = table.deserialize().collect();
    rows.with_context(|| format!("{} is not of this grader", path.display()))
}
