//! Which method, when: one page of all tables, and a few lines of it. The figures are the charts'.

use std::fmt::Write;
use std::path::Path;

use anyhow::Context;
use common::file::write_whole;

use super::frontier::close;
use super::table::{Chart, Row, number, read_rows};

/// Writes the page and the short version beside the charts, from their CSV files there.
pub(crate) fn write(charts: &[&Chart], folder: &Path) -> anyhow::Result<()> {
    for (name, text) in pages(charts, folder)? {
        write_whole(&folder.join(name), text.as_bytes())?;
    }
    Ok(())
}

/// Puts the short version that stands beside the charts into the README.
pub(crate) fn write_readme(folder: &Path, readme: &Path) -> anyhow::Result<()> {
    let short = std::fs::read_to_string(folder.join("methods-short.md"))?;
    let text = std::fs::read_to_string(readme).with_context(|| readme.display().to_string())?;
    Ok(write_whole(readme, in_readme(&text, &short)?.as_bytes())?)
}

/// The two pages, each with its file's name.
pub(crate) fn pages(charts: &[&Chart], folder: &Path) -> anyhow::Result<[(&'static str, String); 2]> {
    let mut page = String::from(
        "| method | worst error found | mean error | time | x86-64-v3 | which, when |\n|:--|--:|--:|--:|--:|:--|\n",
    );
    let mut short = String::from("| job | take | worst error found | time |\n|:--|:--|--:|--:|\n");
    let mut orders = String::new();
    for chart in charts {
        let rows = read_rows(&folder.join(format!("{}.csv", chart.name)))?;
        writeln!(page, "| **{}** | {} | | | | |", chart.job, chart.error.unit)?;
        let close = close(&rows.iter().map(Row::figure).collect::<Vec<_>>());
        for (row, close) in rows.iter().zip(close) {
            let advice =
                chart.advice.iter().find(|(name, _)| *name == row.method).map_or("—", |(_, when)| when);
            let name = if row.frontier { format!("**{}**", row.method) } else { row.method.clone() };
            let name = if close { format!("{name} ≈") } else { name };
            let advice = if row.does_the_job { advice } else { "does another job" };
            let [worst, mean] = [
                readable(&row.error_max, row.is_exact(chart)),
                readable(&row.error_mean, row.is_exact(chart)),
            ];
            let (time, v3) = (&row.relative_time, &row.relative_time_v3);
            writeln!(page, "| {name} | {worst} | {mean} | {time} | {v3} | {advice} |")?;
        }
        if let Some(order) = otherwise(&rows) {
            writeln!(orders, "- {}: {order}.", chart.job)?;
        }
        let usual = |row: &&Row| chart.advice.first().is_some_and(|(name, _)| *name == row.method);
        if let Some(row) = rows.iter().find(usual) {
            let (worst, unit) = (readable(&row.error_max, row.is_exact(chart)), chart.error.unit);
            let error = if row.error_max == "0" { worst } else { format!("{worst} {unit}") };
            writeln!(short, "| {} | `{}` | {error} | {} |", chart.job, row.method, row.relative_time)?;
        }
    }
    page.push_str(
        "\nTime is for the same work, with that of the fastest method that does the job as the unit: in builds for any \
         processor and in builds for x86-64-v3. In bold: the methods that no other one beats. One is faster \
         if it is in every build, and by at least a tenth in the middle one; less is a tie. ≈ is \
         a close call, which a tenth would decide otherwise. A worst error is the largest one of a sample, so a lower bound; \
         *exact* is what is proved, *none found* what a sample showed.\n",
    );
    if !orders.is_empty() {
        write!(page, "\nBuilt for x86-64-v3, the order changes:\n\n{orders}")?;
    }
    short.push_str(
        "\nTime is for the same work, with that of the fastest method as the unit. A worst error found is the largest one of \
         a sample, so a lower bound; *exact* is what is proved, *none found* what a sample showed.\n",
    );
    Ok([("methods.md", page), ("methods-short.md", short)])
}

/// Which methods are faster than ones on the frontier in builds for x86-64-v3, and are not in builds for any
/// processor, if there are such.
pub(crate) fn otherwise(rows: &[Row]) -> Option<String> {
    // What is less than a quarter faster may be another build's tie.
    let faster = |a: &str, b: &str| number(b) > 1.25 * number(a);
    let rows: Vec<&Row> =
        rows.iter().filter(|row| row.does_the_job && !row.relative_time_v3.is_empty()).collect();
    let pairs = rows.iter().flat_map(|a| rows.iter().map(move |b| (a, b))).filter(|(a, b)| {
        b.frontier
            && faster(&a.relative_time_v3, &b.relative_time_v3)
            && !faster(&a.relative_time, &b.relative_time)
    });
    let texts: Vec<String> =
        pairs.map(|(a, b)| format!("{} is faster than {}", a.method, b.method)).collect();
    (!texts.is_empty()).then(|| texts.join(", "))
}

/// What stands before and behind the short version in the README.
const MARKS: [&str; 2] = ["<!-- methods -->\n", "<!-- /methods -->"];

/// The README with this short version between its marks.
pub(crate) fn in_readme(readme: &str, short: &str) -> anyhow::Result<String> {
    let (before, rest) = readme.split_once(MARKS[0]).context("README.md: there is no <!-- methods -->")?;
    let (_, behind) = rest.split_once(MARKS[1]).context("README.md: there is no <!-- /methods -->")?;
    Ok([before, MARKS[0], short, MARKS[1], behind].concat())
}

/// A printed figure for people.
fn readable(text: &str, exact: bool) -> String {
    match text.split_once('e') {
        _ if text == "0" => if exact { "exact" } else { "none found" }.into(),
        _ if text == "inf" => "fails".into(),
        Some((mantissa, exponent)) => format!("{mantissa}·10<sup>{}</sup>", exponent.replace('-', "−")),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::{in_readme, readable};

    #[test]
    fn the_short_version_stands_between_its_marks() {
        let readme = "a\n<!-- methods -->\nold\n<!-- /methods -->\nb\n";
        let expected = "a\n<!-- methods -->\nnew\n<!-- /methods -->\nb\n";
        assert_eq!(in_readme(readme, "new\n").unwrap(), expected);
        assert!(in_readme("nothing", "new").is_err());
    }

    #[test]
    fn figures_are_written_for_people() {
        let texts = ["0", "inf", "5.96e-8", "0.500"].map(|text| readable(text, false));
        assert_eq!(readable("0", true), "exact");
        assert_eq!(texts, ["none found", "fails", "5.96·10<sup>−8</sup>", "0.500"]);
    }
}
