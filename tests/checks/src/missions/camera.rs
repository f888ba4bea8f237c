//! Lesson 8: looking at a point.

use common::{Mat3, Mat4, Vec3, Vec4};
use fastrand::Rng;
use gouraud::{Scene, corner_normals};
use transforms::{place, projection, viewport};

use super::causes::{picture_and, rows, transposed};
use super::scenery::{LIGHT, MODEL, SIDE, TEXTURE, canvas, direction, point};
use super::{Cause, Check, Mission, Precision, Raw, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Camera {
    /// [`camera::basis`].
    pub basis: fn(Vec3, Vec3, Vec3) -> Option<Mat3>,
    /// [`camera::lookat`].
    pub lookat: fn(Vec3, Vec3, Vec3) -> Option<Mat4>,
}

/// The mission.
pub const MISSION: Mission<Camera> = Mission {
    lesson: "08-camera",
    reference: Camera { basis: camera::basis, lookat: camera::lookat },
    checks: &[
        Check {
            name: "basis",
            asks: "the rows x', y', z' of the eye's basis",
            points: 3,
            tasks: |rng| views(rng, true).map(|view| basis_of(&view)).collect(),
            precision: Precision::NUMBERS,
            causes: || {
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
            },
        },
        Check {
            name: "origin",
            asks: "the view of an eye that looks at the origin",
            points: 2,
            tasks: |rng| views(rng, true).map(|view| view_of(&view)).collect(),
            precision: Precision::NUMBERS,
            causes: || vec![EYE],
        },
        Check {
            name: "centre",
            asks: "the view of an eye that looks at any other point, which becomes the origin",
            points: 3,
            tasks: |rng| views(rng, false).map(|view| view_of(&view)).collect(),
            precision: Precision::NUMBERS,
            causes: || {
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
            },
        },
        Check {
            name: "one point",
            asks: "an eye at the centre looks nowhere",
            points: 1,
            tasks: |rng| {
                let p = point(rng);
                vec![Task::new("eye = centre", move |student: &Camera| {
                    let some = (student.lookat)(p, p, Vec3::Y).is_some();
                    Raw::rows([[f32::from(u8::from(some))]])
                })]
            },
            precision: Precision::EXACT,
            causes: Vec::new,
        },
        Check {
            name: "picture",
            asks: "the model from the right and from above",
            points: 1,
            tasks: |_| vec![Task::new("eye (1, 1, 2), centre (0.2, 0, 0)", picture)],
            precision: Precision::MODEL,
            causes: || picture_and(&[]),
        },
    ],
};

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

/// Eye, centre, up.
type View = [Vec3; 3];

/// Four views with eyes at distances from 2 to 4, and ups at least 20° from the view.
fn views(rng: &mut Rng, to_origin: bool) -> impl Iterator<Item = View> {
    let mut view = || loop {
        let (towards, up) = (direction(rng), direction(rng));
        let center = if to_origin { Vec3::ZERO } else { point(rng) };
        if towards.cross(up).length() > 0.35 {
            return [center + towards * (2.0 + 2.0 * rng.f32()), center, up];
        }
    };
    [view(), view(), view(), view()].into_iter()
}

fn name([eye, center, up]: &View) -> String {
    let p = |p: &Vec3| format!("({:.2}, {:.2}, {:.2})", p.x, p.y, p.z);
    format!("eye {}, centre {}, up {}", p(eye), p(center), p(up))
}

fn basis_of(view: &View) -> Task<Camera> {
    let [eye, center, up] = *view;
    Task::new(name(view), move |student: &Camera| {
        let basis = (student.basis)(eye, center, up).unwrap_or(Mat3::NAN);
        Raw::rows([0, 1, 2].map(|row| basis.row(row).to_array()))
    })
}

fn view_of(view: &View) -> Task<Camera> {
    let [eye, center, up] = *view;
    Task::new(name(view), move |student: &Camera| {
        Raw::matrix((student.lookat)(eye, center, up).unwrap_or(Mat4::NAN))
    })
}

fn picture(student: &Camera) -> Raw {
    let (eye, center) = (Vec3::new(1.0, 1.0, 2.0), Vec3::new(0.2, 0.0, 0.0));
    let mut image = canvas(SIDE, SIDE);
    let size = image.size();
    let view = (student.lookat)(eye, center, Vec3::Y).unwrap_or(Mat4::NAN);
    let all = viewport(size.x, size.y, 0.3) * projection(eye.distance(center)) * view;
    let scene = Scene { model: &MODEL, normals: corner_normals(&MODEL), texture: &TEXTURE, light: LIGHT };
    gouraud::gouraud(&scene, &mut image, |p| place(&all, p));
    Raw::Picture(image)
}

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
