//! Mission 6: smooth shading.

use common::{Color, Image, Model, Vec3};
use fastrand::Rng;
use gouraud::{Drawn, Scene, Wrap, corner_normals};
use tasks::scenery::{LIGHT, MODEL, MODEL_CODE, SIDE, Square, TEXTURE, TEXTURE_CODE, canvas, direction};
use tasks::scenery::{squares, squares_code};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Gouraud {
    /// The lesson's `intensities`.
    pub intensities: fn([Vec3; 3], Vec3) -> Vec3,
    /// The lesson's `gouraud`.
    pub gouraud: Draw,
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
            tasks: |_| {
                let half =
                    |left, normal| Square { place: [left, -0.5, left + 0.5, 0.5, 0.0], normals: [normal; 4] };
                vec![drawing(
                    "two squares",
                    &[half(-0.75, Vec3::new(0.6, 0.0, 0.8)), half(0.25, Vec3::new(0.8, 0.0, -0.6))],
                )]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "between",
            asks: "the brightness is interpolated and only then clamped at 0: the dark begins inside the square",
            points: 2,
            tasks: |rng| {
                let mut tilted = |z: f32| {
                    let z = z + 0.1 * rng.f32();
                    Vec3::new((1.0 - z * z).sqrt(), 0.0, z)
                };
                let normals = [tilted(0.85), tilted(-0.6), tilted(-0.2), tilted(0.5)];
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
            tasks: |_| {
                let depths =
                    |drawn: &Drawn, _| Raw::depths(drawn.depths.bounds(), |x, y| drawn.depths.get(x, y));
                vec![whole("drawn.depths", depths)]
            },
            precision: Precision { tolerance: 1e-3, ..Precision::MODEL },
        },
        Check {
            name: "picture",
            asks: "the model with a texture, smoothly shaded",
            points: 3,
            tasks: |rng| {
                vec![
                    whole("image", |_, image| Raw::Picture(image)),
                    cut(rng, "image", |_, image| Raw::Picture(image)),
                ]
            },
            precision: Precision::MODEL,
        },
    ],
};

/// The course's model, texture and light.
fn scene(normals: &[[Vec3; 3]]) -> Scene<'_> {
    Scene { model: &MODEL, normals, texture: &TEXTURE, wrap: Wrap::Clamp, light: LIGHT }
}

/// The triangles of a model in a square picture.
fn shapes(model: &Model, side: u16) -> Vec<Shape> {
    let size = canvas(side, side).size();
    model.faces().map(|corners| corners.map(|corner| zbuffer::to_screen(corner, size)).into()).collect()
}

/// Draws squares in white, under a light from the front.
fn drawing(input: &str, four: &[Square]) -> Task<Gouraud> {
    let code = format!(
        "{}let mut texture = Image::new(1, 1, Format::Rgb);\ntexture.set(0, 0, Color::WHITE);\n\
         let mut got = Image::new(80, 80, Format::Rgb);\nlet size = got.size();\n\
         let normals = corner_normals(&model);\n\
         let scene = Scene {{ model: &model, normals: &normals, texture: &texture, wrap: gouraud::Wrap::Clamp, light: Vec3::Z }};\n\
         gouraud(&scene, &mut got, |p| Some(zbuffer::to_screen(p, size)));",
        squares_code(four)
    );
    let model = squares(four);
    let shapes = shapes(&model, 80);
    let mut white = canvas(1, 1);
    white.set(0, 0, Color::WHITE);
    Task::new(input, code, move |student: &Gouraud| {
        let mut image = canvas(80, 80);
        let size = image.size();
        let normals = corner_normals(&model);
        let scene =
            Scene { model: &model, normals: &normals, texture: &white, wrap: Wrap::Clamp, light: Vec3::Z };
        (student.gouraud)(&scene, &mut image, &|p| Some(zbuffer::to_screen(p, size)));
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}

/// Draws the course's model.
fn whole(code: &str, result: fn(&Drawn, Image) -> Raw) -> Task<Gouraud> {
    let before = whole_code("|p| Some(zbuffer::to_screen(p, size))");
    Task::new("the model", format!("{before}let got = {};", part(code)), move |student: &Gouraud| {
        let mut image = canvas(SIDE, SIDE);
        let size = image.size();
        let drawn = (student.gouraud)(&scene(&corner_normals(&MODEL)), &mut image, &|p| {
            Some(zbuffer::to_screen(p, size))
        });
        result(&drawn, image)
    })
    .of(|_| shapes(&MODEL, SIDE))
}

/// Draws the part of the model that is left of some x.
fn cut(rng: &mut Rng, code: &str, result: fn(Drawn, Image) -> Raw) -> Task<Gouraud> {
    let right = rng.f32() * 0.3 - 0.1;
    let before = whole_code(&format!("|p| (p.x < {right}).then(|| zbuffer::to_screen(p, size))"));
    let input = format!("{code} of the model without its part right of x = {right}");
    Task::new(input, format!("{before}let got = {};", part(code)), move |student: &Gouraud| {
        let mut image = canvas(SIDE, SIDE);
        let size = image.size();
        let place = |p: Vec3| (p.x < right).then(|| zbuffer::to_screen(p, size));
        let drawn = (student.gouraud)(&scene(&corner_normals(&MODEL)), &mut image, &place);
        result(drawn, image)
    })
    .of(|_| shapes(&MODEL, SIDE))
}

/// `drawn` and `image`, of which one is judged.
fn part(code: &str) -> &str {
    if code == "image" { "(drawn, image).1" } else { code }
}

/// The course's model, drawn, as Rust.
fn whole_code(place: &str) -> String {
    format!(
        "{MODEL_CODE}{TEXTURE_CODE}let normals = corner_normals(&model);\n\
         let scene = Scene {{ model: &model, normals: &normals, texture: &texture, wrap: gouraud::Wrap::Clamp, light: {} }};\n\
         let mut image = Image::new({SIDE}, {SIDE}, Format::Rgb);\nlet size = image.size();\n\
         let drawn = gouraud(&scene, &mut image, {place});\n",
        LIGHT.code()
    )
}
