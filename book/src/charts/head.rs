//! No more than the scene needs: how many triangles the head takes, held against itself in very many.

use std::path::Path;
use std::time::Duration;

use common::file::write_whole;
use common::{Attributes, Method, Model, Vec3};
use gouraud::corner_normals;
use serde::Serialize;
use shaders::{Framebuffer, SHADERS};

use super::draw::{Line, Lines, lines};
use super::figures::three_digits;
use super::machine::Machine;
use super::measure::{Effort, Work, alternate};
use super::needs::{SHADED, front};
use super::scene::draw;
use super::table::{Quantity, number};

/// The side of the pictures.
const SIDE: u16 = 400;

/// Triangles of the bust.
const TRIANGLES: [usize; 7] = [350, 700, 1400, 2800, 5600, 11_200, 22_400];

/// Triangles of the bust that stands for the right one.
const FINEST: usize = 90_000;

/// A row of `needs-head.csv`.
#[derive(Clone, Debug, Serialize)]
struct Row {
    shader: &'static str,
    triangles: usize,
    /// The area between the outline and the right one, over the length of that.
    outline_mean: String,
    /// The mean difference of what both cover.
    shading_mean: String,
    ms_median: String,
}

/// The head with a bust of about so many triangles.
fn head(triangles: usize) -> Model {
    let text = assets::head::model_of(triangles).to_obj();
    Model::parse(text.as_bytes(), Attributes { normals: true, uvs: true }).expect("the head is a model")
}

/// Measures the head and draws `needs-head-outline.svg` and `needs-head-shading.svg`.
pub(super) fn measure(effort: Effort, machine: &Machine, folder: &Path) -> anyhow::Result<()> {
    let finest = head(FINEST);
    let render = |shader| Method::find(SHADERS, shader).expect("lesson 9 has it").run.generic;
    let right = draw(render("gouraud"), &front(&finest, &corner_normals(&finest)), SIDE);
    let (mut rows, mut works) = (Vec::new(), Vec::new());
    for triangles in TRIANGLES {
        let model: &'static Model = Box::leak(Box::new(head(triangles)));
        let normals: &'static [[Vec3; 3]] = Vec::leak(corner_normals(model));
        for shader in SHADED {
            let seen = front(model, normals);
            let drawn = draw(render(shader), &seen, SIDE);
            rows.push(Row {
                shader,
                triangles: model.faces().len(),
                outline_mean: three_digits(outline(&drawn, &right)),
                shading_mean: three_digits(shading(&drawn, &right)),
                ms_median: String::new(),
            });
            works.push(Work::new(1.0, move || draw(render(shader), &seen, SIDE)));
        }
    }
    let found = alternate(&mut works, Duration::from_secs(12), effort);
    for (row, found) in rows.iter_mut().zip(found) {
        row.ms_median = three_digits(1000.0 / found.median);
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    write_whole(&folder.join("needs-head.csv"), &writer.into_inner()?)?;
    for (name, title, error, quantity) in OUTLINE_AND_SHADING {
        let line = |shader: &&str| {
            let mine = rows.iter().filter(|row| row.shader == *shader);
            let points = mine.map(|row| (number(&row.ms_median), number(error(row)))).collect();
            Line { name: (*shader).into(), points, ringed: None }
        };
        let triangles: Vec<String> =
            rows.iter().step_by(SHADED.len()).map(|row| row.triangles.to_string()).collect();
        let svg = lines(&Lines {
            name,
            title: (*title).into(),
            reading: format!(
                "The same head in {} triangles is taken for right. {SIDE}×{SIDE} px.",
                finest.faces().len()
            ),
            across: "ms a picture — slower →".into(),
            falling: false,
            error: quantity,
            lines: SHADED.iter().map(line).collect(),
            caption: vec![
                format!("Dots from the left: {} triangles.", triangles.join(", ")),
                machine.caption(),
            ],
        })?;
        write_whole(&folder.join(name).with_extension("svg"), svg.as_bytes())?;
    }
    Ok(())
}

/// One of a row's errors.
type Error = fn(&Row) -> &str;

/// Name and title of the two charts, the error that each shows, and in what it is measured.
const OUTLINE_AND_SHADING: &[(&str, &str, Error, Quantity)] = &[
    (
        "needs-head-outline",
        "The head's outline: how many triangles are enough; lower is better",
        |row| &row.outline_mean,
        Quantity { name: "mean distance from the outline", unit: "px", limit: (0.5, "½ px") },
    ),
    (
        "needs-head-shading",
        "The head's shading: how many triangles are enough; lower is better",
        |row| &row.shading_mean,
        Quantity {
            name: "mean difference from the finest head",
            unit: "grey levels of 255",
            limit: (0.5, "½ level"),
        },
    ),
];

/// Whether something is drawn at a pixel; beside the picture is nothing.
fn covered(drawn: &Framebuffer, x: i32, y: i32) -> bool {
    drawn.depths.bounds().contains(x, y) && drawn.depths.get(x, y) > f32::NEG_INFINITY
}

/// The area between two outlines over the length of the right one, in px. Its length is the number of its pixels
/// with an empty neighbour.
fn outline(drawn: &Framebuffer, right: &Framebuffer) -> f64 {
    let (mut area, mut length) = (0.0, 0.0);
    for (x, y, _) in right.image.pixels() {
        area += f64::from(u8::from(covered(drawn, x, y) != covered(right, x, y)));
        let neighbours = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
        let border = covered(right, x, y) && neighbours.iter().any(|&(x, y)| !covered(right, x, y));
        length += f64::from(u8::from(border));
    }
    area / f64::max(length, 1.0)
}

/// The mean difference of what both cover, in grey levels.
fn shading(drawn: &Framebuffer, right: &Framebuffer) -> f64 {
    let both = drawn.image.pixels().zip(right.image.pixels());
    let both = both.filter(|((x, y, _), _)| covered(drawn, *x, *y) && covered(right, *x, *y));
    let (sum, count) = both.fold((0.0, 0.0), |(sum, count), (got, exact)| {
        (sum + (f64::from(got.2.r) - f64::from(exact.2.r)).abs(), count + 1.0)
    });
    sum / f64::max(count, 1.0)
}
