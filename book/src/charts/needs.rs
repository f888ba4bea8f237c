//! No more than the scene needs: how many triangles a sphere takes, and what a shader carries.

use std::f64::consts::PI;
use std::fmt::Write;
use std::path::Path;
use std::time::Duration;

use checks::sphere::intensity;
use common::file::write_whole;
use common::{Attributes, Method, Model, Vec2, Vec3};
use gouraud::corner_normals;
use serde::Serialize;
use serde_json::json;
use shaders::{Framebuffer, SHADERS, Uniforms, fit};

use super::draw::{Line, Lines, lines};
use super::figures::three_digits;
use super::machine::Machine;
use super::measure::{Effort, Work, alternate};
use super::scene::draw;
use super::table::{Quantity, Series, number};

/// The sides of the pictures.
const SIDES: [u16; 3] = [100, 400, 1600];

/// Segments of the sphere's outline: multiples of 4, so that it has corners at its left and right.
const SEGMENTS: [usize; 11] = [4, 8, 12, 16, 24, 32, 48, 64, 96, 160, 256];

/// The shaders whose difference is compared.
pub(super) const SHADED: [&str; 2] = ["flat", "gouraud"];

/// What the sphere's radius takes up of the picture's side.
const ZOOM: f32 = 0.4;

/// From the side, so that there is light and shadow.
const LIGHT: Vec3 = Vec3::new(0.5, 0.5, 0.707_106_77);

/// A row of `needs.csv`.
#[derive(Clone, Debug, Serialize)]
struct Row {
    shader: &'static str,
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
    /// Whether it is the first with no more than half a pixel by the rule.
    rule: bool,
}

/// The least number of segments whose distance from a circle of radius `radius` is at most `error`, in px: a
/// chord is R·(1 − cos(π/N)) away from its arc.
fn segments_needed(radius: f64, error: f64) -> f64 {
    PI / (1.0 - error / radius).acos()
}

/// A sphere whose outline has so many segments, seen from anywhere on its equator or from a pole.
fn sphere(segments: usize) -> Model {
    let text = assets::sphere::sphere(segments / 2, segments).to_obj();
    let all = Attributes { normals: true, uvs: true };
    Model::parse(text.as_bytes(), all).expect("the sphere is a model")
}

/// How far the outline of a drawn sphere is from a circle, in px: the largest distance of a pixel's centre that
/// is on the wrong side, and the area between the two over the circle's length.
fn outline(drawn: &Framebuffer, side: u16) -> [f64; 2] {
    let radius = f64::from(side) * f64::from(ZOOM);
    let (mut largest, mut area) = (0.0_f64, 0.0);
    for (x, y, _) in drawn.image.pixels() {
        let distance = center(x, side).hypot(center(y, side)) - radius;
        let seen = drawn.depths.get(x, y) > f32::NEG_INFINITY;
        if seen != (distance <= 0.0) {
            largest = largest.max(distance.abs());
            area += 1.0;
        }
    }
    [largest, area / (2.0 * PI * radius)]
}

/// How far the shading of a drawn sphere is from a smooth one's where both are seen, in grey levels: the largest
/// difference and the mean.
fn shading(drawn: &Framebuffer, side: u16) -> [f64; 2] {
    let radius = f64::from(side) * f64::from(ZOOM);
    let light = LIGHT.as_dvec3().normalize();
    let (mut largest, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
    for (x, y, color) in drawn.image.pixels() {
        if drawn.depths.get(x, y) > f32::NEG_INFINITY
            && let Some(exact) = intensity(center(x, side) / radius, center(y, side) / radius, light)
        {
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

/// Measures spheres and draws `needs-outline.svg` and `needs-shading.svg`; writes the table of what shaders carry.
pub(crate) fn measure(effort: Effort, machine: &Machine, folder: &Path) -> anyhow::Result<()> {
    let mut rows = Vec::new();
    for side in SIDES.iter().copied().filter(|&side| !effort.quick || side < 1000) {
        let needed = segments_needed(f64::from(side) * f64::from(ZOOM), 0.5);
        let mut works = Vec::new();
        let first = rows.len();
        for shader in SHADED {
            let render = Method::find(SHADERS, shader).expect("lesson 9 has it").run.generic;
            for segments in SEGMENTS {
                let model: &'static Model = Box::leak(Box::new(sphere(segments)));
                // Under a light from the eye all that is seen is lit, and so drawn.
                let smooth = Method::find(SHADERS, "gouraud").expect("lesson 9 has it").run.generic;
                let normals: &'static [[Vec3; 3]] = Vec::leak(corner_normals(model));
                let shaded = front(model, normals);
                let lit = Uniforms { light: Vec3::Z, ..shaded };
                let [outline_max, outline_mean] = outline(&draw(smooth, &lit, side), side).map(three_digits);
                let [shading_max, shading_mean] =
                    shading(&draw(render, &shaded, side), side).map(three_digits);
                let before = SEGMENTS.iter().rev().find(|&&other| other < segments).copied().unwrap_or(0);
                rows.push(Row {
                    shader,
                    side,
                    segments,
                    triangles: model.faces().len(),
                    outline_max,
                    outline_mean,
                    shading_max,
                    shading_mean,
                    ms_median: String::new(),
                    rule: segments as f64 >= needed && (before as f64) < needed,
                });
                works.push(Work::new(1.0, move || draw(render, &shaded, side)));
            }
        }
        let found = alternate(&mut works, Duration::from_secs(12), effort);
        for (row, found) in rows[first..].iter_mut().zip(found) {
            row.ms_median = three_digits(1000.0 / found.median);
        }
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    write_whole(&folder.join("needs.csv"), &writer.into_inner()?)?;
    write_whole(&folder.join("needs-outline.svg"), outline_chart(&rows, machine)?.as_bytes())?;
    write_whole(&folder.join("needs-shading.svg"), shading_chart(&rows, machine)?.as_bytes())?;
    let facts = json!({
        "machine": machine,
        "quick": effort.quick,
        "sphere": "radius 0.4 of the picture's side, parallel projection",
        "light": LIGHT.to_array(),
        "rule": "the first with N ≥ π / acos(1 − e/R) segments, e = ½ px",
    });
    write_whole(&folder.join("needs.json"), format!("{facts:#}\n").as_bytes())?;
    let (table, markdown) = carried()?;
    write_whole(&folder.join("needs-shaders.csv"), &table)?;
    write_whole(&folder.join("needs-shaders.md"), markdown.as_bytes())?;
    Ok(())
}

/// A model from the front, in parallel projection.
pub(super) fn front<'a>(model: &'a Model, normals: &'a [[Vec3; 3]]) -> Uniforms<'a> {
    Uniforms { normals, light: LIGHT, to_clip: fit(ZOOM, Vec2::ONE), ..Uniforms::new(model) }
}

/// A line of a chart: the error of some rows over time.
fn line(rows: &[Row], name: String, error: fn(&Row) -> &str, of: impl Fn(&Row) -> bool) -> Line {
    let mine: Vec<&Row> = rows.iter().filter(|row| of(row)).collect();
    let points: Series = mine.iter().map(|row| (number(&row.ms_median), number(error(row)))).collect();
    Line { name, points, ringed: mine.iter().position(|row| row.rule) }
}

fn outline_chart(rows: &[Row], machine: &Machine) -> anyhow::Result<String> {
    let sides = SIDES.iter().filter(|side| rows.iter().any(|row| row.side == **side));
    let of = |side: &u16| {
        let name = format!("{side}×{side} px");
        line(rows, name, |row| &row.outline_max, |row| row.side == *side && row.shader == SHADED[1])
    };
    lines(&Lines {
        name: "needs-outline",
        title: "A sphere's outline: how many triangles are enough; lower is better".into(),
        reading:
            "◯ the first with N ≥ π / acos(1 − e/R) segments for e = ½ px. To the right of it time is wasted."
                .into(),
        across: "ms a picture — slower →".into(),
        falling: false,
        error: &Quantity { name: "largest distance from the circle", unit: "px", limit: (0.5, "½ px") },
        lines: sides.map(of).collect(),
        caption: vec![dots(), machine.caption()],
    })
}

fn shading_chart(rows: &[Row], machine: &Machine) -> anyhow::Result<String> {
    let side = 400;
    let of = |shader: &str| {
        line(rows, shader.into(), |row| &row.shading_mean, |row| row.side == side && row.shader == shader)
    };
    lines(&Lines {
        name: "needs-shading",
        title: "A sphere's shading: how many triangles are enough; lower is better".into(),
        reading: format!(
            "◯ where the outline needs no more. Below the dashed line (½ level) no eye sees more. {side}×{side} px."
        ),
        across: "ms a picture — slower →".into(),
        falling: false,
        error: &Quantity {
            name: "mean difference from a smooth sphere",
            unit: "grey levels of 255",
            limit: (0.5, "½ level"),
        },
        lines: SHADED.iter().map(|shader| of(shader)).collect(),
        caption: vec![dots(), machine.caption()],
    })
}

fn dots() -> String {
    let segments: Vec<String> = SEGMENTS.iter().map(ToString::to_string).collect();
    format!("Dots from the left: spheres whose outline has {} segments.", segments.join(", "))
}

/// What shaders carry, as CSV and as Markdown: computed from their types.
fn carried() -> anyhow::Result<(Vec<u8>, String)> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut markdown =
        String::from("| shader | bytes a vertex | numbers interpolated for each pixel |\n|---|---:|---:|\n");
    writer.write_record(["shader", "bytes_per_vertex", "floats_per_fragment"])?;
    for shader in SHADERS {
        let needs = shader.run.needs;
        let share = |needed: bool, size: usize| if needed { size } else { 0 };
        let bytes =
            size_of::<Vec3>() + share(needs.normals, size_of::<Vec3>()) + share(needs.uvs, size_of::<Vec2>());
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
    fn what_a_shader_carries_is_what_its_row_promises() {
        let (_, markdown) = carried().unwrap();
        for row in ["| `flat` | 12 | 0 |", "| `gouraud` | 24 | 1 |", "| `gouraud-texture` | 32 | 3 |"] {
            assert!(markdown.contains(row), "{markdown}");
        }
    }
}
