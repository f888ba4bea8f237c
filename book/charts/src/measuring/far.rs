//! What a triangle costs far from the origin, where lesson 3's `edges` leaves `f64` for `i128`.

use std::path::Path;

use common::{Bounds, IVec2, Method, Vec2};
use triangles::{METHODS, Triangle};

use super::card::hues;
use super::digits::readable;
use super::draw::{Line, Lines, lines_in_each_layout};
use super::finding::times;
use super::measure::{Effort, Work};
use super::table::{Point, read_points, series_of, write_points};
use super::{Comparison, Pictures, Run, caption};
use crate::lessons::triangles::charts::{CHART, random_triangles};

pub(crate) const COMPARISON: Comparison =
    Comparison { name: "03-triangles-far", works, measure, draw: pictures };

/// From the origin to the triangles' picture, in px along both axes: on both sides of 2¹⁶.
const DISTANCES: [usize; 6] = [1, 100, 10_000, 60_000, 70_000, 1_000_000];

/// The side of that picture, and the pixels of a triangle.
const SIDE: u16 = 1500;
const SIZE: usize = 100;

/// The methods that do the job.
fn methods() -> impl Iterator<Item = &'static Method<Triangle>> {
    METHODS.iter().filter(|method| !CHART.wrong.contains(&method.name))
}

/// Each method finding the pixels of the same triangles, that far away.
fn works(distance: usize) -> anyhow::Result<Vec<Work>> {
    let mut random = Effort { quick: false, seed: 1 }.random();
    let shift = |corners: [Vec2; 3]| corners.map(|corner| corner + distance as f32);
    let triangles = random_triangles(SIZE, SIDE, &mut random).into_iter().map(shift).collect::<Vec<_>>();
    let corner = IVec2::splat(distance as i32);
    let window = Bounds { min: corner, max: corner + i32::from(SIDE) };
    let work = |method: &'static Method<Triangle>| {
        let triangles = triangles.clone();
        Work::new((triangles.len() * SIZE) as f64, move || {
            let mut sum = 0;
            for corners in &triangles {
                (method.run.visit)(*corners, window, &mut |x, y, _| sum ^= x ^ y);
            }
            sum
        })
    };
    Ok(methods().map(work).collect())
}

/// Measures the time for a pixel at each distance.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let mut points = Vec::new();
    for distance in DISTANCES {
        let speeds = run.speeds(COMPARISON.name, distance, 0.15)?;
        points.extend(
            methods().zip(speeds).map(|(method, speed)| Point::of_time(method.name, distance, &speed)),
        );
    }
    let path = run.folder.join(COMPARISON.name).with_extension("csv");
    write_points(&points, ["method", "distance", "nanoseconds"], &path)?;
    run.write_facts(COMPARISON.name, serde_json::json!({ "job": CHART.job, "pixels a triangle": SIZE }))
}

/// The chart, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let points = read_points(&folder.join(COMPARISON.name).with_extension("csv"))?;
    let hues = hues(methods().map(|_| true));
    let line = |(method, hue): (&Method<Triangle>, Option<usize>)| Line {
        name: method.name.into(),
        hue,
        points: series_of(method.name, &points),
        ringed: None,
        does_it: true,
    };
    let lines_of: Vec<Line> = methods().zip(hues).map(line).collect();
    let chart = Lines {
        name: COMPARISON.name,
        title: finding(&lines_of),
        reading: format!("The time per px, in triangles of {SIZE} px."),
        across: "distance from the origin, px →".into(),
        falling: false,
        what: "time",
        unit: "ns",
        limit: None,
        lines: lines_of,
        caption: vec![format!("{}.", CHART.job), caption(folder, COMPARISON.name)?],
    };
    lines_in_each_layout(&chart)
}

/// Which method's time grows the most from one distance to the next, by how much, and where.
fn finding(lines: &[Line]) -> String {
    let steps = lines.iter().flat_map(|line| line.points.windows(2).map(move |pair| (line, pair)));
    let ratio = |pair: &[(f64, f64)]| pair[1].1 / pair[0].1;
    let largest = steps.max_by(|a, b| ratio(a.1).total_cmp(&ratio(b.1)));
    largest.map_or_else(String::new, |(line, pair)| {
        let [from, to] = [pair[0].0, pair[1].0].map(readable);
        format!(
            "At {to} px from the origin, {} takes {} as long as at {from} px",
            line.name,
            times(ratio(pair))
        )
    })
}
