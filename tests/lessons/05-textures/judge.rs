//! Mission 5: colour from a picture, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use common::Color;
use judge::causes::{self, picture, picture_and};
use judge::{Cause, Judge};
use tasks::Raw;
use textures_tasks::{MISSION, TEXELS, Textures};

const JUDGE: Judge<Textures> = Judge {
    mission: MISSION,
    reference: Textures {
        texel: textures::texel,
        interpolate: textures::interpolate,
        draw_textured: |model, light, image, color| textures::draw_textured(model, light, image, color),
    },
    causes: &[
        ("texels", || picture_and(&[ROUNDED])),
        ("within", || vec![ROUNDED]),
        ("border", || vec![BLACK, REPEATED]),
        ("interpolate", || {
            vec![Cause {
                name: "u and v are swapped",
                explains: |asked, got| asked.becomes(got, |raw| causes::rows(raw, |row| row.swap(0, 1))),
            }]
        }),
        ("coordinates", || {
            picture_and(&[Cause {
                name: "u and v are swapped",
                explains: |asked, got| {
                    asked.becomes(got, |raw| {
                        picture(raw, |from, x, y| from.get(x, y).map(|c| Color { r: c.g, g: c.r, ..c }))
                    })
                },
            }])
        }),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

const ROUNDED: Cause = Cause {
    name: "half a texel off: a texel is a square, so cut off and do not round",
    explains: |asked, got| {
        // Beyond the last texel there is none, or the last one again.
        let next = |raw: &Raw| picture(raw, |from, x, y| from.get(x + 1, y + 1));
        let next_or_last = |raw: &Raw| {
            let last = i32::from(TEXELS) - 1;
            picture(raw, |from, x, y| from.get((x + 1).min(last), (y + 1).min(last)))
        };
        asked.becomes(got, next) || asked.becomes(got, next_or_last)
    },
};

const BLACK: Cause = Cause {
    name: "black from u = 1 on and outside: take the nearest texel that exists",
    explains: |asked, got| {
        let inside = |n: i32| (1..3).contains(&n);
        let only = |raw: &Raw| picture(raw, |from, x, y| from.get(x, y).filter(|_| inside(x) && inside(y)));
        asked.becomes(got, only)
    },
};

const REPEATED: Cause = Cause {
    name: "the texture is repeated: from u = 1 on and outside, take the nearest texel that exists",
    explains: |asked, got| {
        let again = |n: i32| [2, 1, 2, 1, 2][n as usize];
        asked.becomes(got, |raw| picture(raw, |from, x, y| from.get(again(x), again(y))))
    },
};
