//! Figures that a page states: read from the tables that were measured with the charts, never typed.

use std::path::Path;

use anyhow::{Context, ensure};
use serde_json::Value;

/// A measured table: a row of names, then rows whose first cells say what they are of.
pub(crate) struct Table {
    name: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
    /// The methods whose error of 0 is more than what a sample showed: proved, or measured over all there is.
    exact: Vec<String>,
}

impl Table {
    /// Reads `NAME.csv` of a folder.
    ///
    /// # Errors
    /// Where there is none, or it is no table.
    pub(crate) fn read(folder: &Path, name: &str) -> anyhow::Result<Self> {
        let path = folder.join(name).with_extension("csv");
        let mut reader = csv::Reader::from_path(&path).with_context(|| {
            format!("there is no table charts/{name}.csv: cargo run --release -p book -- charts")
        })?;
        let columns = reader.headers()?.iter().map(String::from).collect();
        let rows: Result<Vec<Vec<String>>, csv::Error> =
            reader.records().map(|record| Ok(record?.iter().map(String::from).collect())).collect();
        let rows = rows?;
        let exact = exact(folder, name, &rows)?;
        Ok(Self { name: name.into(), columns, rows, exact })
    }

    /// The cell in a column, of the first row whose first cells are these.
    ///
    /// # Errors
    /// Where there is no such row or column; the message lists what there is.
    pub(crate) fn cell(&self, row: &[&str], column: &str) -> anyhow::Result<&str> {
        let at = self.columns.iter().position(|name| name == column);
        let at = at.with_context(|| {
            format!("charts/{}.csv has no column `{column}`, but {}", self.name, self.columns.join(", "))
        })?;
        let is_row = |cells: &&Vec<String>| row.iter().zip(*cells).all(|(key, cell)| key == cell);
        let found = self.rows.iter().find(is_row).filter(|_| !row.is_empty());
        let cells = found.with_context(|| {
            let names: Vec<&str> =
                self.rows.iter().filter_map(|cells| cells.first()).map(String::as_str).collect();
            format!("charts/{}.csv has no row `{}`, but {}", self.name, row.join(" "), names.join(", "))
        })?;
        cells.get(at).map(String::as_str).context("a row is too short")
    }

    /// How many times as large a column is in one row as in another, to two digits.
    ///
    /// # Errors
    /// As [`cell`](Self::cell), and where a cell is no number or the second one is 0.
    pub(crate) fn ratio(&self, row: &str, over: &str, column: &str) -> anyhow::Result<String> {
        let number = |row| -> anyhow::Result<f64> {
            let cell = self.cell(&[row], column)?;
            cell.parse().with_context(|| format!("charts/{}.csv, `{row}`: `{cell}` is no number", self.name))
        };
        let ratio = number(row)? / number(over)?;
        ensure!(ratio.is_finite() && ratio > 0.0, "{row} over {over}, `{column}`: {ratio} is no ratio");
        let digits = (1.0 - ratio.log10().floor()).max(0.0);
        let scale = 10f64.powf(1.0 - ratio.log10().floor());
        Ok(format!("{:.*}", digits as usize, (ratio * scale).round() / scale))
    }

    /// The methods that no other one of the table beats in both speed and accuracy, if that was measured.
    pub(crate) fn best(&self) -> Vec<&str> {
        let at = self.columns.iter().position(|name| name == "frontier");
        let is_best = |row: &&Vec<String>| at.is_some_and(|at| row[at] == "true");
        self.rows.iter().filter(is_best).map(|row| row[0].as_str()).collect()
    }

    /// Columns of the table under other names, as Markdown.
    ///
    /// # Errors
    /// Where there is no such column.
    pub(crate) fn markdown(&self, columns: &[(&str, &str)]) -> anyhow::Result<String> {
        let mut lines = vec![
            format!("| {} |", columns.iter().map(|column| column.1).collect::<Vec<_>>().join(" | ")),
            format!("|---|{}", "--:|".repeat(columns.len() - 1)),
        ];
        for row in &self.rows {
            let key = row.first().context("an empty row")?;
            let none = if self.exact.contains(key) { "exact" } else { "none found" };
            let cells: anyhow::Result<Vec<String>> = columns
                .iter()
                .map(|column| Ok(shown(self.cell(&[key], column.0)?, column.0, none)))
                .collect();
            lines.push(format!("| {} |", cells?.join(" | ")));
        }
        Ok(lines.join("\n"))
    }

    /// A column's cells by two others: a row for each value of `down`, a column for each of `across`, both in the order in which they
    /// first come. Cells of the same two stand side by side.
    ///
    /// # Errors
    /// Where there is no such column.
    pub(crate) fn crossed(&self, down: &str, across: &str, column: &str) -> anyhow::Result<String> {
        let at = |name: &str| {
            let found = self.columns.iter().position(|column| column == name);
            found.with_context(|| {
                format!("charts/{}.csv has no column `{name}`, but {}", self.name, self.columns.join(", "))
            })
        };
        let [down_at, across_at, column_at] = [at(down)?, at(across)?, at(column)?];
        let different = |at: usize| {
            let mut all: Vec<&str> = Vec::new();
            for row in &self.rows {
                if !all.contains(&row[at].as_str()) {
                    all.push(&row[at]);
                }
            }
            all
        };
        let names = different(across_at);
        let mut lines = vec![
            format!("| {down} | {} |", names.join(" | ")),
            format!("|---|{}", "--:|".repeat(names.len())),
        ];
        for key in different(down_at) {
            let cell = |name: &&str| {
                let found = self.rows.iter().filter(|row| row[down_at] == key && row[across_at] == **name);
                found.map(|row| rounded(&row[column_at])).collect::<Vec<_>>().join(" / ")
            };
            lines.push(format!("| {key} | {} |", names.iter().map(cell).collect::<Vec<_>>().join(" | ")));
        }
        Ok(lines.join("\n"))
    }
}

/// A number in three digits, as long as all before its point are there; other words stay.
fn rounded(cell: &str) -> String {
    let Ok(number) = cell.parse::<f64>() else { return cell.into() };
    if number == 0.0 || !number.is_finite() {
        return cell.into();
    }
    let digits = (2.0 - number.abs().log10().floor()).max(0.0) as usize;
    format!("{number:.digits$}")
}

/// The methods of these rows that are exact, as the facts tell that were written when the table was measured, or the
/// one that it comes with: `01-lines.json` tells of `01-lines-growth.csv` too.
fn exact(folder: &Path, name: &str, rows: &[Vec<String>]) -> anyhow::Result<Vec<String>> {
    let names = std::iter::successors(Some(name), |name| Some(name.rsplit_once('-')?.0));
    let mut paths = names.map(|name| folder.join(name).with_extension("json"));
    let Some(path) = paths.find(|path| path.is_file()) else { return Ok(Vec::new()) };
    let facts: Value =
        serde_json::from_slice(&std::fs::read(&path)?).with_context(|| path.display().to_string())?;
    let exhaustive = facts["error_max"].as_str().is_some_and(|bound| bound.starts_with("exhaustive"));
    let proved: Vec<&str> =
        facts["proved_exact"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let methods = rows.iter().filter_map(|row| row.first());
    Ok(methods.filter(|method| exhaustive || proved.contains(&method.as_str())).cloned().collect())
}

/// A cell of a table as readers like it; no error is told as `none`.
fn shown(cell: &str, column: &str, none: &str) -> String {
    match cell {
        "inf" => "fails".into(),
        "0" if column.starts_with("error") => none.into(),
        _ => spelled(cell),
    }
}

/// A number with its power of ten written out: 8e-4 as 8·10⁻⁴. Other words stay.
pub(crate) fn spelled(cell: &str) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let Some((digits, power)) = cell.split_once('e').filter(|_| cell.parse::<f64>().is_ok()) else {
        return cell.into();
    };
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    format!("{digits}·10{}", power.chars().map(raised).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let row = |cells: &[&str]| cells.iter().map(ToString::to_string).collect();
        Table {
            name: "test".into(),
            columns: row(&["method", "stress", "error"]),
            rows: vec![
                row(&["a", "1", "0.5"]),
                row(&["a", "10", "2"]),
                row(&["b", "1", "nan"]),
                row(&["c", "1", "0.0021"]),
            ],
            exact: Vec::new(),
        }
    }

    #[test]
    fn a_cell_is_found_by_the_first_cells_of_its_row() {
        assert_eq!(table().cell(&["a"], "error").unwrap(), "0.5");
        assert_eq!(table().cell(&["a", "10"], "error").unwrap(), "2");
    }

    #[test]
    fn cells_are_put_where_their_row_and_column_meet() {
        let crossed = table().crossed("method", "stress", "error").unwrap();
        assert_eq!(
            crossed,
            "| method | 1 | 10 |\n|---|--:|--:|\n| a | 0.500 | 2.00 |\n| b | nan |  |\n| c | 0.00210 |  |"
        );
        let mut twice = table();
        twice.rows[1][1] = "1".into();
        assert!(twice.crossed("method", "stress", "error").unwrap().contains("| a | 0.500 / 2.00 |"));
        let error = table().crossed("method", "speed", "error").unwrap_err().to_string();
        assert!(error.contains("no column `speed`, but method, stress, error"), "{error}");
    }

    #[test]
    fn what_is_missing_is_told_with_what_there_is() {
        for (row, column, said) in [
            (&["z"][..], "error", "no row `z`, but a, a, b, c"),
            (&["a", "2"], "error", "no row `a 2`"),
            (&["a"], "speed", "no column `speed`, but method, stress, error"),
            (&[], "error", "no row"),
        ] {
            let error = table().cell(row, column).unwrap_err().to_string();
            assert!(error.contains(said), "{error}");
        }
        let missing = Table::read(Path::new("."), "99-none").err().unwrap().to_string();
        assert!(missing.contains("there is no table charts/99-none.csv"), "{missing}");
    }

    #[test]
    fn the_best_are_those_on_the_frontier() {
        assert_eq!(table().best(), [""; 0]);
        let mut measured = table();
        measured.columns[1] = "frontier".into();
        measured.rows[2][1] = "true".into();
        assert_eq!(measured.best(), ["b"]);
    }

    #[test]
    fn the_facts_beside_a_table_tell_what_is_exact() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
        for name in ["01-a.csv", "01-a-growth.csv", "02-b.csv", "03-c.csv"] {
            write(name, "method,error_max\nx,0\ny,0\nz,0.5\n");
        }
        write("01-a.json", r#"{ "error_max": "sampled: a lower bound", "proved_exact": ["y"] }"#);
        write("02-b.json", r#"{ "error_max": "exhaustive: a maximum", "proved_exact": [] }"#);
        let errors = |name| {
            let text =
                Table::read(folder.path(), name).unwrap().markdown(&[("method", ""), ("error_max", "")]);
            text.unwrap().lines().skip(2).map(|line| line[6..line.len() - 2].to_string()).collect::<Vec<_>>()
        };
        assert_eq!(errors("01-a"), ["none found", "exact", "0.5"]);
        assert_eq!(errors("01-a-growth"), ["none found", "exact", "0.5"]);
        assert_eq!(errors("02-b"), ["exact", "exact", "0.5"]);
        assert_eq!(errors("03-c"), ["none found", "none found", "0.5"]);
    }

    #[test]
    fn powers_of_ten_are_spelled_out() {
        let cells = ["8e-4", "1.2e10", "0.5", "lines", "inf"].map(spelled);
        assert_eq!(cells, ["8·10⁻⁴", "1.2·10¹⁰", "0.5", "lines", "inf"]);
    }

    #[test]
    fn a_ratio_has_two_digits() {
        assert_eq!(table().ratio("a", "c", "error").unwrap(), "240");
        assert_eq!(table().ratio("c", "a", "error").unwrap(), "0.0042");
        assert_eq!(table().ratio("a", "a", "error").unwrap(), "1.0");
        assert!(table().ratio("a", "b", "error").is_err());
        assert!(table().ratio("b", "a", "error").is_err());
    }
}
