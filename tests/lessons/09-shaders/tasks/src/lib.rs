//! Mission 9: shaders.

pub use shaders_given as given;

use common::{Color, Mat4, Model, Vec2, Vec3};
use fastrand::Rng;
use given::{Framebuffer, Uniforms, fit};
use gouraud::corner_normals;
use tasks::scenery::{
    MODEL, MODEL_CODE, SIDE, Square, TEXTURE, TEXTURE_CODE, canvas, light, squares, squares_code,
};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

/// What the student writes, as four looks.
#[derive(Clone, Copy)]
pub struct Shaders {
    /// White, under `Gouraud`.
    pub gouraud: Draw,
    /// `Texture`, under `Gouraud`.
    pub gouraud_texture: Draw,
    /// White, under `Quantized`.
    pub quantized: Draw,
    /// `Texture`, under `Quantized`.
    pub quantized_texture: Draw,
}

/// Draws with a look.
pub type Draw = fn(&Uniforms, &mut Framebuffer);

/// One of them, and its source and lighting as Rust.
type Look = (fn(&Shaders) -> Draw, &'static str);

const GOURAUD: Look = (|student| student.gouraud, "shaders_given::White, Gouraud");
const GOURAUD_TEXTURE: Look = (|student| student.gouraud_texture, "Texture, Gouraud");
const QUANTIZED: Look = (|student| student.quantized, "shaders_given::White, Quantized");
const QUANTIZED_TEXTURE: Look = (|student| student.quantized_texture, "Texture, Quantized");

/// The mission.
pub const MISSION: Mission<Shaders> = Mission {
    lesson: "09-shaders",
    checks: &[
        Check {
            name: "gouraud",
            asks: "white squares, of which one faces away and is not drawn, and one is dark on a side only",
            points: 2,
            tasks: |rng| {
                vec![
                    drawn("two squares", Scene::new(&two_sides(), GOURAUD), COLORS),
                    drawn("one square", Scene::new(&[half_dark(rng)], GOURAUD), COLORS),
                    drawn(
                        "one square, lit from the right",
                        Scene { light: Vec3::new(0.6, 0.0, 0.8), ..Scene::new(&[half_dark(rng)], GOURAUD) },
                        COLORS,
                    ),
                ]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "dropped",
            asks: "what faces away is dropped: it leaves no depth behind",
            points: 1,
            tasks: |rng| {
                vec![
                    drawn("two squares", Scene::new(&two_sides(), GOURAUD), DEPTHS),
                    drawn("one square", Scene::new(&[half_dark(rng)], GOURAUD), DEPTHS),
                ]
            },
            precision: Precision { tolerance: 1e-3, strays: 0 },
        },
        Check {
            name: "texture",
            asks: "a square with a texture of 16 texels; without a texture it is black",
            points: 2,
            tasks: |rng| {
                let tilted = Vec3::new(0.8, 0.0, 0.6);
                let square = [Square { place: WIDE, normals: [Vec3::Z, tilted, tilted, Vec3::Z] }];
                let scene = Scene::new(&square, GOURAUD_TEXTURE);
                let textured = Scene { texture: Some([4, 4, rng.u16(64..200)]), ..scene.clone() };
                let bright =
                    Scene { texture: Some([1, 1, rng.u16(80..120)]), light: Vec3::Z * 1.7, ..scene.clone() };
                vec![
                    drawn("a square with a texture", textured, COLORS),
                    drawn("a square without a texture", scene, COLORS),
                    drawn("a grey square under a light 1.7 long", bright, COLORS),
                ]
            },
            precision: Precision { tolerance: 2.0, strays: 20 },
        },
        Check {
            name: "steps",
            asks: "squares of different brightness i, in steps of ⌊N·min(i, 1)⌋ / N",
            points: 3,
            tasks: |rng| {
                let white = |levels| {
                    let squares = [1, 2, 3, 4].map(|step| step_up(step, levels));
                    let input = format!("four squares, {levels} levels");
                    drawn(&input, Scene { levels, ..Scene::new(&squares, QUANTIZED) }, COLORS)
                };
                // Brighter than white is possible under a light that is longer than 1.
                let scene = Scene::new(&[Square { place: WIDE, normals: [Vec3::Z; 4] }], QUANTIZED_TEXTURE);
                let grey = Some([1, 1, rng.u16(80..120)]);
                let bright = Scene { texture: grey, light: Vec3::Z * 1.7, levels: 5, ..scene };
                vec![
                    white(5),
                    white(rng.u16(6..9)),
                    drawn(
                        "a square",
                        Scene { levels: 5, ..Scene::new(&[half_dark(rng)], QUANTIZED) },
                        COLORS,
                    ),
                    drawn("a grey square under a light 1.7 long", bright, COLORS),
                    drawn("the depths of a square", Scene::new(&[half_dark(rng)], QUANTIZED), DEPTHS),
                ]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "picture",
            asks: "the model, with a texture and in steps",
            points: 2,
            tasks: |rng| [GOURAUD_TEXTURE, QUANTIZED].map(|look| model(rng, look)).into(),
            precision: Precision::MODEL,
        },
    ],
};

/// Levels of the quantized shader on the model.
const STEPS: u16 = 5;

/// Width and height of the picture of squares.
const SMALL: u16 = 80;

/// A square that nearly fills the picture.
const WIDE: [f32; 5] = [-0.8, -0.8, 0.8, 0.8, 0.0];

/// A square that faces the light and one that faces away.
fn two_sides() -> [Square; 2] {
    let half = |left, normal| Square { place: [left, -0.5, left + 0.5, 0.5, 0.0], normals: [normal; 4] };
    [half(-0.75, Vec3::new(0.6, 0.0, 0.8)), half(0.25, Vec3::new(0.8, 0.0, -0.6))]
}

/// A normal at whose corner the brightness is z, under a light from the front.
fn tilted(z: f32) -> Vec3 {
    Vec3::new((1.0 - z * z).sqrt(), 0.0, z)
}

/// A square of which one side is in the dark.
fn half_dark(rng: &mut Rng) -> Square {
    let mut at = |z: f32| tilted(z + 0.1 * rng.f32());
    Square { place: WIDE, normals: [at(0.85), at(-0.6), at(-0.3), at(0.5)] }
}

/// A square whose brightness is three quarters of a step above a step.
fn step_up(step: u8, levels: u16) -> Square {
    let left = f32::from(step) * 0.5 - 1.4;
    let normals = [tilted((f32::from(step) + 0.75) / f32::from(levels)); 4];
    Square { place: [left, -0.8, left + 0.4, 0.8, 0.0], normals }
}

/// Squares, a look, and what the look reads.
#[derive(Clone)]
struct Scene {
    squares: Model,
    code: String,
    look: Look,
    /// Width, height, and the blue of all texels; red and green are 60 times column and row.
    texture: Option<[u16; 3]>,
    light: Vec3,
    levels: u16,
}

impl Scene {
    fn new(list: &[Square], look: Look) -> Self {
        Self {
            squares: squares(list),
            code: squares_code(list),
            look,
            texture: None,
            light: Vec3::Z,
            levels: STEPS,
        }
    }
}

/// What is judged of a drawing, and as Rust.
type Result = (fn(Framebuffer) -> Raw, &'static str);

const COLORS: Result = (|target| Raw::Picture(target.image), "target.image");
const DEPTHS: Result =
    (|target| Raw::depths(target.depths.bounds(), |x, y| target.depths.get(x, y)), "target.depths");

/// Draws squares.
fn drawn(input: &str, scene: Scene, result: Result) -> Task<Shaders> {
    let light = scene.light;
    let texture = scene.texture.map(|[width, height, blue]| {
        let mut texture = canvas(width, height);
        for (x, y, _) in texture.clone().pixels() {
            texture.set(x, y, Color::rgb(60 * x as u8, 60 * y as u8, blue as u8));
        }
        texture
    });
    let mut code = scene.code;
    if let Some([width, height, blue]) = scene.texture {
        code += &format!(
            "let mut texture = Image::new({width}, {height}, Format::Rgb);\n\
             for (x, y, _) in texture.clone().pixels() {{\n    \
             texture.set(x, y, Color::rgb(60 * x as u8, 60 * y as u8, {blue}));\n}}\n"
        );
    }
    code += &format!(
        "let normals = gouraud::corner_normals(&model);\nlet uniforms = Uniforms {{\n    normals: &normals,\n    \
         texture: {},\n    light: {},\n    levels: {},\n    ..Uniforms::new(&model)\n}};\n\
         let mut target = shaders_given::Framebuffer::new(Image::new({SMALL}, {SMALL}, Format::Rgb));\n\
         shaders_given::draw(&uniforms, {}, &mut target);\nlet got = {};",
        if texture.is_some() { "Some(&texture)" } else { "None" },
        light.code(),
        scene.levels,
        scene.look.1,
        result.1
    );
    let (model, look, levels) = (scene.squares, scene.look.0, scene.levels);
    let shapes = shapes(&model, Mat4::IDENTITY, SMALL);
    Task::new(input, code, move |student: &Shaders| {
        let mut target = Framebuffer::new(canvas(SMALL, SMALL));
        let normals = corner_normals(&model);
        let texture = texture.as_ref();
        let uniforms = Uniforms { normals: &normals, texture, light, levels, ..Uniforms::new(&model) };
        look(student)(&uniforms, &mut target);
        (result.0)(target)
    })
    .of(move |_| shapes.clone())
}

/// The triangles of a model in a square picture.
fn shapes(model: &Model, to_clip: Mat4, side: u16) -> Vec<Shape> {
    let half = f32::from(side) / 2.0;
    let place = |p: Vec3| {
        let p = to_clip * p.extend(1.0);
        Vec3::new(p.x / p.w * half + half, p.y / p.w * half + half, p.z / p.w)
    };
    model.faces().map(|corners| corners.map(place).into()).collect()
}

/// The course's model.
fn model(rng: &mut Rng, (look, code): Look) -> Task<Shaders> {
    let (zoom, light) = (0.4 + 0.1 * rng.f32(), light(rng));
    let input = format!("the model under {}", code.trim_start_matches("shaders_given::"));
    let code = format!(
        "{MODEL_CODE}{TEXTURE_CODE}let normals = gouraud::corner_normals(&model);\n\
         let uniforms = Uniforms {{\n    normals: &normals,\n    texture: Some(&texture),\n    light: {},\n    \
         to_clip: shaders_given::fit({}, Vec2::ONE),\n    levels: {STEPS},\n    ..Uniforms::new(&model)\n}};\n\
         let mut target = shaders_given::Framebuffer::new(Image::new({SIDE}, {SIDE}, Format::Rgb));\n\
         shaders_given::draw(&uniforms, {code}, &mut target);\nlet got = target.image;",
        light.code(),
        zoom.code()
    );
    Task::new(input, code, move |student: &Shaders| {
        let mut target = Framebuffer::new(canvas(SIDE, SIDE));
        let uniforms = Uniforms {
            normals: &corner_normals(&MODEL),
            texture: Some(&TEXTURE),
            light,
            to_clip: fit(zoom, Vec2::ONE),
            levels: STEPS,
            ..Uniforms::new(&MODEL)
        };
        look(student)(&uniforms, &mut target);
        Raw::Picture(target.image)
    })
    .of(move |_| shapes(&MODEL, fit(zoom, Vec2::ONE), SIDE))
}
