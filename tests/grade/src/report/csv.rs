//! Tables for a spreadsheet.

use std::path::Path;

use anyhow::{Context, anyhow};

use super::Time;
use crate::marks::{self, Marks, decimal};
use crate::results::{Class, total};

/// A row for each submission: points and state of each lesson, points of each check, the sum; and, where there are rules,
/// what counts. Where something is not graded, the points and the sum are left empty: they are not 0.
pub(super) fn grades(class: &Class, marks: Option<&Marks>) -> anyhow::Result<Vec<u8>> {
    // The mark by which Excel knows UTF-8.
    let mut table = csv::Writer::from_writer("\u{feff}".as_bytes().to_vec());
    let mut head = vec!["submission".to_string()];
    for lesson in &class.lessons {
        head.extend([lesson.name.clone(), format!("{} state", lesson.name)]);
        head.extend(lesson.checks.iter().map(|check| format!("{} {}", lesson.name, check.name)));
    }
    head.extend(["total", "of"].map(String::from));
    if marks.is_some() {
        for lesson in &class.lessons {
            let columns = ["days late", "free days", "counted"];
            head.extend(columns.map(|column| format!("{} {column}", lesson.name)));
        }
        head.extend(["counted total", "counted of"].map(String::from));
    }
    table.write_record(&head)?;
    for (name, works) in &class.submissions {
        let mut row = vec![harmless(name)];
        for (work, lesson) in works.iter().zip(&class.lessons) {
            row.extend([points(work.earned()), work.state().to_string()]);
            row.extend((0..lesson.checks.len()).map(|check| points(work.earned_in(check))));
        }
        row.push(points(total(works)));
        row.push(class.points().to_string());
        if let Some(marks) = marks {
            let own = &marks.students[name];
            let counted = |hundredths: Option<u64>| hundredths.map(decimal).unwrap_or_default();
            for mark in own {
                row.extend([mark.days.to_string(), mark.free.to_string(), counted(mark.counted)]);
            }
            row.extend([counted(marks::total(own)), decimal(marks.of)]);
        }
        table.write_record(row)?;
    }
    table.into_inner().map_err(|error| anyhow!("{error}"))
}

pub(super) fn points(earned: Option<u32>) -> String {
    earned.map(|points| points.to_string()).unwrap_or_default()
}

/// A name that a spreadsheet does not take for a formula, be it behind white space that some leave out:
/// <https://owasp.org/www-community/attacks/CSV_Injection>.
pub(crate) fn harmless(name: &str) -> String {
    let formula = name.trim_start().starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']);
    if formula || name.starts_with(['\t', '\r', '\n']) { format!("'{name}") } else { name.into() }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula() {
        for text in ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1", " =1", "＝1", "\tann"] {
            assert_eq!(harmless(text), format!("'{text}"), "{text:?}");
        }
        for text in ["ann", "ann=1", "    Points Possible", "", "'=1"] {
            assert_eq!(harmless(text), text);
        }
    }
}
