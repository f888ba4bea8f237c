//! What a map of normals buys: the head in few triangles with the normals of a fine shape, beside heads of more triangles.

use std::path::Path;

use clipping::mesh::indexed;
use clipping::{Cull, Mesh};
use common::file::write_whole;
use common::{Color, Format, Image, Mat4, Method};
use lighting::{LOOKS, Maps, PointLight, Scene};
use perspective::scene::Loaded;
use serde::{Deserialize, Serialize};
use serde_json::json;
use textures::Wrap;
use zbuffer::DepthBuffer;

use super::card::LAYOUTS;
use super::digits::three_digits;
use super::draw::{Dot, Speed, speed};
use super::finding::times;
use super::frontier::{Figure, close, frontier};
use super::measure::Work;
use super::models::scene_model;
use super::speed::spread;
use super::table::{Quantity, number, numbers, spaced};
use super::{Comparison, Pictures, Run, caption};
use crate::figures::shape::parsed;
use crate::lessons::lighting::figures::{ALL, SEEN, camera};

pub(super) const COMPARISON: Comparison =
    Comparison { name: "12-lighting-maps", works, measure, draw: pictures };

/// The side of the pictures.
const SIDE: u16 = 800;

/// Triangles of the bust that stands for the right one.
const FINEST: usize = 90_000;

/// A row of `12-lighting-maps.csv`.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Row {
    choice: String,
    triangles: usize,
    look: String,
    /// The mean difference to the finest head's picture, where both show something, of white heads: of the light alone.
    error_mean: String,
    /// The same of textured ones.
    textured_mean: String,
    ms_median: String,
    /// In each build.
    ms_builds: String,
    frontier: bool,
}

/// A head with its mesh and its maps, and how it is drawn.
struct Choice {
    loaded: Loaded,
    mesh: Mesh,
    maps: Maps,
    look: &'static str,
}

impl Choice {
    fn new(mesh: &assets::mesh::Mesh, texture: &Image, normals: Option<Image>) -> anyhow::Result<Self> {
        let loaded = Loaded::new(parsed(&mesh.to_obj())?, texture.clone(), Wrap::Clamp);
        let mesh = indexed(&loaded.model, &loaded.normals, ALL);
        let look = if normals.is_some() { "tangent-normals" } else { "plain" };
        let Maps { normals: flat, shine } = Maps::default();
        Ok(Self { loaded, mesh, maps: Maps { normals: normals.unwrap_or(flat), shine }, look })
    }

    /// The same in white.
    fn white(mut self) -> Self {
        self.loaded.texture = Image::new(1, 1, Format::Rgb);
        self.loaded.texture.set(0, 0, Color::WHITE);
        self
    }

    /// What it draws, and where.
    fn drawn(&self) -> anyhow::Result<(Image, DepthBuffer<f32>)> {
        let scene = Scene::placed(&self.loaded, Mat4::IDENTITY, camera(SEEN)?, SEEN.0, PointLight::default())
            .ok_or_else(|| anyhow::anyhow!("a head is not flat"))?;
        let look = Method::find(LOOKS, self.look).ok_or_else(|| anyhow::anyhow!("no look {}", self.look))?;
        let mut image = Image::new(SIDE, SIDE, Format::Rgb);
        let depths = (look.run.draw)(&scene, &self.maps, &self.mesh, Cull::Back, &mut image).depths;
        Ok((image, depths))
    }
}

/// Heads of more and more triangles, the two coarse ones without and with a map. The maps hold the normals of the fine shape
/// and no relief that is in no mesh, so that all heads are of one shape.
fn choices() -> anyhow::Result<Vec<Choice>> {
    let (_, _, texture) = scene_model()?;
    let fine = assets::head::fine_normals(0.0);
    let (low, usual) = (assets::head::low_model(), assets::head::model());
    Ok(vec![
        Choice::new(&low, texture, None)?,
        Choice::new(&low, texture, Some(assets::head::low_tangent_map(&fine)))?,
        Choice::new(&usual, texture, None)?,
        Choice::new(&usual, texture, Some(assets::head::tangent_map(&fine)))?,
        Choice::new(&assets::head::model_of(22_400), texture, None)?,
    ])
}

fn works(_: usize) -> anyhow::Result<Vec<Work>> {
    let work = |choice: Choice| Work::new(1.0, move || choice.drawn().map(|(image, _)| image.get(0, 0)));
    Ok(choices()?.into_iter().map(work).collect())
}

/// The mean difference of a channel, where both pictures show something.
fn apart((a, a_depths): &(Image, DepthBuffer<f32>), (b, b_depths): &(Image, DepthBuffer<f32>)) -> f64 {
    let (mut sum, mut count) = (0, 0);
    for (x, y, one) in a.pixels().filter(|&(x, y, _)| a_depths.get(x, y).max(b_depths.get(x, y)) < 1.0) {
        let Some(two) = b.get(x, y) else { continue };
        sum += [(one.r, two.r), (one.g, two.g), (one.b, two.b)]
            .map(|(one, two)| u32::from(one.abs_diff(two)))
            .iter()
            .sum::<u32>();
        count += 3;
    }
    f64::from(sum) / f64::from(count)
}

/// Measures the choices.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let (_, _, texture) = scene_model()?;
    let finest = Choice::new(&assets::head::model_of(FINEST), texture, None)?;
    let triangles = finest.loaded.model.triangles().len();
    let textured = finest.drawn()?;
    let white = finest.white().drawn()?;
    let speeds = run.speeds(COMPARISON.name, usize::from(SIDE), 1.0)?;
    let mut rows = Vec::new();
    for (choice, found) in choices()?.into_iter().zip(speeds) {
        let (triangles, look) = (choice.loaded.model.triangles().len(), choice.look);
        let ms = |rate: f64| three_digits(1000.0 / rate);
        let with = if look == "plain" { "" } else { "-map" };
        rows.push(Row {
            choice: format!("{triangles}{with}"),
            triangles,
            look: look.into(),
            textured_mean: three_digits(apart(&choice.drawn()?, &textured)),
            error_mean: three_digits(apart(&choice.white().drawn()?, &white)),
            ms_median: ms(found.median()),
            ms_builds: spaced(found.builds.iter().map(|rate| ms(*rate))),
            frontier: false,
        });
    }
    let best = frontier(&figures(&rows));
    rows.iter_mut().zip(best).for_each(|(row, best)| row.frontier = best);
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    write_whole(&run.folder.join(COMPARISON.name).with_extension("csv"), &writer.into_inner()?)?;
    run.write_facts(COMPARISON.name, json!({ "right": triangles, "side": SIDE }))
}

/// What decides about each choice.
fn figures(rows: &[Row]) -> Vec<Figure> {
    let figure = |row: &Row| Figure { error: number(&row.error_mean), builds: rates(row), does_it: true };
    rows.iter().map(figure).collect()
}

/// Pictures a second, in each build.
fn rates(row: &Row) -> Vec<f64> {
    numbers(&row.ms_builds).into_iter().map(|ms| 1000.0 / ms).collect()
}

/// The chart, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let mut reader = csv::Reader::from_path(folder.join(COMPARISON.name).with_extension("csv"))?;
    let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>()?;
    let error = Quantity {
        name: "mean difference of the light on a head of 90,000 triangles",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    };
    let close = close(&figures(&rows));
    let dot = |(row, close): (&Row, &bool)| Dot {
        name: row.choice.clone(),
        hue: Some(usize::from(row.look != "plain")),
        worst: row.error_mean.clone(),
        mean: row.error_mean.clone(),
        exact: true,
        speed: spread(&rates(row)),
        frontier: row.frontier,
        close: *close,
        does_it: true,
    };
    let mut pictures = Vec::new();
    for layout in &LAYOUTS {
        let chart = Speed {
            name: COMPARISON.name,
            title: finding(&rows),
            error: &error,
            none: "none",
            speed: "ms a picture".into(),
            times: true,
            dots: rows.iter().zip(&close).map(dot).collect(),
            caption: vec![
                format!(
                    "The head in so many triangles, {SIDE}×{SIDE} px, by blinn-phong; textured where it is timed. The maps hold the fine shape's normals."
                ),
                caption(folder, COMPARISON.name)?,
            ],
        };
        pictures.push((format!("{}{}", COMPARISON.name, layout.ending), speed(&chart, layout)?));
    }
    Ok(pictures)
}

/// What the map does to the head of fewest triangles.
fn finding(rows: &[Row]) -> String {
    let [plain, mapped, ..] = rows else { return String::new() };
    format!(
        "A map takes {} triangles from {} to {} levels, for {} the time",
        plain.triangles,
        plain.error_mean,
        mapped.error_mean,
        times(number(&mapped.ms_median) / number(&plain.ms_median))
    )
}
