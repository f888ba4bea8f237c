//! What a look-up costs in lesson 13, by the layout of the texture and the direction of the walk.

use std::path::Path;

use common::Method;
use filtering::LAYOUTS;
use filtering::layout::Keep;

use super::card::hues;
use super::draw::{Line, Lines, lines_in_each_layout};
use super::finding::times;
use super::table::{Point, read_points, series_of, write_points};
use super::{Comparison, Pictures, Run, caption};
use crate::lessons::filtering::charts::walks;

pub(super) const COMPARISON: Comparison = Comparison {
    name: "13-filtering-walks",
    works: |angle| Ok(walks(SIDE, angle as f32)),
    measure,
    draw: pictures,
};

/// Texels across the texture: more than a cache holds.
const SIDE: usize = 4096;

/// Of the walk to the texture's rows, in degrees.
const ANGLES: [usize; 8] = [0, 5, 14, 30, 45, 60, 75, 90];

/// Measures the time for a look-up at each angle.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let mut points = Vec::new();
    for angle in ANGLES {
        let speeds = run.speeds(COMPARISON.name, angle, 0.15)?;
        points.extend(
            LAYOUTS.iter().zip(speeds).map(|(method, speed)| Point::of_time(method.name, angle, &speed)),
        );
    }
    let path = run.folder.join(COMPARISON.name).with_extension("csv");
    write_points(&points, ["method", "angle", "nanoseconds"], &path)?;
    run.write_facts(COMPARISON.name, serde_json::json!({ "texels across": SIDE }))
}

/// The chart, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let points = read_points(&folder.join(COMPARISON.name).with_extension("csv"))?;
    let line = |(method, hue): (&Method<Keep>, Option<usize>)| Line {
        name: method.name.into(),
        hue,
        points: series_of(method.name, &points),
        ringed: None,
        does_it: true,
    };
    let lines_of: Vec<Line> = LAYOUTS.iter().zip(hues(LAYOUTS.iter().map(|_| true))).map(line).collect();
    let chart = Lines {
        name: COMPARISON.name,
        title: finding(&lines_of),
        reading: format!("The time for a bilinear look-up in a texture of {SIDE}×{SIDE} texels."),
        across: "angle of the walk to the texture's rows, degrees →".into(),
        falling: false,
        what: "time",
        unit: "ns",
        limit: None,
        lines: lines_of,
        caption: vec!["Lesson 13, where texels are kept.".into(), caption(folder, COMPARISON.name)?],
    };
    lines_in_each_layout(&chart)
}

/// How much longer the worst direction takes than the best, for the layout for which that is most and the one for which it
/// is least.
fn finding(lines: &[Line]) -> String {
    let ratio = |line: &Line| {
        let values = line.points.iter().map(|point| point.1);
        values.clone().fold(0.0, f64::max) / values.fold(f64::INFINITY, f64::min)
    };
    let mut by_ratio: Vec<&Line> = lines.iter().collect();
    by_ratio.sort_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    match by_ratio[..] {
        [least, .., most] => format!(
            "From its best direction to its worst {} takes {} the time, {} {}",
            most.name,
            times(ratio(most)),
            least.name,
            times(ratio(least))
        ),
        _ => String::new(),
    }
}
