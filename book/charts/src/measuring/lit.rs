//! What lesson 12's ways to compute cost in a whole picture, and single figures of its chapter.

use clipping::Cull;
use clipping::mesh::indexed;
use common::file::write_whole;
use common::{Format, Image, Mat4};
use lighting::{Draw, LOOKS, METHODS, NORMALISATIONS, POWERS, PointLight, Scene};
use perspective::scene::Loaded;
use textures::Wrap;

use super::digits::three_digits;
use super::measure::Work;
use super::models::scene_model;
use super::{Comparison, Run};
use crate::lessons::lighting::figures::{ALL, SEEN, best_ratio, camera, maps_of, stretched_pictures};

pub(super) const COMPARISON: Comparison =
    Comparison { name: "12-lighting-pictures", works, measure, draw: |_| Ok(Vec::new()) };

/// The side of the picture.
const SIDE: u16 = 800;

/// All that draws in one of the lesson's ways, but for the looks.
fn draws() -> impl Iterator<Item = (&'static str, Draw)> {
    let methods = METHODS.iter().map(|row| (row.name, row.run));
    let roots = NORMALISATIONS.iter().map(|row| (row.name, row.run.draw));
    let powers = POWERS.iter().map(|row| (row.name, row.run.draw));
    methods.chain(roots).chain(powers)
}

/// The lesson's picture.
fn works(_: usize) -> anyhow::Result<Vec<Work>> {
    let (_, model, texture) = scene_model()?;
    let head: &Loaded = Box::leak(Box::new(Loaded::new(model.clone(), texture.clone(), Wrap::Clamp)));
    let mesh = indexed(&head.model, &head.normals, ALL);
    let camera = camera(SEEN)?;
    let scene = Scene::placed(head, Mat4::IDENTITY, camera, SEEN.0, PointLight::default());
    let scene = scene.ok_or_else(|| anyhow::anyhow!("the head is not flat"))?;
    let image = Image::new(SIDE, SIDE, Format::Rgb);
    let mut works: Vec<Work> = draws()
        .map(|(_, draw)| {
            let (mesh, mut image) = (mesh.clone(), image.clone());
            Work::new(1.0, move || draw(&scene, &mesh, Cull::Back, &mut image).counts)
        })
        .collect();
    for row in LOOKS {
        let (mesh, mut image, maps) = (mesh.clone(), image.clone(), maps_of(row.name)?);
        works.push(Work::new(1.0, move || {
            (row.run.draw)(&scene, &maps, &mesh, Cull::Back, &mut image).counts
        }));
    }
    Ok(works)
}

/// How far two pictures of a thing on black are apart, in levels of a channel: at worst, and in the mean over its pixels.
fn apart(a: &Image, b: &Image) -> [f64; 2] {
    let (mut largest, mut sum, mut count) = (0, 0, 0);
    for (x, y, color) in a.pixels() {
        let Some(other) = b.get(x, y) else { continue };
        let [one, two] = [color, other].map(|color| [color.r, color.g, color.b]);
        if one.iter().chain(&two).all(|&channel| channel == 0) {
            continue;
        }
        for (one, two) in one.into_iter().zip(two) {
            largest = largest.max(one.abs_diff(two));
            sum += u32::from(one.abs_diff(two));
            count += 1;
        }
    }
    [f64::from(largest), f64::from(sum) / f64::from(count)]
}

/// Measures, and writes both tables.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let speeds = run.speeds(COMPARISON.name, usize::from(SIDE), 1.0)?;
    let names = draws().map(|(name, _)| name).chain(LOOKS.iter().map(|row| row.name));
    let pictures =
        names.zip(speeds).map(|(name, speed)| [name.into(), three_digits(1000.0 / speed.median())]);
    write(run, COMPARISON.name, ["method", "ms"], pictures)?;

    let ratios = [0.0_f32, 30.0, 60.0, 90.0].map(|degrees| {
        [format!("ratio_at_{degrees}°"), format!("{:.2}", best_ratio(32.0, degrees.to_radians()))]
    });
    let [wrong, right] = stretched_pictures(450)?;
    let [largest, mean] = apart(&wrong, &right);
    let stretched =
        [["M_alone_max".into(), format!("{largest:.0}")], ["M_alone_mean".into(), format!("{mean:.1}")]];
    write(run, "12-lighting-figures", ["what", "number"], ratios.into_iter().chain(stretched))
}

fn write(
    run: &Run,
    name: &str,
    columns: [&str; 2],
    rows: impl IntoIterator<Item = [String; 2]>,
) -> anyhow::Result<()> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns)?;
    for row in rows {
        writer.write_record(row)?;
    }
    Ok(write_whole(&run.folder.join(name).with_extension("csv"), &writer.into_inner()?)?)
}
