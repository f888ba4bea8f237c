//! What lesson 16 leaves out, and where the time of its own scene goes.

use std::path::Path;
use std::sync::Arc;

use clipping::Cull;
use common::file::write_whole;
use common::{Color, Mat4, Vec2, Vec3};
use lighting::PointLight;
use scene::frustum::pixels_per_unit;
use scene::head::{STAGES, Stage};
use scene::{
    Entity, Filtering, Levels, Mesh, Paint, Scene, Shading, Style, Target, VERSIONS, Vertex, orbit,
    render_scene, sphere,
};
use serde_json::json;
use transforms::inverse::rigid;

use super::digits::{readable, three_digits};
use super::draw::{Line, Lines, lines_in_each_layout};
use super::measure::Work;
use super::table::{Point, read_points, series_of, write_points};
use super::{Comparison, Pictures, Run, caption};
use crate::lessons::scene::figures::sizes;

/// The size in which the lesson's scenes are stated.
const SIZE: [u16; 2] = [1024, 768];

fn size() -> Vec2 {
    Vec2::new(SIZE[0].into(), SIZE[1].into())
}

/// A scene to be drawn again and again.
fn drawing(scene: Scene, antialiased: bool, projection: Mat4, camera: Mat4) -> Work {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    target.antialiased = antialiased;
    let inverse = rigid(&camera);
    Work::new(1.0, move || render_scene(&scene, &mut target, &projection, &inverse))
}

/// Where the milliseconds of the lesson's own scene go: it, and it without one thing.
pub(super) const FRAME: Comparison =
    Comparison { name: "16-scene-frame", works: |_| frames(), measure: frame, draw: |_| Ok(Vec::new()) };

/// What is done without.
const WITHOUT: [&str; 7] = ["nothing", "samples", "light", "filter", "culling", "levels", "entities"];

fn frames() -> anyhow::Result<Vec<Work>> {
    let version = &VERSIONS[11];
    let frame = |without: &str| -> anyhow::Result<Work> {
        let mut scene = (version.scene)(sizes(if without == "levels" { "128x256" } else { "by-size" })?)?;
        match without {
            "light" => scene.style.shading = Shading::Unlit,
            "filter" => scene.style.filter = Filtering::Nearest,
            "culling" => scene.style.cull = Cull::None,
            "entities" => scene.entities.clear(),
            _ => {}
        }
        let camera = version.camera.map_or(Mat4::IDENTITY, |orbit| orbit.camera());
        Ok(drawing(scene, without != "samples", (version.projection)(size()), camera))
    };
    WITHOUT.into_iter().map(frame).collect()
}

fn frame(run: &mut Run) -> anyhow::Result<()> {
    let speeds = run.speeds(FRAME.name, 0, 1.0)?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["without", "ms"])?;
    for (without, speed) in WITHOUT.iter().zip(&speeds) {
        writer.write_record([*without, &three_digits(1000.0 / speed.median())])?;
    }
    write_whole(&run.folder.join(FRAME.name).with_extension("csv"), &writer.into_inner()?)?;
    run.write_facts(FRAME.name, json!({ "size": SIZE }))
}

/// Many things of which some are seen, asked for or not.
pub(super) const OUTSIDE: Comparison = Comparison {
    name: "16-scene-outside",
    works: |share| Ok(outside(share)),
    measure: outsides,
    draw: outside_chart,
};

/// How many of the things are in the picture, in percent.
const SHARES: [usize; 6] = [0, 10, 25, 50, 75, 100];

/// So many things.
const THINGS: usize = 400;

/// The same spheres twice: with the balls that contain them, and with balls so large that each might be seen.
const ASKED: [&str; 2] = ["asked", "unasked"];

fn outside(share: usize) -> Vec<Work> {
    let shape = sphere(16, 32);
    let mut unbounded = shape.clone();
    // In no triangle: it costs nothing but the ball.
    unbounded.vertices.push(Vertex { position: Vec3::splat(1e6), ..shape.vertices[0] });
    let work = |shape| {
        let mesh = Levels::one(Mesh::new(shape, Paint::Color(Color::gray(0.7))));
        let entity = |n: usize| {
            let [column, row] = [n % 20, n / 20].map(|n| n as f32 - 9.5);
            // What is not seen is behind.
            let seen = n * 37 % THINGS * 100 < share * THINGS;
            let position = Vec3::new(column, row, if seen { -30.0 } else { 30.0 });
            Entity { position, scale: Vec3::splat(0.4), ..Entity::new(Arc::clone(&mesh)) }
        };
        let scene = Scene {
            entities: (0..THINGS).map(entity).collect(),
            lights: vec![PointLight::default()],
            background: Color::BLACK,
            style: Style { shading: Shading::BlinnPhong, filter: Filtering::Nearest, cull: Cull::Back },
        };
        let projection = perspective::perspective(45.0, 4.0 / 3.0, 0.1, 100.0).expect("a camera");
        drawing(scene, false, projection, Mat4::IDENTITY)
    };
    [&shape, &unbounded].map(work).into()
}

fn outsides(run: &mut Run) -> anyhow::Result<()> {
    let mut points = Vec::new();
    for share in SHARES {
        let speeds = run.speeds(OUTSIDE.name, share, 0.15)?;
        points.extend(ASKED.iter().zip(&speeds).map(|(name, speed)| Point {
            method: (*name).into(),
            at: share.to_string(),
            value: three_digits(1000.0 / speed.median()),
        }));
    }
    write_points(&points, ["way", "seen_%", "ms"], &run.folder.join(OUTSIDE.name).with_extension("csv"))?;
    run.write_facts(OUTSIDE.name, json!({ "things": THINGS }))
}

fn line(name: String, hue: usize, points: Vec<(f64, f64)>, ringed: Option<usize>) -> Line {
    Line { name, hue: Some(hue), points, ringed, does_it: true }
}

fn outside_chart(folder: &Path) -> anyhow::Result<Pictures> {
    let points = read_points(&folder.join(OUTSIDE.name).with_extension("csv"))?;
    let of = |name: &str| series_of(name, &points);
    let at = |name: &str, share: f64| {
        let found = of(name).into_iter().find(|point| point.0 == share);
        found.map_or_else(|| "?".into(), |point| readable(point.1))
    };
    let chart = Lines {
        name: OUTSIDE.name,
        title: format!(
            "With a tenth of {THINGS} spheres in the picture a frame takes {} ms where it is asked whether they are seen, \
             else {} ms",
            at(ASKED[0], 10.0),
            at(ASKED[1], 10.0)
        ),
        reading: format!(
            "The time for a picture of {THINGS} spheres of 960 triangles, by how many are seen."
        ),
        across: "spheres in the picture, % →".into(),
        falling: false,
        what: "time",
        unit: "ms",
        limit: None,
        lines: ["asked whether it is seen", "not asked"]
            .into_iter()
            .zip(ASKED)
            .enumerate()
            .map(|(hue, (name, way))| line(name.into(), hue, of(way), None))
            .collect(),
        caption: vec![
            format!("Lesson 16, {}×{} px, one sample, lit at each pixel.", SIZE[0], SIZE[1]),
            caption(folder, OUTSIDE.name)?,
        ],
    };
    lines_in_each_layout(&chart)
}

/// The head in each of its levels, from near to far.
pub(super) const HEADS: Comparison =
    Comparison { name: "16-scene-heads", works: heads, measure: head_levels, draw: heads_chart };

/// Of the eye from the head's middle.
const DISTANCES: [usize; 4] = [2, 10, 40, 200];

fn seen_from(distance: usize) -> anyhow::Result<[Mat4; 2]> {
    let projection = perspective::perspective(45.0, 4.0 / 3.0, 0.1, 1000.0)?;
    Ok([projection, orbit(20.0, 5.0, distance as f32)])
}

fn heads(distance: usize) -> anyhow::Result<Vec<Work>> {
    let [projection, camera] = seen_from(distance)?;
    let work = |stage: &Stage| {
        let mesh = stage.mesh(&Paint::Color(Color::gray(0.8)))?;
        let scene = Scene {
            entities: vec![Entity::new(Levels::one(mesh))],
            lights: vec![PointLight::default()],
            background: Color::BLACK,
            style: Style { shading: Shading::BlinnPhong, filter: Filtering::Nearest, cull: Cull::Back },
        };
        Ok(drawing(scene, false, projection, camera))
    };
    STAGES.iter().map(work).collect()
}

fn head_levels(run: &mut Run) -> anyhow::Result<()> {
    let mut points = Vec::new();
    for distance in DISTANCES {
        let speeds = run.speeds(HEADS.name, distance, 0.25)?;
        points.extend(STAGES.iter().zip(&speeds).map(|(stage, speed)| Point {
            method: distance.to_string(),
            at: stage.triangles.to_string(),
            value: three_digits(1000.0 / speed.median()),
        }));
    }
    write_points(
        &points,
        ["distance", "triangles", "ms"],
        &run.folder.join(HEADS.name).with_extension("csv"),
    )?;
    run.write_facts(HEADS.name, json!({ "size": SIZE }))
}

fn heads_chart(folder: &Path) -> anyhow::Result<Pictures> {
    let points = read_points(&folder.join(HEADS.name).with_extension("csv"))?;
    let levels = scene::head::head(&Paint::Color(Color::WHITE))?;
    let mut lines = Vec::new();
    let mut title = String::new();
    for (hue, distance) in DISTANCES.into_iter().enumerate() {
        let [projection, camera] = seen_from(distance)?;
        let to_clip = projection * rigid(&camera);
        let pixels = pixels_per_unit(&to_clip, &Entity::new(Arc::clone(&levels)).bounds(), size());
        let times = series_of(&distance.to_string(), &points);
        // The time, and how many pixels the level is off at most.
        let of_level = |(stage, (_, ms)): (&Stage, &(f64, f64))| (*ms, f64::from(stage.distance * pixels));
        let line_points: Vec<(f64, f64)> = STAGES.iter().zip(&times).map(of_level).collect();
        let chosen = line_points.iter().position(|point| point.1 <= 0.5);
        if let (40, Some(n), Some(finest)) = (distance, chosen, times.last()) {
            title = format!(
                "From {distance} units away the head needs {} triangles, and takes {} ms, its finest level {}",
                STAGES[n].triangles,
                readable(times[n].1),
                readable(finest.1)
            );
        }
        lines.push(line(format!("{distance} units away"), hue, line_points, chosen));
    }
    let counts: Vec<String> = STAGES.iter().map(|stage| stage.triangles.to_string()).collect();
    let chart = Lines {
        name: HEADS.name,
        title,
        reading: "How far a level of the head is from its finest in the picture, at most, and how long it takes; the level \
                  that is chosen is ringed."
            .into(),
        across: "ms a picture →".into(),
        falling: false,
        what: "largest distance from the finest head",
        unit: "px",
        limit: Some((0.5, "½ px")),
        lines,
        caption: vec![
            format!("Dots from the left: {} triangles.", counts.join(", ")),
            format!("Lesson 16, {}×{} px, one sample, lit at each pixel.", SIZE[0], SIZE[1]),
            caption(folder, HEADS.name)?,
        ],
    };
    lines_in_each_layout(&chart)
}
