//! The figures as Markdown and as CSV.

use std::path::Path;

use anyhow::Context;
use speed_scenes::Recipe;
use speed_scenes::clock::Clock;
use speed_scenes::rounds::Times;

use crate::comparison::LEVELS;
use crate::facts::Facts;

/// How fast a renderer draws a scene.
pub(crate) struct Cell {
    pub(crate) recipe: &'static Recipe,
    pub(crate) renderer: String,
    pub(crate) cores: usize,
    pub(crate) times: Times,
    /// The share of the pixels that are others than those of the first method.
    pub(crate) differing: f64,
}

/// The times of one scene in a line.
pub(crate) fn line(cells: &[Cell]) -> String {
    let title = cells.first().map_or("", |cell| cell.recipe.title);
    let times = cells.iter().map(|Cell { renderer, cores, times, .. }| {
        format!("{renderer} {} ({cores})", three_digits(times.median))
    });
    format!("{title}: {}", times.collect::<Vec<_>>().join(", "))
}

/// Prints the times, the shares of pixels, and what was measured on.
pub(crate) fn print(cells: &[Cell], facts: &Facts, clock: Clock) {
    let what = match clock {
        Clock::Wall => "medians: one core / two",
        Clock::Processor => "medians of the time for which it had a processor, on one core",
    };
    println!("Milliseconds to clear and draw a picture, {what}.\n");
    print_table(cells, |cell| three_digits(cell.times.median));
    println!("\nPixels that differ from the first column's by more than {LEVELS} levels, in percent.\n");
    print_table(cells, |cell| three_digits(100.0 * cell.differing));
    println!("\n{}", facts.lines());
}

/// A table of scenes and renderers, both in the order of their first cells.
fn print_table(cells: &[Cell], text: impl Fn(&Cell) -> String) {
    let mut renderers: Vec<&str> = Vec::new();
    let mut scenes: Vec<&Recipe> = Vec::new();
    for cell in cells {
        if !renderers.contains(&cell.renderer.as_str()) {
            renderers.push(&cell.renderer);
        }
        if !scenes.iter().any(|scene| scene.name == cell.recipe.name) {
            scenes.push(cell.recipe);
        }
    }
    println!("| scene | {} |", renderers.join(" | "));
    println!("|---|{}", "---|".repeat(renderers.len()));
    for scene in scenes {
        let of = |renderer: &str| -> String {
            let found =
                cells.iter().filter(|cell| cell.recipe.name == scene.name && cell.renderer == renderer);
            found.map(&text).collect::<Vec<_>>().join(" / ")
        };
        let row: Vec<String> = renderers.iter().map(|renderer| of(renderer)).collect();
        println!("| {} | {} |", scene.title, row.join(" | "));
    }
}

/// A number in three digits; those before the point are all there.
fn three_digits(number: f64) -> String {
    if number == 0.0 {
        return "0".into();
    }
    let digits = (2.0 - number.log10().floor()).clamp(0.0, 3.0) as usize;
    format!("{number:.digits$}")
}

/// Writes a line for each cell, and beside it, as JSON, what was measured on.
pub(crate) fn write_csv(cells: &[Cell], facts: &Facts, clock: Clock, path: &Path) -> anyhow::Result<()> {
    let mut text = String::from("scene,renderer,cores,median_ms,p25_ms,p75_ms,differing\n");
    for Cell { recipe, renderer, cores, times, differing } in cells {
        let Times { p25, median, p75 } = times;
        let name = recipe.name;
        text += &format!("{name},{renderer},{cores},{median:.4},{p25:.4},{p75:.4},{differing:.6}\n");
    }
    let mut json = facts.json();
    json["processor_time"] = (clock == Clock::Processor).into();
    let json = format!("{json:#}\n");
    for (path, text) in [(path.to_path_buf(), text), (path.with_extension("json"), json)] {
        common::file::write_whole(&path, text.as_bytes()).with_context(|| path.display().to_string())?;
    }
    Ok(())
}
