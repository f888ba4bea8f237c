//! Mission 6: smooth shading.

pub use gouraud_given as given;

use common::{Bounds, Color, Image, Model, Vec3};
use fastrand::Rng;
use given::{Scene, corner_normals};
use tasks::scenery::{MODEL, MODEL_CODE, Square, TEXTURE, TEXTURE_CODE, canvas, direction};
use tasks::scenery::{light, squares, squares_code, wide};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};
use zbuffer::DepthBuffer;

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Gouraud {
    /// The lesson's `intensities`.
    pub intensities: fn([Vec3; 3], Vec3) -> Vec3,
    /// The lesson's `gouraud`.
    pub gouraud: Draw,
}

/// What a drawing leaves behind.
pub type Drawn = given::Drawn<DepthBuffer<f32>>;

/// The depths of a drawing, whatever they were kept in: that depends on whose lesson 4 a student builds on.
pub fn kept(bounds: Bounds, depth: impl Fn(i32, i32) -> f32) -> DepthBuffer<f32> {
    let image = canvas((bounds.max.x + 1) as u16, (bounds.max.y + 1) as u16);
    let mut depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
    image.pixels().for_each(|(x, y, _)| depths.set(x, y, depth(x, y)));
    depths
}

/// A scene, a picture, and where a point lands in it.
pub type Draw = fn(&Scene, &mut Image, &dyn Fn(Vec3) -> Option<Vec3>) -> Drawn;

/// The mission.
pub const MISSION: Mission<Gouraud> = Mission {
    lesson: "06-gouraud",
    checks: &[
        Check {
            name: "corners",
            asks: "the cosine between normal and light at each corner, below 0 in the dark",
            points: 2,
            tasks: |rng| {
                let mut task = || {
                    let (normals, light) = ([(); 3].map(|()| direction(rng)), direction(rng));
                    let call = format!("intensities({}, {})", normals.code(), light.code());
                    Task::call("", call, move |student: &Gouraud| {
                        Raw::value((student.intensities)(normals, light).to_array())
                    })
                };
                (0..8).map(|_| task()).collect()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "two sides",
            asks: "two white squares; the left one faces the light, the right one faces away and is black",
            points: 1,
            tasks: |rng| {
                let z = 0.6 + 0.3 * rng.f32();
                let half =
                    |left, normal| Square { place: [left, -0.5, left + 0.5, 0.5, 0.0], normals: [normal; 4] };
                vec![drawing("two squares", &[half(-0.75, tilted(z)), half(0.25, tilted(-z))])]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "between",
            asks: "the brightness is interpolated and only then clamped at 0: the dark begins inside the square",
            points: 2,
            tasks: |rng| {
                let normals = [0.85, -0.6, -0.2, 0.5].map(|z| tilted(z + 0.1 * rng.f32()));
                vec![drawing("one square", &[Square { place: [-0.8, -0.8, 0.8, 0.8, 0.0], normals }])]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "left out",
            asks: "triangles with a corner that has no place are left out and counted",
            points: 1,
            tasks: |rng| {
                let count = |drawn: Drawn, _| Raw::value([drawn.left_out as f32]);
                vec![cut(rng, "drawn.left_out", count), cut(rng, "drawn.left_out", count)]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "depths",
            asks: "the depths that the drawing leaves behind",
            points: 1,
            tasks: |rng| {
                let depths =
                    |drawn: &Drawn, _| Raw::depths(drawn.depths.bounds(), |x, y| drawn.depths.get(x, y));
                vec![whole(rng, "drawn.depths", depths)]
            },
            precision: Precision { tolerance: 1e-3, ..Precision::MODEL },
        },
        Check {
            name: "picture",
            asks: "the model with a texture, smoothly shaded",
            points: 3,
            tasks: |rng| {
                vec![
                    whole(rng, "image", |_, image| Raw::Picture(image)),
                    cut(rng, "image", |_, image| Raw::Picture(image)),
                ]
            },
            precision: Precision::MODEL,
        },
    ],
};

/// A normal at whose corner the brightness is z, under a light from the front.
fn tilted(z: f32) -> Vec3 {
    Vec3::new((1.0 - z * z).sqrt(), 0.0, z)
}

/// The course's model and texture, under a light.
fn scene(normals: &[[Vec3; 3]], light: Vec3) -> Scene<'_> {
    Scene { model: &MODEL, normals, texture: &TEXTURE, light }
}

/// The triangles of a model in a picture.
fn shapes(model: &Model, [width, height]: [u16; 2]) -> Vec<Shape> {
    let size = canvas(width, height).size();
    model.faces().map(|corners| corners.map(|corner| zbuffer::to_screen(corner, size)).into()).collect()
}

/// Draws squares in white, under a light from the front.
fn drawing(input: &str, four: &[Square]) -> Task<Gouraud> {
    let code = format!(
        "{}let mut texture = Image::new(1, 1, Format::Rgb);\ntexture.set(0, 0, Color::WHITE);\n\
         let mut got = Image::new(80, 80, Format::Rgb);\nlet size = got.size();\n\
         let normals = corner_normals(&model);\n\
         let scene = Scene {{ model: &model, normals: &normals, texture: &texture, light: Vec3::Z }};\n\
         gouraud(&scene, &mut got, |p| Some(zbuffer::to_screen(p, size)));",
        squares_code(four)
    );
    let model = squares(four);
    let shapes = shapes(&model, [80, 80]);
    let mut white = canvas(1, 1);
    white.set(0, 0, Color::WHITE);
    Task::new(input, code, move |student: &Gouraud| {
        let mut image = canvas(80, 80);
        let size = image.size();
        let normals = corner_normals(&model);
        let scene = Scene { model: &model, normals: &normals, texture: &white, light: Vec3::Z };
        (student.gouraud)(&scene, &mut image, &|p| Some(zbuffer::to_screen(p, size)));
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}

/// Draws the course's model.
fn whole(rng: &mut Rng, code: &str, result: fn(&Drawn, Image) -> Raw) -> Task<Gouraud> {
    let (sides, light) = (wide(rng), light(rng));
    let before = whole_code(sides, light, "|p| Some(zbuffer::to_screen(p, size))");
    let input = format!("the model, {}x{}", sides[0], sides[1]);
    Task::new(input, format!("{before}let got = {};", part(code)), move |student: &Gouraud| {
        let mut image = canvas(sides[0], sides[1]);
        let size = image.size();
        let drawn = (student.gouraud)(&scene(&corner_normals(&MODEL), light), &mut image, &|p| {
            Some(zbuffer::to_screen(p, size))
        });
        result(&drawn, image)
    })
    .of(move |_| shapes(&MODEL, sides))
}

/// Draws the part of the model that is left of some x.
fn cut(rng: &mut Rng, code: &str, result: fn(Drawn, Image) -> Raw) -> Task<Gouraud> {
    let right = rng.f32() * 0.3 - 0.1;
    let (sides, light) = (wide(rng), light(rng));
    let before =
        whole_code(sides, light, &format!("|p| (p.x < {right}).then(|| zbuffer::to_screen(p, size))"));
    let input = format!("{code} of the model without its part right of x = {right}");
    Task::new(input, format!("{before}let got = {};", part(code)), move |student: &Gouraud| {
        let mut image = canvas(sides[0], sides[1]);
        let size = image.size();
        let place = |p: Vec3| (p.x < right).then(|| zbuffer::to_screen(p, size));
        let drawn = (student.gouraud)(&scene(&corner_normals(&MODEL), light), &mut image, &place);
        result(drawn, image)
    })
    .of(move |_| shapes(&MODEL, sides))
}

/// `drawn` and `image`, of which one is judged.
fn part(code: &str) -> &str {
    if code == "image" { "(drawn, image).1" } else { code }
}

/// The course's model, drawn, as Rust.
fn whole_code([width, height]: [u16; 2], light: Vec3, place: &str) -> String {
    format!(
        "{MODEL_CODE}{TEXTURE_CODE}let normals = corner_normals(&model);\n\
         let scene = Scene {{ model: &model, normals: &normals, texture: &texture, light: {} }};\n\
         let mut image = Image::new({width}, {height}, Format::Rgb);\nlet size = image.size();\n\
         let drawn = gouraud(&scene, &mut image, {place});\n",
        light.code()
    )
}
