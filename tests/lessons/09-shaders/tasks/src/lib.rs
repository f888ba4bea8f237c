//! Mission 9: shaders.

use common::{Model, Vec2, Vec3};
use fastrand::Rng;
use gouraud::corner_normals;
use shaders::{Draw, Framebuffer, Uniforms, fit};
use tasks::scenery::{LIGHT, MODEL, SIDE, Square, TEXTURE, canvas, noise, squares};
use tasks::{Check, Mission, Precision, Raw, Task};

/// What the student writes, as three looks.
#[derive(Clone, Copy)]
pub struct Shaders {
    /// White, under `Gouraud`.
    pub gouraud: Draw,
    /// `Texture`, under `Gouraud`.
    pub gouraud_texture: Draw,
    /// White, under `Quantized`.
    pub quantized: Draw,
}

/// The mission.
pub const MISSION: Mission<Shaders> = Mission {
    lesson: "09-shaders",
    checks: &[
        Check {
            name: "gouraud",
            asks: "two white squares; the left one faces the light, the right one faces away and is not drawn",
            points: 2,
            tasks: |_| vec![small("two squares", two_sides(), None, |student| student.gouraud, colors)],
            precision: Precision::SHADED,
        },
        Check {
            name: "dropped",
            asks: "what faces away is dropped: it leaves no depth behind",
            points: 1,
            tasks: |_| {
                vec![small(
                    "two squares",
                    two_sides(),
                    None,
                    |student| student.gouraud,
                    |target| Raw::depths(target.depths.bounds(), |x, y| target.depths.get(x, y)),
                )]
            },
            precision: Precision { tolerance: 1e-3, strays: 0 },
        },
        Check {
            name: "texture",
            asks: "a square with a texture of 16 texels",
            points: 2,
            tasks: |rng| vec![textured(rng)],
            precision: Precision { tolerance: 2.0, strays: 20 },
        },
        Check {
            name: "steps",
            asks: "four squares of different brightness, in steps of ⌊N·min(i, 1)⌋ / N for N = 5",
            points: 3,
            tasks: |_| {
                // Three quarters of a step above a step.
                let tilted = |step: f32| {
                    let z = (step + 0.75) / f32::from(STEPS);
                    Vec3::new((1.0 - z * z).sqrt(), 0.0, z)
                };
                let square = |step: u8| {
                    let left = f32::from(step) * 0.5 - 1.4;
                    Square {
                        place: [left, -0.8, left + 0.4, 0.8, 0.0],
                        normals: [tilted(f32::from(step)); 4],
                    }
                };
                let four = squares(&[1, 2, 3, 4].map(square));
                vec![small("four squares", four, None, |student| student.quantized, colors)]
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "picture",
            asks: "the model, with a texture and in steps",
            points: 2,
            tasks: |_| {
                let model = |input: &str, look: fn(&Shaders) -> Draw| {
                    Task::new(input, move |student: &Shaders| {
                        let mut target = Framebuffer::new(canvas(SIDE, SIDE));
                        let uniforms = Uniforms {
                            normals: &corner_normals(&MODEL),
                            texture: Some(&TEXTURE),
                            light: LIGHT,
                            to_clip: fit(0.45, Vec2::ONE),
                            levels: STEPS,
                            ..Uniforms::new(&MODEL)
                        };
                        look(student)(&uniforms, &mut target);
                        Raw::Picture(target.image)
                    })
                };
                vec![
                    model("gouraud-texture", |student| student.gouraud_texture),
                    model("quantized", |student| student.quantized),
                ]
            },
            precision: Precision::MODEL,
        },
    ],
};

/// Levels of the quantized shader.
pub const STEPS: u16 = 5;

/// A square that faces the light and one that faces away.
fn two_sides() -> Model {
    let half = |left, normal| Square { place: [left, -0.5, left + 0.5, 0.5, 0.0], normals: [normal; 4] };
    squares(&[half(-0.75, Vec3::Z), half(0.25, Vec3::NEG_Z)])
}

fn colors(target: Framebuffer) -> Raw {
    Raw::Picture(target.image)
}

/// Draws a small model with the light in front.
fn small(
    input: &str,
    model: Model,
    texture: Option<common::Image>,
    look: fn(&Shaders) -> Draw,
    result: fn(Framebuffer) -> Raw,
) -> Task<Shaders> {
    Task::new(input, move |student: &Shaders| {
        let mut target = Framebuffer::new(canvas(80, 80));
        let normals = corner_normals(&model);
        let uniforms =
            Uniforms { normals: &normals, texture: texture.as_ref(), levels: STEPS, ..Uniforms::new(&model) };
        look(student)(&uniforms, &mut target);
        result(target)
    })
}

/// A square with a random texture, brighter on the left.
fn textured(rng: &mut Rng) -> Task<Shaders> {
    let tilted = Vec3::new(0.8, 0.0, 0.6);
    let normals = [Vec3::Z, tilted, tilted, Vec3::Z];
    let model = squares(&[Square { place: [-0.8, -0.8, 0.8, 0.8, 0.0], normals }]);
    small("a square", model, Some(noise(rng, 4)), |student| student.gouraud_texture, colors)
}
