//! Wrong versions of mission 8, by which the judge knows what was done.

use camera_tasks::Camera;
use common::{Mat3, Mat4, Vec3};
use judge::Fault;
use transforms::translate;

use crate::RIGHT;

/// A basis from the way to the eye, and up, whether that makes sense or not.
macro_rules! made {
    ($rows:expr) => {
        Camera {
            basis: |eye, center, up| {
                let rows: fn(Vec3, Vec3) -> [Vec3; 3] = $rows;
                let [x, y, z] = rows(eye - center, up);
                Some(Mat3::from_cols(x, y, z).transpose())
            },
            ..RIGHT
        }
    };
}

/// The right basis, with other rows.
macro_rules! right_but {
    ($change:expr) => {
        Camera {
            basis: |eye, center, up| {
                let change: fn([Vec3; 3]) -> [Vec3; 3] = $change;
                let rows = camera::basis(eye, center, up)?;
                let [x, y, z] = change([0, 1, 2].map(|n| rows.row(n)));
                Some(Mat3::from_cols(x, y, z).transpose())
            },
            ..RIGHT
        }
    };
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Camera>] = &[
    Fault {
        cause: "an eye at the centre gives NaN: use try_normalize(), and return None where it does",
        hint: Some(4),
        versions: &[
            Camera {
                basis: |eye, center, up| camera::basis(eye, center, up).or(Some(Mat3::NAN)),
                lookat: |eye, center, up| camera::lookat(eye, center, up).or(Some(Mat4::NAN)),
            },
            made!(|z, up| {
                let z = z.normalize();
                let x = up.cross(z).normalize();
                [x, z.cross(x), z]
            }),
            made!(|z, up| {
                let z = z.normalize_or_zero();
                let x = up.cross(z).normalize_or_zero();
                [x, z.cross(x), z]
            }),
        ],
    },
    Fault {
        cause: "the basis stands in columns: transposed, its rows bring the world to the eye",
        hint: Some(1),
        versions: &[Camera {
            basis: |eye, center, up| Some(camera::basis(eye, center, up)?.transpose()),
            ..RIGHT
        }],
    },
    Fault {
        cause: "not 1 long: a cross product is as long as the sine of the angle times both lengths, so normalize",
        hint: None,
        versions: &[
            // x' not, and y' with it; z' not; none.
            made!(|z, up| {
                let (z, x) = (z.normalize(), up.cross(z.normalize()));
                [x, z.cross(x), z]
            }),
            made!(|z, up| {
                let (z, x) = (z.normalize(), up.normalize().cross(z.normalize()));
                [x, z.cross(x), z]
            }),
            made!(|z, up| {
                let x = up.cross(z).normalize();
                [x, z.cross(x), z]
            }),
            made!(|z, up| {
                let x = up.cross(z).normalize();
                [x, z.cross(x).normalize(), z]
            }),
            made!(|z, up| {
                let x = up.cross(z);
                [x, z.cross(x), z]
            }),
        ],
    },
    Fault {
        cause: "it is mirrored: x' is up x z', not z' x up",
        hint: Some(2),
        versions: &[right_but!(|[x, y, z]| [-x, y, z])],
    },
    Fault {
        cause: "it is mirrored and upside down: x' is up x z' and y' is z' x x', in this order",
        hint: Some(2),
        versions: &[right_but!(|[x, y, z]| [-x, -y, z])],
    },
    Fault {
        cause: "it is upside down: y' is z' x x', not x' x z'",
        hint: Some(2),
        versions: &[right_but!(|[x, y, z]| [x, -y, z])],
    },
    Fault {
        cause: "it looks away: z' points from the centre to the eye, not to what is seen",
        hint: None,
        versions: &[
            Camera { basis: |eye, center, up| camera::basis(center, eye, up), ..RIGHT },
            right_but!(|[x, y, z]| [x, y, -z]),
        ],
    },
    Fault {
        cause: "y' is the given up: it has to be at right angles to the view, so it is z' x x'",
        hint: None,
        versions: &[
            made!(|z, up| [up.cross(z).normalize(), up, z.normalize()]),
            made!(|z, up| [up.cross(z).normalize(), up.normalize(), z.normalize()]),
        ],
    },
    Fault {
        cause: "the eye is subtracted: here the centre becomes the origin, and the eye stands at (0, 0, D)",
        hint: Some(3),
        versions: &[Camera {
            lookat: |eye, center, up| {
                Some(Mat4::from_mat3(camera::basis(eye, center, up)?) * translate(-eye))
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "rows and columns are swapped: the basis has rows already, do not turn it again",
        hint: Some(1),
        versions: &[
            Camera { lookat: |eye, center, up| Some(camera::lookat(eye, center, up)?.transpose()), ..RIGHT },
            Camera {
                lookat: |eye, center, up| {
                    let rows = camera::basis(eye, center, up)?;
                    Some(Mat4::from_mat3(rows.transpose()) * translate(-center))
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the centre is subtracted after turning: subtract it first, R * (P - C)",
        hint: Some(3),
        versions: &[Camera { lookat: camera::listing, ..RIGHT }],
    },
    Fault {
        cause: "the centre is added: subtract it, R * (P - C)",
        hint: Some(3),
        versions: &[Camera {
            lookat: |eye, center, up| {
                Some(Mat4::from_mat3(camera::basis(eye, center, up)?) * translate(center))
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the centre is not subtracted: R * (P - C)",
        hint: Some(3),
        versions: &[Camera {
            lookat: |eye, center, up| Some(Mat4::from_mat3(camera::basis(eye, center, up)?)),
            ..RIGHT
        }],
    },
    Fault {
        cause: "an eye at the centre makes it panic: do not unwrap(), pass None on with `?`",
        hint: Some(4),
        versions: &[
            Camera {
                basis: |eye, center, up| Some(camera::basis(eye, center, up).unwrap()),
                lookat: |eye, center, up| Some(camera::lookat(eye, center, up).unwrap()),
            },
            Camera { lookat: |eye, center, up| Some(camera::lookat(eye, center, up).unwrap()), ..RIGHT },
        ],
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JUDGE;

    #[test]
    fn the_reference_earns_ten_points_for_any_seed() {
        JUDGE.check();
    }

    #[test]
    fn to_do_nothing_earns_nothing() {
        JUDGE.earns_nothing(&Camera { basis: |_, _, _| None, lookat: |_, _, _| None });
    }

    #[test]
    fn each_fault_is_recognised() {
        let reference = JUDGE.reference;
        let lookat = |lookat, words| {
            JUDGE.recognises(&Camera { lookat, ..reference }, "centre", words);
        };
        lookat(camera::listing, "subtracted after turning");
        lookat(
            |eye, center, up| {
                let rows = camera::basis(eye, center, up)?;
                Some(Mat4::from_mat3(rows) * translate(center))
            },
            "the centre is added",
        );
        lookat(
            |eye, center, up| {
                let rows = camera::basis(eye, center, up)?;
                Some(Mat4::from_mat3(rows) * translate(-eye))
            },
            "the eye is subtracted",
        );
        let basis = |basis, words| {
            JUDGE.recognises(&Camera { basis, ..reference }, "basis", words);
        };
        basis(|eye, center, up| Some(camera::basis(eye, center, up)?.transpose()), "stands in columns");
        basis(|eye, center, up| camera::basis(center, eye, up), "looks away");
        basis(
            |eye, center, up| {
                let z = (eye - center).normalize();
                let x = up.cross(z);
                Some(Mat3::from_cols(x, z.cross(x), z).transpose())
            },
            "not 1 long",
        );
        basis(
            |eye, center, up| {
                let z = (eye - center).normalize();
                let x = up.cross(z).normalize();
                Some(Mat3::from_cols(x, x.cross(z), z).transpose())
            },
            "upside down",
        );
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
