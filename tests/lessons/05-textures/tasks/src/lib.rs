//! Mission 5: colour from a picture.

use common::{Bounds, Color, Image, Model, Vec2, Vec3};
use fastrand::Rng;
use tasks::scenery::{MODEL, MODEL_CODE, TEXTURE, TEXTURE_CODE, canvas, light, signed, wide};
use tasks::{Check, Code, Mission, Precision, Raw, Task};
use zbuffer::DepthBuffer;

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Textures {
    /// The lesson's `texel`.
    pub texel: fn(&Image, Vec2) -> Color,
    /// The lesson's `interpolate`.
    pub interpolate: fn([Vec2; 3], Vec3) -> Vec2,
    /// The lesson's `draw_textured`.
    pub draw_textured: Draw,
}

/// A model, the light, a picture, and the colour at (u, v).
pub type Draw = fn(&Model, Vec3, &mut Image, &dyn Fn(Vec2) -> Color) -> DepthBuffer<f32>;

/// The depths of a drawing, whatever they were kept in: that depends on whose lesson 4 a student builds on.
pub fn kept(bounds: Bounds, depth: impl Fn(i32, i32) -> f32) -> DepthBuffer<f32> {
    let image = canvas((bounds.max.x + 1) as u16, (bounds.max.y + 1) as u16);
    let mut depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
    image.pixels().for_each(|(x, y, _)| depths.set(x, y, depth(x, y)));
    depths
}

/// Width and height of the small texture.
const TEXELS: [u16; 2] = [16, 12];

/// The mission.
pub const MISSION: Mission<Textures> = Mission {
    lesson: "05-textures",
    checks: &[
        Check {
            name: "texels",
            asks: "the middle of a texel; red is 16 times its column, green 16 times its row",
            points: 2,
            tasks: |rng| (0..8).map(|_| looked_up(TEXELS, inside(rng, [0.5, 0.5]))).collect(),
            precision: Precision::EXACT,
        },
        Check {
            name: "within",
            asks: "all of a texel has its colour, not only the middle",
            points: 1,
            tasks: |rng| {
                let place = |rng: &mut Rng| [0.1 + 0.8 * rng.f32(), 0.6 + 0.3 * rng.f32()];
                let mut tasks = Vec::new();
                for _ in 0..4 {
                    let [a, b] = place(rng);
                    tasks.extend([[a, b], [b, a]].map(|within| looked_up(TEXELS, inside(rng, within))));
                }
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "border",
            asks: "at u = 1, v = 1 and outside: the nearest texel; without texels, black",
            points: 2,
            tasks: |rng| {
                let Vec2 { x, y } = inside(rng, [0.5, 0.5]);
                let beyond = 1.0 + rng.f32();
                let places =
                    [(1.0, y), (x, 1.0), (1.0, 1.0), (0.0, 0.0), (-beyond, y), (x, -beyond), (beyond, y)];
                let more = [(x, beyond), (-0.01, y), (x, -0.01), (beyond, -beyond)];
                let of = |size: [u16; 2]| move |(u, v)| looked_up(size, Vec2::new(u, v));
                let mut tasks: Vec<_> = places.into_iter().chain(more).map(of(TEXELS)).collect();
                tasks.extend([(0.0, 0.5), (0.7, 0.7), (1.0, 1.0), (-1.5, beyond)].map(of([1, 1])));
                tasks.push(of([0, 0])((0.5, 0.5)));
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "interpolate",
            asks: "the mean of three corners' (u, v), each with its weight",
            points: 1,
            tasks: |rng| (0..8).map(|_| interpolated(uvs(rng), weights(rng))).collect(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "coordinates",
            asks: "the model with u in red and v in green, flat-shaded",
            points: 1,
            tasks: |rng| {
                let code = "|uv| Color::rgb((uv.x * 255.0) as u8, (uv.y * 255.0) as u8, 64)";
                let color =
                    |_: &Textures, uv: Vec2| Color::rgb((uv.x * 255.0) as u8, (uv.y * 255.0) as u8, 64);
                vec![model(rng, code, color, |image, _| Raw::Picture(image))]
            },
            precision: Precision::MODEL,
        },
        Check {
            name: "depths",
            asks: "the depths that the drawing leaves behind",
            points: 1,
            tasks: |rng| {
                let depths =
                    |_, depths: &DepthBuffer<f32>| Raw::depths(depths.bounds(), |x, y| depths.get(x, y));
                vec![model(rng, "|_| Color::WHITE", |_, _| Color::WHITE, depths)]
            },
            precision: Precision { tolerance: 1e-3, ..Precision::MODEL },
        },
        Check {
            name: "picture",
            asks: "the model with a texture, flat-shaded",
            points: 2,
            tasks: |rng| {
                let color = |student: &Textures, uv| (student.texel)(&TEXTURE, uv);
                vec![model(rng, "|uv| texel(&texture, uv)", color, |image, _| Raw::Picture(image))]
            },
            precision: Precision::MODEL,
        },
    ],
};

/// The (u, v) of a place in some texel.
fn inside(rng: &mut Rng, within: [f32; 2]) -> Vec2 {
    let [u, v] = [0, 1].map(|n| (f32::from(rng.u16(0..TEXELS[n])) + within[n]) / f32::from(TEXELS[n]));
    Vec2::new(u, v)
}

/// The colour at a place in a texture whose texels say where they are.
fn looked_up([width, height]: [u16; 2], uv: Vec2) -> Task<Textures> {
    let before = format!(
        "let mut texture = Image::new({width}, {height}, Format::Rgb);\n\
         for (x, y, _) in texture.clone().pixels() {{\n    \
         texture.set(x, y, Color::rgb(16 * x as u8, 16 * y as u8, 99));\n}}\n"
    );
    let mut texture = canvas(width, height);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::rgb(16 * x as u8, 16 * y as u8, 99));
    }
    let task = Task::call(&before, format!("texel(&texture, {})", uv.code()), move |student: &Textures| {
        let Color { r, g, b, .. } = (student.texel)(&texture, uv);
        Raw::value([r, g, b].map(f32::from))
    });
    Task { input: format!("texel(a texture of {width}x{height}, {})", uv.code()), ..task }
}

/// The mean of three corners' (u, v).
fn interpolated(uvs: [Vec2; 3], weights: Vec3) -> Task<Textures> {
    let call = format!("interpolate({}, {})", uvs.code(), weights.code());
    Task::call("", call, move |student: &Textures| Raw::value((student.interpolate)(uvs, weights).to_array()))
}

/// The model in colours that depend on (u, v).
fn model(
    rng: &mut Rng,
    code: &str,
    color: fn(&Textures, Vec2) -> Color,
    result: fn(Image, &DepthBuffer<f32>) -> Raw,
) -> Task<Textures> {
    let texture = if code.contains("&texture") { TEXTURE_CODE } else { "" };
    let ([width, height], light) = (wide(rng), light(rng));
    let call = format!("draw_textured(&model, light, &mut image, {code})");
    let code = format!(
        "{MODEL_CODE}{texture}let light = {};\nlet mut image = Image::new({width}, {height}, Format::Rgb);\n\
         let depths = {call};\nlet got = {};",
        light.code(),
        if code.contains("WHITE") { "depths" } else { "{ let _ = depths; image }" }
    );
    Task::new(format!("the model, {width}x{height}"), code, move |student: &Textures| {
        let mut image = canvas(width, height);
        let depths = (student.draw_textured)(&MODEL, light, &mut image, &|uv| color(student, uv));
        result(image, &depths)
    })
    .of(move |_| {
        let size = Vec2::new(width.into(), height.into());
        let lit = MODEL.faces().filter(|&corners| triangles::flat_intensity(corners, light) >= 0.0);
        lit.map(|corners| corners.map(|corner| zbuffer::to_screen(corner, size)).into()).collect()
    })
}

fn uvs(rng: &mut Rng) -> [Vec2; 3] {
    [(); 3].map(|()| Vec2::new(signed(rng), signed(rng)))
}

/// Three weights, each at least 0, that add up to 1.
fn weights(rng: &mut Rng) -> Vec3 {
    let weights = Vec3::new(rng.f32(), rng.f32(), rng.f32() + 0.1);
    weights / weights.element_sum()
}
