//! Lesson 9: shaders.

use common::{Color, Model, Vec2, Vec3};
use fastrand::Rng;
use gouraud::corner_normals;
use shaders::lighting::{Gouraud, Quantized};
use shaders::source::{Texture, White};
use shaders::{Draw, Framebuffer, Uniforms, draw, fit};

use super::causes::{mirrored, picture, picture_and};
use super::scenery::{LIGHT, MODEL, SIDE, Square, TEXTURE, canvas, depths, noise, squares};
use super::{Cause, Check, Mission, Precision, Raw, Task};

/// What the student writes, as three looks.
#[derive(Clone, Copy)]
pub struct Shaders {
    /// White, under [`Gouraud`].
    pub gouraud: Draw,
    /// [`Texture`], under [`Gouraud`].
    pub gouraud_texture: Draw,
    /// White, under [`Quantized`].
    pub quantized: Draw,
}

/// The mission.
pub const MISSION: Mission<Shaders> = Mission {
    lesson: "09-shaders",
    reference: Shaders {
        gouraud: |uniforms, target| draw(uniforms, White, Gouraud, target),
        gouraud_texture: |uniforms, target| draw(uniforms, Texture, Gouraud, target),
        quantized: |uniforms, target| draw(uniforms, White, Quantized, target),
    },
    checks: &[
        Check {
            name: "gouraud",
            asks: "two white squares; the left one faces the light, the right one faces away and is not drawn",
            points: 2,
            tasks: |_| vec![small("two squares", two_sides(), None, |student| student.gouraud, colors)],
            precision: Precision::SHADED,
            causes: || {
                picture_and(&[Cause {
                    name: "the light comes from behind: it points from the surface to the light",
                    explains: |asked, got| asked.becomes(got, mirrored),
                }])
            },
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
                    |target| depths(&target.depths),
                )]
            },
            precision: Precision { tolerance: 1e-3, strays: 0 },
            causes: || {
                vec![Cause {
                    name: "dark fragments are drawn black: leave the intensity below 0, and they are dropped",
                    explains: |asked, got| {
                        let nothing = |n: usize| match &asked.expected {
                            Raw::Depths { values, .. } => values.get(n) == Some(&f32::NEG_INFINITY),
                            _ => false,
                        };
                        asked.mended(got, |raw| match raw {
                            Raw::Depths { width, values } => {
                                let cleared =
                                    |(n, &depth)| if nothing(n) { f32::NEG_INFINITY } else { depth };
                                Raw::Depths {
                                    width: *width,
                                    values: values.iter().enumerate().map(cleared).collect(),
                                }
                            }
                            _ => raw.clone(),
                        })
                    },
                }]
            },
        },
        Check {
            name: "texture",
            asks: "a square with a texture of 16 texels",
            points: 2,
            tasks: |rng| vec![textured(rng)],
            precision: Precision { tolerance: 2.0, strays: 20 },
            causes: || picture_and(&[]),
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
            causes: || picture_and(&[STEP_UP, NO_STEPS]),
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
            causes: || picture_and(&[]),
        },
    ],
};

/// Levels of the quantized shader.
const STEPS: u16 = 5;

const STEP_UP: Cause = Cause {
    name: "one step too bright: cut off with floor(), do not round",
    explains: |asked, got| {
        let step = (255 / STEPS) as u8;
        let up = |c: Color| if c.r > 0 { Color::rgb(c.r + step, c.g + step, c.b + step) } else { c };
        asked.becomes(got, |raw| picture(raw, |from, x, y| from.get(x, y).map(up)))
    },
};

const NO_STEPS: Cause = Cause {
    name: "there are no steps: ⌊N·min(i, 1)⌋ / N",
    explains: |asked, got| {
        let down = |c: Color| {
            let level = (u16::from(c.r) * STEPS / 255 * 255 / STEPS) as u8;
            Color::rgb(level, level, level)
        };
        asked.mended(got, |raw| picture(raw, |from, x, y| from.get(x, y).map(down)))
    },
};

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
