//! The committed figures and charts.

use super::frontier::frontier;
use super::place::Rect;
use super::*;

/// The committed charts, by name.
fn pictures() -> Vec<(String, String)> {
    let files = std::fs::read_dir(COMMITTED).unwrap().map(|file| file.unwrap().path());
    let charts = files.filter(|path| path.extension().is_some_and(|ending| ending == "svg"));
    let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
    charts.map(|path| (name(&path), std::fs::read_to_string(&path).unwrap())).collect()
}

/// The rows of every table, as committed.
fn committed() -> impl Iterator<Item = (&'static Chart, Vec<Row>)> {
    all_charts().into_iter().map(|chart| {
        let path = Path::new(COMMITTED).join(format!("{}.csv", chart.name));
        (chart, read_rows(&path).unwrap())
    })
}

/// Titles, too, and with them what a chart is said to show.
#[test]
fn charts_are_those_of_the_committed_figures() {
    let folder = Path::new(COMMITTED);
    let tables = all_charts().into_iter().map(|chart| (chart.name, table_pictures(chart, folder).unwrap()));
    let others = COMPARISONS.iter().map(|comparison| ("", (comparison.draw)(folder).unwrap()));
    let mut drawn: Vec<(String, String)> = tables
        .chain(others)
        .flat_map(|(name, pictures)| {
            pictures.into_iter().map(move |(end, svg)| (format!("{name}{end}.svg"), svg))
        })
        .collect();
    let mut there = pictures();
    drawn.sort();
    there.sort();
    let names =
        |pictures: &[(String, String)]| pictures.iter().map(|picture| picture.0.clone()).collect::<Vec<_>>();
    assert_eq!(names(&drawn), names(&there));
    for (drawn, there) in drawn.iter().zip(&there) {
        assert!(drawn == there, "{}: cargo run --release -p book -- charts --draw", there.0);
    }
}

/// What each text covers, if letters are `width` times as wide as high; its height; and the text.
fn texts(svg: &str, width: f64) -> Vec<(Rect, f64, String)> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let sheet = document.descendants().find(|node| node.has_tag_name("style")).unwrap().text().unwrap();
    let usual: f64 = sheet.split_once("font:").unwrap().1.split_once("px").unwrap().0.parse().unwrap();
    let measured = |node: roxmltree::Node| {
        let value = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
        let text = node.text().unwrap_or_default().trim().to_string();
        let size = node.attribute("style").and_then(|style| style.split_once("font-size:"));
        let size = size.map_or(usual, |(_, size)| size.trim_end_matches("px").parse().unwrap());
        let length = text.chars().count() as f64 * size * width;
        let left = value("x")
            - match node.attribute("text-anchor") {
                Some("middle") => length / 2.0,
                Some("end") => length,
                _ => 0.0,
            };
        let middle = [left + length / 2.0, value("y") - 0.35 * size];
        (Rect::about(middle, length, 0.85 * size), size, text)
    };
    document.descendants().filter(|node| node.has_tag_name("text")).map(measured).collect()
}

#[test]
fn no_text_is_small_or_covers_another_or_leaves_the_card() {
    for (chart, svg) in pictures() {
        let document = roxmltree::Document::parse(&svg).unwrap();
        let side = |name| document.root_element().attribute(name).unwrap().parse::<f64>().unwrap();
        let (width, height) = (side("width"), side("height"));
        let texts = texts(&svg, 0.5);
        assert!(texts.len() > 10, "{chart}: text is no text");
        for (n, (place, size, text)) in texts.iter().enumerate() {
            assert!(*size >= 12.0, "{chart}: {text} is {size} px high");
            let inside = place.left >= 0.0 && place.right <= width && place.bottom <= height;
            assert!(inside, "{chart}: {text}");
            for (other, _, covered) in &texts[..n] {
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
fn marks_are_of_methods_that_there_are() {
    for chart in all_charts() {
        let methods = (chart.methods)();
        for name in chart.wrong.iter().chain(chart.proved) {
            assert!(methods.contains(name), "{}: {name}", chart.name);
        }
    }
}

/// The book tells by these facts what is exact.
#[test]
fn the_committed_facts_tell_what_is_exact() {
    for chart in all_charts() {
        let path = Path::new(COMMITTED).join(format!("{}.json", chart.name));
        let facts: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
        assert_eq!(facts["proved_exact"], json!(chart.proved), "{}", chart.name);
        assert_eq!(facts["error_max"], bound(chart), "{}", chart.name);
    }
}

/// What was proved is not refuted by a sample.
#[test]
fn what_is_proved_exact_has_no_error() {
    for (chart, rows) in committed() {
        for row in rows.iter().filter(|row| chart.proved.contains(&row.method.as_str())) {
            assert_eq!(row.error_max, "0", "{}, {}", chart.name, row.method);
        }
    }
}

#[test]
fn the_summary_is_that_of_the_committed_figures() {
    for (name, text) in summary::pages(&all_charts(), Path::new(COMMITTED)).unwrap() {
        let committed = std::fs::read_to_string(Path::new(COMMITTED).join(name)).unwrap();
        assert_eq!(committed, text, "{name}: measure the charts again");
        if name == "methods-short.md" {
            let readme = std::fs::read_to_string(README).unwrap();
            assert_eq!(summary::in_readme(&readme, &text).unwrap(), readme);
        }
    }
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
        let figures: Vec<_> = rows.iter().map(Row::figure).collect();
        let printed: Vec<bool> = rows.iter().map(|row| row.frontier).collect();
        assert_eq!(printed, frontier(&figures), "{}", chart.name);
    }
}

#[test]
fn medians_are_those_of_the_builds_and_means_below_worst_cases() {
    for (chart, rows) in committed() {
        for row in rows {
            let [low, median, high] = spread(&row.figure().builds);
            assert!(0.0 < low && high.is_finite(), "{}, {}", chart.name, row.method);
            assert_eq!(median, number(&row.throughput_median), "{}, {}", chart.name, row.method);
            let [worst, mean] = [&row.error_max, &row.error_mean].map(|text| number(text));
            assert!(mean <= 1.05 * worst, "{}, {}", chart.name, row.method);
        }
    }
}

/// Figures that were measured from sources which nobody has cannot be measured again.
#[test]
fn the_committed_figures_name_a_commit() {
    let files = std::fs::read_dir(COMMITTED).unwrap().map(|file| file.unwrap().path());
    for path in files.filter(|path| path.extension().is_some_and(|ending| ending == "json")) {
        let facts: serde_json::Value =
            serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
        let commit = facts["machine"]["commit"].as_str().unwrap();
        assert!(!commit.contains("changed"), "{}: {commit}", path.display());
        assert_eq!(facts["quick"], false, "{}", path.display());
    }
}
