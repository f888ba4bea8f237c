//! The charts for the pages' script, `theme/charts.js`: each in a script of its own beside its file, with the commands that draw
//! by its methods.
//!
//! They are scripts, since a page that is opened as a file may load scripts but not fetch; and they are not on the pages, whose
//! readers may have no scripts, and whose words the search lists.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use anyhow::Context;
use charts::lessons::{LESSONS, tables};
use regex::Regex;
use serde_json::json;

/// Writes a script beside each chart of a folder.
///
/// # Errors
/// Where a file cannot be read or written.
pub(crate) fn write(charts: &Path) -> anyhow::Result<()> {
    for entry in std::fs::read_dir(charts).with_context(|| charts.display().to_string())? {
        let file = entry?.file_name();
        let Some(name) = file.to_str().and_then(|file| file.strip_suffix("-narrow.svg")) else { continue };
        let read = |file: String| std::fs::read_to_string(charts.join(&file)).context(file);
        let [wide, narrow] = [read(format!("{name}.svg"))?, read(format!("{name}-narrow.svg"))?];
        let chart = json!({
            "name": name,
            "wide": for_page(&wide),
            "narrow": for_page(&narrow),
            "commands": commands(name),
        });
        std::fs::write(charts.join(format!("{name}.js")), format!("liveChart({chart});\n"))?;
    }
    Ok(())
}

/// A chart as a part of a page: its style is about nothing else there, and its dark colours are those of the dark page.
fn for_page(svg: &str) -> String {
    static STYLE: LazyLock<Regex> = LazyLock::new(|| {
        Regex::new(r"(?s)<style>(.*)@media\(prefers-color-scheme:dark\)\{(.*)\}\s*</style>")
            .expect("the pattern is right")
    });
    static RULE: LazyLock<Regex> =
        LazyLock::new(|| Regex::new(r"\s*([^{}]+\{[^{}]*\})").expect("the pattern is right"));
    let style = |found: &regex::Captures| {
        let light = RULE.replace_all(&found[1], ".chart-live $1");
        let dark = RULE.replace_all(&found[2], ".navy .chart-live $1");
        format!("<style>{}{dark}</style>", light.trim_end())
    };
    STYLE.replace(svg, style).into_owned()
}

/// How to draw a lesson's picture by each method of a chart: those of a lesson's main table have a flag, of which each lesson has
/// the same.
fn commands(chart: &str) -> BTreeMap<&'static str, String> {
    let is_of =
        |table: &str| chart.strip_prefix(table).is_some_and(|rest| rest.is_empty() || rest.starts_with('-'));
    let table = tables().filter(|(name, _)| is_of(name)).max_by_key(|(name, _)| name.len());
    let lesson = LESSONS.iter().find(|lesson| is_of(&lesson.lesson.folder()));
    let (Some((_, table)), Some(lesson)) = (table, lesson) else { return BTreeMap::new() };
    if !table.name.is_empty() {
        return BTreeMap::new();
    }
    let command =
        |method: &str| format!("cargo run --release -p {} -- --method {method}", lesson.lesson.name);
    (table.rows)().iter().map(|row| (row.name, command(row.name))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_style_is_of_the_chart_alone_and_follows_the_page() {
        let svg = "<svg><style>\ntext{font:13px a,b}.f0{fill:#1}@media(prefers-color-scheme:dark){.f0{fill:#2}}\n</style><g/></svg>";
        let style = "<style>.chart-live text{font:13px a,b}.chart-live .f0{fill:#1}.navy .chart-live .f0{fill:#2}</style>";
        assert_eq!(for_page(svg), format!("<svg>{style}<g/></svg>"));
    }

    #[test]
    fn what_has_the_flag_has_a_command() {
        let command = |chart, method| commands(chart).get(method).cloned();
        let wu = Some("cargo run --release -p lines -- --method wu".into());
        assert_eq!(command("01-lines", "wu"), wu);
        assert_eq!(command("01-lines-coverage-stability", "wu"), wu);
        assert_eq!(commands("07-transforms-rotations-stability"), BTreeMap::new());
        assert_eq!(commands("needs-shading"), BTreeMap::new());
    }
}
