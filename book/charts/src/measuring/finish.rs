//! The finished picture: what each choice buys.
//!
//! Lesson 9's scene, looked at in one size. A choice is a shader, the size in which it is drawn, and how the shader
//! is called. Smaller pictures are enlarged by bilinear interpolation, a larger one is averaged down, and the time
//! for that counts for all alike. The picture that all should be has 16×16 samples a pixel, smooth normals and
//! perspective, in f64.

use std::path::Path;

use common::file::write_whole;
use common::{Image, Vec3};
use serde::{Deserialize, Serialize};
use serde_json::json;
use shaders::{Call, Draw, Look, METHODS, SHADERS};

use super::card::LAYOUTS;
use super::digits::three_digits;
use super::draw::{Dot, Speed, speed};
use super::finding::times;
use super::frontier::{Figure, close, frontier};
use super::measure::Work;
use super::models::scene_model;
use super::scene::{EYE, Subject, channels, draw, exact};
use super::speed::spread;
use super::table::{Quantity, number, numbers, spaced};
use super::{Comparison, Pictures, Run, caption};

pub(super) const COMPARISON: Comparison = Comparison { name: "finish", works, measure, draw: pictures };

/// The size in which pictures are looked at.
const SIDE: u16 = 800;

/// The sizes in which they are drawn.
const SIZES: [u16; 5] = [100, 200, 400, 800, 1600];

/// From the side, so that there is light and shadow.
const LIGHT: Vec3 = Vec3::new(0.5, 0.5, 0.707_106_77);

/// The shader whose picture all should be.
const LOOK: &str = "gouraud-texture";

/// A row of `finish.csv`.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Row {
    choice: String,
    shader: String,
    method: String,
    size: u16,
    rms: String,
    /// The same, over the pixels of the head alone: the ground around it is black in every picture.
    rms_object: String,
    flip: String,
    flip_object: String,
    ms_median: String,
    /// In each build.
    ms_builds: String,
    frontier_rms: bool,
    frontier_flip: bool,
}

/// A shader, how it is called, and the size in which it is drawn.
type Choice = (&'static common::Method<Look>, &'static common::Method<Call>, u16);

/// The choices that are compared.
fn choices() -> Vec<Choice> {
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
    choices
}

/// What is shown: a picture drawn in its size, in the size in which it is looked at.
fn shown(render: Draw, subject: &Subject, size: u16) -> Image {
    let image = draw(render, &subject.seen(LIGHT, EYE), size).image;
    match size {
        SIDE => image,
        ..SIDE => enlarged(&image, SIDE),
        _ => image.scale(SIDE, SIDE),
    }
}

/// A picture of `side`×`side` pixels, interpolated bilinearly between the centres of those that there are, with
/// weights of 8 bits.
fn enlarged(image: &Image, side: u16) -> Image {
    let [width, height, wide] = [image.width(), image.height(), side.into()].map(|length| length as usize);
    let channels = image.buffer().len() / (width * height);
    // What lies before a centre, and 256 times how far the centre is from that.
    let before = |n: usize, size: usize| {
        let at = ((2 * n + 1) * size * 128 / wide).saturating_sub(128).min((size - 1) * 256);
        (at / 256, at % 256)
    };
    let columns: Vec<(usize, usize, u16)> = (0..wide)
        .flat_map(|x| {
            let (left, part) = before(x, width);
            let right = (left + 1).min(width - 1);
            (0..channels).map(move |c| (left * channels + c, right * channels + c, part as u16))
        })
        .collect();
    // First along the rows, times 256, then between them.
    let rows: Vec<Vec<u16>> = image
        .buffer()
        .chunks_exact(width * channels)
        .map(|row| {
            let mix = |&(a, b, part): &(usize, usize, u16)| {
                u16::from(row[a]) * (256 - part) + u16::from(row[b]) * part
            };
            columns.iter().map(mix).collect()
        })
        .collect();
    let mut large = Image::new(side, side, image.format());
    for (y, row) in large.buffer_mut().chunks_exact_mut(wide * channels).enumerate() {
        let (low, part) = before(y, height);
        let (pair, part) = ([&rows[low], &rows[(low + 1).min(height - 1)]], part as u32);
        for (channel, (low, high)) in row.iter_mut().zip(pair[0].iter().zip(pair[1])) {
            *channel = ((u32::from(*low) * (256 - part) + u32::from(*high) * part + 0x8000) >> 16) as u8;
        }
    }
    large
}

fn works(_: usize) -> anyhow::Result<Vec<Work>> {
    let (_, model, texture) = scene_model()?;
    let subject = Subject::new(model, texture);
    let work = |(shader, method, size): Choice| {
        let (render, subject) = ((method.run)(&shader.run), subject.clone());
        Work::new(1.0, move || shown(render, &subject, size))
    };
    Ok(choices().into_iter().map(work).collect())
}

/// Measures the choices.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let (name, model, texture) = scene_model()?;
    let samples = if run.effort.quick { 4 } else { 16 };
    let expected = exact(model, Some(texture), LIGHT, EYE, (SIDE, samples));
    let object: Vec<bool> = expected.iter().map(|color| *color != [0.0; 3]).collect();
    let generic = METHODS.last().expect("lesson 9 has methods");
    let speeds = run.speeds(COMPARISON.name, usize::from(SIDE), 3.0)?;
    let subject = Subject::new(model, texture);
    let mut rows = Vec::new();
    for ((shader, method, size), found) in choices().into_iter().zip(speeds) {
        let image = shown((method.run)(&shader.run), &subject, size);
        let flips = flip(&image, &expected);
        let mean = |counts: &dyn Fn(usize) -> bool| {
            let counted =
                flips.iter().enumerate().filter(|(n, _)| counts(*n)).map(|(_, flip)| f64::from(*flip));
            counted.clone().sum::<f64>() / counted.count() as f64
        };
        let ms = |rate: f64| three_digits(1000.0 / rate);
        let called = if method.name == generic.name { String::new() } else { format!(" {}", method.name) };
        rows.push(Row {
            choice: format!("{} {size}{called}", shader.name),
            shader: shader.name.into(),
            method: method.name.into(),
            size,
            rms: three_digits(rms(&image, &expected, |_| true)),
            rms_object: three_digits(rms(&image, &expected, |n| object[n])),
            flip: three_digits(mean(&|_| true)),
            flip_object: three_digits(mean(&|n| object[n])),
            ms_median: ms(found.median()),
            ms_builds: spaced(found.builds.iter().map(|rate| ms(*rate))),
            frontier_rms: false,
            frontier_flip: false,
        });
    }
    let best_rms = frontier(&figures(&rows, |row| number(&row.rms_object)));
    let best_flip = frontier(&figures(&rows, |row| number(&row.flip_object)));
    for (row, best) in rows.iter_mut().zip(best_rms.into_iter().zip(best_flip)) {
        (row.frontier_rms, row.frontier_flip) = best;
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    write_whole(&run.folder.join("finish.csv"), &writer.into_inner()?)?;
    let facts = json!({
        "model": format!("{name} of {} triangles, shown in {SIDE}×{SIDE}", model.faces().len()),
        "reference": format!("{samples}×{samples} samples a pixel in f64"),
        "object_%": 100 * object.iter().filter(|is| **is).count() / object.len(),
        "light": LIGHT.to_array(),
        "eye": EYE.to_array(),
    });
    run.write_facts("finish", facts)
}

/// What decides about each choice, by this error.
fn figures(rows: &[Row], error: fn(&Row) -> f64) -> Vec<Figure> {
    rows.iter().map(|row| Figure { error: error(row), builds: rates(row), does_it: true }).collect()
}

/// Pictures a second, in each build.
fn rates(row: &Row) -> Vec<f64> {
    numbers(&row.ms_builds).into_iter().map(|ms| 1000.0 / ms).collect()
}

/// The charts, from the figures in a folder.
fn pictures(folder: &Path) -> anyhow::Result<Pictures> {
    let mut reader = csv::Reader::from_path(folder.join("finish.csv"))?;
    let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>()?;
    let facts: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join("finish.json"))?)?;
    let fact = |name: &str| facts[name].to_string().trim_matches('"').to_string();
    let captions = vec![
        format!("{}, against {}. Over the head's pixels, {} % of all.", fact("model"), fact("reference"), fact("object_%")),
        "A number is the size in which the picture is drawn; smaller ones are enlarged bilinearly, 1600 averages 2×2: \
         the time for it counts."
            .into(),
        caption(folder, "finish")?,
    ];
    let rms_axis =
        Quantity { name: "RMS difference", unit: "grey levels of 255", limit: (1.0, "within 1 level") };
    let flip_axis = Quantity { name: "mean of NVIDIA's FLIP", unit: "0 to 1", limit: (0.01, "within 0.01") };
    type Get<T> = fn(&Row) -> T;
    let charts: [(&str, &Quantity, Get<f64>, Get<bool>); 2] = [
        ("finish", &rms_axis, |row| number(&row.rms_object), |row| row.frontier_rms),
        ("finish-flip", &flip_axis, |row| number(&row.flip_object), |row| row.frontier_flip),
    ];
    let mut pictures = Vec::new();
    for (name, error, get, best) in charts {
        let close = close(&figures(&rows, get));
        let dot = |(row, close): (&Row, &bool)| Dot {
            name: row.choice.clone(),
            hue: hue(row),
            worst: three_digits(get(row)),
            mean: three_digits(get(row)),
            exact: true,
            speed: spread(&rates(row)),
            frontier: best(row),
            close: *close,
            does_it: true,
        };
        for layout in &LAYOUTS {
            let chart = Speed {
                name,
                title: finding(&rows, get, best),
                error,
                none: "exact",
                speed: "ms a picture".into(),
                times: true,
                dots: rows.iter().zip(&close).map(dot).collect(),
                caption: captions.clone(),
            };
            pictures.push((format!("{name}{}", layout.ending), speed(&chart, layout)?));
        }
    }
    Ok(pictures)
}

/// A colour for each shader, and one for what is called in another way.
fn hue(row: &Row) -> Option<usize> {
    let shader = SHADERS.iter().position(|shader| shader.name == row.shader);
    if row.method == METHODS.last()?.name { shader } else { Some(SHADERS.len()) }
}

/// What the next better picture costs, from the cheapest one on the frontier to the best.
fn finding(rows: &[Row], error: fn(&Row) -> f64, best: fn(&Row) -> bool) -> String {
    let mut best: Vec<&Row> = rows.iter().filter(|row| best(row)).collect();
    best.sort_by(|a, b| error(a).total_cmp(&error(b)));
    match best[..] {
        [finest, .., cheapest] => format!(
            "From {} to {}: {} less error for {} the time",
            cheapest.choice,
            finest.choice,
            times(error(cheapest) / error(finest)),
            times(number(&finest.ms_median) / number(&cheapest.ms_median))
        ),
        [only] => format!("{} beats all others", only.choice),
        [] => String::new(),
    }
}

/// The root of the mean squared difference of a channel, over the pixels that count.
pub(crate) fn rms(got: &Image, expected: &[[f64; 3]], counts: impl Fn(usize) -> bool) -> f64 {
    let pairs = channels(got).zip(expected).enumerate().filter(|(n, _)| counts(*n));
    let square =
        |(_, (a, b)): (usize, ([f64; 3], &[f64; 3]))| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>();
    let (sum, count) = pairs.map(square).fold((0.0, 0.0), |(sum, count), square| (sum + square, count + 3.0));
    (sum / f64::max(count, 1.0)).sqrt()
}

/// FLIP at each pixel, which weighs differences as an eye sees them that alternates between the two pictures
/// (P. Andersson and others, *FLIP: a difference evaluator for alternating images*, HPG 2020). 0 is none, 1 the
/// largest.
pub(crate) fn flip(got: &Image, expected: &[[f64; 3]]) -> Vec<f32> {
    let (width, height) = (got.width() as u32, got.height() as u32);
    let bytes: Vec<u8> = expected.iter().flatten().map(|channel| channel.round() as u8).collect();
    let [expected, got] =
        [&bytes[..], got.buffer()].map(|bytes| nv_flip::FlipImageRgb8::with_data(width, height, bytes));
    nv_flip::flip(expected, got, nv_flip::DEFAULT_PIXELS_PER_DEGREE).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::{Color, Format};

    #[test]
    fn equal_pictures_do_not_differ_and_others_do() {
        let mut image = Image::new(16, 16, Format::Rgb);
        image.buffer_mut().fill(100);
        let mean = |expected: &[[f64; 3]]| flip(&image, expected).iter().sum::<f32>() / 256.0;
        let equal = vec![[100.0; 3]; 256];
        assert_eq!((rms(&image, &equal, |_| true), mean(&equal)), (0.0, 0.0));
        let brighter = vec![[103.0, 100.0, 100.0]; 256];
        assert!((rms(&image, &brighter, |_| true) - 3f64.sqrt()).abs() < 1e-12);
        assert_eq!(rms(&image, &brighter, |_| false), 0.0);
        assert!(mean(&vec![[255.0; 3]; 256]) > 0.3);
    }

    #[test]
    fn what_is_enlarged_is_straight_between_centres() {
        let mut image = Image::new(2, 1, Format::Rgb);
        image.set(1, 0, Color::WHITE);
        let large = enlarged(&image, 8);
        let row: Vec<u8> = (0..8).map(|x| large.get(x, 3).unwrap().r).collect();
        // Centres of the two are at 2 and 6 of 8: what lies outside of them is theirs.
        assert_eq!(row, [0, 0, 32, 96, 159, 223, 255, 255]);
    }
}
