//! Mission 3: the pixels of a triangle, and how bright it is, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use common::Color;
use judge::causes::{self, negated, picture, picture_and};
use judge::{Cause, Judge};
use triangles_tasks::{MISSION, Triangles, VISIT};

const JUDGE: Judge<Triangles> = Judge {
    mission: MISSION,
    reference: Triangles {
        fill: |corners, bounds, visit| triangles::fill(corners, bounds, visit),
        flat_intensity: triangles::flat_intensity,
    },
    causes: &[
        ("coverage", || picture_and(&[TWICE])),
        ("order", || picture_and(&[TWICE])),
        ("weights", || picture_and(&[SWAPPED])),
        ("bounds", || picture_and(&[TWICE])),
        ("sides", || picture_and(&[TWICE])),
        ("intensity", || {
            vec![
                Cause {
                    name: "the sign is wrong, as if light came from behind: the normal is (b − a) × (c − a)",
                    explains: |asked, got| asked.becomes(got, negated),
                },
                Cause {
                    name: "what faces away is 0: leave it below 0, so that the caller can tell",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| causes::rows(raw, |row| row[0] = row[0].max(0.0)))
                    },
                },
            ]
        }),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

const TWICE: Cause = Cause {
    name: "some pixels are visited twice: a centre on a common side belongs to one triangle only",
    explains: |asked, got| {
        let once = |color: Color| if color.r > VISIT { Color::rgb(VISIT, VISIT, VISIT) } else { color };
        asked.mended(got, |raw| picture(raw, |from, x, y| from.get(x, y).map(once)))
    },
};

const SWAPPED: Cause = Cause {
    name: "the weights are swapped: the first one is 1 at the first corner, 0 on the side opposite",
    explains: |asked, got| {
        [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]].iter().any(|order| {
            asked.becomes(got, |raw| {
                picture(raw, |from, x, y| {
                    let Color { r, g, b, .. } = from.get(x, y)?;
                    let [r, g, b] = order.map(|n| [r, g, b][n]);
                    Some(Color::rgb(r, g, b))
                })
            })
        })
    },
};
