//! Mission 7: viewport, projection, and where a point lands, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use judge::causes::{picture_and, rows, transposed};
use judge::{Cause, Judge};
use tasks::Raw;
use transforms_tasks::{MISSION, Transforms};

const JUDGE: Judge<Transforms> = Judge {
    mission: MISSION,
    reference: Transforms {
        viewport: transforms::viewport,
        projection: transforms::projection,
        place: transforms::place,
    },
    causes: &[
        ("viewport", || {
            vec![
                TRANSPOSED,
                Cause {
                    name: "it is upside down: y points up in the picture, too",
                    explains: |asked, got| asked.becomes(got, |raw| entry(raw, 1, 1, |n| -n)),
                },
                Cause {
                    name: "half as large: a length of 1 becomes zoom times the whole side",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| entry(&entry(raw, 0, 0, |n| n / 2.0), 1, 1, |n| n / 2.0))
                    },
                },
                Cause {
                    name: "twice as large: a length of 1 becomes zoom times the side, not twice that",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| entry(&entry(raw, 0, 0, |n| n * 2.0), 1, 1, |n| n * 2.0))
                    },
                },
                Cause {
                    name: "the middle stays in the corner: move by half the size",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| entry(&entry(raw, 0, 3, |_| 0.0), 1, 3, |_| 0.0))
                    },
                },
                Cause {
                    name: "the order of the product is wrong: the matrix on the right acts first",
                    explains: |asked, got| {
                        // Scaling after moving scales the way as well.
                        let after = |raw: &Raw| {
                            rows(raw, |row| {
                                let scale: f32 = row[..2].iter().sum();
                                row[3] *= if scale == 0.0 { 1.0 } else { scale };
                            })
                        };
                        asked.becomes(got, after)
                    },
                },
            ]
        }),
        ("projection", || {
            vec![
                TRANSPOSED,
                Cause {
                    name: "the sign is wrong: w = 1 − z/d, what is near has the smaller w",
                    explains: |asked, got| asked.becomes(got, |raw| entry(raw, 3, 2, |n| -n)),
                },
                Cause {
                    name: "it is d where 1/d should be",
                    explains: |asked, got| asked.becomes(got, |raw| entry(raw, 3, 2, |n| 1.0 / n)),
                },
            ]
        }),
        ("parallel", Vec::new),
        ("place", Vec::new),
        ("behind", || {
            vec![Cause {
                name: "points behind the eye are drawn, upside down: return None where w ≤ 1e-6",
                explains: |asked, got| asked.mended(got, |raw| rows(raw, |row| row.fill(f32::NAN))),
            }]
        }),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

const TRANSPOSED: Cause = Cause {
    name: "rows and columns are swapped: Mat4::from_cols takes columns, and m.z_axis.w is row w, column z",
    explains: |asked, got| asked.becomes(got, transposed),
};

/// A matrix with one entry changed.
fn entry(raw: &Raw, row: usize, column: usize, change: impl Fn(f32) -> f32) -> Raw {
    let mut raw = raw.clone();
    if let Raw::Numbers { columns, values } = &mut raw {
        let at = row * *columns + column;
        values[at] = change(values[at]);
    }
    raw
}
