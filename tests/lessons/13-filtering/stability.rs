use std::collections::BTreeMap;
use std::f64::consts::TAU;

use checks::footprint::{Outside, Texture as Exactly, code, halved, light};
use clipping::Cull;
use clipping::mesh::indexed;
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE};
use common::{Attributes, Color, Format, Image, Model, Vec2, Vec3};
use fastrand::Rng;
use filtering::light::SRGB;
use filtering::{
    Footprint, LAYOUTS, LESSON, Level, METHODS, MIPMAPS, Sampler, Surface, WRAPS, Wrap, nearest,
};
use gouraud::corner_normals;
use perspective::{perspective, view};
use shaders::Uniforms;
use verify::stability::Must::{AtMost, Between, Exact};
use verify::stability::{Case, Row, counted, every_method};
use verify::{CRATE, SPHERE, method};

/// Pixels of one size and form, anywhere on a texture.
pub(crate) struct Pixels {
    image: fn() -> Image,
    wrap: Wrap,
    /// The footprint's two sides, in texels.
    sides: [[f32; 2]; 2],
    /// The corner of the square of side 1 in which (u, v) are.
    around: [f32; 2],
}

/// Pixels so many texels wide and high, on a texture that repeats.
pub(crate) const fn square(image: fn() -> Image, side: f32) -> Pixels {
    Pixels { image, wrap: Wrap::Repeat, sides: [[side, 0.0], [0.0, side]], around: [0.0; 2] }
}

/// The same with other sides.
const fn pixels(image: fn() -> Image, sides: [[f32; 2]; 2]) -> Pixels {
    Pixels { image, wrap: Wrap::Repeat, sides, around: [0.0; 2] }
}

/// Colours at random.
pub(crate) fn noise(width: u16, height: u16) -> Image {
    let mut rng = Rng::with_seed(13);
    let mut image = Image::new(width, height, Format::Rgb);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, Color::rgb(rng.u8(..), rng.u8(..), rng.u8(..)));
    }
    image
}

/// Black and white.
fn checks(width: u16, height: u16) -> Image {
    let mut image = Image::new(width, height, Format::Rgb);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, Color::gray(((x + y) % 2) as f32));
    }
    image
}

/// One colour.
pub(crate) fn plain() -> Image {
    let mut image = Image::new(37, 20, Format::Rgb);
    image.buffer_mut().chunks_exact_mut(3).for_each(|texel| texel.copy_from_slice(&[200, 3, 77]));
    image
}

pub(crate) fn outside(wrap: Wrap) -> Outside {
    match wrap {
        Wrap::Clamp => Outside::Border,
        Wrap::Repeat => Outside::Again,
        Wrap::Mirror => Outside::Mirrored,
    }
}

/// By how many grey levels a channel is off beyond what rounding to a whole one takes, in the mean of many places.
pub(crate) fn off(sampler: &Sampler, pixels: &Pixels) -> f64 {
    let image = (pixels.image)();
    let texture = method(MIPMAPS, "box-linear").texture(&image, pixels.wrap);
    let exactly = Exactly::new(&image, outside(pixels.wrap));
    let [x, y] = pixels.sides.map(|side| Vec2::from_array(side) / image.size());
    // Two rays to a texel or more, and sixteen at least.
    let longest = pixels.sides.iter().flatten().fold(0.0_f32, |most, side| most.max(side.abs()));
    let rays = (2.0 * longest).ceil().max(16.0) as u32;
    let mut rng = Rng::with_seed(14);
    let places = if rays > 100 { 20 } else { 200 };
    let mut sum = 0.0;
    for _ in 0..places {
        let uv = Vec2::new(rng.f32(), rng.f32()) + Vec2::from_array(pixels.around);
        let Color { r, g, b, .. } = (sampler.color)(&texture, uv, Footprint { x, y });
        let truth = exactly.mean(uv.as_dvec2(), [x, y].map(Vec2::as_dvec2), rays);
        for (got, truth) in [r, g, b].into_iter().zip(truth) {
            sum += beyond_rounding(got, truth);
        }
    }
    sum / f64::from(3 * places)
}

/// By how many grey levels a code is farther off a light, from 0 to 1, than rounding takes it: half a level, and a five
/// hundredth more for the f32 before.
fn beyond_rounding(got: u8, exact: f64) -> f64 {
    ((f64::from(got) - code(exact)).abs() - 0.502).max(0.0)
}

/// Pixels, and by how many grey levels each method is off beyond rounding, in the mean.
const PIXELS: &[Case<Pixels>] = &[
    (
        "one colour, enlarged",
        square(plain, 0.1),
        &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "one colour, made smaller",
        square(plain, 9.3),
        &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "one colour, aslant",
        pixels(plain, [[3.0, 40.0], [2.0, 1.0]]),
        &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "enlarged 16 times",
        square(|| noise(64, 64), 1.0 / 16.0),
        &[("nearest", Between(31.8, 34.5)), ("bilinear, bilinear-8, trilinear, anisotropic", AtMost(0.1))],
    ),
    (
        "enlarged 4096 times",
        square(|| noise(64, 64), 1.0 / 4096.0),
        &[
            ("nearest", Between(31.8, 34.5)),
            ("bilinear, trilinear, anisotropic", Exact),
            ("bilinear-8", AtMost(0.1)),
        ],
    ),
    (
        "as large as it is",
        square(|| noise(64, 64), 1.0),
        &[
            ("nearest", Between(39.3, 42.7)),
            ("bilinear, bilinear-8, trilinear, anisotropic", Between(9.13, 9.91)),
        ],
    ),
    (
        "1.5 times smaller",
        square(|| noise(64, 64), 1.5),
        &[
            ("nearest", Between(46.3, 50.2)),
            ("bilinear, bilinear-8", Between(16.6, 18.1)),
            ("trilinear, anisotropic", Between(6.88, 7.47)),
        ],
    ),
    (
        "2 times smaller",
        square(|| noise(64, 64), 2.0),
        &[
            ("nearest", Between(51.9, 56.3)),
            ("bilinear, bilinear-8", Between(23.0, 25.0)),
            ("trilinear, anisotropic", Between(10.9, 11.9)),
        ],
    ),
    (
        "3 times smaller",
        square(|| noise(64, 64), 3.0),
        &[
            ("nearest", Between(58.3, 63.3)),
            ("bilinear, bilinear-8", Between(31.0, 33.7)),
            ("trilinear, anisotropic", Between(7.3, 7.92)),
        ],
    ),
    (
        "4 times smaller",
        square(|| noise(64, 64), 4.0),
        &[
            ("nearest", Between(60.7, 65.9)),
            ("bilinear, bilinear-8", Between(34.1, 37.1)),
            ("trilinear, anisotropic", Between(6.85, 7.43)),
        ],
    ),
    (
        "8 times smaller",
        square(|| noise(256, 256), 8.0),
        &[
            ("nearest", Between(63.1, 68.5)),
            ("bilinear, bilinear-8", Between(34.8, 37.8)),
            ("trilinear, anisotropic", Between(3.5, 3.8)),
        ],
    ),
    (
        "16 times smaller",
        square(|| noise(256, 256), 16.0),
        &[
            ("nearest", Between(63.4, 68.8)),
            ("bilinear, bilinear-8", Between(35.2, 38.3)),
            ("trilinear, anisotropic", Between(1.76, 1.91)),
        ],
    ),
    (
        "32 times smaller",
        square(|| noise(256, 256), 32.0),
        &[
            ("nearest", Between(63.9, 69.3)),
            ("bilinear, bilinear-8", Between(35.6, 38.7)),
            ("trilinear, anisotropic", Between(0.645, 0.7)),
        ],
    ),
    (
        "64 times smaller",
        square(|| noise(256, 256), 64.0),
        &[
            ("nearest", Between(68.9, 74.8)),
            ("bilinear, bilinear-8", Between(37.7, 40.9)),
            ("trilinear, anisotropic", Between(0.283, 0.307)),
        ],
    ),
    (
        "128 times smaller",
        square(|| noise(256, 256), 128.0),
        &[
            ("nearest", Between(69.0, 74.9)),
            ("bilinear, bilinear-8", Between(37.7, 40.9)),
            ("trilinear, anisotropic", AtMost(0.1)),
        ],
    ),
    (
        "256 times smaller, all of it in a pixel",
        square(|| noise(256, 256), 256.0),
        &[
            ("nearest", Between(69.0, 74.9)),
            ("bilinear, bilinear-8", Between(37.7, 41.0)),
            ("trilinear, anisotropic", Exact),
        ],
    ),
    (
        "checks, all in a pixel",
        square(|| checks(64, 64), 64.0),
        &[
            ("nearest", Between(116.0, 126.0)),
            ("bilinear, bilinear-8", Between(21.0, 22.9)),
            ("trilinear, anisotropic", Exact),
        ],
    ),
    (
        "checks, 2 times smaller",
        square(|| checks(64, 64), 2.0),
        &[
            ("nearest", Between(119.0, 130.0)),
            ("bilinear, bilinear-8", Between(23.1, 25.1)),
            ("trilinear, anisotropic", Exact),
        ],
    ),
    (
        "checks, 3 times smaller",
        square(|| checks(64, 64), 3.0),
        &[
            ("nearest", Between(118.0, 129.0)),
            ("bilinear, bilinear-8", Between(22.0, 23.9)),
            ("trilinear, anisotropic", Between(0.722, 0.783)),
        ],
    ),
    (
        "2 times as long as wide",
        pixels(|| noise(256, 256), [[1.0, 0.0], [0.0, 2.0]]),
        &[
            ("nearest", Between(50.7, 55.0)),
            ("bilinear, bilinear-8", Between(17.7, 19.3)),
            ("trilinear", Between(14.4, 15.7)),
            ("anisotropic", Between(4.49, 4.88)),
        ],
    ),
    (
        "4 times as long as wide, up",
        pixels(|| noise(256, 256), [[1.0, 0.0], [0.0, 4.0]]),
        &[
            ("nearest", Between(57.7, 62.6)),
            ("bilinear, bilinear-8", Between(28.2, 30.6)),
            ("trilinear", Between(14.0, 15.3)),
            ("anisotropic", Between(2.7, 2.93)),
        ],
    ),
    (
        "4 times as long as wide, to the right",
        pixels(|| noise(256, 256), [[4.0, 0.0], [0.0, 1.0]]),
        &[
            ("nearest", Between(56.9, 61.7)),
            ("bilinear, bilinear-8", Between(27.5, 29.9)),
            ("trilinear", Between(13.9, 15.2)),
            ("anisotropic", Between(2.61, 2.84)),
        ],
    ),
    (
        "16 times as long as wide",
        pixels(|| noise(256, 256), [[1.0, 0.0], [0.0, 16.0]]),
        &[
            ("nearest", Between(62.2, 67.5)),
            ("bilinear, bilinear-8", Between(33.9, 36.9)),
            ("trilinear", Between(8.69, 9.42)),
            ("anisotropic", Between(0.985, 1.07)),
        ],
    ),
    (
        "64 times as long as wide: more than 16 probes",
        pixels(|| noise(256, 256), [[1.0, 0.0], [0.0, 64.0]]),
        &[
            ("nearest", Between(68.1, 73.9)),
            ("bilinear, bilinear-8", Between(36.5, 39.7)),
            ("trilinear", Between(4.09, 4.44)),
            ("anisotropic", Between(3.07, 3.34)),
        ],
    ),
    (
        "8 times as long as wide, at 45 degrees",
        pixels(|| noise(256, 256), [[0.7, 0.7], [-6.0, 6.0]]),
        &[
            ("nearest", Between(59.7, 64.8)),
            ("bilinear, bilinear-8", Between(31.8, 34.5)),
            ("trilinear", Between(11.6, 12.6)),
            ("anisotropic", Between(2.23, 2.42)),
        ],
    ),
    (
        "two long sides, nearly parallel",
        pixels(|| noise(256, 256), [[8.0, 8.0], [7.0, 8.0]]),
        &[
            ("nearest", Between(61.5, 66.8)),
            ("bilinear, bilinear-8", Between(33.2, 36.1)),
            ("trilinear", Between(8.34, 9.04)),
            ("anisotropic", Between(2.8, 3.05)),
        ],
    ),
    (
        "edge-on: of no width",
        pixels(|| noise(256, 256), [[8.0, 0.0], [0.0, 0.0]]),
        &[
            ("nearest", Between(60.1, 65.2)),
            ("bilinear, bilinear-8", Between(31.4, 34.1)),
            ("trilinear", Between(13.4, 14.7)),
            ("anisotropic", Between(0.171, 0.187)),
        ],
    ),
    (
        "255x255, 4 times smaller",
        square(|| noise(255, 255), 4.0),
        &[
            ("nearest", Between(61.1, 66.3)),
            ("bilinear, bilinear-8", Between(34.7, 37.7)),
            ("trilinear, anisotropic", Between(6.62, 7.18)),
        ],
    ),
    (
        "7x5, enlarged",
        square(|| noise(7, 5), 0.1),
        &[("nearest", Between(33.4, 36.3)), ("bilinear, bilinear-8, trilinear, anisotropic", AtMost(0.1))],
    ),
    (
        "7x5, all of it in a pixel",
        pixels(|| noise(7, 5), [[7.0, 0.0], [0.0, 5.0]]),
        &[
            ("nearest", Between(60.4, 65.5)),
            ("bilinear, bilinear-8", Between(34.8, 37.8)),
            ("trilinear, anisotropic", AtMost(0.1)),
        ],
    ),
    ("1x1", square(|| noise(1, 1), 3.0), &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)]),
    (
        "1x64, enlarged",
        square(|| noise(1, 64), 0.1),
        &[
            ("nearest", Between(22.4, 24.4)),
            ("bilinear, trilinear, anisotropic", AtMost(0.15)),
            ("bilinear-8", AtMost(0.15)),
        ],
    ),
    (
        "1x64, 4 times smaller",
        square(|| noise(1, 64), 4.0),
        &[
            ("nearest", Between(54.2, 58.8)),
            ("bilinear, bilinear-8", Between(35.9, 39.0)),
            ("trilinear, anisotropic", Between(11.2, 12.2)),
        ],
    ),
    (
        "64x1, 4 times smaller",
        square(|| noise(64, 1), 4.0),
        &[
            ("nearest", Between(52.6, 57.1)),
            ("bilinear, bilinear-8", Between(36.1, 39.2)),
            ("trilinear, anisotropic", Between(10.4, 11.4)),
        ],
    ),
    (
        "1x64, 4 times smaller along it alone",
        pixels(|| noise(1, 64), [[0.1, 0.0], [0.0, 4.0]]),
        &[
            ("nearest", Between(54.2, 58.8)),
            ("bilinear, bilinear-8", Between(35.9, 39.0)),
            ("trilinear", Between(11.2, 12.2)),
            ("anisotropic", Between(0.744, 0.807)),
        ],
    ),
    (
        "2x1",
        square(|| noise(2, 1), 0.5),
        &[
            ("nearest", Between(29.6, 32.2)),
            ("bilinear, bilinear-8, trilinear, anisotropic", Between(2.24, 2.45)),
        ],
    ),
    (
        "at 10⁶, repeated",
        Pixels { around: [1e6, -1e6], ..square(|| noise(64, 64), 0.25) },
        &[("nearest", Between(52.2, 56.7)), ("bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "at 10⁶, mirrored",
        Pixels { around: [1e6, -1e6], wrap: Wrap::Mirror, ..square(|| noise(64, 64), 0.25) },
        &[("nearest", Between(51.4, 55.8)), ("bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "at 10⁶, clamped",
        Pixels { around: [1e6, -1e6], wrap: Wrap::Clamp, ..square(|| noise(64, 64), 0.25) },
        &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "at 10⁶, repeated, 4 times smaller",
        Pixels { around: [1e6, -1e6], ..square(|| noise(64, 64), 4.0) },
        &[
            ("nearest", Between(59.7, 64.7)),
            ("bilinear, bilinear-8", Between(20.7, 22.6)),
            ("trilinear, anisotropic", Between(8.46, 9.17)),
        ],
    ),
    (
        "about the border, repeated",
        Pixels { around: [-0.5, 0.5], ..square(|| noise(8, 8), 0.1) },
        &[("nearest", Between(30.2, 32.9)), ("bilinear, bilinear-8, trilinear, anisotropic", AtMost(0.1))],
    ),
    (
        "about the border, mirrored",
        Pixels { around: [-1.0, 1.5], wrap: Wrap::Mirror, ..square(|| noise(8, 8), 0.1) },
        &[("nearest", Between(27.2, 29.6)), ("bilinear, bilinear-8, trilinear, anisotropic", AtMost(0.1))],
    ),
    (
        "about the border, clamped",
        Pixels { around: [-0.5, 0.5], wrap: Wrap::Clamp, ..square(|| noise(8, 8), 0.1) },
        &[("nearest", Between(18.4, 20.1)), ("bilinear, bilinear-8, trilinear, anisotropic", AtMost(0.1))],
    ),
    (
        "about the border, repeated, 2 times smaller",
        Pixels { around: [-0.5, 0.5], ..square(|| noise(8, 8), 2.0) },
        &[
            ("nearest", Between(46.8, 50.8)),
            ("bilinear, bilinear-8", Between(19.7, 21.4)),
            ("trilinear, anisotropic", Between(9.47, 10.3)),
        ],
    ),
];

#[test]
fn pixels_of_any_size_and_form() {
    every_method(LESSON.name, METHODS, PIXELS, |method, pixels| off(&method.run, pixels));
}

/// A chart of one colour in an atlas that is black elsewhere, its colour grown by so many texels over its border, and so many
/// texels that a pixel is wide.
struct Chart {
    grown: i32,
    side: f32,
}

/// What a method makes of pixels on the chart's border, at a texel's centre: by how many grey levels it is off at most.
fn bleeds(sampler: &Sampler, &Chart { grown, side }: &Chart) -> f64 {
    let (chart, color) = (80..176, Color::rgb(200, 120, 40));
    let mut image = Image::new(256, 256, Format::Rgb);
    for (x, y, _) in image.clone().pixels() {
        let within = |n: i32| (chart.start - grown..chart.end + grown).contains(&n);
        if within(x) && within(y) {
            image.set(x, y, color);
        }
    }
    let texture = method(MIPMAPS, "box-linear").texture(&image, Wrap::Clamp);
    let footprint = Footprint { x: Vec2::new(side / 256.0, 0.0), y: Vec2::new(0.0, side / 256.0) };
    let most = (chart.start + 40..chart.end - 40).map(|y| {
        let uv = (Vec2::new(chart.start as f32, y as f32) + 0.5) / 256.0;
        let Color { r, g, b, .. } = (sampler.color)(&texture, uv, footprint);
        [r.abs_diff(color.r), g.abs_diff(color.g), b.abs_diff(color.b)].into_iter().max()
    });
    f64::from(most.flatten().max().unwrap_or(0))
}

const CHARTS: &[Case<Chart>] = &[
    (
        "a chart's border, as large as it is",
        Chart { grown: 0, side: 1.0 },
        &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "4 texels a pixel",
        Chart { grown: 0, side: 4.0 },
        &[("nearest, bilinear, bilinear-8", Exact), ("trilinear, anisotropic", Between(36.4, 39.6))],
    ),
    (
        "16 texels a pixel",
        Chart { grown: 0, side: 16.0 },
        &[("nearest, bilinear, bilinear-8", Exact), ("trilinear, anisotropic", Between(48.0, 52.0))],
    ),
    (
        "grown by 4 texels, 4 texels a pixel",
        Chart { grown: 4, side: 4.0 },
        &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
    (
        "grown by 4 texels, 16 texels a pixel",
        Chart { grown: 4, side: 16.0 },
        &[("nearest, bilinear, bilinear-8", Exact), ("trilinear, anisotropic", Between(33.6, 36.4))],
    ),
    (
        "grown over all of the atlas, 64 texels a pixel",
        Chart { grown: 256, side: 64.0 },
        &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Exact)],
    ),
];

#[test]
fn what_is_beside_a_chart_bleeds_into_it_on_coarse_levels() {
    every_method(LESSON.name, METHODS, CHARTS, |method, chart| bleeds(&method.run, chart));
}

/// Pixels so many texels wide on the seams of the head, whose atlas is as it is, or black where no triangle is.
struct Seams {
    side: i32,
    black: bool,
}

/// By how many grey levels a method is off the mean of what of a pixel the head's triangles cover, in the mean of the middles
/// of all sides at which two charts meet.
fn off_at_seams(sampler: &Sampler, &Seams { side, black }: &Seams) -> f64 {
    let model = Model::read(DEFAULT_MODEL.as_ref(), Attributes { normals: false, uvs: true }).unwrap();
    let mut image = Image::read(DEFAULT_TEXTURE.as_ref()).unwrap();
    let (size, bounds) = (image.size(), image.bounds());
    let mut used = vec![false; (image.width() * image.height()) as usize];
    for uvs in model.face_uvs() {
        triangles::fill(uvs.map(|uv| uv * size), bounds, |x, y, _| {
            used[(y * size.x as i32 + x) as usize] = true;
        });
    }
    let is_used = |x: i32, y: i32| bounds.contains(x, y) && used[(y * size.x as i32 + x) as usize];
    if black {
        for (x, y) in (0..=bounds.max.y).flat_map(|y| (0..=bounds.max.x).map(move |x| (x, y))) {
            if !is_used(x, y) {
                image.set(x, y, Color::BLACK);
            }
        }
    }
    let texture = method(MIPMAPS, "box-linear").texture(&image, Wrap::Clamp);
    // The middles of a side in the texture, by the numbers of its ends.
    let mut middles: BTreeMap<[u32; 2], Vec<Vec2>> = BTreeMap::new();
    for (face, triangle) in model.triangles().iter().enumerate() {
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let ends = [triangle[from].min(triangle[to]), triangle[from].max(triangle[to])];
            middles.entry(ends).or_default().push((model.uv(face, from) + model.uv(face, to)) / 2.0);
        }
    }
    let apart = |places: &&Vec<Vec2>| places.len() == 2 && places[0].distance(places[1]) > 0.01;
    let (mut sum, mut count) = (0.0, 0_u32);
    for uv in middles.values().filter(apart).flatten() {
        let at = *uv * size;
        let (x, y) = (at.x as i32 - side / 2, at.y as i32 - side / 2);
        let (mut exact, mut texels) = ([0.0; 3], 0.0);
        for (x, y) in
            (y..y + side).flat_map(|y| (x..x + side).map(move |x| (x, y))).filter(|&(x, y)| is_used(x, y))
        {
            let Color { r, g, b, .. } = image.get(x, y).unwrap_or(Color::BLACK);
            [r, g, b].into_iter().zip(&mut exact).for_each(|(code, sum)| *sum += light(code.into()));
            texels += 1.0;
        }
        if texels > 0.0 {
            let footprint = Footprint {
                x: Vec2::new(side as f32 / size.x, 0.0),
                y: Vec2::new(0.0, side as f32 / size.y),
            };
            let Color { r, g, b, .. } = (sampler.color)(&texture, *uv, footprint);
            sum += [r, g, b]
                .into_iter()
                .zip(exact)
                .map(|(got, exact)| beyond_rounding(got, exact / texels))
                .sum::<f64>();
            count += 3;
        }
    }
    assert!(count > 1000, "{count}");
    sum / f64::from(count)
}

const SEAMS: &[Case<Seams>] = &[
    (
        "the head's seams, 2 texels a pixel",
        Seams { side: 2, black: false },
        &[
            ("nearest", Between(4.16, 4.51)),
            ("bilinear, bilinear-8", Between(3.26, 3.54)),
            ("trilinear, anisotropic", Between(3.05, 3.31)),
        ],
    ),
    (
        "the head's seams, 8 texels a pixel",
        Seams { side: 8, black: false },
        &[
            ("nearest", Between(8.98, 9.73)),
            ("bilinear, bilinear-8", Between(7.83, 8.5)),
            ("trilinear, anisotropic", Between(4.2, 4.56)),
        ],
    ),
    (
        "the head's seams, 32 texels a pixel",
        Seams { side: 32, black: false },
        &[
            ("nearest", Between(16.1, 17.5)),
            ("bilinear, bilinear-8", Between(15.3, 16.7)),
            ("trilinear, anisotropic", Between(9.31, 10.1)),
        ],
    ),
    (
        "black between charts, 2 texels a pixel",
        Seams { side: 2, black: true },
        &[
            ("nearest", Between(32.8, 35.6)),
            ("bilinear, bilinear-8", Between(22.3, 24.3)),
            ("trilinear, anisotropic", Between(21.1, 22.9)),
        ],
    ),
    (
        "black between charts, 8 texels a pixel",
        Seams { side: 8, black: true },
        &[
            ("nearest", Between(47.3, 51.3)),
            ("bilinear, bilinear-8", Between(30.0, 32.6)),
            ("trilinear, anisotropic", Between(26.2, 28.5)),
        ],
    ),
    (
        "black between charts, 32 texels a pixel",
        Seams { side: 32, black: true },
        &[
            ("nearest", Between(53.0, 57.5)),
            ("bilinear, bilinear-8", Between(35.5, 38.6)),
            ("trilinear, anisotropic", Between(36.6, 39.7)),
        ],
    ),
];

#[test]
fn the_heads_seams_show_on_coarse_levels() {
    every_method(LESSON.name, METHODS, SEAMS, |method, seams| off_at_seams(&method.run, seams));
}

/// Pictures of any size, of whose levels each should be what the one before is in the mean of light: by how many grey levels
/// they are off beyond rounding, in the mean of all texels of all levels.
const LEVELS: &[Case<Make>] = &[
    ("one colour", plain, &[("box-encoded, box-linear, lanczos-linear", Exact)]),
    (
        "noise, 64x64",
        || noise(64, 64),
        &[
            ("box-encoded", Between(18.2, 19.8)),
            ("box-linear", Exact),
            ("lanczos-linear", Between(10.4, 11.3)),
        ],
    ),
    (
        "checks, 64x64",
        || checks(64, 64),
        &[("box-encoded", Between(56.6, 61.4)), ("box-linear, lanczos-linear", Exact)],
    ),
    (
        "noise, 63x63",
        || noise(63, 63),
        &[
            ("box-encoded", Between(19.6, 21.4)),
            ("box-linear", Exact),
            ("lanczos-linear", Between(6.81, 7.38)),
        ],
    ),
    (
        "noise, 65x33",
        || noise(65, 33),
        &[
            ("box-encoded", Between(19.7, 21.5)),
            ("box-linear", Exact),
            ("lanczos-linear", Between(6.56, 7.12)),
        ],
    ),
    (
        "noise, 7x5",
        || noise(7, 5),
        &[
            ("box-encoded", Between(18.5, 20.2)),
            ("box-linear", Exact),
            ("lanczos-linear", Between(5.36, 5.82)),
        ],
    ),
    (
        "noise, 3x3",
        || noise(3, 3),
        &[("box-encoded", Between(20.5, 22.4)), ("box-linear", Exact), ("lanczos-linear", AtMost(0.1))],
    ),
    (
        "noise, 1x64",
        || noise(1, 64),
        &[
            ("box-encoded", Between(15.6, 17.0)),
            ("box-linear", Exact),
            ("lanczos-linear", Between(11.3, 12.4)),
        ],
    ),
    (
        "noise, 61x1",
        || noise(61, 1),
        &[
            ("box-encoded", Between(16.8, 18.3)),
            ("box-linear", Exact),
            ("lanczos-linear", Between(7.55, 8.19)),
        ],
    ),
    (
        "noise, 2x1",
        || noise(2, 1),
        &[("box-encoded", Between(14.8, 16.2)), ("box-linear, lanczos-linear", Exact)],
    ),
    ("noise, 1x1", || noise(1, 1), &[("box-encoded, box-linear, lanczos-linear", Exact)]),
];

/// Makes a picture.
type Make = fn() -> Image;

#[test]
fn levels_of_any_size_have_the_light_of_the_picture() {
    every_method(LESSON.name, MIPMAPS, LEVELS, |method, make| {
        let image = make();
        let levels = method.run.levels(&image, Wrap::Repeat);
        let (mut sum, mut count) = (0.0, 0_u32);
        for channel in [|c: Color| c.r, |c: Color| c.g, |c: Color| c.b] {
            let mut exact: Vec<f64> = image.pixels().map(|pixel| light(channel(pixel.2).into())).collect();
            let mut width = image.width() as usize;
            for level in &levels[1..] {
                (exact, width) = halved(&exact, width);
                assert_eq!(
                    (level.width() as usize, (level.width() * level.height()) as usize),
                    (width, exact.len())
                );
                for ((.., color), exact) in level.pixels().zip(&exact) {
                    sum += beyond_rounding(channel(color), *exact);
                    count += 1;
                }
            }
        }
        sum / f64::from(count.max(1))
    });
}

/// Of codes taken for light the mean is exact, too: whole numbers, rounded, halves up.
#[test]
fn encoded_levels_are_the_mean_of_codes() {
    for (width, height) in [(64, 64), (63, 31), (7, 5), (1, 9), (5, 1)] {
        let image = noise(width, height);
        let levels = method(MIPMAPS, "box-encoded").levels(&image, Wrap::Repeat);
        let mut exact: Vec<f64> = image.pixels().map(|pixel| pixel.2.g.into()).collect();
        let mut columns = usize::from(width);
        for level in &levels[1..] {
            (exact, columns) = halved(&exact, columns);
            for ((x, y, color), exact) in level.pixels().zip(&exact) {
                let half = ((exact - 0.5).fract() - 0.5).abs() > 0.499_99;
                let got = f64::from(color.g);
                assert!(
                    got == (exact + 0.5).floor() || half && (got - exact).abs() < 0.51,
                    "({x}, {y}): {exact}"
                );
            }
        }
    }
}

/// A wave of so many texels of the first level: what of it is left on the second, as a share of its height. What two texels of
/// the second level cannot hold should go, and what they can should stay.
#[test]
fn a_sinc_keeps_what_a_level_can_hold_and_less_of_what_it_cannot() {
    // Texels to a wave, and what is left by either kernel.
    for (texels, by_box, by_sinc) in [(16, 0.98, 1.0), (8, 0.92, 1.0), (3, 0.5, 0.043)] {
        let mut image = Image::new(48, 1, Format::Gray);
        let wave = |x: i32| 0.5 + 0.4 * (f64::from(x) / f64::from(texels) * TAU).sin();
        for x in 0..48 {
            image.set(x, 0, Color::gray(code(wave(x)) as f32 / 255.0));
        }
        let left = |name: &str| {
            let level = &method(MIPMAPS, name).levels(&image, Wrap::Repeat)[1];
            let power =
                level.pixels().map(|pixel| (light(pixel.2.r.into()) - 0.5).powi(2)).sum::<f64>() / 24.0;
            (2.0 * power).sqrt() / 0.4
        };
        let got = [left("box-linear"), left("lanczos-linear")];
        assert!((got[0] - by_box).abs() < 0.02 && (got[1] - by_sinc).abs() < 0.02, "{texels}: {got:?}");
    }
}

/// Beside an edge a sinc overshoots: a dark rim in what is dark, a bright one in what is bright. A box does not.
#[test]
fn a_sinc_rings_beside_an_edge() {
    let mut image = Image::new(64, 1, Format::Gray);
    (0..64).for_each(|x| image.set(x, 0, Color::gray(if x < 31 { 0.4 } else { 0.8 })));
    let ends = |name: &str| {
        let level = &method(MIPMAPS, name).levels(&image, Wrap::Clamp)[1];
        let codes = || level.pixels().map(|pixel| pixel.2.r);
        [codes().min().unwrap(), codes().max().unwrap()]
    };
    assert_eq!(ends("box-linear"), [102, 204]);
    let [dark, bright] = ends("lanczos-linear");
    assert!(dark < 90 && bright > 208, "{dark} {bright}");
}

/// The largest step from a code to the next on the way from black to white, enlarged a thousand times.
const RAMP: &[Case<()>] = &[(
    "black to white",
    (),
    &[
        ("nearest", Between(255.0, 255.0)),
        ("bilinear, trilinear, anisotropic", Between(1.0, 1.0)),
        ("bilinear-8", Between(13.0, 13.0)),
    ],
)];

#[test]
fn weights_of_8_bits_show_beside_black() {
    let mut image = Image::new(2, 1, Format::Gray);
    image.set(1, 0, Color::WHITE);
    let texture = method(MIPMAPS, "box-linear").texture(&image, Wrap::Clamp);
    let footprint = Footprint { x: Vec2::new(0.0005, 0.0), y: Vec2::new(0.0, 0.0005) };
    every_method(LESSON.name, METHODS, RAMP, |method, ()| {
        let codes: Vec<f64> = (0..=20_000)
            .map(|n| (method.run.color)(&texture, Vec2::new(n as f32 / 20_000.0, 0.5), footprint).r.into())
            .collect();
        codes.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
    });
}

const W: &[Row] = &[("clamp, repeat, mirror", Exact)];

/// u, and the texel of 5 that is there by each wrap.
const PLACES: &[Case<f32>] = &[
    ("0", 0.0, W),
    ("-0", -0.0, W),
    ("1", 1.0, W),
    ("-1", -1.0, W),
    ("2", 2.0, W),
    ("a texel's border", 0.5, W),
    ("a little below 0", -1e-30, W),
    ("a little below 1", 1.0 - 1e-7, W),
    ("a little above 1", 1.0 + 2e-7, W),
    ("0.3", 0.3, W),
    ("-0.3", -0.3, W),
    ("1.9", 1.9, W),
    ("-1.9", -1.9, W),
    ("10⁶ and some", 1_000_000.3, W),
    ("-10⁶ and some", -1_000_000.7, W),
    ("2²³ − ½", 8_388_607.5, W),
    ("2²⁴ − 1", 16_777_215.0, W),
    ("-2²³ + ½", -8_388_607.5, W),
    ("2³¹", 2_147_483_648.0, W),
    ("-2³¹", -2_147_483_648.0, W),
    ("10³⁰", 1e30, W),
    ("the largest", f32::MAX, W),
    ("infinite", f32::INFINITY, W),
    ("-infinite", f32::NEG_INFINITY, W),
    ("NaN", f32::NAN, W),
];

#[test]
fn beyond_its_border_a_texture_is_what_its_wrap_says() {
    let mut image = Image::new(5, 1, Format::Gray);
    (0..5).for_each(|x| image.set(x, 0, Color::rgb(x as u8, x as u8, x as u8)));
    let level: Level = Level::new(&image, &SRGB);
    every_method(LESSON.name, WRAPS, PLACES, |method, &u| {
        let got = i32::from(nearest(&level, Vec2::new(u, 0.5), method.run).r);
        let column = checks::texel::column(u, 5);
        let exact = match (method.run, column) {
            (Wrap::Clamp, None) if u == f32::INFINITY => 4,
            (_, None) => 0,
            (Wrap::Clamp, Some(i)) => i.clamp(0, 4) as i32,
            (Wrap::Repeat, Some(i)) => checks::texel::repeated(u, 5).unwrap_or(i as i32),
            // From 2²⁴ on all numbers are even.
            (Wrap::Mirror, Some(_)) if u.abs() >= (1 << 24) as f32 => 0,
            (Wrap::Mirror, Some(i)) => {
                let there = i.rem_euclid(10) as i32;
                if there < 5 { there } else { 9 - there }
            }
        };
        if got == exact { Vec::new() } else { vec![format!("texel {got} instead of {exact}")] }
    });
}

const L: &[Row] = &[("rows, tiles-4x4, morton", Exact)];

const KEPT: &[Case<Make>] = &[
    ("a square", || noise(64, 64), L),
    ("odd", || noise(37, 21), L),
    ("one texel", || noise(1, 1), L),
    ("a row", || noise(300, 1), L),
    ("a column", || noise(1, 300), L),
    ("one more than a tile", || noise(5, 5), L),
    ("wide", || noise(257, 3), L),
    ("high", || noise(3, 257), L),
];

#[test]
fn every_layout_gives_the_same_colours() {
    every_method(LESSON.name, LAYOUTS, KEPT, |method, make| {
        let image = make();
        let size = image.size();
        // From each texel's centre to the next.
        let step = Footprint { x: Vec2::new(1.0 / size.x, 0.0), y: Vec2::new(0.0, 1.0 / size.y) };
        let width = image.width() as usize;
        let mut colors = vec![Color::BLACK; width * image.height() as usize];
        (method.run.walk)(&image)(Vec2::splat(0.5) / size, step, width, &mut colors);
        let wrong = image.pixels().zip(&colors).filter(|((.., expected), got)| {
            // Rounding brings a place off a centre by a thousandth of a texel.
            let off = |a: u8, b: u8| a.abs_diff(b) > 2;
            off(expected.r, got.r) || off(expected.g, got.g) || off(expected.b, got.b)
        });
        counted([("wrong", wrong.count())])
    });
}

/// Twice as many triangles, and four times the fragments, allocate as often: the depths once, the vertices once.
#[test]
fn drawing_allocates_nothing_per_triangle_or_fragment() {
    let image = Image::read(CRATE.as_ref()).unwrap();
    let texture = method(MIPMAPS, "box-linear").texture(&image, Wrap::Repeat);
    let needs = Attributes { normals: true, uvs: true };
    let text = std::fs::read_to_string(SPHERE).unwrap();
    let to_clip = perspective(90.0, 1.0, 0.1, 10.0).unwrap()
        * view(Vec3::new(0.3, 0.2, 0.1), Vec3::new(1.0, 0.5, 0.0), Vec3::Y).unwrap();
    for method in METHODS {
        let counts = [(1, 50), (2, 50), (1, 100)].map(|(times, side)| {
            let faces: String =
                text.lines().filter(|line| line.starts_with('f')).map(|line| format!("{line}\n")).collect();
            let model = Model::parse((text.clone() + &faces.repeat(times - 1)).as_bytes(), needs).unwrap();
            let normals = corner_normals(&model);
            let mesh = indexed(&model, &normals, needs);
            let uniforms = Uniforms { normals: &normals, to_clip, ..Uniforms::new(&model) };
            let mut image = Image::new(side, side, Format::Rgb);
            let surfaces = [Surface { uniforms, mesh: &mesh, texture: &texture }];
            let draw = || drop((method.run.draw)(&surfaces, Cull::None, &mut image));
            allocation_counter::measure(draw).count_total
        });
        assert_eq!(counts, [2; 3], "{}", method.name);
    }
}
