//! Where lesson 17's time goes: layers behind each other, threads, and what a machine gives at most.

use std::convert::Infallible;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

use common::Method;
use common::file::write_whole;
use fearless_simd::{Level, Simd, dispatch, f32x8, prelude::*};
use serde_json::json;
use speed::{METHODS, Picture, Renderer};
use speed_scenes::rounds::{Limits, rounds};
use speed_scenes::{Scene, find, layers};

use super::card::hues;
use super::digits::{readable, three_digits};
use super::draw::{Line, Lines, lines_in_each_layout};
use super::finding::times;
use super::measure::Work;
use super::table::{Point, read_points, series_of, write_points};
use super::{Comparison, Pictures, Run, caption};
use crate::lessons::speed::charts::scene_works;

/// Layers, the nearest first.
pub(super) const FRONT: Comparison = Comparison {
    name: "17-speed-front",
    works: |count| Ok(layered(layers::front(count as u16, tilt(count)))),
    measure: |run| measure_layers(run, FRONT.name),
    draw: |folder| layers_chart(folder, FRONT.name, "nearest first"),
};

/// The same layers, the farthest first.
pub(super) const BACK: Comparison = Comparison {
    name: "17-speed-back",
    works: |count| Ok(layered(layers::back(count as u16, tilt(count)))),
    measure: |run| measure_layers(run, BACK.name),
    draw: |folder| layers_chart(folder, BACK.name, "farthest first"),
};

/// How many layers there are.
const LAYERS: [usize; 5] = [2, 5, 10, 20, 50];

/// How far so many layers are tilted, in steps from one to the next: as far as all of them stay before the eye.
fn tilt(count: usize) -> f32 {
    layers::TILT.min(0.1 * (count - 1) as f32)
}

/// All methods that draw on one thread.
fn single() -> &'static [Method<Renderer>] {
    &METHODS[..METHODS.len() - 1]
}

fn layered(scene: Scene) -> Vec<Work> {
    scene_works(scene, single())
}

fn measure_layers(run: &mut Run, name: &str) -> anyhow::Result<()> {
    let mut points = Vec::new();
    for count in LAYERS {
        let speeds = run.speeds(name, count, 0.25)?;
        points.extend(single().iter().zip(&speeds).map(|(method, speed)| Point {
            method: method.name.into(),
            at: count.to_string(),
            // So long for a picture's pixels.
            value: three_digits(pixels() * 1000.0 / speed.median()),
        }));
    }
    write_points(&points, ["method", "layers", "ms"], &run.folder.join(name).with_extension("csv"))?;
    run.write_facts(name, json!({ "size": speed_scenes::FULL }))
}

/// Of the picture.
fn pixels() -> f64 {
    speed_scenes::FULL.into_iter().map(f64::from).product()
}

fn layers_chart(folder: &Path, name: &str, order: &str) -> anyhow::Result<Pictures> {
    let points = read_points(&folder.join(name).with_extension("csv"))?;
    let line = |(method, hue): (&Method<Renderer>, Option<usize>)| Line {
        name: method.name.into(),
        hue,
        points: series_of(method.name, &points),
        ringed: None,
        does_it: true,
    };
    let lines: Vec<Line> = single().iter().zip(hues(single().iter().map(|_| true))).map(line).collect();
    let at = |name: &str, count: f64| {
        let line = lines.iter().find(|line| line.name == name);
        let point = line.and_then(|line| line.points.iter().find(|point| point.0 == count));
        point.map_or(f64::NAN, |point| point.1)
    };
    let (simple, deferred) = (at("simple", 20.0), at("deferred", 20.0));
    let chart = Lines {
        name,
        title: format!(
            "20 layers, {order}: {} ms by simple, {} by deferred, {} less",
            readable(simple),
            readable(deferred),
            times(simple / deferred)
        ),
        reading: format!("The time for a picture of tilted layers that all fill it, {order}."),
        across: "layers →".into(),
        falling: false,
        what: "time",
        unit: "ms",
        limit: None,
        lines,
        caption: vec!["Lesson 17, 1920×1080 px, one core, nearest texel.".into(), caption(folder, name)?],
    };
    lines_in_each_layout(&chart)
}

/// What a second thread gains: by the clock on the wall, since a thread's own does not see others work.
pub(super) const THREADS: Comparison = Comparison {
    name: "17-speed-threads",
    works: |_| Ok(Vec::new()),
    measure: measure_threads,
    draw: |_| Ok(Vec::new()),
};

/// The scenes that are drawn by threads.
const SCENES: [&str; 6] = ["head-800", "head", "knot", "tilted-front-20", "tilted-back-20", "soup"];

fn measure_threads(run: &mut Run) -> anyhow::Result<()> {
    let limits = Limits { rounds: 200, time: run.time.div_f64(2.0) };
    let method = METHODS.last().map(|method| &method.run).expect("there is one");
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["scene", "one", "two", "gain"])?;
    for name in SCENES {
        let recipe = find(name).expect("it is one of the scenes");
        let scene = (recipe.make)();
        let mut drawn =
            [1, 2].map(|threads| (method.drawer(scene.size.map(i32::from), 0, threads), scene.canvas()));
        let times = rounds(2, limits, |n| -> Result<Duration, Infallible> {
            let (draw, image) = &mut drawn[n];
            let start = Instant::now();
            draw(&Picture { surfaces: &[scene.surface()], cull: Scene::CULL }, image);
            Ok(start.elapsed())
        });
        let Ok(times) = times;
        let [one, two] = [times[0].median, times[1].median];
        let gain = format!("{:.2}", one / two);
        writer.write_record([recipe.title, &three_digits(one), &three_digits(two), &gain])?;
    }
    write_whole(&run.folder.join(THREADS.name).with_extension("csv"), &writer.into_inner()?)?;
    run.write_facts(THREADS.name, json!({ "size": speed_scenes::FULL }))
}

/// What memory and a core give at most, and how much of it the methods take. The figure of it is drawn with the book's.
pub(super) const ROOFLINE: Comparison = Comparison {
    name: "17-speed-roofline",
    works: |size| {
        Ok(match size {
            MEMORY => vec![copying()],
            CORE => vec![computing()],
            _ => scene_works(layers::back(ROOF_LAYERS as u16, layers::TILT), single()),
        })
    },
    measure: measure_roofline,
    draw: |_| Ok(Vec::new()),
};

const MEMORY: usize = 0;
const CORE: usize = 1;
const DRAWN: usize = 2;

/// The layers that are drawn, farthest first, each in all pixels.
const ROOF_LAYERS: usize = 20;

/// What a pixel takes, as the chapter counts it: multiplications, additions and divisions to find that it is covered, and how deep,
/// and to shade it.
const FINDING: usize = 15;
const SHADING: usize = 36;

/// Bytes of memory that a pixel takes, as the chapter counts them: each time that it is drawn to, and once a picture.
const OF_WHOLE: [usize; 2] = [14, 14];
const OF_COPIED: [usize; 2] = [16, 26];
const OF_TILE: [usize; 2] = [0, 26];
const OF_DEFERRED: [usize; 2] = [0, 58];

/// Operations and bytes a pixel of the picture.
fn demands(method: &str) -> [usize; 2] {
    let times = ROOF_LAYERS;
    let bytes = |[each, once]: [usize; 2]| each * times + once;
    match method {
        "simple" | "blocks" => [times * (FINDING + SHADING), bytes(OF_WHOLE)],
        "simd" => [times * (FINDING + SHADING), bytes(OF_COPIED)],
        "deferred" => [times * FINDING + SHADING, bytes(OF_DEFERRED)],
        _ => [times * (FINDING + SHADING), bytes(OF_TILE)],
    }
}

/// Copies more than caches hold; counted are bytes read and bytes written.
fn copying() -> Work {
    const BYTES: usize = 1 << 27;
    let from = vec![1_u8; BYTES];
    let mut to = vec![0_u8; BYTES];
    Work::new(2.0 * BYTES as f64, move || {
        to.copy_from_slice(black_box(&from));
        to[0]
    })
}

/// Multiplies and adds, eight numbers at once, in more chains than an operation takes cycles.
fn computing() -> Work {
    const TIMES: usize = 1 << 16;
    const CHAINS: usize = 12;
    let level = Level::new();
    Work::new(
        (TIMES * CHAINS * 8 * 2) as f64,
        move || dispatch!(level, simd => chains::<_, CHAINS>(simd, TIMES)),
    )
}

#[inline(always)]
fn chains<S: Simd, const N: usize>(simd: S, times: usize) -> f32 {
    let mut sums = [f32x8::splat(simd, black_box(1.0)); N];
    let (factor, more) = (f32x8::splat(simd, black_box(0.999)), f32x8::splat(simd, black_box(0.001)));
    for _ in 0..times {
        for sum in &mut sums {
            *sum = *sum * factor + more;
        }
    }
    let mut all = sums[0];
    for sum in &sums[1..] {
        all += *sum;
    }
    all.as_slice().iter().sum()
}

fn measure_roofline(run: &mut Run) -> anyhow::Result<()> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["what", "operations", "bytes", "millions"])?;
    for (name, size) in [("memory", MEMORY), ("core", CORE)] {
        let speed = &run.speeds(ROOFLINE.name, size, 0.25)?[0];
        let [operations, bytes] = if size == MEMORY { ["0", "1"] } else { ["1", "0"] };
        writer.write_record([name, operations, bytes, &three_digits(speed.median() / 1e6)])?;
    }
    let speeds = run.speeds(ROOFLINE.name, DRAWN, 0.5)?;
    for (method, speed) in single().iter().zip(&speeds) {
        let [operations, bytes] = demands(method.name);
        let rate = three_digits(operations as f64 * speed.median() / 1e6);
        writer.write_record([method.name, &operations.to_string(), &bytes.to_string(), &rate])?;
    }
    write_whole(&run.folder.join(ROOFLINE.name).with_extension("csv"), &writer.into_inner()?)?;
    run.write_facts(ROOFLINE.name, json!({ "layers": ROOF_LAYERS, "size": speed_scenes::FULL }))
}
