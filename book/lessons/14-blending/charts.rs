//! Lesson 14: division by 255, layers in their order, and cut-outs in codes and in light.

use blending::blend::BlendStage;
use blending::cutout::{Cutout, FERN};
use blending::space::SPACES;
use blending::transparency::{TRANSPARENCY, Transparency};
use blending::{Divide, METHODS, Over, TwoShift};
use checks::cutout::Cutout as Exact;
use checks::layers;
use common::{Color, DVec2, Format, Image, Method, Vec2, Vec3};
use fastrand::Rng;
use filtering::Wrap;
use filtering::filter::{Bilinear, Filter};
use zbuffer::{DepthBuffer, Surface};

use crate::figures::picture::painted;
use crate::measuring::finish::{flip, rms};
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "14-blending",
    job: "Lesson 14, division by 255",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference from the nearest level",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &["wrong_%"],
    samples: "each alpha, all 256 channels over black: all 65,536 products",
    exhaustive: true,
    proved: &[],
    errors: method_errors,
    timed: "100 rows of 4096 colours, each laid over the same row of pixels",
    throughput: "Mpx/s",
    work: method_work,
    sizes: Sizes { name: "layers over one another", all: &[1, 10, 100, 1000], usual: 100 },
    stability: Stability {
        stress: "layers of white, alpha 1 of 255",
        falling: false,
        error: Quantity {
            name: "larger difference, over white and over black",
            unit: "grey levels of 255",
            limit: (1.0, "1 level"),
        },
        measure: method_stability,
    },
    wrong: &[],
    advice: &[
        ("two-shift", "always"),
        ("exact", "where it is to be read at a glance: the same results"),
        ("float", "where colours are floats anyhow"),
        ("div-256", "where the last level does not matter, and layers are few"),
    ],
};

pub(crate) const TRANSPARENCY_CHART: Chart = Chart {
    name: "14-blending-transparency",
    job: "Lesson 14, what is seen through what",
    methods: || TRANSPARENCY.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "RMS difference of a picture",
        unit: "grey levels of 255",
        limit: (1.0, "within 1 level"),
    },
    further: &["flip"],
    samples: "pictures of 64×64 px of 12 random triangles that cut each other, in random colours and alphas",
    exhaustive: false,
    proved: &[],
    errors: transparency_errors,
    timed: "8 layers of 128 triangles that cut each other, in a picture of 200×200 px",
    throughput: "Mfragment/s",
    work: transparency_work,
    sizes: Sizes { name: "layers over one another", all: &[1, 2, 4, 8, 16, 32], usual: 8 },
    stability: Stability {
        stress: "triangles that cut each other",
        falling: false,
        error: Quantity {
            name: "RMS difference",
            unit: "grey levels of 255",
            limit: (10.0, "10 grey levels"),
        },
        measure: transparency_stability,
    },
    wrong: &[],
    advice: &[
        ("list", "always, where memory may grow with what is drawn"),
        ("peeling", "few layers, and no memory for more"),
        ("sorted", "small triangles that do not cut each other: smoke, sparks, leaves"),
        ("weighted", "what is thin and of like colours, where nothing may flicker as it moves"),
        ("drawn", "layers that are known to come in their order"),
    ],
};

pub(crate) const SPACES_CHART: Chart = Chart {
    name: "14-blending-spaces",
    job: "Lesson 14, colours with an alpha",
    methods: || SPACES.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "RMS difference of a picture",
        unit: "grey levels of 255",
        limit: (1.0, "within 1 level"),
    },
    further: &["flip"],
    samples: "pictures of 48×48 px of a fern, 1 to 16 times as large, over random colours, against light in f64",
    exhaustive: false,
    proved: &[],
    errors: space_errors,
    timed: "512×512 filtered texels of a cut-out of 256×256, laid over a colour",
    throughput: "Mpx/s",
    work: space_work,
    sizes: Sizes { name: "texels across the texture", all: &[256], usual: 256 },
    stability: Stability {
        stress: "code of the ground",
        falling: false,
        error: Quantity { name: "RMS difference", unit: "grey levels of 255", limit: (2.0, "2 grey levels") },
        measure: space_stability,
    },
    wrong: &[],
    advice: &[
        ("linear-premultiplied", "always"),
        ("encoded-premultiplied", "where pictures are to look as in programs that mix codes"),
        ("linear-straight", "cut-outs whose transparent texels have the colour of their neighbours"),
        ("encoded-straight", "nothing that is filtered"),
    ],
};

/// The products of each alpha, against whole numbers: x/255 is never half-way between two of them.
fn method_errors(_: Effort) -> Vec<Errors> {
    let of = |mix: fn(u8, u8, u8) -> u8| {
        let mut errors = Errors::new(1);
        for alpha in 0..=255 {
            let off = |channel: u8| {
                let nearest = (2 * i32::from(channel) * i32::from(alpha) + 255) / (2 * 255);
                f64::from((i32::from(mix(channel, 0, alpha)) - nearest).abs())
            };
            let all: Vec<f64> = (0..=255).map(off).collect();
            let wrong = all.iter().filter(|off| **off > 0.0).count() as f64;
            let largest = all.iter().copied().fold(0.0, f64::max);
            errors.add(largest, all.iter().sum::<f64>() / 256.0, &[100.0 * wrong / 256.0]);
        }
        errors
    };
    METHODS.iter().map(|method| of(method.run.mix)).collect()
}

/// Layers over white and over black, each channel kept as a byte, against the exact number.
fn method_stability(_: Effort) -> Vec<Series> {
    const ALPHA: u8 = 1;
    let stops = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
    let of = |mix: fn(u8, u8, u8) -> u8| {
        let (mut codes, mut layers) = ([255, 0], 0);
        let point = |&stop: &i32| {
            (layers..stop).for_each(|_| codes = codes.map(|code| mix(255, code, ALPHA)));
            layers = stop;
            let rest = (1.0 - f64::from(ALPHA) / 255.0).powi(stop);
            let off = |first: f64, code: u8| (255.0 + (first - 255.0) * rest - f64::from(code)).abs();
            (f64::from(stop), off(255.0, codes[0]).max(off(0.0, codes[1])))
        };
        stops.iter().map(point).collect()
    };
    METHODS.iter().map(|method| of(method.run.mix)).collect()
}

/// Rows of any colours and alphas, laid over a row of pixels.
fn method_work(layers: usize, effort: Effort) -> Vec<Work> {
    const WIDTH: usize = 4096;
    const ROWS: usize = 4;
    let mut random = effort.random();
    let mut row = || (0..WIDTH).map(|_| any_color(&mut random)).collect::<Vec<Color>>();
    let rows: Vec<Vec<Color>> = (0..ROWS).map(|_| row()).collect();
    let work = |method: &'static Method<Divide>| {
        let (rows, mut pixels) = (rows.clone(), vec![Color::BLACK; WIDTH]);
        Work::new((WIDTH * layers) as f64, move || {
            rows.iter().cycle().take(layers).for_each(|row| (method.run.row)(row, &mut pixels));
            pixels[WIDTH / 2]
        })
    };
    METHODS.iter().map(work).collect()
}

/// Triangles all over a square picture, at all depths, so that most of them cut others.
fn crossing(random: &mut Rng, side: u16, count: usize) -> Vec<Surface> {
    let corner = |random: &mut Rng| {
        let at = |random: &mut Rng| (1.5 * random.f32() - 0.25) * f32::from(side);
        Vec3::new(at(random), at(random), random.f32())
    };
    let surface = |_| {
        let corners = [(); 3].map(|()| corner(random));
        Surface { corners, color: any_color(random) }
    };
    (0..count).map(surface).collect()
}

/// Any colour, and any alpha.
fn any_color(random: &mut Rng) -> Color {
    Color { r: random.u8(..), g: random.u8(..), b: random.u8(..), a: random.u8(..) }
}

/// How much each way is off in a picture of triangles: RMS, and FLIP's mean.
fn layers_off(random: &mut Rng, count: usize) -> Vec<[f64; 2]> {
    const SIDE: u16 = 64;
    let surfaces = crossing(random, SIDE, count);
    let ground = Color { a: 255, ..any_color(random) };
    let panes: Vec<layers::Pane> = surfaces.iter().map(|surface| (surface.corners, surface.color)).collect();
    let empty = painted(SIDE, SIDE, |_, _| ground);
    let expected: Vec<[f64; 3]> = empty
        .pixels()
        .map(|(x, y, _)| {
            let [r, g, b, _] = layers::at(ground, &[], &panes, x, y).exact();
            [r, g, b]
        })
        .collect();
    let off = |method: &Method<Transparency>| {
        let mut image = empty.clone();
        let depths = DepthBuffer::new(&image, 1.0);
        method.run.draw(&surfaces, Over(TwoShift), &mut image, &depths);
        [rms(&image, &expected, |_| true), mean(&flip(&image, &expected))]
    };
    TRANSPARENCY.iter().map(off).collect()
}

fn mean(values: &[f32]) -> f64 {
    values.iter().map(|value| f64::from(*value)).sum::<f64>() / values.len() as f64
}

fn transparency_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(TRANSPARENCY.len(), TRANSPARENCY_CHART.further.len());
    for _ in 0..effort.samples(400) {
        let all = layers_off(&mut random, 12);
        errors.iter_mut().zip(all).for_each(|(errors, [rms, flip])| errors.add(rms, rms, &[flip]));
    }
    errors
}

fn transparency_stability(effort: Effort) -> Vec<Series> {
    let mut random = effort.random();
    let mut series = vec![Series::new(); TRANSPARENCY.len()];
    for count in [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64] {
        let pictures = effort.samples(100);
        let mut sums = vec![0.0; TRANSPARENCY.len()];
        for _ in 0..pictures {
            sums.iter_mut().zip(layers_off(&mut random, count)).for_each(|(sum, [rms, _])| *sum += rms);
        }
        series.iter_mut().zip(&sums).for_each(|(line, sum)| line.push((count as f64, sum / pictures as f64)));
    }
    series
}

/// Layers that cover a square picture, each a sheet of 128 triangles that is tilted at random.
fn tilted_layers(random: &mut Rng, side: u16, layers: usize) -> Vec<Surface> {
    const CELLS: usize = 8;
    let mut surfaces = Vec::new();
    for _ in 0..layers {
        let tilt = Vec2::new(random.f32(), random.f32()) - 0.5;
        let corner = |x: usize, y: usize| {
            let at = Vec2::new(x as f32, y as f32) / CELLS as f32;
            (at * f32::from(side)).extend(0.5 + 0.9 * tilt.dot(at - 0.5))
        };
        for (x, y) in (0..CELLS).flat_map(|y| (0..CELLS).map(move |x| (x, y))) {
            let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
            let color = any_color(random);
            surfaces.extend([[a, b, c], [a, c, d]].map(|corners| Surface { corners, color }));
        }
    }
    random.shuffle(&mut surfaces);
    surfaces
}

fn transparency_work(layers: usize, effort: Effort) -> Vec<Work> {
    const SIDE: u16 = 200;
    let surfaces = tilted_layers(&mut effort.random(), SIDE, layers);
    let fragments = f64::from(SIDE) * f64::from(SIDE) * layers as f64;
    let work = |way: Transparency| {
        let (surfaces, mut image) = (surfaces.clone(), Image::new(SIDE, SIDE, Format::Rgb));
        let depths = DepthBuffer::new(&image, 1.0);
        Work::new(fragments, move || way.draw(&surfaces, Over(TwoShift), &mut image, &depths))
    };
    TRANSPARENCY.iter().map(|method| work(method.run)).collect()
}

/// A part of the fern over a colour: the pictures of all spaces, and what should be seen.
struct Views {
    fern: Cutout,
    exact: Exact,
}

impl Views {
    fn new() -> Self {
        let fern = Cutout::read(FERN).expect("the course has a fern");
        let exact = Exact::new(&fern.picture, true, true);
        Self { fern, exact }
    }

    /// How much each space is off, that many pixels a texel, somewhere: RMS, and FLIP's mean.
    fn off(&self, random: &mut Rng, scale: f32, ground: Color) -> Vec<[f64; 2]> {
        const SIDE: u16 = 48;
        let size = self.fern.picture.size();
        // As far from the border as the picture reaches.
        let margin = f32::from(SIDE) / 2.0 / scale / size.min_element() + 0.01;
        let place = |random: &mut Rng| margin + (1.0 - 2.0 * margin) * random.f32();
        let middle = Vec2::new(place(random), place(random));
        let empty = painted(SIDE, SIDE, |_, _| ground);
        let seen = |(x, y, _)| {
            let from_middle = DVec2::new(f64::from(x), f64::from(y)) + 0.5 - f64::from(SIDE) / 2.0;
            let uv = middle.as_dvec2() + from_middle / (f64::from(scale) * size.as_dvec2());
            self.exact.over(uv, ground)
        };
        let expected: Vec<[f64; 3]> = empty.pixels().map(seen).collect();
        let off = |method: &Method<blending::space::Space>| {
            let mut image = empty.clone();
            self.fern.draw(&method.run, scale, middle, &mut image);
            [rms(&image, &expected, |_| true), mean(&flip(&image, &expected))]
        };
        SPACES.iter().map(off).collect()
    }
}

/// From 1 to 16 pixels a texel, each power equally likely.
fn any_scale(random: &mut Rng) -> f32 {
    2f32.powf(4.0 * random.f32())
}

fn space_errors(effort: Effort) -> Vec<Errors> {
    let (views, mut random) = (Views::new(), effort.random());
    let mut errors = Errors::table(SPACES.len(), SPACES_CHART.further.len());
    for _ in 0..effort.samples(200) {
        let (scale, ground) = (any_scale(&mut random), Color { a: 255, ..any_color(&mut random) });
        let all = views.off(&mut random, scale, ground);
        errors.iter_mut().zip(all).for_each(|(errors, [rms, flip])| errors.add(rms, rms, &[flip]));
    }
    errors
}

fn space_stability(effort: Effort) -> Vec<Series> {
    let views = Views::new();
    let mut series = vec![Series::new(); SPACES.len()];
    for code in [1, 2, 4, 8, 16, 32, 64, 96, 128, 160, 192, 224, 255_u8] {
        // The same places over each ground.
        let mut random = effort.random();
        let pictures = effort.samples(40);
        let mut sums = vec![0.0; SPACES.len()];
        for _ in 0..pictures {
            let scale = any_scale(&mut random);
            let all = views.off(&mut random, scale, Color::rgb(code, code, code));
            sums.iter_mut().zip(all).for_each(|(sum, [rms, _])| *sum += rms);
        }
        series.iter_mut().zip(&sums).for_each(|(line, sum)| line.push((code.into(), sum / pictures as f64)));
    }
    series
}

/// A cut-out that is made ready for each space, that many texels across, looked up and laid over a colour.
fn space_work(texels: usize, _: Effort) -> Vec<Work> {
    const SIDE: u16 = 512;
    let fern = Cutout::read(FERN).expect("the course has a fern").picture;
    let picture = fern.scale(texels as u16, texels as u16);
    let work = |space: blending::space::Space| {
        let texture = space.texture(&picture, Wrap::Clamp);
        let mut image = Image::new(SIDE, SIDE, Format::Rgb);
        let ground = Color::rgb(0xf3, 0xe9, 0xd8);
        Work::new(f64::from(SIDE) * f64::from(SIDE), move || {
            for (x, y) in (0..i32::from(SIDE)).flat_map(|y| (0..i32::from(SIDE)).map(move |x| (x, y))) {
                let uv = (Vec2::new(x as f32, y as f32) + 0.5) / f32::from(SIDE);
                image.set(x, y, space.color(Bilinear.color(&texture, uv, ()), ground));
            }
        })
    };
    SPACES.iter().map(|method| work(method.run)).collect()
}
