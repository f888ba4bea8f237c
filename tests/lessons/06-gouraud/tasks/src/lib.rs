//! Mission 6: smooth shading.

use common::{Color, Image, Model, Vec3};
use gouraud::{Drawn, Scene, Wrap, corner_normals};
use tasks::scenery::{LIGHT, MODEL, SIDE, Square, TEXTURE, canvas, direction, squares};
use tasks::{Check, Mission, Precision, Raw, Task};

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
                let input: Vec<_> = (0..8)
                    .map(|_| ([direction(rng), direction(rng), direction(rng)], direction(rng)))
                    .collect();
                vec![Task::new("normals and lights", move |student: &Gouraud| {
                    Raw::rows(
                        input
                            .iter()
                            .map(|&(normals, light)| (student.intensities)(normals, light).to_array()),
                    )
                })]
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
                let model = squares(&[half(-0.75, Vec3::Z), half(0.25, Vec3::NEG_Z)]);
                vec![drawing("two squares", model, Vec3::Z)]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "between",
            asks: "the brightness is interpolated and only then clamped at 0: the dark begins inside the square",
            points: 2,
            tasks: |_| {
                let tilted = |z: f32| Vec3::new((1.0 - z * z).sqrt(), 0.0, z);
                let normals = [tilted(0.9), tilted(-0.6), tilted(-0.2), tilted(0.5)];
                vec![drawing(
                    "one square",
                    squares(&[Square { place: [-0.8, -0.8, 0.8, 0.8, 0.0], normals }]),
                    Vec3::Z,
                )]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "left out",
            asks: "triangles with a corner that has no place are left out and counted",
            points: 1,
            tasks: |_| {
                vec![Task::new("the model without its right half", |student: &Gouraud| {
                    let mut image = canvas(SIDE, SIDE);
                    let size = image.size();
                    let place = |p: Vec3| (p.x < 0.1).then(|| zbuffer::to_screen(p, size));
                    Raw::rows([[course(student, &mut image, &place).left_out as f32]])
                })]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "depths",
            asks: "the depths that the drawing leaves behind",
            points: 1,
            tasks: |_| {
                vec![whole(|drawn, _| Raw::depths(drawn.depths.bounds(), |x, y| drawn.depths.get(x, y)))]
            },
            precision: Precision { tolerance: 1e-3, ..Precision::MODEL },
        },
        Check {
            name: "picture",
            asks: "the model with a texture, smoothly shaded",
            points: 3,
            tasks: |_| vec![whole(|_, image| Raw::Picture(image))],
            precision: Precision::MODEL,
        },
    ],
};

/// The course's model and texture, drawn by the student.
fn course(student: &Gouraud, image: &mut Image, place: &dyn Fn(Vec3) -> Option<Vec3>) -> Drawn {
    let scene = Scene {
        model: &MODEL,
        normals: &corner_normals(&MODEL),
        texture: &TEXTURE,
        wrap: Wrap::Clamp,
        light: LIGHT,
    };
    (student.gouraud)(&scene, image, place)
}

/// Draws a model in white.
fn drawing(input: &str, model: Model, light: Vec3) -> Task<Gouraud> {
    let mut white = canvas(1, 1);
    white.set(0, 0, Color::WHITE);
    Task::new(input, move |student: &Gouraud| {
        let mut image = canvas(80, 80);
        let size = image.size();
        let scene = Scene {
            model: &model,
            normals: &corner_normals(&model),
            texture: &white,
            wrap: Wrap::Clamp,
            light,
        };
        (student.gouraud)(&scene, &mut image, &|p| Some(zbuffer::to_screen(p, size)));
        Raw::Picture(image)
    })
}

/// Draws the course's model.
fn whole(result: fn(&Drawn, Image) -> Raw) -> Task<Gouraud> {
    Task::new("the model", move |student: &Gouraud| {
        let mut image = canvas(SIDE, SIDE);
        let size = image.size();
        let drawn = course(student, &mut image, &|p| Some(zbuffer::to_screen(p, size)));
        result(&drawn, image)
    })
}
