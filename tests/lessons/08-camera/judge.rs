//! Mission 8: looking at a point, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use camera_tasks::{Camera, MISSION};
use common::{Mat3, Mat4, Vec3, Vec4};
use judge::causes::{picture_and, rows, transposed};
use judge::{Cause, Judge};
use tasks::Raw;

const JUDGE: Judge<Camera> = Judge {
    mission: MISSION,
    reference: Camera { basis: camera::basis, lookat: camera::lookat },
    causes: &[
        ("basis", || {
            vec![
                Cause {
                    name: "the basis stands in columns: transposed, its rows bring the world to the eye",
                    explains: |asked, got| asked.becomes(got, transposed),
                },
                Cause {
                    name: "not 1 long: a cross product is as long as the sine of the angle, so normalize",
                    explains: |asked, got| {
                        asked.mended(got, |raw| {
                            rows(raw, |row| {
                                let length = row.iter().map(|n| n * n).sum::<f32>().sqrt();
                                row.iter_mut().for_each(|n| *n /= length);
                            })
                        })
                    },
                },
                Cause {
                    name: "it is mirrored: x' is up × z', not z' × up",
                    explains: |asked, got| asked.becomes(got, |raw| signs(raw, [-1.0, 1.0, 1.0])),
                },
                Cause {
                    name: "it is mirrored and upside down: x' is up × z' and y' is z' × x', in this order",
                    explains: |asked, got| asked.becomes(got, |raw| signs(raw, [-1.0, -1.0, 1.0])),
                },
                Cause {
                    name: "it is upside down: y' is z' × x', not x' × z'",
                    explains: |asked, got| asked.becomes(got, |raw| signs(raw, [1.0, -1.0, 1.0])),
                },
                Cause {
                    name: "it looks away: z' points from the centre to the eye",
                    explains: |asked, got| {
                        asked.becomes(got, |raw| signs(raw, [-1.0, 1.0, -1.0]))
                            || asked.becomes(got, |raw| signs(raw, [1.0, 1.0, -1.0]))
                    },
                },
            ]
        }),
        ("origin", || vec![EYE]),
        ("centre", || {
            vec![
                EYE,
                Cause {
                    name: "the centre is subtracted after turning: subtract it first, R·(P − C)",
                    explains: |asked, got| asked.becomes(got, |raw| moved(raw, |m, t| m.transpose() * t)),
                },
                Cause {
                    name: "the centre is added: subtract it, R·(P − C)",
                    explains: |asked, got| asked.becomes(got, |raw| moved(raw, |_, t| -t)),
                },
                Cause {
                    name: "the centre is not subtracted: R·(P − C)",
                    explains: |asked, got| asked.becomes(got, |raw| moved(raw, |_, _| Vec3::ZERO)),
                },
                Cause {
                    name: "rows and columns are swapped: Mat4::from_cols takes columns",
                    explains: |asked, got| asked.becomes(got, transposed),
                },
            ]
        }),
        ("one point", Vec::new),
        ("picture", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

const EYE: Cause = Cause {
    name: "the eye is subtracted: here the centre becomes the origin, and the eye stands at (0, 0, D)",
    // It moves everything by D along z', so that one entry is wrong and no other.
    explains: |asked, got| match &asked.expected {
        Raw::Numbers { values, .. } => asked.mended(got, |raw| match raw {
            Raw::Numbers { columns: 4, values: got } if got.len() == 16 && got[11] < values[11] => {
                let values = (0..16).map(|n| if n == 11 { values[n] } else { got[n] });
                Raw::Numbers { columns: 4, values: values.collect() }
            }
            _ => raw.clone(),
        }),
        _ => false,
    },
};

/// A basis whose rows have other signs.
fn signs(raw: &Raw, signs: [f32; 3]) -> Raw {
    match raw {
        Raw::Numbers { columns: 3, values } => {
            let values = values.iter().enumerate().map(|(n, value)| signs[n / 3 % 3] * value);
            Raw::Numbers { columns: 3, values: values.collect() }
        }
        _ => raw.clone(),
    }
}

/// A view matrix whose last column, −R·C, is another vector made of R and it.
fn moved(raw: &Raw, other: impl Fn(Mat3, Vec3) -> Vec3) -> Raw {
    let Raw::Numbers { columns: 4, values } = raw else { return raw.clone() };
    let Ok(array) = <[f32; 16]>::try_from(values.as_slice()) else { return raw.clone() };
    let m = Mat4::from_cols_array(&array).transpose();
    let last: Vec4 = other(Mat3::from_mat4(m), m.w_axis.truncate()).extend(1.0);
    Raw::matrix(Mat4 { w_axis: last, ..m })
}
