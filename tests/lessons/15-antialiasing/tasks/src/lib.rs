//! Mission 15: the mask of covered samples, and the resolve.

pub use antialiasing_given as given;

use common::{Color, Format, IVec2, Image, Vec2};
use fastrand::Rng;
use tasks::scenery::canvas;
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

use given::{Coverage, Resolve, draw, pattern};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Antialiasing {
    /// The lesson's `coverage`.
    pub coverage: Coverage,
    /// The lesson's `resolve`.
    pub resolve: Resolve,
}

/// The mission.
pub const MISSION: Mission<Antialiasing> = Mission {
    lesson: "15-antialiasing",
    checks: &[
        Check {
            name: "one pixel",
            asks: "the samples of one pixel that a triangle covers, wherever the pixel is",
            points: 2,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for samples in COUNTS {
                    for reach in [2, 6, 200] {
                        let pixel = IVec2::new(rng.i32(-reach..=reach), rng.i32(1..=reach));
                        tasks.push(one_pixel(across(rng, pixel.as_vec2()), pixel, samples));
                    }
                }
                let far = IVec2::new(rng.i32(3000..9000), rng.i32(-9000..-3000));
                tasks.push(one_pixel(across(rng, far.as_vec2()), far, 16));
                // Beside the pixel, and of no area.
                let [a, b, c] = across(rng, Vec2::ZERO);
                tasks.push(one_pixel([a, b, c], IVec2::new(90, -80), 8));
                tasks.push(one_pixel([a, b, b], IVec2::ZERO, 16));
                tasks.push(one_pixel(
                    [a, (a + c) / 2.0, c].map(|p| (p * 64.0).round() / 64.0),
                    IVec2::ZERO,
                    4,
                ));
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "masks",
            asks: "red and green are the mask of each pixel, for all patterns, and both ways round",
            points: 2,
            tasks: |rng| {
                let mut tasks: Vec<_> = COUNTS.map(|samples| masks(corners(rng), samples)).into();
                let [a, b, c] = corners(rng);
                tasks.extend([[a, b, c], [b, a, c], [c, a, b], [a, c, b]].map(|corners| masks(corners, 16)));
                // Thinner than the samples are apart.
                let sliver = [a, c, c + Vec2::new(0.2 + 0.2 * rng.f32(), 0.3)];
                tasks.extend([4, 16].map(|samples| masks(sliver, samples)));
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "sides",
            asks: "each sample on a common side is in one triangle: red how many are covered, green how many twice",
            points: 2,
            tasks: |rng| [2, 4, 8, 16, 16].map(|samples| fan(rng, samples)).into(),
            precision: Precision::EXACT,
        },
        Check {
            name: "resolve",
            asks: "the mean of the samples, rounded once",
            points: 2,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for samples in COUNTS {
                    let color = any_color(rng);
                    // Of one colour, of two, and of any; each sum of a few lies half-way between two codes.
                    let next = Color { r: color.r ^ 1, g: color.g ^ 1, b: color.b ^ 1, a: color.a ^ 1 };
                    tasks.push(mean(vec![color; samples]));
                    tasks.push(mean((0..samples).map(|s| if s % 2 == 0 { color } else { next }).collect()));
                    tasks.extend((0..2).map(|_| mean((0..samples).map(|_| any_color(rng)).collect())));
                }
                tasks.push(mean((0..16).map(|_| Color { r: 255, g: 254, ..any_color(rng) }).collect()));
                tasks.push(mean((0..3).map(|_| any_color(rng)).collect()));
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "a wheel of thin triangles",
            points: 2,
            tasks: |rng| [4, 16].map(|samples| wheel(samples, rng.u64(..1_000_000))).into(),
            precision: Precision::EXACT,
        },
    ],
};

/// The patterns that there are.
const COUNTS: [usize; 5] = [1, 2, 4, 8, 16];

/// Width and height of the pictures of masks.
const SMALL: [u16; 2] = [48, 40];

/// Those of the wheel.
const SIZE: [u16; 2] = [160, 120];

fn any_color(rng: &mut Rng) -> Color {
    let [r, g, b, a] = rng.u32(..).to_le_bytes();
    Color { r, g, b, a }
}

fn color_code(Color { r, g, b, a }: &Color) -> String {
    format!("Color {{ r: {r}, g: {g}, b: {b}, a: {a} }}")
}

/// A place in 1/256 px.
fn rounded(place: Vec2) -> Vec2 {
    (place * 256.0).round() / 256.0
}

/// A triangle with a side through a pixel.
fn across(rng: &mut Rng, pixel: Vec2) -> [Vec2; 3] {
    let angle = rng.f32() * std::f32::consts::TAU;
    let way = Vec2::from_angle(angle);
    let through = pixel + Vec2::new(0.3 + 0.4 * rng.f32(), 0.3 + 0.4 * rng.f32());
    let far = through + way.perp() * (4.0 + 4.0 * rng.f32());
    let mut corners = [through - way * (5.0 + rng.f32()), through + way * (5.0 + rng.f32()), far];
    rng.shuffle(&mut corners);
    corners.map(rounded)
}

/// A triangle in the small picture that is no sliver.
fn corners(rng: &mut Rng) -> [Vec2; 3] {
    let size = Vec2::from_array(SMALL.map(f32::from));
    let any = |_| {
        let corners = [(); 3].map(|()| Vec2::new(rng.f32(), rng.f32()) * size);
        let [a, b, c] = corners;
        ((b - a).perp_dot(c - a).abs() > 400.0).then(|| corners.map(rounded))
    };
    (0..).find_map(any).unwrap_or_default()
}

fn one_pixel(corners: [Vec2; 3], pixel: IVec2, samples: usize) -> Task<Antialiasing> {
    let call = format!("coverage({}, {}, pattern({samples}))", corners.code(), pixel.code());
    let code = format!("let mask = {call};\nlet got = [mask as f32];");
    Task::new(call, code, move |student: &Antialiasing| {
        Raw::value([(student.coverage)(corners, pixel, pattern(samples)) as f32])
    })
}

/// A picture of each pixel's mask.
fn masks(corners: [Vec2; 3], samples: usize) -> Task<Antialiasing> {
    let [width, height] = SMALL;
    let code = format!(
        "let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         for (x, y, _) in got.clone().pixels() {{\n    \
             let mask = coverage({}, IVec2::new(x, y), pattern({samples}));\n    \
             let [low, high, above, _] = mask.to_le_bytes();\n    \
             got.set(x, y, Color::rgb(low, high, above));\n}}",
        corners.code()
    );
    let input =
        format!("coverage({}, …, pattern({samples})) in each pixel, {width}x{height}", corners.code());
    let shape: Shape = corners.map(|corner| corner.extend(0.0)).into();
    Task::new(input, code, move |student: &Antialiasing| {
        let mut image = canvas(width, height);
        for (x, y, _) in image.clone().pixels() {
            let mask = (student.coverage)(corners, IVec2::new(x, y), pattern(samples));
            let [low, high, above, _] = mask.to_le_bytes();
            image.set(x, y, Color::rgb(low, high, above));
        }
        Raw::Picture(image)
    })
    .of(move |_| vec![shape.clone()])
}

/// How many samples of each pixel triangles cover: red at all, green twice or more, 15 each.
#[must_use]
pub fn counts(triangles: &[[Vec2; 3]], samples: usize, coverage: Coverage) -> Image {
    let mut image = Image::new(SMALL[0], SMALL[1], Format::Rgb);
    for (x, y, _) in image.clone().pixels() {
        let (mut once, mut twice) = (0, 0);
        for &corners in triangles {
            let mask = coverage(corners, IVec2::new(x, y), pattern(samples));
            twice |= once & mask;
            once |= mask;
        }
        let [red, green] = [once, twice].map(|mask| (mask.count_ones() * 15).min(255) as u8);
        image.set(x, y, Color::rgb(red, green, 0));
    }
    image
}

/// Triangles about a sample, to the same sample in other pixels: their sides pass through more of these.
fn fan(rng: &mut Rng, samples: usize) -> Task<Antialiasing> {
    let places = pattern(samples);
    let [x, y] = places[rng.usize(..samples)];
    let middle =
        Vec2::new(rng.i32(20..28) as f32, rng.i32(17..23) as f32) + Vec2::new(x as f32, y as f32) / 16.0;
    let ring: Vec<Vec2> = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)]
        .map(|(x, y)| {
            // Longer ways that are the multiple of a short one lead through samples.
            let [far, near] = [rng.i32(4..9), rng.i32(2..4)];
            let way = if x == 0 || y == 0 {
                IVec2::new(x * 2 * far, y * 2 * far)
            } else {
                IVec2::new(x * 2 * near, y * far)
            };
            middle + way.as_vec2()
        })
        .into();
    let triangles: Vec<[Vec2; 3]> = (0..ring.len())
        .map(|n| {
            let mut corners = [middle, ring[n], ring[(n + 1) % ring.len()]];
            rng.shuffle(&mut corners);
            corners
        })
        .collect();
    let list: Vec<String> = triangles.iter().map(Code::code).collect();
    let code = format!(
        "let triangles = [{}];\nlet got = antialiasing_tasks::counts(&triangles, {samples}, coverage);",
        list.join(", ")
    );
    let shapes: Vec<Shape> =
        triangles.iter().map(|corners| corners.map(|corner| corner.extend(0.0)).into()).collect();
    let input = format!("8 triangles about {}, {samples} samples", middle.code());
    Task::new(input, code, move |student: &Antialiasing| {
        Raw::Picture(counts(&triangles, samples, student.coverage))
    })
    .of(move |_| shapes.clone())
}

fn mean(samples: Vec<Color>) -> Task<Antialiasing> {
    let list: Vec<String> = samples.iter().map(color_code).collect();
    let call = format!("resolve(&[{}])", list.join(", "));
    let code = format!("let Color {{ r, g, b, a }} = {call};\nlet got = [r, g, b, a].map(f32::from);");
    Task::new(call, code, move |student: &Antialiasing| {
        let Color { r, g, b, a } = (student.resolve)(&samples);
        Raw::value([r, g, b, a].map(f32::from))
    })
}

/// Spokes of any colour about a point, each thinner than a pixel at its end.
#[must_use]
pub fn spokes(seed: u64) -> Vec<([Vec2; 3], Color)> {
    let mut rng = Rng::with_seed(seed);
    let [width, height] = SIZE.map(f32::from);
    let middle = Vec2::new(width * (0.3 + 0.4 * rng.f32()), height * (0.3 + 0.4 * rng.f32()));
    let turn = rng.f32();
    let spoke = |n: u8| {
        let way = Vec2::from_angle((f32::from(n) + turn) * std::f32::consts::TAU / 24.0);
        let far = middle + way * (40.0 + 20.0 * rng.f32());
        let wide = way.perp() * (0.5 + 3.0 * rng.f32());
        let color = Color { a: 255, ..any_color(&mut rng) };
        ([middle, far - wide, far + wide].map(rounded), color)
    };
    (0..24).map(spoke).collect()
}

fn wheel(samples: usize, seed: u64) -> Task<Antialiasing> {
    let [width, height] = SIZE;
    let code = format!(
        "let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         draw(&antialiasing_tasks::spokes({seed}), pattern({samples}), coverage, resolve, &mut got);"
    );
    let input = format!("a wheel of 24 spokes, {samples} samples, {width}x{height}");
    let shapes: Vec<Shape> =
        spokes(seed).iter().map(|(corners, _)| corners.map(|corner| corner.extend(0.0)).into()).collect();
    Task::new(input, code, move |student: &Antialiasing| {
        let mut image = canvas(width, height);
        draw(&spokes(seed), pattern(samples), student.coverage, student.resolve, &mut image);
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}
