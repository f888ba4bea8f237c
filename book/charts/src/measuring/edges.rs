//! How well the samples of a pixel show a straight edge, by its angle, and what the head costs by each of lesson 15's ways.

use std::path::Path;

use antialiasing::pattern::Place;
use antialiasing::{METHODS, STORAGES, Scene, pattern};
use checks::edge::quality;
use common::file::write_whole;
use common::{Color, Format, Image};
use serde_json::json;

use super::card::hues;
use super::digits::{readable, three_digits};
use super::draw::{Line, Lines, lines_in_each_layout};
use super::measure::Work;
use super::table::{Point, read_points, series_of, write_points};
use super::{Comparison, Pictures, Run, caption};
use crate::lessons::antialiasing::figures::Head;
use crate::lessons::antialiasing::sketches::grid;

pub(super) const COMPARISON: Comparison =
    Comparison { name: "15-antialiasing-edges", works, measure, draw: pictures };

/// What the head costs.
const PICTURES: &str = "15-antialiasing-pictures";

/// The side of the head's picture.
const SIDE: u16 = 800;

/// Sample places and what they are called.
fn patterns() -> Vec<(String, Vec<Place>)> {
    let standard = [1, 2, 4, 8, 16].map(|samples| (samples.to_string(), pattern(samples).to_vec()));
    standard.into_iter().chain([("4x4".to_string(), grid())]).collect()
}

/// Of an edge to the nearer of rows and columns, in degrees.
const ANGLES: [f64; 19] =
    [0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 13.0, 16.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0];

/// How far off samples are at that angle, in the mean over the four directions that have it.
fn off(places: &[Place], angle: f64) -> f64 {
    let directions = [angle, 90.0 - angle, 90.0 + angle, 180.0 - angle];
    (directions.map(|angle| quality(places, angle).rms.powi(2)).iter().sum::<f64>() / 4.0).sqrt()
}

/// Each method and each storage drawing the head.
fn works(_: usize) -> anyhow::Result<Vec<Work>> {
    let head: &'static Head = Box::leak(Box::new(Head::new()?));
    let entities = Box::leak(Box::new([head.entity()]));
    let scene = Scene { world: Some(head.world(entities)), ..Scene::of(&[], Color::BLACK) };
    let work = |draw: &antialiasing::Draw| {
        let mut image = Image::new(SIDE, SIDE, Format::Rgb);
        let mut frames = (draw.frames)([SIDE.into(); 2]);
        Work::new(1.0, move || frames(&scene, &mut image))
    };
    Ok(METHODS.iter().chain(STORAGES).map(|row| work(&row.run)).collect())
}

fn measure(run: &mut Run) -> anyhow::Result<()> {
    let mut points = Vec::new();
    for (name, places) in patterns() {
        points.extend(ANGLES.map(|angle| Point {
            method: name.clone(),
            at: three_digits(angle),
            value: three_digits(off(&places, angle)),
        }));
    }
    let folder = run.folder.clone();
    let path = |name: &str| folder.join(name).with_extension("csv");
    write_points(&points, ["pattern", "angle", "levels"], &path(COMPARISON.name))?;

    let counts = Head::new()?.counts(SIDE);
    let speeds = run.speeds(COMPARISON.name, usize::from(SIDE), 1.0)?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["method", "ms"])?;
    for (row, speed) in METHODS.iter().chain(STORAGES).zip(&speeds) {
        writer.write_record([row.name, &three_digits(1000.0 / speed.median())])?;
    }
    write_whole(&path(PICTURES), &writer.into_inner()?)?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["what", "number"])?;
    for (what, number) in counts {
        writer.write_record([what, &three_digits(number)])?;
    }
    write_whole(&path("15-antialiasing-figures"), &writer.into_inner()?)?;
    run.write_facts(COMPARISON.name, json!({ "side": SIDE }))
}

/// The chart, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let points = read_points(&folder.join(COMPARISON.name).with_extension("csv"))?;
    // One sample, off by much more than the others, is left out.
    let shown: Vec<String> =
        patterns().into_iter().map(|(name, _)| name).filter(|name| name != "1").collect();
    let line = |(name, hue): (&String, Option<usize>)| Line {
        name: if name == "4x4" { "grid of 4×4".into() } else { format!("{name} samples") },
        hue,
        points: series_of(name, &points),
        ringed: None,
        does_it: true,
    };
    let lines: Vec<Line> = shown.iter().zip(hues(shown.iter().map(|_| true))).map(line).collect();
    let at = |name: &str, angle: f64| {
        let point = series_of(name, &points).into_iter().find(|point| point.0 == angle);
        point.map_or_else(|| "?".into(), |point| readable(point.1))
    };
    let chart = Lines {
        name: COMPARISON.name,
        title: format!(
            "Along an axis the grid of 4×4 is off by {} levels, the pattern of 16 by {}; at 30° it is {} and {}",
            at("4x4", 0.0),
            at("16", 0.0),
            at("4x4", 30.0),
            at("16", 30.0)
        ),
        reading: "How far the samples of a pixel on a straight edge are from its exact share (RMS).".into(),
        across: "angle of the edge to the nearer axis, degrees →".into(),
        falling: false,
        what: "RMS difference",
        unit: "grey levels of 255",
        limit: None,
        lines,
        caption: vec![
            "Lesson 15, white on black; integrated over all places of the edge, in f64.".into(),
            caption(folder, COMPARISON.name)?,
        ],
    };
    lines_in_each_layout(&chart)
}
