//! No more than the scene needs: how many triangles the head takes, held against itself in very many.

use std::path::Path;

use common::file::write_whole;
use common::{Attributes, Method, Model};
use gouraud::corner_normals;
use serde::{Deserialize, Serialize};
use serde_json::json;
use shaders::{Framebuffer, SHADERS};

use super::digits::three_digits;
use super::draw::{Line, Lines, lines_in_each_layout};
use super::measure::Work;
use super::needs::{SHADED, coverage, drawing, front};
use super::scene::draw;
use super::table::{Series, number};
use super::{Comparison, Pictures, Run, caption};

pub(crate) const COMPARISON: Comparison = Comparison { name: "needs-head", works, measure, draw: pictures };

/// The side of the pictures.
const SIDE: u16 = 400;

/// Triangles of the bust.
const TRIANGLES: [usize; 7] = [350, 700, 1400, 2800, 5600, 11_200, 22_400];

/// Triangles of the bust that stands for the right one.
const FINEST: usize = 90_000;

/// A row of `needs-head.csv`.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Row {
    shader: String,
    triangles: usize,
    /// The area between the outline and the right one, over the length of that.
    outline_mean: String,
    /// The mean difference of what both show.
    shading_mean: String,
    ms_median: String,
}

/// The head with a bust of about so many triangles.
fn head(triangles: usize) -> Model {
    let text = assets::head::model_of(triangles).to_obj();
    Model::parse(text.as_bytes(), Attributes { normals: true, uvs: true }).expect("the head is a model")
}

/// Each shader drawing each head.
fn works(_: usize) -> anyhow::Result<Vec<Work>> {
    let models = TRIANGLES.map(|triangles| &*Box::leak(Box::new(head(triangles))));
    let work = |(model, shader): (&'static Model, &str)| drawing(shader, model, SIDE);
    Ok(models.into_iter().flat_map(|model| SHADED.map(|shader| (model, shader))).map(work).collect())
}

/// Measures the head.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let finest = head(FINEST);
    let render = |shader| Method::find(SHADERS, shader).expect("lesson 9 has it").run.generic;
    let normals = corner_normals(&finest);
    let seen = front(&finest, &normals);
    let (right, whole) = (draw(render("gouraud"), &seen, SIDE), coverage(&seen, SIDE));
    let speeds = run.speeds(COMPARISON.name, usize::from(SIDE), 1.0)?;
    let pairs = TRIANGLES.into_iter().flat_map(|triangles| SHADED.map(|shader| (triangles, shader)));
    let mut writer = csv::Writer::from_writer(Vec::new());
    for ((triangles, shader), speed) in pairs.zip(speeds) {
        let model = head(triangles);
        let normals = corner_normals(&model);
        let seen = front(&model, &normals);
        writer.serialize(Row {
            shader: shader.into(),
            triangles: model.faces().len(),
            outline_mean: three_digits(outline(&coverage(&seen, SIDE), &whole)),
            shading_mean: three_digits(shading(&draw(render(shader), &seen, SIDE), &right)),
            ms_median: three_digits(1000.0 / speed.median()),
        })?;
    }
    write_whole(&run.folder.join("needs-head.csv"), &writer.into_inner()?)?;
    run.write_facts("needs-head", json!({ "side": SIDE, "right": finest.faces().len() }))
}

/// The charts, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let mut reader = csv::Reader::from_path(folder.join("needs-head.csv"))?;
    let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>()?;
    let machine = caption(folder, "needs-head")?;
    let mut numbers: Vec<String> = rows.iter().map(|row| row.triangles.to_string()).collect();
    numbers.dedup();
    let caption = vec![format!("Dots from the left: {} triangles.", numbers.join(", ")), machine];
    let points = |shader: &str, error: fn(&Row) -> &str| -> Series {
        let mine = rows.iter().filter(|row| row.shader == shader);
        mine.map(|row| (number(&row.ms_median), number(error(row)))).collect()
    };
    let enough = |shader: &str, error: fn(&Row) -> &str| {
        let first = rows.iter().find(|row| row.shader == shader && number(error(row)) <= 0.5);
        first.map_or_else(
            || format!("more than {}", rows.last().map_or(0, |row| row.triangles)),
            |row| row.triangles.to_string(),
        )
    };
    let outline: fn(&Row) -> &str = |row| &row.outline_mean;
    let shading: fn(&Row) -> &str = |row| &row.shading_mean;
    let line = |(hue, name): (usize, &str), error| Line {
        name: name.into(),
        hue: Some(hue),
        points: points(name, error),
        ringed: None,
        does_it: true,
    };
    let reading = format!("The same head in some {FINEST} triangles is taken for right. {SIDE}×{SIDE} px.");
    let of_outline = Lines {
        name: "needs-head-outline",
        title: format!(
            "Half a pixel off on average, the head's outline takes {} triangles",
            enough("gouraud", outline)
        ),
        reading: reading.clone(),
        across: "ms a picture →".into(),
        falling: false,
        what: "mean distance from the outline",
        unit: "px",
        limit: Some((0.5, "½ px")),
        lines: vec![Line { name: "whatever the shading".into(), ..line((1, "gouraud"), outline) }],
        caption: caption.clone(),
    };
    let of_shading = Lines {
        name: "needs-head-shading",
        title: format!(
            "Half a level off on average, the head takes {} triangles by gouraud",
            enough("gouraud", shading)
        ),
        what: "mean difference from the finest head",
        unit: "grey levels of 255",
        limit: Some((0.5, "½ level")),
        lines: SHADED.into_iter().enumerate().map(|shader| line(shader, shading)).collect(),
        across: of_outline.across.clone(),
        reading,
        caption,
        ..of_outline
    };
    Ok([lines_in_each_layout(&of_outline)?, lines_in_each_layout(&of_shading)?].concat())
}

/// Whether something is drawn at a pixel; beside the picture is nothing.
fn covered(drawn: &Framebuffer, x: i32, y: i32) -> bool {
    drawn.depths.bounds().contains(x, y) && drawn.depths.get(x, y) > f32::NEG_INFINITY
}

/// The area between two outlines over the length of the right one, in px. Its length is the number of its pixels
/// with an empty neighbour.
fn outline(covered: &[bool], right: &[bool]) -> f64 {
    let side = usize::from(SIDE);
    let is_right = |x: usize, y: usize| x < side && y < side && right[y * side + x];
    let (mut area, mut length) = (0.0, 0.0);
    for (n, (got, exact)) in covered.iter().zip(right).enumerate() {
        let (x, y) = (n % side, n / side);
        area += f64::from(u8::from(got != exact));
        // To the left of column 0 is a column too large for the picture.
        let neighbours = [(x.wrapping_sub(1), y), (x + 1, y), (x, y.wrapping_sub(1)), (x, y + 1)];
        length += f64::from(u8::from(*exact && neighbours.iter().any(|&(x, y)| !is_right(x, y))));
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
