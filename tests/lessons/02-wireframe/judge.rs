//! Mission 2: a model's edges, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use judge::causes::{picture_and, rows};
use judge::{Cause, Judge};
use wireframe_tasks::{MISSION, SIZE, Wireframe};

const JUDGE: Judge<Wireframe> = Judge {
    mission: MISSION,
    reference: Wireframe { wireframe: wireframe::wireframe, to_pixel: wireframe::to_pixel },
    causes: &[
        ("pixel", || {
            vec![
                Cause {
                    name: "rounded to the nearest: a pixel is a square, so cut off with floor()",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| rows(raw, |row| row[0] += 1.0))
                            || asked
                                .becomes(got, |raw| rows(raw, |row| row.iter_mut().for_each(|n| *n += 1.0)))
                    },
                },
                Cause {
                    name: "it is upside down: y points up, row 0 is the lowest",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| rows(raw, |row| row[1] = (SIZE.y - 1) as f32 - row[1]))
                    },
                },
                Cause {
                    name: "it is mirrored: x points to the right, column 0 is the leftmost",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| rows(raw, |row| row[0] = (SIZE.x - 1) as f32 - row[0]))
                    },
                },
            ]
        }),
        ("border", || {
            vec![Cause {
                name: "off by one at the border: x = 1 gives column `width`, which does not exist",
                explains: |asked, got| {
                    asked.becomes(got, |raw| {
                        rows(raw, |row| {
                            for (n, size) in row.iter_mut().zip(SIZE.to_array()) {
                                *n += if *n == (size - 1) as f32 { 1.0 } else { 0.0 };
                            }
                        })
                    })
                },
            }]
        }),
        ("outside", || {
            vec![Cause {
                name: "cut off towards 0: below 0 that is inwards; floor() goes down everywhere",
                explains: |asked, got| {
                    asked.becomes(got, |raw| {
                        rows(raw, |row| row.iter_mut().for_each(|n| *n += f32::from(u8::from(*n < 0.0))))
                    })
                },
            }]
        }),
        ("edges", || picture_and(&[])),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}
