//! Mission 6: smooth shading, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use gouraud_tasks::{Gouraud, MISSION};
use judge::causes::{mirrored, negated, picture_and, rows};
use judge::{Cause, Judge};

const JUDGE: Judge<Gouraud> = Judge {
    mission: MISSION,
    reference: Gouraud {
        intensities: gouraud::intensities,
        gouraud: |scene, image, place| gouraud::gouraud(scene, image, place),
    },
    causes: &[
        ("corners", || {
            vec![
                Cause {
                    name: "the sign is wrong, as if the light came from behind: it points to the light",
                    explains: |asked, got| asked.becomes(got, negated),
                },
                CLAMPED,
                Cause {
                    name: "the corners are swapped: the first intensity is the first normal's",
                    explains: |asked, got| {
                        [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]].iter().any(|order| {
                            asked.becomes(got, |raw| {
                                rows(raw, |row| {
                                    let permuted = order.map(|n| row[n]);
                                    row.copy_from_slice(&permuted);
                                })
                            })
                        })
                    },
                },
            ]
        }),
        ("two sides", || {
            picture_and(&[Cause {
                name: "the light comes from behind: it points from the surface to the light",
                explains: |asked, got| asked.becomes(got, mirrored),
            }])
        }),
        ("between", || picture_and(&[])),
        ("left out", Vec::new),
        ("depths", Vec::new),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

const CLAMPED: Cause = Cause {
    name: "clamped at the corners: below 0 an intensity still counts, clamp what is interpolated",
    explains: |asked, got| {
        asked.becomes(got, |raw| rows(raw, |row| row.iter_mut().for_each(|value| *value = value.max(0.0))))
    },
};
