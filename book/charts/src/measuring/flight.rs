//! A flight over lesson 13's floor: how much of what changes from picture to picture should not, what a picture differs by, and
//! by how much at each angle.
//!
//! The floor has its checks, lies under a light from straight above, and is held against the mean light of the rays through each
//! pixel, in f64. What is so near to the horizon that a footprint is longer than nearly three fields of the checks counts nowhere.

use std::path::Path;

use checks::footprint::{Outside, Plane, Texture, code};
use checks::ray::Screen;
use common::Image;
use common::file::write_whole;
use filtering::{METHODS, Sampler};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::card::{LAYOUTS, hues};
use super::digits::{readable, three_digits};
use super::draw::{Dot, Line, Lines, Speed, lines_in_each_layout, speed};
use super::finding::times;
use super::finish::{flip, rms};
use super::frontier::{Figure, close, frontier};
use super::measure::Work;
use super::speed::spread;
use super::table::{Point, Quantity, number, numbers, read_points, series_of, spaced, write_points};
use super::{Comparison, Pictures, Run, caption};
use crate::lessons::filtering::charts::drawing;
use crate::lessons::filtering::figures::{Subject, by_sampler, flying, flying_view, of_floor};

pub(super) const COMPARISON: Comparison =
    Comparison { name: "13-filtering-flight", works, measure, draw: pictures };

/// The tables of what pictures differ by, and of that over the angle.
const FLIP: &str = "13-filtering-flip";
const ANGLE: &str = "13-filtering-angle";

/// The sides of the picture that is timed, and of the pictures of the flight.
const SIDE: u16 = 800;
const SMALL: u16 = 320;

/// Pictures of the flight.
const FRAMES: usize = 16;

/// The longest footprint that is held against what it should be, in texels: nearly three fields of the checks.
const LONGEST: f64 = 362.0;

/// Texels of its texture, each way.
const TEXELS: f64 = 256.0;

/// A row of `13-filtering-flip.csv`.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Row {
    method: String,
    rms: String,
    flip: String,
    ms_median: String,
    /// In each build.
    ms_builds: String,
    frontier_rms: bool,
    frontier_flip: bool,
}

/// Each method drawing the first picture of the flight.
fn works(_: usize) -> anyhow::Result<Vec<Work>> {
    let floor: &'static Subject = Box::leak(Box::new(of_floor()?));
    let to_clip = flying(0, 1.0)?;
    let work = |sampler| Work::new(1.0, drawing(floor, to_clip, SIDE, sampler));
    Ok(METHODS.iter().map(|method| work(&method.run)).collect())
}

/// What a pixel of the floor shows, and how long and how wide its footprint is, in texels.
struct Seen {
    color: [f64; 3],
    axes: [f64; 2],
}

/// A picture of the flight as it should be; nothing where the floor does not fill a pixel, or a footprint is too long.
fn exact(floor: &Subject, frame: usize, side: u16, rays: [u32; 2]) -> anyhow::Result<Vec<Option<Seen>>> {
    let texture = Texture::new(floor.image(), Outside::Again);
    let view = flying_view(frame)?.as_dmat4();
    let ground = floor.model().positions()[0].y;
    let plane = Plane {
        origin: view.transform_point3(DVec3::new(0.0, ground.into(), 0.0)),
        u: view.transform_vector3(DVec3::X),
        v: view.transform_vector3(-DVec3::Z),
    };
    let screen = Screen::ahead(45.0, DVec2::splat(side.into()));
    let pixel = |n: i32| {
        let (x, y) = (n % i32::from(side), n / i32::from(side));
        let corner = |dx: i32, dy: i32| DVec2::new(f64::from(x + dx), f64::from(y + dy));
        let mut corners = [(0, 0), (1, 0), (0, 1), (1, 1)].into_iter();
        if !corners.all(|(dx, dy)| plane.met(screen.direction(corner(dx, dy))).is_some()) {
            return None;
        }
        let [a, b] = plane.moves(&screen, corner(0, 0) + 0.5)?.map(|step| step * TEXELS);
        let (sum, area) = (a.length_squared() + b.length_squared(), a.perp_dot(b).abs());
        let long = ((sum + (sum * sum - 4.0 * area * area).max(0.0).sqrt()) / 2.0).sqrt();
        if long > LONGEST {
            return None;
        }
        let color = plane.seen(&texture, &screen, [x, y], rays)?.map(code);
        Some(Seen { color, axes: [long, area / long] })
    };
    Ok((0..i32::from(side) * i32::from(side)).map(pixel).collect())
}

/// A picture of the flight by a method.
fn drawn(floor: &Subject, frame: usize, side: u16, sampler: &Sampler) -> anyhow::Result<Image> {
    Ok(by_sampler(sampler, std::slice::from_ref(floor), flying(frame, 1.0)?, [side, side]))
}

/// The channels of a picture's pixel.
fn channels(image: &Image, n: usize) -> [f64; 3] {
    [0, 1, 2].map(|channel| f64::from(image.buffer()[3 * n + channel]))
}

/// The root of the mean of what was added, by powers of two of some quantity.
#[derive(Clone, Default)]
struct ByPower([(f64, usize); 16]);

impl ByPower {
    fn add(&mut self, quantity: f64, differences: [f64; 3]) {
        let power = (quantity.log2().round().max(0.0) as usize).min(15);
        let (sum, count) = &mut self.0[power];
        *sum += differences.into_iter().map(|difference| difference * difference).sum::<f64>();
        *count += 3;
    }

    /// For each power that occurred often enough to tell.
    fn points(&self, name: &str) -> Vec<Point> {
        let often = self.0.iter().enumerate().filter(|(_, (_, count))| *count >= 1000);
        let point = |(power, (sum, count)): (usize, &(f64, usize))| Point {
            method: name.into(),
            at: three_digits(2f64.powi(power as i32)),
            value: three_digits((sum / *count as f64).sqrt()),
        };
        often.map(point).collect()
    }
}

/// What is called in the tables by what it should be.
const RIGHT: &str = "expected";

/// Flies, measures and writes.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let quick = run.effort.quick;
    let (frames, rays) = if quick { (3, [8, 16]) } else { (FRAMES, [16, 64]) };
    // Footprints are longer than wide: more rays one above the other than side by side.
    let floor = of_floor()?;
    let mut changes = vec![ByPower::default(); METHODS.len() + 1];
    let mut errors = vec![ByPower::default(); METHODS.len()];
    let shot = |frame: usize| -> anyhow::Result<_> {
        let images: anyhow::Result<Vec<Image>> =
            METHODS.iter().map(|method| drawn(&floor, frame, SMALL, &method.run)).collect();
        Ok((exact(&floor, frame, SMALL, rays)?, images?))
    };
    let mut last = shot(0)?;
    for frame in 1..frames {
        let next = shot(frame)?;
        for (n, pair) in last.0.iter().zip(&next.0).enumerate() {
            let (Some(from), Some(to)) = pair else { continue };
            let should = [0, 1, 2].map(|c| to.color[c] - from.color[c]);
            changes[METHODS.len()].add(to.axes[0], should);
            for (method, (before, after)) in last.1.iter().zip(&next.1).enumerate() {
                let (before, after) = (channels(before, n), channels(after, n));
                changes[method].add(to.axes[0], [0, 1, 2].map(|c| after[c] - before[c] - should[c]));
                errors[method].add(to.axes[0] / to.axes[1], [0, 1, 2].map(|c| after[c] - to.color[c]));
            }
        }
        last = next;
    }
    let names: Vec<&str> = METHODS.iter().map(|method| method.name).chain([RIGHT]).collect();
    let points =
        |of: &[ByPower]| names.iter().zip(of).flat_map(|(name, of)| of.points(name)).collect::<Vec<_>>();
    let path = |name: &str| run.folder.join(name).with_extension("csv");
    write_points(&points(&changes), ["method", "texels", "levels"], &path(COMPARISON.name))?;
    write_points(&points(&errors), ["method", "times", "levels"], &path(ANGLE))?;
    write_flip(run, &floor, rays)?;
    let [well, roughly] = [rays, rays.map(|rays| rays / 2)].map(|rays| exact(&floor, 0, SMALL, rays));
    let facts = json!({
        "pictures": frames,
        "half_as_many_rays": three_digits(difference(&well?, &roughly?)),
        "reference": format!("{}×{} rays a pixel in f64", rays[0], rays[1]),
    });
    run.write_facts(COMPARISON.name, facts)
}

/// The RMS difference of two pictures of the flight.
fn difference(a: &[Option<Seen>], b: &[Option<Seen>]) -> f64 {
    let pairs = a.iter().zip(b).filter_map(|(a, b)| Some((a.as_ref()?.color, b.as_ref()?.color)));
    let squares = pairs.flat_map(|(a, b)| [0, 1, 2].map(|c| (a[c] - b[c]).powi(2)));
    let (sum, count) = squares.fold((0.0, 0.0), |(sum, count), square| (sum + square, count + 1.0));
    (sum / f64::max(count, 1.0)).sqrt()
}

/// Measures what the first picture differs by, and what it costs.
fn write_flip(run: &mut Run, floor: &Subject, rays: [u32; 2]) -> anyhow::Result<()> {
    let seen = exact(floor, 0, SIDE, rays)?;
    let speeds = run.speeds(COMPARISON.name, usize::from(SIDE), 1.0)?;
    let mut rows = Vec::new();
    for (method, found) in METHODS.iter().zip(speeds) {
        let image = drawn(floor, 0, SIDE, &method.run)?;
        // Where nothing is told, nothing differs.
        let expected: Vec<[f64; 3]> = seen
            .iter()
            .enumerate()
            .map(|(n, seen)| seen.as_ref().map_or(channels(&image, n), |seen| seen.color))
            .collect();
        let flips = flip(&image, &expected);
        let counted = || seen.iter().zip(&flips).filter(|(seen, _)| seen.is_some());
        let mean = counted().map(|(_, flip)| f64::from(*flip)).sum::<f64>() / counted().count() as f64;
        let ms = |rate: f64| three_digits(1000.0 / rate);
        rows.push(Row {
            method: method.name.into(),
            rms: three_digits(rms(&image, &expected, |n| seen[n].is_some())),
            flip: three_digits(mean),
            ms_median: ms(found.median()),
            ms_builds: spaced(found.builds.iter().map(|rate| ms(*rate))),
            frontier_rms: false,
            frontier_flip: false,
        });
    }
    let best = [|row: &Row| number(&row.rms), |row: &Row| number(&row.flip)]
        .map(|error| frontier(&figures(&rows, error)));
    for (n, row) in rows.iter_mut().enumerate() {
        [row.frontier_rms, row.frontier_flip] = [best[0][n], best[1][n]];
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    Ok(write_whole(&run.folder.join(FLIP).with_extension("csv"), &writer.into_inner()?)?)
}

/// What decides about each method, by this error.
fn figures(rows: &[Row], error: fn(&Row) -> f64) -> Vec<Figure> {
    rows.iter().map(|row| Figure { error: error(row), builds: rates(row), does_it: true }).collect()
}

/// Pictures a second, in each build.
fn rates(row: &Row) -> Vec<f64> {
    numbers(&row.ms_builds).into_iter().map(|ms| 1000.0 / ms).collect()
}

/// The lines of a table, and their value for a method at a place.
fn lines_of(folder: &Path, name: &str) -> anyhow::Result<Vec<Line>> {
    let points = read_points(&folder.join(name).with_extension("csv"))?;
    let names: Vec<&str> = METHODS.iter().map(|method| method.name).chain([RIGHT]).collect();
    let colors = hues(names.iter().map(|name| *name != RIGHT));
    let line = |(name, hue): (&&str, Option<usize>)| Line {
        name: (*name).into(),
        hue,
        points: series_of(name, &points),
        ringed: None,
        does_it: *name != RIGHT,
    };
    Ok(names.iter().zip(colors).map(line).filter(|line| !line.points.is_empty()).collect())
}

/// A line's value at a place.
fn value(lines: &[Line], name: &str, at: f64) -> String {
    let line = lines.iter().find(|line| line.name == name);
    let point = line.and_then(|line| line.points.iter().find(|point| point.0 == at));
    point.map_or_else(|| "?".into(), |point| readable(point.1))
}

/// The charts, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let caption = caption(folder, COMPARISON.name)?;
    let facts: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join(COMPARISON.name).with_extension("json"))?)?;
    let fact = |name: &str| facts[name].to_string().trim_matches('"').to_string();
    let against = format!(
        "Lesson 13, over the floor; {} pictures, against {}; half as many each way differ by {} levels.",
        fact("pictures"),
        fact("reference"),
        fact("half_as_many_rays")
    );
    let changes = lines_of(folder, COMPARISON.name)?;
    let angles = lines_of(folder, ANGLE)?;
    let change = |name: &str| value(&changes, name, 64.0);
    let off = |name: &str| value(&angles, name, 16.0);
    let flight = Lines {
        name: COMPARISON.name,
        title: format!(
            "Where a pixel is 64 texels long, {} grey levels should change: nearest is off by {}, trilinear by {}",
            change(RIGHT),
            change("nearest"),
            change("trilinear")
        ),
        reading:
            "From each picture of a flight to the next: how far a change is from the expected one (RMS)."
                .into(),
        across: "length of a pixel's footprint, texels →".into(),
        falling: false,
        what: "change",
        unit: "grey levels of 255",
        limit: None,
        lines: changes,
        caption: vec![against.clone(), caption.clone()],
    };
    let angle = Lines {
        name: ANGLE,
        title: format!(
            "Footprints 16 times as long as wide: anisotropic is off by {} grey levels, trilinear by {}",
            off("anisotropic"),
            off("trilinear")
        ),
        reading: "How far pixels are from the mean over their footprints (RMS).".into(),
        across: "length of the footprint over its width →".into(),
        falling: false,
        what: "RMS difference",
        unit: "grey levels of 255",
        limit: None,
        lines: angles,
        caption: vec![against.clone(), caption.clone()],
    };
    let mut pictures = [lines_in_each_layout(&flight)?, lines_in_each_layout(&angle)?].concat();
    for layout in &LAYOUTS {
        pictures
            .push((format!("{FLIP}{}", layout.ending), flip_chart(folder, layout, [&against, &caption])?));
    }
    Ok(pictures)
}

/// FLIP against time.
fn flip_chart(
    folder: &Path,
    layout: &'static super::card::Layout,
    captions: [&str; 2],
) -> anyhow::Result<String> {
    let mut reader = csv::Reader::from_path(folder.join(FLIP).with_extension("csv"))?;
    let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>()?;
    let error: fn(&Row) -> f64 = |row| number(&row.flip);
    let close = close(&figures(&rows, error));
    let dot = |(n, (row, close)): (usize, (&Row, &bool))| Dot {
        name: row.method.clone(),
        hue: Some(n),
        worst: row.flip.clone(),
        mean: row.flip.clone(),
        exact: true,
        speed: spread(&rates(row)),
        frontier: row.frontier_flip,
        close: *close,
        does_it: true,
    };
    let mut best: Vec<&Row> = rows.iter().filter(|row| row.frontier_flip).collect();
    best.sort_by(|a, b| error(a).total_cmp(&error(b)));
    let title = match best[..] {
        [finest, .., cheapest] => format!(
            "From {} to {}: {} less difference for {} the time",
            cheapest.method,
            finest.method,
            times(error(cheapest) / error(finest)),
            times(number(&finest.ms_median) / number(&cheapest.ms_median))
        ),
        [only] => format!("{} beats all others", only.method),
        [] => String::new(),
    };
    let chart = Speed {
        name: FLIP,
        title,
        error: &Quantity { name: "mean of NVIDIA's FLIP", unit: "0 to 1", limit: (0.02, "within 0.02") },
        none: "exact",
        speed: format!("ms a picture of {SIDE}×{SIDE} px"),
        times: true,
        dots: rows.iter().zip(&close).enumerate().map(dot).collect(),
        caption: captions.map(String::from).to_vec(),
    };
    speed(&chart, layout)
}
