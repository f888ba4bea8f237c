//! No more than the scene needs: how many triangles a sphere takes, and what a shader carries.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::path::Path;

use common::file::write_whole;
use common::{Attributes, DVec3, Format, Image, Method, Model, Vec2, Vec3};
use gouraud::corner_normals;
use serde::{Deserialize, Serialize};
use serde_json::json;
use shaders::{Framebuffer, SHADERS, Uniforms, fit};
use transforms::{place, viewport};

use super::card::LAYOUTS;
use super::digits::three_digits;
use super::draw::{Line, Lines, lines};
use super::measure::Work;
use super::scene::draw;
use super::table::{Series, number};
use super::{Comparison, Pictures, Run, caption};

pub(crate) const COMPARISON: Comparison = Comparison { name: "needs", works, measure, draw: pictures };

/// The sides of the pictures.
const SIDES: [u16; 3] = [100, 400, 1600];

/// Segments of the sphere's outline: multiples of 4, so that it has corners at its left and right.
const SEGMENTS: [usize; 11] = [4, 8, 12, 16, 24, 32, 48, 64, 96, 160, 256];

/// The shaders whose difference is compared.
pub(super) const SHADED: [&str; 2] = ["flat", "gouraud"];

/// The side of the picture in the chart of shading.
const SHADING_SIDE: u16 = 400;

/// What the sphere's radius takes up of the picture's side.
const ZOOM: f32 = 0.4;

/// From the side, so that there is light and shadow.
const LIGHT: Vec3 = Vec3::new(0.5, 0.5, 0.707_106_77);

/// A row of `needs.csv`.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Row {
    shader: String,
    side: u16,
    segments: usize,
    triangles: usize,
    /// Largest distance between the drawn outline and the circle.
    outline_max: String,
    /// The area between them over the circle's length.
    outline_mean: String,
    shading_max: String,
    shading_mean: String,
    ms_median: String,
    /// Whether it is the first with no more than half a pixel by the rule for outlines.
    rule: bool,
    /// Whether it is the first that loses no more than half a level by the rule for Gouraud's shading.
    shading_rule: bool,
}

/// The least number of segments whose distance from a circle of radius `radius` is at most `error`, in px: a
/// chord is R·(1 − cos(π/N)) away from its arc.
fn segments_needed(radius: f64, error: f64) -> f64 {
    PI / (1.0 - error / radius).acos()
}

/// The least number of segments with which Gouraud shading loses at most `levels` of 255.
///
/// Between two unit normals an angle α apart, the middle of the straight line is cos(α/2) ≈ 1 − α²/8 long, which is
/// the share of the brightness that is left. Corners of a cell of latitude and longitude are φ apart along its sides
/// and √2·φ along its diagonal, so the largest loss is φ²/4, with φ = 2π/N.
fn segments_for_shading(levels: f64) -> f64 {
    TAU / (4.0 * levels / 255.0).sqrt()
}

/// A sphere whose outline has so many segments, seen from anywhere on its equator or from a pole.
fn sphere(segments: usize) -> Model {
    let text = assets::sphere::sphere(segments / 2, segments).to_obj();
    let all = Attributes { normals: true, uvs: true };
    Model::parse(text.as_bytes(), all).expect("the sphere is a model")
}

/// The pixels that a model covers, whatever light falls on it, in rows from the bottom.
pub(super) fn coverage(uniforms: &Uniforms, side: u16) -> Vec<bool> {
    let empty = Image::new(side, side, Format::Gray);
    let mut covered = vec![false; usize::from(side) * usize::from(side)];
    let to_screen = viewport(f32::from(side), f32::from(side), 0.5) * uniforms.to_clip;
    for face in uniforms.model.faces() {
        if let [Some(a), Some(b), Some(c)] = face.map(|corner| place(&to_screen, corner)) {
            triangles::fill([a, b, c].map(Vec3::truncate), empty.bounds(), |x, y, _| {
                covered[y as usize * usize::from(side) + x as usize] = true;
            });
        }
    }
    covered
}

/// How far the outline of a drawn sphere is from a circle, in px: the largest distance of a pixel's centre that
/// is on the wrong side, and the area between the two over the circle's length.
fn outline(covered: &[bool], side: u16) -> [f64; 2] {
    let radius = f64::from(side) * f64::from(ZOOM);
    let (mut largest, mut area) = (0.0_f64, 0.0);
    for (n, covered) in covered.iter().enumerate() {
        let [x, y] = [n % usize::from(side), n / usize::from(side)].map(|n| center(n as i32, side));
        let distance = x.hypot(y) - radius;
        if *covered != (distance <= 0.0) {
            largest = largest.max(distance.abs());
            area += 1.0;
        }
    }
    [largest, area / (2.0 * PI * radius)]
}

/// How far the shading of a drawn sphere is from that of the smooth one, in grey levels: the largest difference and
/// the mean. A point of the drawn surface is held against the point of the sphere in the same direction from the
/// middle: that the two are seen in different pixels is a matter of the outline.
fn shading(drawn: &Framebuffer, side: u16) -> [f64; 2] {
    let radius = f64::from(side) * f64::from(ZOOM);
    let light = LIGHT.as_dvec3().normalize();
    let (mut largest, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
    for (x, y, color) in drawn.image.pixels() {
        let depth = drawn.depths.get(x, y);
        if depth > f32::NEG_INFINITY {
            let point = DVec3::new(center(x, side) / radius, center(y, side) / radius, f64::from(depth));
            let exact = point.normalize().dot(light).max(0.0);
            let off = (f64::from(color.r) - 255.0 * exact).abs();
            largest = largest.max(off);
            sum += off;
            count += 1.0;
        }
    }
    [largest, sum / f64::max(count, 1.0)]
}

/// Where a pixel's centre is, from the middle of the picture.
fn center(n: i32, side: u16) -> f64 {
    f64::from(n) + 0.5 - f64::from(side) / 2.0
}

/// Each shader drawing each sphere, in pictures of that side.
fn works(side: usize) -> anyhow::Result<Vec<Work>> {
    let side = side as u16;
    let models = SEGMENTS.map(|segments| &*Box::leak(Box::new(sphere(segments))));
    let work = |(shader, model): (&str, &'static Model)| drawing(shader, model, side);
    Ok(SHADED.iter().flat_map(|shader| models.map(|model| (*shader, model))).map(work).collect())
}

/// Measures spheres, and writes the table of what shaders carry.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let mut rows = Vec::new();
    let quick = run.effort.quick;
    for side in SIDES.into_iter().filter(|&side| !quick || side < 1000) {
        let speeds = run.speeds(COMPARISON.name, usize::from(side), 1.0)?;
        let pairs = SHADED.iter().flat_map(|shader| SEGMENTS.map(|segments| (*shader, segments)));
        for ((shader, segments), speed) in pairs.zip(speeds) {
            let model = sphere(segments);
            let normals = corner_normals(&model);
            let uniforms = front(&model, &normals);
            let render = Method::find(SHADERS, shader).expect("lesson 9 has it").run.generic;
            let [outline_max, outline_mean] = outline(&coverage(&uniforms, side), side).map(three_digits);
            let [shading_max, shading_mean] = shading(&draw(render, &uniforms, side), side).map(three_digits);
            let before = SEGMENTS.iter().rev().find(|&&other| other < segments).copied().unwrap_or(0);
            let is_first = |needed: f64| segments as f64 >= needed && (before as f64) < needed;
            rows.push(Row {
                shader: shader.into(),
                side,
                segments,
                triangles: model.faces().len(),
                outline_max,
                outline_mean,
                shading_max,
                shading_mean,
                ms_median: three_digits(1000.0 / speed.median()),
                rule: is_first(segments_needed(f64::from(side) * f64::from(ZOOM), 0.5)),
                shading_rule: shader == SHADED[1] && is_first(segments_for_shading(0.5)),
            });
        }
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    write_whole(&run.folder.join("needs.csv"), &writer.into_inner()?)?;
    let facts = json!({
        "sphere": "radius 0.4 of the picture's side, parallel projection",
        "light": LIGHT.to_array(),
        "rule": "the first with N ≥ π / acos(1 − e/R) segments, e = ½ px",
        "shading_rule": "the first with N ≥ 2π / √(4·e/255) segments, e = ½ level",
    });
    run.write_facts("needs", facts)?;
    let (table, markdown) = carried()?;
    write_whole(&run.folder.join("needs-shaders.csv"), &table)?;
    write_whole(&run.folder.join("needs-shaders.md"), markdown.as_bytes())?;
    write_whole(&run.folder.join("needs-loop.csv"), &super::counts::table()?)?;
    Ok(())
}

/// A model from the front, in parallel projection.
pub(super) fn front<'a>(model: &'a Model, normals: &'a [[Vec3; 3]]) -> Uniforms<'a> {
    Uniforms { normals, light: LIGHT, to_clip: fit(ZOOM, Vec2::ONE), ..Uniforms::new(model) }
}

/// The piece of work of drawing a model from the front; what it draws is kept until the program ends.
pub(super) fn drawing(shader: &str, model: &'static Model, side: u16) -> Work {
    let render = Method::find(SHADERS, shader).expect("lesson 9 has it").run.generic;
    let uniforms = front(model, Vec::leak(corner_normals(model)));
    Work::new(1.0, move || draw(render, &uniforms, side))
}

/// The charts, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let mut reader = csv::Reader::from_path(folder.join("needs.csv"))?;
    let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>()?;
    let caption = caption(folder, "needs")?;
    let mut pictures = Vec::new();
    for layout in &LAYOUTS {
        pictures.push((
            format!("needs-outline{}", layout.ending),
            lines(&outline_chart(&rows, &caption), layout)?,
        ));
        pictures.push((
            format!("needs-shading{}", layout.ending),
            lines(&shading_chart(&rows, &caption), layout)?,
        ));
    }
    Ok(pictures)
}

fn outline_chart<'a>(rows: &[Row], caption: &str) -> Lines<'a> {
    let mine = |side: u16| rows.iter().filter(move |row| row.side == side && row.shader == SHADED[1]);
    let sides: Vec<u16> = SIDES.into_iter().filter(|side| mine(*side).next().is_some()).collect();
    let line = |(n, side): (usize, &u16)| {
        let points: Series =
            mine(*side).map(|row| (number(&row.ms_median), number(&row.outline_max))).collect();
        Line {
            name: format!("{side}×{side} px"),
            hue: Some(n),
            points,
            ringed: mine(*side).position(|row| row.rule),
            does_it: true,
        }
    };
    let enough: Vec<String> = sides
        .iter()
        .filter_map(|side| mine(*side).find(|row| row.rule))
        .map(|row| format!("{} at {}×{1} px", row.segments, row.side))
        .collect();
    Lines {
        name: "needs-outline",
        title: format!("A round outline takes so many segments: {}; more are not seen", enough.join(", ")),
        reading: "◯ the first with N ≥ π / acos(1 − e/R) segments, for e = ½ px: more only take time.".into(),
        across: "ms a picture →".into(),
        falling: false,
        what: "largest distance from the circle",
        unit: "px",
        limit: Some((0.5, "½ px")),
        lines: sides.iter().enumerate().map(line).collect(),
        caption: vec![dots(), caption.into()],
    }
}

fn shading_chart<'a>(rows: &[Row], caption: &str) -> Lines<'a> {
    let mine = |shader: &'static str| {
        rows.iter().filter(move |row| row.side == SHADING_SIDE && row.shader == shader)
    };
    let line = |(n, shader): (usize, &&'static str)| {
        let points: Series =
            mine(shader).map(|row| (number(&row.ms_median), number(&row.shading_max))).collect();
        let ringed = mine(shader).position(|row| row.shading_rule);
        Line { name: (*shader).into(), hue: Some(n), points, ringed, does_it: true }
    };
    let ringed = mine(SHADED[1]).find(|row| row.shading_rule).map_or(0, |row| row.segments);
    let finest = |shader| mine(shader).next_back().map_or("inf", |row| row.shading_max.as_str());
    Lines {
        name: "needs-shading",
        title: format!(
            "Gouraud shading loses half a level at most from {ringed} segments on; flat is {} levels off at {} still",
            finest(SHADED[0]),
            SEGMENTS[SEGMENTS.len() - 1]
        ),
        reading: format!(
            "◯ the first with N ≥ 2π / √(4·e/255) segments, for a loss of e = ½ level; rounding to 8 bits takes \
             another ½. {SHADING_SIDE}×{SHADING_SIDE} px."
        ),
        across: "ms a picture →".into(),
        falling: false,
        what: "largest difference from a smooth sphere",
        unit: "grey levels of 255",
        limit: Some((1.0, "½ level lost, ½ rounded")),
        lines: SHADED.iter().enumerate().map(line).collect(),
        caption: vec![dots(), caption.into()],
    }
}

fn dots() -> String {
    let segments: Vec<String> = SEGMENTS.iter().map(ToString::to_string).collect();
    format!("Dots from the left: spheres whose outline has {} segments.", segments.join(", "))
}

/// What shaders carry, as CSV and as Markdown: computed from the types of what they read and interpolate.
fn carried() -> anyhow::Result<(Vec<u8>, String)> {
    /// The size of what a function returns.
    fn size_of_result<A, T>(_: impl FnOnce(A) -> T) -> usize {
        size_of::<T>()
    }
    // Of what a lesson reads for each corner.
    let position: usize = size_of_result(|model: &Model| model.position(0, 0));
    let uv = size_of_result(|model: &Model| model.uv(0, 0));
    let normal = size_of_result(|model: &Model| corner_normals(model)[0][0]);
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut markdown =
        String::from("| shader | bytes a vertex | numbers interpolated for each pixel |\n|---|---:|---:|\n");
    writer.write_record(["shader", "bytes_per_vertex", "floats_per_fragment"])?;
    for shader in SHADERS {
        let needs = shader.run.needs;
        let bytes = position + usize::from(needs.normals) * normal + usize::from(needs.uvs) * uv;
        let floats = shader.run.interpolated / size_of::<f32>();
        writer.write_record([shader.name, &bytes.to_string(), &floats.to_string()])?;
        writeln!(markdown, "| `{}` | {bytes} | {floats} |", shader.name)?;
    }
    Ok((writer.into_inner()?, markdown))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_keeps_half_a_pixel_and_no_fewer_segments_do() {
        for radius in [10.0, 40.0, 160.0, 640.0] {
            let needed = segments_needed(radius, 0.5);
            let sagitta = |n: f64| radius * (1.0 - (PI / n).cos());
            assert!(sagitta(needed.ceil()) <= 0.5 && sagitta(needed.ceil() - 1.0) > 0.5);
        }
    }

    #[test]
    fn the_rule_for_shading_loses_half_a_level_in_the_middle_of_a_cell() {
        // Corners of a cell on the equator, where it is largest; the light along the middle of its diagonal.
        let needed = segments_for_shading(0.5);
        let loss = |segments: f64| {
            let angle = TAU / segments;
            let [a, b] = [-0.5, 0.5].map(|half| {
                let ((sin_x, cos_x), (sin_y, cos_y)) = ((half * angle).sin_cos(), (half * angle).sin_cos());
                DVec3::new(cos_y * sin_x, sin_y, cos_y * cos_x)
            });
            255.0 * (1.0 - (a + b).length() / 2.0)
        };
        assert!((loss(needed) - 0.5).abs() < 0.001);
        assert!(loss(needed.ceil()) <= 0.5 && loss(needed * 0.9) > 0.6);
    }

    #[test]
    fn what_a_shader_carries_is_what_its_row_promises() {
        let (_, markdown) = carried().unwrap();
        for row in ["| `flat` | 12 | 0 |", "| `gouraud` | 24 | 1 |", "| `gouraud-texture` | 32 | 3 |"] {
            assert!(markdown.contains(row), "{markdown}");
        }
    }
}
