//! Mission 9: shaders, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use common::Color;
use judge::causes::{mirrored, picture, picture_and};
use judge::{Cause, Judge};
use shaders::draw;
use shaders::lighting::{Gouraud, Quantized};
use shaders::source::{Texture, White};
use shaders_tasks::{MISSION, STEPS, Shaders};
use tasks::Raw;

const JUDGE: Judge<Shaders> = Judge {
    mission: MISSION,
    reference: Shaders {
        gouraud: |uniforms, target| draw(uniforms, White, Gouraud, target),
        gouraud_texture: |uniforms, target| draw(uniforms, Texture, Gouraud, target),
        quantized: |uniforms, target| draw(uniforms, White, Quantized, target),
    },
    causes: &[
        ("gouraud", || {
            picture_and(&[Cause {
                name: "the light comes from behind: it points from the surface to the light",
                explains: |asked, got| asked.becomes(got, mirrored),
            }])
        }),
        ("dropped", || {
            vec![Cause {
                name: "dark fragments are drawn black: leave the intensity below 0, and they are dropped",
                explains: |asked, got| {
                    let nothing = |n: usize| match &asked.expected {
                        Raw::Depths { values, .. } => values.get(n) == Some(&f32::NEG_INFINITY),
                        _ => false,
                    };
                    asked.mended(got, |raw| match raw {
                        Raw::Depths { width, values } => {
                            let cleared = |(n, &depth)| if nothing(n) { f32::NEG_INFINITY } else { depth };
                            Raw::Depths {
                                width: *width,
                                values: values.iter().enumerate().map(cleared).collect(),
                            }
                        }
                        _ => raw.clone(),
                    })
                },
            }]
        }),
        ("texture", || picture_and(&[])),
        ("steps", || picture_and(&[STEP_UP, NO_STEPS])),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

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
