//! The finished picture: what each choice buys.
//!
//! Lesson 9's scene, looked at in one size. A choice is a shader, the size in which it is drawn (smaller ones are
//! enlarged, a larger one is averaged down), and how the shader is called. The picture that all should be has
//! 16×16 samples a pixel, smooth normals and perspective, in f64.

use std::path::Path;
use std::time::Duration;

use common::file::write_whole;
use common::{Image, Vec3};
use serde::Serialize;
use serde_json::json;
use shaders::{Draw, METHODS, SHADERS};

use super::draw::{Dot, Speed, speed};
use super::figures::three_digits;
use super::frontier::frontier;
use super::machine::Machine;
use super::measure::{Effort, Throughput, Work, alternate};
use super::models::scene_model;
use super::scene::{EYE, Subject, channels, draw, exact};
use super::table::{Quantity, number};

/// The size in which pictures are looked at.
const SIDE: u16 = 800;

/// The sizes in which they are drawn.
const SIZES: [u16; 5] = [100, 200, 400, 800, 1600];

/// From the side, so that there is light and shadow.
const LIGHT: Vec3 = Vec3::new(0.5, 0.5, 0.707_106_77);

/// The shader whose picture all should be.
const LOOK: &str = "gouraud-texture";

/// A row of `finish.csv`.
#[derive(Clone, Debug, Serialize)]
struct Row {
    choice: String,
    shader: &'static str,
    method: &'static str,
    size: u16,
    rms: String,
    flip: String,
    ms_median: String,
    ms_p25: String,
    ms_p75: String,
    frontier_rms: bool,
    frontier_flip: bool,
}

/// Measures the choices and draws `finish.svg` and `finish-flip.svg`.
pub(crate) fn measure(effort: Effort, machine: &Machine, folder: &Path) -> anyhow::Result<()> {
    let (name, model, texture) = scene_model()?;
    let samples = if effort.quick { 4 } else { 16 };
    let expected = exact(model, Some(texture), LIGHT, EYE, |intensity| intensity, (SIDE, samples));

    let generic = METHODS.last().expect("lesson 9 has methods");
    let mut choices = Vec::new();
    for shader in SHADERS {
        // Without a texture no size helps: one shows how much is missing.
        let sizes = SIZES.iter().filter(|&&size| size == SIDE || shader.run.needs.uvs);
        choices.extend(sizes.map(|&size| (shader, generic, size)));
    }
    let looks = SHADERS.iter().filter(|shader| shader.name == LOOK);
    let others = METHODS.iter().filter(|method| method.name != generic.name);
    choices.extend(looks.flat_map(|look| others.clone().map(move |method| (look, method, SIDE))));

    let subject: &'static Subject = Box::leak(Box::new(Subject::new(model, texture)));
    let drawn = move |render: Draw, size: u16| draw(render, &subject.seen(LIGHT, EYE), size).image;
    let shown = move |render: Draw, size: u16| {
        let image = drawn(render, size);
        if size == SIDE { image } else { image.scale(SIDE, SIDE) }
    };
    let mut works = Vec::new();
    let mut differences = Vec::new();
    for (shader, method, size) in &choices {
        let (render, size) = ((method.run)(&shader.run), *size);
        let image = shown(render, size);
        differences.push((rms(&image, &expected), flip(&image, &expected)));
        works.push(if size > SIDE {
            // Averaging is part of this choice; enlarging is left to whoever shows the picture.
            Work::new(1.0, move || shown(render, size))
        } else {
            Work::new(1.0, move || drawn(render, size))
        });
    }
    let found = alternate(&mut works, Duration::from_secs(30), effort);

    let ms = |rate: f64| three_digits(1000.0 / rate);
    let mut rows: Vec<Row> = choices
        .iter()
        .zip(differences.iter().zip(&found))
        .map(|((shader, method, size), ((rms, flip), found))| Row {
            choice: if method.name == generic.name {
                format!("{} {size}", shader.name)
            } else {
                format!("{} {size} {}", shader.name, method.name)
            },
            shader: shader.name,
            method: method.name,
            size: *size,
            rms: three_digits(*rms),
            flip: three_digits(*flip),
            ms_median: ms(found.median),
            ms_p25: ms(found.p75),
            ms_p75: ms(found.p25),
            frontier_rms: false,
            frontier_flip: false,
        })
        .collect();
    let best = |error: fn(&Row) -> &str| {
        let figures: Vec<(f64, f64)> =
            rows.iter().map(|row| (number(error(row)), 1.0 / number(&row.ms_median))).collect();
        frontier(&figures)
    };
    let (best_rms, best_flip) = (best(|row| &row.rms), best(|row| &row.flip));
    for (row, best) in rows.iter_mut().zip(best_rms.into_iter().zip(best_flip)) {
        (row.frontier_rms, row.frontier_flip) = best;
    }

    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    write_whole(&folder.join("finish.csv"), &writer.into_inner()?)?;
    let told = format!("{name} of {} triangles, shown in {SIDE}×{SIDE}", model.faces().len());
    let captions = vec![
        format!("Against {samples}×{samples} samples a pixel in f64: {told}."),
        "A number is the size in which the picture is drawn; smaller ones are enlarged, 1600 averages 2×2."
            .into(),
        machine.caption(),
    ];
    let rms_axis = Quantity { name: "RMS difference", unit: "grey levels of 255", limit: (1.0, "1 level") };
    let flip_axis = Quantity { name: "mean of NVIDIA's FLIP", unit: "0 to 1", limit: (0.01, "0.01") };
    type Get<T> = fn(&Row) -> T;
    let charts: [(&str, &Quantity, Get<f64>, Get<bool>); 2] = [
        ("finish", &rms_axis, |row| number(&row.rms), |row| row.frontier_rms),
        ("finish-flip", &flip_axis, |row| number(&row.flip), |row| row.frontier_flip),
    ];
    for (name, error, get, best) in charts {
        let dot = |row: &Row| Dot {
            name: row.choice.clone(),
            worst: get(row),
            mean: get(row),
            speed: [&row.ms_p75, &row.ms_median, &row.ms_p25].map(|text| 1000.0 / number(text)),
            frontier: best(row),
        };
        let chart = speed(&Speed {
            name,
            title: "The finished picture, what each choice buys".into(),
            error,
            speed: "ms a picture".into(),
            times: true,
            dots: rows.iter().map(dot).collect(),
            caption: captions.clone(),
        })?;
        write_whole(&folder.join(format!("{name}.svg")), chart.as_bytes())?;
    }
    let facts = json!({
        "machine": machine,
        "quick": effort.quick,
        "model": told,
        "reference": format!("{samples}×{samples} samples a pixel, f64"),
        "light": LIGHT.to_array(),
        "eye": EYE.to_array(),
        "rounds": found.iter().map(|found: &Throughput| found.rounds).max(),
    });
    write_whole(&folder.join("finish.json"), format!("{facts:#}\n").as_bytes())?;
    Ok(())
}

/// The root of the mean squared difference of a channel.
fn rms(got: &Image, expected: &[[f64; 3]]) -> f64 {
    let squares =
        channels(got).zip(expected).map(|(a, b)| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>());
    (squares.sum::<f64>() / (3 * expected.len()) as f64).sqrt()
}

/// The mean of FLIP, which weighs differences as an eye sees them that alternates between the two pictures
/// (P. Andersson and others, *FLIP: a difference evaluator for alternating images*, HPG 2020). 0 is none, 1 the
/// largest.
fn flip(got: &Image, expected: &[[f64; 3]]) -> f64 {
    let (width, height) = (got.width() as u32, got.height() as u32);
    let bytes: Vec<u8> = expected.iter().flatten().map(|channel| channel.round() as u8).collect();
    let [expected, got] =
        [&bytes[..], got.buffer()].map(|bytes| nv_flip::FlipImageRgb8::with_data(width, height, bytes));
    let map = nv_flip::flip(expected, got, nv_flip::DEFAULT_PIXELS_PER_DEGREE);
    f64::from(nv_flip::FlipPool::from_image(&map).mean())
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Format;

    #[test]
    fn equal_pictures_do_not_differ_and_others_do() {
        let mut image = Image::new(16, 16, Format::Rgb);
        image.buffer_mut().fill(100);
        let equal = vec![[100.0; 3]; 256];
        assert_eq!((rms(&image, &equal), flip(&image, &equal)), (0.0, 0.0));
        let brighter = vec![[103.0, 100.0, 100.0]; 256];
        assert!((rms(&image, &brighter) - 3f64.sqrt()).abs() < 1e-12);
        assert!(flip(&image, &vec![[255.0; 3]; 256]) > 0.3);
    }
}
