//! Wrong versions of mission 7, by which the judge knows what was done.

use common::{Mat4, Vec3, Vec4Swizzles};
use judge::Fault;
use transforms::{scale, translate};
use transforms_tasks::Transforms;

use crate::RIGHT;

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Transforms>] = &[
    Fault {
        cause: "rows and columns are swapped: Mat4::from_cols takes columns, and m.z_axis.w is row w, column z",
        hint: Some(1),
        versions: &[
            Transforms { viewport: |w, h, zoom| transforms::viewport(w, h, zoom).transpose(), ..RIGHT },
            Transforms { projection: |d| transforms::projection(d).transpose(), ..RIGHT },
        ],
    },
    Fault {
        cause: "it is upside down: y points up in the picture, too",
        hint: None,
        versions: &[Transforms {
            viewport: |w, h, zoom| transforms::viewport(w, h, zoom) * scale(Vec3::new(1.0, -1.0, 1.0)),
            ..RIGHT
        }],
    },
    Fault {
        cause: "the wrong size: a length of 1 becomes zoom times the whole side, neither half nor twice that",
        hint: Some(2),
        versions: &[
            Transforms { viewport: |w, h, zoom| transforms::viewport(w, h, zoom / 2.0), ..RIGHT },
            Transforms { viewport: |w, h, zoom| transforms::viewport(w, h, zoom * 2.0), ..RIGHT },
        ],
    },
    Fault {
        cause: "the zoom is forgotten: a length of 1 becomes zoom times the side",
        hint: None,
        versions: &[
            Transforms { viewport: |w, h, _| transforms::viewport(w, h, 1.0), ..RIGHT },
            Transforms { viewport: |w, h, _| transforms::viewport(w, h, 0.5), ..RIGHT },
        ],
    },
    Fault {
        cause: "width for height: x is stretched by the width and moved by half of it, y by the height",
        hint: None,
        versions: &[
            Transforms { viewport: |w, _, zoom| transforms::viewport(w, w, zoom), ..RIGHT },
            Transforms { viewport: |_, h, zoom| transforms::viewport(h, h, zoom), ..RIGHT },
            Transforms { viewport: |w, h, zoom| transforms::viewport(h, w, zoom), ..RIGHT },
        ],
    },
    Fault {
        cause: "both directions are stretched alike: x by zoom times the width, y by zoom times the height",
        hint: None,
        versions: &[
            Transforms { viewport: |w, h, zoom| middle(w, h) * alike(w * zoom), ..RIGHT },
            Transforms { viewport: |w, h, zoom| middle(w, h) * alike(h * zoom), ..RIGHT },
            Transforms { viewport: |w, h, zoom| middle(w, h) * alike(w.min(h) * zoom), ..RIGHT },
            Transforms { viewport: |w, h, zoom| middle(w, h) * alike(w.max(h) * zoom), ..RIGHT },
        ],
    },
    Fault {
        cause: "the zoom moves the middle: that is at half the size, whatever the zoom",
        hint: None,
        versions: &[Transforms {
            viewport: |w, h, zoom| middle(2.0 * w * zoom, 2.0 * h * zoom) * stretch(w * zoom, h * zoom),
            ..RIGHT
        }],
    },
    Fault {
        cause: "one less than the size: the picture reaches from 0 to width, and its middle is width / 2",
        hint: None,
        versions: &[
            Transforms {
                viewport: |w, h, zoom| middle(w - 1.0, h - 1.0) * stretch(w * zoom, h * zoom),
                ..RIGHT
            },
            Transforms { viewport: |w, h, zoom| transforms::viewport(w - 1.0, h - 1.0, zoom), ..RIGHT },
        ],
    },
    Fault {
        cause: "it is moved, and not stretched: scale() is missing",
        hint: Some(2),
        versions: &[Transforms { viewport: |w, h, _| middle(w, h), ..RIGHT }],
    },
    Fault {
        cause: "the middle stays in the corner: move by half the size",
        hint: Some(2),
        versions: &[
            Transforms { viewport: |w, h, zoom| scale(Vec3::new(w * zoom, h * zoom, 1.0)), ..RIGHT },
            Transforms {
                viewport: |w, h, zoom| {
                    translate(Vec3::new(w, h, 0.0)) * scale(Vec3::new(w * zoom, h * zoom, 1.0))
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the order of the product is wrong: the matrix on the right acts first",
        hint: Some(2),
        versions: &[Transforms {
            viewport: |w, h, zoom| scale(Vec3::new(w * zoom, h * zoom, 1.0)) * middle(w, h),
            ..RIGHT
        }],
    },
    Fault {
        cause: "the depth is stretched, too: z stays",
        hint: None,
        versions: &[
            Transforms { viewport: |w, h, zoom| middle(w, h) * scale(Vec3::new(w, h, 1.0) * zoom), ..RIGHT },
            Transforms { viewport: |w, h, zoom| middle(w, h) * scale(Vec3::new(w, h, w) * zoom), ..RIGHT },
            Transforms { viewport: |w, h, zoom| middle(w, h) * scale(Vec3::new(w, h, h) * zoom), ..RIGHT },
            Transforms {
                viewport: |w, h, zoom| middle(w, h) * scale(Vec3::new(w * zoom, h * zoom, 0.0)),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the sign is wrong: w = 1 - z/d, what is near has the smaller w",
        hint: None,
        versions: &[Transforms { projection: |d| transforms::projection(-d), ..RIGHT }],
    },
    Fault {
        cause: "it is d where 1/d should be",
        hint: None,
        versions: &[Transforms { projection: |d| transforms::projection(1.0 / d), ..RIGHT }],
    },
    Fault {
        cause: "w = -z/d: the 1 of `1 - z/d` stays on the diagonal",
        hint: Some(1),
        versions: &[Transforms {
            projection: |d| {
                let mut m = transforms::projection(d);
                m.w_axis.w = 0.0;
                m
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "it is not divided by w: after the product, x, y and z are over w",
        hint: None,
        versions: &[Transforms {
            place: |m, p| {
                let p = *m * p.extend(1.0);
                (p.w > 1e-6).then(|| p.xyz())
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "it is multiplied by w: after the product, x, y and z are over w",
        hint: None,
        versions: &[Transforms {
            place: |m, p| {
                let p = *m * p.extend(1.0);
                (p.w > 1e-6).then(|| p.xyz() * p.w)
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the test is the wrong way round: None where w <= 1e-6, and a place where it is more",
        hint: Some(4),
        versions: &[
            Transforms {
                place: |m, p| Some(*m * p.extend(1.0)).filter(|p| p.w <= 1e-6).map(|p| p.xyz() / p.w),
                ..RIGHT
            },
            Transforms {
                place: |m, p| Some(*m * p.extend(1.0)).filter(|p| p.w < 1e-6).map(|p| p.xyz() / p.w),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the point is taken for a row: it is the column on the right, *m * v",
        hint: None,
        versions: &[Transforms { place: |m, p| transforms::place(&m.transpose(), p), ..RIGHT }],
    },
    Fault {
        cause: "z is not divided by w: all three coordinates are",
        hint: None,
        versions: &[Transforms {
            place: |m, p| {
                let p = *m * p.extend(1.0);
                (p.w > 1e-6).then(|| Vec3::new(p.x / p.w, p.y / p.w, p.z))
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the fourth coordinate is 0: a point has w = 1, else it is not moved",
        hint: None,
        versions: &[Transforms {
            place: |m, p| {
                let p = *m * p.extend(0.0);
                (p.w > 1e-6).then(|| p.xyz() / p.w)
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "points behind the eye are drawn, upside down: return None where w <= 1e-6",
        hint: Some(4),
        versions: &[
            Transforms { place: |m, p| Some(m.project_point3(p)), ..RIGHT },
            Transforms {
                place: |m, p| Some(*m * p.extend(1.0)).filter(|p| p.w.abs() > 1e-6).map(|p| p.xyz() / p.w),
                ..RIGHT
            },
            Transforms {
                place: |m, p| Some(*m * p.extend(1.0)).filter(|p| p.w != 0.0).map(|p| p.xyz() / p.w),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "points at the eye's height are placed: None not only below 0, but up to 1e-6 and there as well",
        hint: Some(4),
        versions: &[
            Transforms {
                place: |m, p| Some(*m * p.extend(1.0)).filter(|p| p.w > 0.0).map(|p| p.xyz() / p.w),
                ..RIGHT
            },
            Transforms {
                place: |m, p| Some(*m * p.extend(1.0)).filter(|p| p.w >= 0.0).map(|p| p.xyz() / p.w),
                ..RIGHT
            },
            Transforms {
                place: |m, p| Some(*m * p.extend(1.0)).filter(|p| p.w >= 1e-6).map(|p| p.xyz() / p.w),
                ..RIGHT
            },
        ],
    },
];

fn stretch(x: f32, y: f32) -> Mat4 {
    scale(Vec3::new(x, y, 1.0))
}

fn alike(side: f32) -> Mat4 {
    stretch(side, side)
}

fn middle(width: f32, height: f32) -> Mat4 {
    translate(Vec3::new(width / 2.0, height / 2.0, 0.0))
}

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
        JUDGE.earns_nothing(&Transforms {
            viewport: |_, _, _| Mat4::IDENTITY,
            projection: |_| Mat4::IDENTITY,
            place: |_, _| None,
        });
    }

    #[test]
    fn each_fault_is_recognised() {
        let reference = JUDGE.reference;
        let viewport = |viewport, words| {
            let functions = Transforms { viewport, ..reference };
            JUDGE.recognises(&functions, "viewport", words);
        };
        viewport(|w, h, zoom| transforms::viewport(w, h, zoom).transpose(), "rows and columns");
        viewport(
            |w, h, zoom| transforms::viewport(w, h, zoom) * scale(Vec3::new(1.0, -1.0, 1.0)),
            "upside down",
        );
        viewport(|w, h, zoom| transforms::viewport(w, h, zoom / 2.0), "the wrong size");
        viewport(
            |w, h, zoom| {
                scale(Vec3::new(w * zoom, h * zoom, 1.0)) * translate(Vec3::new(w / 2.0, h / 2.0, 0.0))
            },
            "order of the product",
        );
        let projection = |projection, words| {
            let functions = Transforms { projection, ..reference };
            JUDGE.recognises(&functions, "projection", words);
        };
        projection(|d| transforms::projection(-d), "the sign is wrong");
        projection(|d| transforms::projection(d).transpose(), "rows and columns");
        let behind = Transforms { place: |m, p| Some(m.project_point3(p)), ..reference };
        JUDGE.recognises(&behind, "behind", "behind the eye");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
