//! Which method, when: one page of all tables, and a few lines of it. The figures are the charts'.

use std::fmt::Write;
use std::path::Path;

use common::file::write_whole;

use super::table::{Chart, Row, read_rows};

/// Writes the page and the short version beside the charts, from their CSV files there.
pub(crate) fn write(charts: &[Chart], folder: &Path) -> anyhow::Result<()> {
    for (name, text) in pages(charts, folder)? {
        write_whole(&folder.join(name), text.as_bytes())?;
    }
    Ok(())
}

/// The two pages, each with its file's name.
pub(crate) fn pages(charts: &[Chart], folder: &Path) -> anyhow::Result<[(&'static str, String); 2]> {
    let mut page =
        String::from("| method | worst error | mean error | time | which, when |\n|:--|--:|--:|--:|:--|\n");
    let mut short = String::from("| job | take | worst error | time |\n|:--|:--|--:|--:|\n");
    for chart in charts {
        let rows = read_rows(&folder.join(format!("{}.csv", chart.name)))?;
        writeln!(page, "| **{}** | {} | | | |", chart.job, chart.error.unit)?;
        for row in &rows {
            let advice =
                chart.advice.iter().find(|(name, _)| *name == row.method).map_or("—", |(_, when)| when);
            let name = if row.frontier { format!("**{}**", row.method) } else { row.method.clone() };
            let [worst, mean] = [&row.error_max, &row.error_mean].map(|text| readable(text));
            writeln!(page, "| {name} | {worst} | {mean} | {} | {advice} |", row.relative_time)?;
        }
        let usual = |row: &&Row| chart.advice.first().is_some_and(|(name, _)| *name == row.method);
        if let Some(row) = rows.iter().find(usual) {
            let (worst, unit) = (readable(&row.error_max), chart.error.unit);
            let error = if row.error_max == "0" { worst } else { format!("{worst} {unit}") };
            writeln!(short, "| {} | `{}` | {error} | {} |", chart.job, row.method, row.relative_time)?;
        }
    }
    page.push_str(
        "\nTime is for the same work, that of the fastest method of the table as the unit. In bold: the methods that no \
         other one beats in both.\n",
    );
    short.push_str("\nTime is for the same work, that of the fastest method of the table as the unit.\n");
    Ok([("methods.md", page), ("methods-short.md", short)])
}

/// A printed figure for people.
fn readable(text: &str) -> String {
    match text.split_once('e') {
        _ if text == "0" => "exact".into(),
        _ if text == "inf" => "fails".into(),
        Some((mantissa, exponent)) => format!("{mantissa}·10<sup>{}</sup>", exponent.replace('-', "−")),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn figures_are_written_for_people() {
        let texts = ["0", "inf", "5.96e-8", "0.500"].map(readable);
        assert_eq!(texts, ["exact", "fails", "5.96·10<sup>−8</sup>", "0.500"]);
    }
}
