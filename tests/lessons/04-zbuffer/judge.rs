//! Mission 4: the nearest surface, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use judge::causes::{picture, picture_and, swapped};
use judge::{Cause, Judge};
use tasks::Raw;
use zbuffer_tasks::{FAR, MISSION, NEAR, WIDE, Zbuffer};

const JUDGE: Judge<Zbuffer> = Judge {
    mission: MISSION,
    reference: Zbuffer {
        fill_nearest: |corners, depths, store, visit| zbuffer::fill_nearest(corners, depths, store, visit),
        z_f32: zbuffer::z_f32,
    },
    causes: &[
        ("pairs", || picture_and(&[LAST, FIRST, SIGN, NONE])),
        ("depths", || {
            vec![
                Cause {
                    name: "wrong sign of depth: a larger depth is nearer, and is kept as it is",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| {
                            change(raw, |depth| if depth.is_finite() { -depth } else { depth })
                        })
                    },
                },
                Cause {
                    name: "the buffer stays empty: set() the depth of each pixel that is drawn",
                    explains: |asked, got| asked.becomes(got, |raw| change(raw, |_| f32::NEG_INFINITY)),
                },
            ]
        }),
        ("layers", || picture_and(&[])),
        ("equal", || {
            picture_and(&[Cause {
                name: "the second one covers the first: nearer is >, not ≥",
                explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |_| true)),
            }])
        }),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

const LAST: Cause = Cause {
    name: "the last one drawn is seen: draw only what is nearer than the buffer says, and keep its depth there",
    explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |x| x < i32::from(WIDE) / 2)),
};

const FIRST: Cause = Cause {
    name: "the first one drawn is seen: what is nearer than the buffer says must be drawn over it",
    explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |x| x >= i32::from(WIDE) / 2)),
};

const SIGN: Cause = Cause {
    name: "wrong sign of depth, the far one is seen: a larger depth is nearer",
    explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |_| true)),
};

const NONE: Cause = Cause {
    name: "nothing passes the depth test: a larger depth is nearer, and the buffer starts at −∞",
    explains: |asked, got| asked.becomes(got, |raw| picture(raw, |_, _, _| None)),
};

/// Every depth made another.
fn change(raw: &Raw, change: impl Fn(f32) -> f32) -> Raw {
    match raw {
        Raw::Depths { width, values } => {
            Raw::Depths { width: *width, values: values.iter().map(|&depth| change(depth)).collect() }
        }
        _ => raw.clone(),
    }
}
