//! Lesson 15: the share of a pixel that a triangle covers, and what becomes of its samples.

use std::f32::consts::TAU;
use std::fmt::Write;

use antialiasing::resolve::Resolve;
use antialiasing::scene::World;
use antialiasing::{Draw, METHODS, RESOLVES, STORAGES, Scene};
use blending::scene::{Entity, View};
use checks::area::area;
use checks::box_filter;
use checks::footprint::{code, light};
use clipping::Cull;
use common::{Color, Format, Image, Mat4, Method, Vec2, Vec3};
use fastrand::Rng;
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use lighting::PointLight;
use perspective::scene::Loaded;
use zbuffer::Surface;

use super::figures::{GROUND, flat, wheel};
use crate::figures::picture::method;
use crate::figures::shape::parsed;
use crate::measuring::finish::{flip, rms};
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::texture;
use crate::measuring::scene::channels;
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

/// Sides of the triangles that are timed, in pixels.
const SIDES: Sizes =
    Sizes { name: "pixels of a triangle's side", all: &[2, 4, 8, 16, 32, 64, 256], usual: 16 };

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "15-antialiasing",
    job: "Lesson 15, drawing an edge across pixels",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "RMS difference of the pixels that a side runs through",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &["flip", "mesh"],
    samples: "random white triangles, each alone on black, 32×32 px",
    exhaustive: false,
    proved: &[],
    errors: method_errors,
    timed: "a textured, lit square in right triangles with two sides of 16 px, aslant in 512×512 px",
    throughput: "Mpx/s",
    work: |size, _| drawing(METHODS, size),
    sizes: SIDES,
    stability: Stability {
        stress: "width of a long triangle's base, px",
        falling: true,
        error: Quantity {
            name: "RMS difference",
            unit: "times what should be seen",
            limit: (0.5, "half of it"),
        },
        measure: method_stability,
    },
    // Exact for a shape alone; in a mesh the ground shines through.
    wrong: &["area"],
    advice: &[
        ("msaa-16", "pictures that are looked at for long"),
        ("msaa-4", "pictures that move: most of what 16 samples do, for less"),
        ("msaa-8", "in between"),
        ("ssaa-16", "where textures and highlights are to be smooth, too"),
        ("msaa-2", "where one grey more is all that there is time for"),
        ("none", "where pixels are to be seen"),
    ],
};

pub(crate) const RESOLVES_CHART: Chart = Chart {
    name: "15-antialiasing-resolves",
    job: "Lesson 15, making one colour of several",
    methods: || RESOLVES.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference from the mean of the light",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "16 samples of two random colours, each as often as chance will have it",
    exhaustive: false,
    proved: &[],
    errors: resolve_errors,
    timed: "512×512 pixels of 16 samples of two colours",
    throughput: "Mpx/s",
    work: |samples, effort| resolve_work(samples, effort),
    sizes: Sizes { name: "samples a pixel", all: &[2, 4, 8, 16], usual: 16 },
    stability: Stability {
        stress: "difference of two codes about 128",
        falling: false,
        error: Quantity { name: "difference", unit: "grey levels of 255", limit: (1.0, "1 grey level") },
        measure: resolve_stability,
    },
    wrong: &[],
    advice: &[
        ("linear", "always, if light is what counts"),
        ("encoded", "numbers that are no colours, and where all the rest computes with codes"),
    ],
};

pub(crate) const STORAGES_CHART: Chart = Chart {
    name: "15-antialiasing-storages",
    job: "Lesson 15, keeping the colours of samples",
    methods: || STORAGES.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference from a colour for each sample",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "wheels of random triangles and colours, 32×32 px",
    exhaustive: false,
    // By the tests, too: neither changes what a sample's colour is.
    proved: &["samples", "compressed"],
    errors: storage_errors,
    timed: METHODS_CHART.timed,
    throughput: METHODS_CHART.throughput,
    work: |size, _| drawing(STORAGES, size),
    sizes: SIDES,
    stability: Stability {
        stress: "triangles of a wheel in 32×32 px",
        falling: false,
        error: Quantity { name: "difference", unit: "grey levels of 255", limit: (0.5, "½ grey level") },
        measure: storage_stability,
    },
    wrong: &[],
    advice: &[
        ("compressed", "triangles of ten pixels and more"),
        ("samples", "smaller ones, where nearly each pixel has a side in it"),
    ],
};

/// The sides of the pictures that errors are measured in.
const SMALL: i32 = 32;

/// A small picture of triangles in the window.
fn picture(draw: &Draw, surfaces: &[Surface], background: Color) -> Image {
    let mut image = Image::new(SMALL as u16, SMALL as u16, Format::Rgb);
    (draw.picture)(&Scene::of(surfaces, background), &mut image);
    image
}

fn somewhere(random: &mut Rng) -> Vec2 {
    // Some of it outside of the picture.
    Vec2::new(random.f32(), random.f32()) * 48.0 - 8.0
}

/// The share of each pixel that a triangle covers.
fn shares(corners: [Vec2; 3]) -> Vec<f64> {
    (0..SMALL * SMALL).map(|n| area(corners, n % SMALL, n / SMALL)).collect()
}

/// What white on black of these shares shows.
fn white(shares: &[f64]) -> Vec<[f64; 3]> {
    shares.iter().map(|share| [255.0 * share; 3]).collect()
}

/// A gray wheel of triangles with common sides somewhere on a bright ground.
fn random_wheel(random: &mut Rng) -> Vec<Surface> {
    let middle = Vec2::new(random.f32(), random.f32()) * 8.0 + 12.0;
    let spokes = wheel(middle, 11.0, (random.u32(5..9), 1.0), Color::gray(random.f32() / 2.0));
    let turn = Vec2::from_angle(random.f32() * TAU);
    let turned = |corner: Vec3| (turn.rotate(corner.truncate() - middle) + middle).extend(corner.z);
    spokes
        .into_iter()
        .map(|Surface { corners, color }| Surface { corners: corners.map(turned), color })
        .collect()
}

fn channels_of(Color { r, g, b, .. }: Color) -> [f64; 3] {
    [r, g, b].map(f64::from)
}

/// What should be seen of a wheel.
fn exact(wheel: &[Surface]) -> Vec<[f64; 3]> {
    let surfaces: Vec<box_filter::Surface> = wheel
        .iter()
        .map(|&Surface { corners, color }| box_filter::Surface { corners, color: channels_of(color) })
        .collect();
    box_filter::picture(&surfaces, channels_of(GROUND), SMALL, SMALL)
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), METHODS_CHART.further.len());
    for _ in 0..effort.samples(2000) {
        let corners = [(); 3].map(|()| somewhere(&mut random));
        let shares = shares(corners);
        let border = |n: usize| 0.0 < shares[n] && shares[n] < 1.0;
        let crossed = (0..shares.len()).filter(|&n| border(n)).count();
        if crossed == 0 {
            continue;
        }
        let expected = white(&shares);
        let wheel = random_wheel(&mut random);
        let of_wheel = exact(&wheel);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let got = picture(&method.run, &[flat(corners, Color::WHITE)], Color::BLACK);
            let flips = flip(&got, &expected);
            let seen: f32 = (0..shares.len()).filter(|&n| border(n)).map(|n| flips[n]).sum();
            let mesh = rms(&picture(&method.run, &wheel, GROUND), &of_wheel, |_| true);
            let wrong = rms(&got, &expected, border);
            errors.add(wrong, wrong, &[f64::from(seen) / crossed as f64, mesh]);
        }
    }
    errors
}

fn method_stability(effort: Effort) -> Vec<Series> {
    let mut random = effort.random();
    let mut series = vec![Series::new(); METHODS.len()];
    for power in -2..=6 {
        let width = 2_f32.powi(-power);
        let triangles = effort.samples(400);
        let mut sums = vec![0.0; METHODS.len()];
        for _ in 0..triangles {
            let along = Vec2::from_angle(random.f32() * TAU);
            let tip = Vec2::splat(16.0) + Vec2::new(random.f32(), random.f32()) - 13.0 * along;
            let base = tip + 26.0 * along;
            let corners = [tip, base - along.perp() * width / 2.0, base + along.perp() * width / 2.0];
            let shares = shares(corners);
            let touched = |n: usize| shares[n] > 0.0;
            let expected = white(&shares);
            let nothing = Image::new(SMALL as u16, SMALL as u16, Format::Rgb);
            let whole = rms(&nothing, &expected, touched);
            for (method, sum) in METHODS.iter().zip(&mut sums) {
                let got = picture(&method.run, &[flat(corners, Color::WHITE)], Color::BLACK);
                *sum += rms(&got, &expected, touched) / whole;
            }
        }
        let add = |(line, sum): (&mut Series, &f64)| line.push((width.into(), sum / triangles as f64));
        series.iter_mut().zip(&sums).for_each(add);
    }
    series
}

/// A square of right triangles, so many along its side.
fn sheet(cells: usize) -> String {
    let mut text = String::from("vn 0 0 1\n");
    let at = |n: usize| n as f32 / cells as f32;
    for (x, y) in (0..=cells).flat_map(|y| (0..=cells).map(move |x| (at(x), at(y)))) {
        let _ = writeln!(text, "v {} {} 0\nvt {x} {y}", 2.0 * x - 1.0, 2.0 * y - 1.0);
    }
    for (x, y) in (0..cells).flat_map(|y| (0..cells).map(move |x| (x, y))) {
        let corner = |dx: usize, dy: usize| {
            let n = (y + dy) * (cells + 1) + x + dx + 1;
            format!("{n}/{n}/1")
        };
        let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
        let _ = writeln!(text, "f {a} {b} {d}\nf {b} {c} {d}");
    }
    text
}

/// The square of such triangles, turned a little, drawn in each of these ways to samples that are kept.
fn drawing(ways: &'static [Method<Draw>], side: usize) -> Vec<Work> {
    const PICTURE: u16 = 512;
    /// The side of the square, in pixels.
    const SQUARE: usize = 256;
    let model = parsed(&sheet(SQUARE / side)).expect("the square is a model");
    let mipmap = *method(MIPMAPS, "box-linear").expect("lesson 13 has it");
    let loaded = Loaded::new(model, texture(), textures::Wrap::Clamp);
    let to_world = Mat4::from_rotation_z(0.35) * Mat4::from_scale(Vec3::new(0.5, 0.5, 1.0));
    let model = Box::leak(Box::new(Filterable::new(loaded, mipmap, Wrap::Clamp)));
    let entities = Box::leak(Box::new([Entity { model, to_world, alpha: 1.0 }]));
    let view = View { to_clip: Mat4::IDENTITY, eye: Vec3::Z * 3.0, light: PointLight::default() };
    let world = Some(World { entities, view, cull: Cull::Back });
    let scene = Scene { world, ..Scene::of(&[], Color::BLACK) };
    let work = |way: &Method<Draw>| {
        let mut image = Image::new(PICTURE, PICTURE, Format::Rgb);
        let mut frames = (way.run.frames)([PICTURE.into(); 2]);
        Work::new((SQUARE * SQUARE) as f64, move || frames(&scene, &mut image))
    };
    ways.iter().map(work).collect()
}

fn any_color(random: &mut Rng) -> Color {
    Color::rgb(random.u8(..), random.u8(..), random.u8(..))
}

/// How far a pixel is from the mean of its samples' light: at most, and in the mean of its channels.
fn off(resolve: Resolve, samples: &[Color]) -> [f64; 2] {
    let got = channels_of(resolve(samples));
    let mean = |channel: usize| {
        let light: f64 = samples.iter().map(|&color| light(channels_of(color)[channel])).sum();
        code(light / samples.len() as f64)
    };
    let off = [0, 1, 2].map(|channel| (got[channel] - mean(channel)).abs());
    [off.into_iter().fold(0.0, f64::max), off.iter().sum::<f64>() / 3.0]
}

fn resolve_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(RESOLVES.len(), 0);
    for _ in 0..effort.samples(20_000) {
        let samples = two_colors(&mut random, 16);
        for (method, errors) in RESOLVES.iter().zip(&mut errors) {
            let [largest, mean] = off(method.run, &samples);
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

/// Samples of two colours, each as often as chance has it.
fn two_colors(random: &mut Rng, samples: usize) -> Vec<Color> {
    let colors = [any_color(random), any_color(random)];
    let share = random.f64();
    (0..samples).map(|_| colors[usize::from(random.f64() < share)]).collect()
}

fn resolve_stability(_: Effort) -> Vec<Series> {
    let apart = [2, 4, 8, 16, 32, 64, 128, 192, 254];
    let at = |resolve: Resolve, apart: u8| {
        let samples = [128 - apart / 2, 128 + (apart / 2).min(127)].map(|code| Color::rgb(code, code, code));
        (f64::from(apart), off(resolve, &samples)[0])
    };
    RESOLVES.iter().map(|method| apart.map(|apart| at(method.run, apart)).to_vec()).collect()
}

fn resolve_work(samples: usize, effort: Effort) -> Vec<Work> {
    const PIXELS: usize = 512 * 512;
    let mut random = effort.random();
    let colors: &'static [Color] =
        Vec::leak((0..PIXELS).flat_map(|_| two_colors(&mut random, samples)).collect());
    let work = |method: &Method<Resolve>| {
        let (resolve, mut resolved) = (method.run, vec![Color::BLACK; PIXELS]);
        Work::new(PIXELS as f64, move || {
            for (pixel, samples) in resolved.iter_mut().zip(colors.chunks_exact(samples)) {
                *pixel = resolve(samples);
            }
            resolved[0]
        })
    };
    RESOLVES.iter().map(work).collect()
}

/// What each way to keep colours draws of a wheel, held against the first.
fn storages_apart(wheel: &[Surface], background: Color) -> Vec<[f64; 2]> {
    let pictures: Vec<Image> =
        STORAGES.iter().map(|method| picture(&method.run, wheel, background)).collect();
    let apart = |got: &Image| {
        let off = || {
            let pairs = channels(got).zip(channels(&pictures[0]));
            pairs.flat_map(|(a, b)| [0, 1, 2].map(|channel| (a[channel] - b[channel]).abs()))
        };
        [off().fold(0.0, f64::max), off().sum::<f64>() / f64::from(3 * SMALL * SMALL)]
    };
    pictures.iter().map(apart).collect()
}

/// Triangles about a place, each of a colour and an alpha by chance, some over others.
fn colored(random: &mut Rng, count: u32) -> Vec<Surface> {
    let mut spokes = wheel(Vec2::new(15.3, 16.8), 14.0, (count, 1.7), Color::BLACK);
    for spoke in &mut spokes {
        spoke.color = Color { a: [96, 255][random.usize(..2)], ..any_color(random) };
        spoke.corners.iter_mut().for_each(|corner| corner.z = random.f32());
    }
    spokes
}

fn storage_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(STORAGES.len(), 0);
    for _ in 0..effort.samples(2000) {
        let count = random.u32(3..60);
        let wheel = colored(&mut random, count);
        for ([largest, mean], errors) in
            storages_apart(&wheel, any_color(&mut random)).into_iter().zip(&mut errors)
        {
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

fn storage_stability(effort: Effort) -> Vec<Series> {
    let mut random = effort.random();
    let mut series = vec![Series::new(); STORAGES.len()];
    for count in [3, 10, 30, 100, 300] {
        let apart = storages_apart(&colored(&mut random, count), any_color(&mut random));
        series.iter_mut().zip(apart).for_each(|(line, [largest, _])| line.push((f64::from(count), largest)));
    }
    series
}
