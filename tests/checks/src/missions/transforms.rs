//! Lesson 7: viewport, projection, and where a point lands.

use common::{Mat4, Vec3};
use fastrand::Rng;
use gouraud::{Scene, corner_normals};

use super::causes::{picture_and, rows, transposed};
use super::scenery::{LIGHT, MODEL, SIDE, TEXTURE, canvas, point};
use super::{Cause, Check, Mission, Precision, Raw, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Transforms {
    /// [`transforms::viewport`].
    pub viewport: fn(f32, f32, f32) -> Mat4,
    /// [`transforms::projection`].
    pub projection: fn(f32) -> Mat4,
    /// [`transforms::place`].
    pub place: fn(&Mat4, Vec3) -> Option<Vec3>,
}

/// The mission.
pub const MISSION: Mission<Transforms> = Mission {
    lesson: "07-transforms",
    reference: Transforms {
        viewport: transforms::viewport,
        projection: transforms::projection,
        place: transforms::place,
    },
    checks: &[
        Check {
            name: "viewport",
            asks: "the matrix from [−1, 1]² to pixels",
            points: 2,
            tasks: |rng| {
                let mut size = || [rng.i32(20..900) as f32, rng.i32(20..900) as f32, 0.3 + 0.3 * rng.f32()];
                let some = [[800.0, 600.0, 0.5], size(), size()];
                let task = |[width, height, zoom]: [f32; 3]| {
                    Task::new(format!("{width}x{height}, zoom {zoom:.2}"), move |student: &Transforms| {
                        Raw::matrix((student.viewport)(width, height, zoom))
                    })
                };
                some.map(task).into()
            },
            precision: Precision::NUMBERS,
            causes: || {
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
            },
        },
        Check {
            name: "projection",
            asks: "the matrix that makes w = 1 − z/d",
            points: 2,
            tasks: |_| [2.0, 5.0, 1.25].map(projected).into(),
            precision: Precision::NUMBERS,
            causes: || {
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
            },
        },
        Check {
            name: "parallel",
            asks: "d = ∞ is the identity",
            points: 1,
            tasks: |_| vec![projected(f32::INFINITY)],
            precision: Precision::EXACT,
            causes: Vec::new,
        },
        Check {
            name: "place",
            asks: "a point under a matrix, divided by its w",
            points: 2,
            tasks: |rng| vec![placed(rng, 1.0)],
            precision: Precision::NUMBERS,
            causes: Vec::new,
        },
        Check {
            name: "behind",
            asks: "no place at the eye's height and behind it, where w ≤ 1e-6",
            points: 1,
            tasks: |rng| vec![placed(rng, -1.0)],
            precision: Precision::NUMBERS,
            causes: || {
                vec![Cause {
                    name: "points behind the eye are drawn, upside down: return None where w ≤ 1e-6",
                    explains: |asked, got| asked.mended(got, |raw| rows(raw, |row| row.fill(f32::NAN))),
                }]
            },
        },
        Check {
            name: "picture",
            asks: "the model in perspective, and in parallel projection",
            points: 2,
            tasks: |_| [2.0, f32::INFINITY].map(picture).into(),
            precision: Precision::MODEL,
            causes: || picture_and(&[]),
        },
    ],
};

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

fn projected(d: f32) -> Task<Transforms> {
    Task::new(format!("d = {d}"), move |student: &Transforms| Raw::matrix((student.projection)(d)))
}

/// Points under a matrix, a row each, NaN for those without a place; w is positive or negative.
fn placed(rng: &mut Rng, sign: f32) -> Task<Transforms> {
    let points: Vec<Vec3> = (0..8).map(|_| point(rng)).collect();
    let mut m = Mat4::from_cols_array(&[(); 16].map(|()| super::scenery::signed(rng)));
    // |w| is at least 4 − 3.
    (m.x_axis.w, m.y_axis.w, m.z_axis.w, m.w_axis.w) = (0.5, -0.8, 0.7, sign * 4.0);
    Task::new("points and a matrix", move |student: &Transforms| {
        Raw::rows(points.iter().map(|&p| (student.place)(&m, p).map_or([f32::NAN; 3], |p| p.to_array())))
    })
}

/// The model, placed by the student's three functions.
fn picture(d: f32) -> Task<Transforms> {
    Task::new(format!("the model, d = {d}"), move |student: &Transforms| {
        let mut image = canvas(SIDE, SIDE);
        let size = image.size();
        let all = (student.viewport)(size.x, size.y, 0.4) * (student.projection)(d);
        let scene = Scene { model: &MODEL, normals: corner_normals(&MODEL), texture: &TEXTURE, light: LIGHT };
        gouraud::gouraud(&scene, &mut image, |p| (student.place)(&all, p));
        Raw::Picture(image)
    })
}
