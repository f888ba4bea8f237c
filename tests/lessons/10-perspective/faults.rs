//! Wrong versions of mission 10, by which the judge knows what was done.

use common::{Mat4, Vec3, Vec4};
use judge::Fault;
use perspective_tasks::Perspective;

use crate::RIGHT;

/// The lesson's matrix, changed.
macro_rules! matrix {
    (|$m:ident, $l:ident, $r:ident, $b:ident, $t:ident, $n:ident, $f:ident| $change:expr) => {
        Perspective {
            frustum: |$l, $r, $b, $t, $n, $f| {
                let mut $m = (RIGHT.frustum)($l, $r, $b, $t, $n, $f)?;
                let _ = ($l, $r, $b, $t, $n, $f);
                $change;
                Some($m)
            },
            ..RIGHT
        }
    };
}

/// The usual formulas, as they stand, for whatever numbers.
fn as_it_stands(l: f32, r: f32, b: f32, t: f32, n: f32, f: f32) -> Mat4 {
    Mat4::from_cols(
        Vec4::new(2.0 * n / (r - l), 0.0, 0.0, 0.0),
        Vec4::new(0.0, 2.0 * n / (t - b), 0.0, 0.0),
        Vec4::new((r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1.0),
        Vec4::new(0.0, 0.0, -2.0 * f * n / (f - n), 0.0),
    )
}

/// The same with its limit.
fn in_the_limit(l: f32, r: f32, b: f32, t: f32, n: f32, f: f32) -> Mat4 {
    let k = n / f;
    let mut m = as_it_stands(l, r, b, t, n, f);
    (m.z_axis.z, m.w_axis.z) = (-(1.0 + k) / (1.0 - k), -2.0 * n / (1.0 - k));
    m
}

fn each_over(products: Vec3) -> Vec3 {
    products / products.element_sum()
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Perspective>] = &[
    Fault {
        cause: "rows and columns are swapped: Mat4::from_cols takes columns, so transpose what you wrote in rows",
        hint: Some(1),
        versions: &[matrix!(|m, _l, _r, _b, _t, _n, _f| m = m.transpose())],
    },
    Fault {
        cause: "w is z, which is negative before the eye: the last row makes w = -z",
        hint: None,
        versions: &[
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.z_axis.w = 1.0),
            // All four rows divided by z instead of −z.
            matrix!(|m, _l, _r, _b, _t, _n, _f| m *= -1.0),
        ],
    },
    Fault {
        cause: "the 2 is missing: the sides of the picture are 2 apart after the division, and 2n / (r - l) apart before",
        hint: None,
        versions: &[
            matrix!(
                |m, _l, _r, _b, _t, _n, _f| (m.x_axis.x, m.y_axis.y) = (m.x_axis.x / 2.0, m.y_axis.y / 2.0)
            ),
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.x_axis.x /= 2.0),
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.y_axis.y /= 2.0),
        ],
    },
    Fault {
        cause: "n is missing in the first two rows: the rectangle is on the near plane, at the depth n",
        hint: None,
        versions: &[matrix!(
            |m, _l, _r, _b, _t, n, _f| (m.x_axis.x, m.y_axis.y) = (m.x_axis.x / n, m.y_axis.y / n)
        )],
    },
    Fault {
        cause: "the view is always through the middle of the picture: (r + l) / (r - l) and (t + b) / (t - b) are missing",
        hint: Some(2),
        versions: &[matrix!(|m, _l, _r, _b, _t, _n, _f| (m.z_axis.x, m.z_axis.y) = (0.0, 0.0))],
    },
    Fault {
        cause: "the picture is off to the other side: (r + l) / (r - l) is multiplied by z, which is negative, so its sign is +",
        hint: Some(2),
        versions: &[
            matrix!(|m, _l, _r, _b, _t, _n, _f| (m.z_axis.x, m.z_axis.y) = (-m.z_axis.x, -m.z_axis.y)),
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.z_axis.x = -m.z_axis.x),
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.z_axis.y = -m.z_axis.y),
        ],
    },
    Fault {
        cause: "(r + l) / (r - l) stands in the last column: it is multiplied by z, as the division by w comes after it",
        hint: Some(2),
        versions: &[
            matrix!(|m, _l, _r, _b, _t, _n, _f| {
                (m.w_axis.x, m.w_axis.y) = (m.z_axis.x, m.z_axis.y);
                (m.z_axis.x, m.z_axis.y) = (0.0, 0.0);
            }),
            matrix!(|m, _l, _r, _b, _t, _n, _f| {
                (m.w_axis.x, m.w_axis.y) = (-m.z_axis.x, -m.z_axis.y);
                (m.z_axis.x, m.z_axis.y) = (0.0, 0.0);
            }),
        ],
    },
    Fault {
        cause: "this is the range of Vulkan, from 0 to 1: here the near plane becomes z = -w",
        hint: Some(3),
        versions: &[matrix!(|m, _l, _r, _b, _t, n, f| {
            let k = n / f;
            (m.z_axis.z, m.w_axis.z) = (-1.0 / (1.0 - k), -n / (1.0 - k));
        })],
    },
    Fault {
        cause: "near and far are swapped: the near plane becomes z = -w, the far one z = w",
        hint: Some(3),
        versions: &[matrix!(
            |m, _l, _r, _b, _t, _n, _f| (m.z_axis.z, m.w_axis.z) = (-m.z_axis.z, -m.w_axis.z)
        )],
    },
    Fault {
        cause: "a sign in the row of depths is wrong: put z = -n and z = -f in, and see whether -n and f come out",
        hint: Some(3),
        versions: &[
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.z_axis.z = -m.z_axis.z),
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.w_axis.z = -m.w_axis.z),
        ],
    },
    Fault {
        cause: "a factor is missing in -2fn / (f - n): put z = -n and z = -f in, and see whether -n and f come out",
        hint: Some(3),
        versions: &[
            matrix!(|m, _l, _r, _b, _t, _n, _f| m.w_axis.z /= 2.0),
            matrix!(|m, _l, _r, _b, _t, n, _f| m.w_axis.z /= n),
            matrix!(|m, _l, _r, _b, _t, _n, f| m.w_axis.z /= f),
        ],
    },
    Fault {
        cause: "an infinite f makes NaN: divide above and below by f, so that only n / f is left of it",
        hint: Some(4),
        versions: &[
            Perspective {
                frustum: |l, r, b, t, n, f| {
                    (RIGHT.frustum)(l, r, b, t, n, f).map(|_| as_it_stands(l, r, b, t, n, f))
                },
                ..RIGHT
            },
            Perspective {
                frustum: |l, r, b, t, n, f| {
                    (RIGHT.frustum)(l, r, b, t, n, f)
                        .map(|_| as_it_stands(l, r, b, t, n, f))
                        .filter(Mat4::is_finite)
                },
                ..RIGHT
            },
            Perspective {
                frustum: |l, r, b, t, n, f| (RIGHT.frustum)(l, r, b, t, n, f).filter(|_| f.is_finite()),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "a large f overflows: f * n is no f32, so divide above and below by f",
        hint: Some(4),
        versions: &[Perspective {
            frustum: |l, r, b, t, n, f| {
                let right = (RIGHT.frustum)(l, r, b, t, n, f)?;
                Some(if f.is_infinite() { right } else { as_it_stands(l, r, b, t, n, f) })
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "what is no frustum is not refused: None unless 0 < n < f, l != r and b != t, and all but f are finite",
        hint: Some(4),
        versions: &[
            Perspective { frustum: |l, r, b, t, n, f| Some(in_the_limit(l, r, b, t, n, f)), ..RIGHT },
            Perspective {
                frustum: |l, r, b, t, n, f| Some(in_the_limit(l, r, b, t, n, f)).filter(Mat4::is_finite),
                ..RIGHT
            },
            Perspective {
                frustum: |l, r, b, t, n, f| {
                    Some(in_the_limit(l, r, b, t, n, f)).filter(|_| !(n <= 0.0 || f <= n || l == r || b == t))
                },
                ..RIGHT
            },
            Perspective {
                frustum: |l, r, b, t, n, f| Some(in_the_limit(l, r, b, t, n, f)).filter(|_| 0.0 < n && n < f),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the weights are those in the picture: the texture bends, as in lesson 9",
        hint: Some(5),
        versions: &[
            Perspective { perspective_weights: |weights, _| weights, ..RIGHT },
            Perspective { perspective_weights: |weights, _| each_over(weights), ..RIGHT },
        ],
    },
    Fault {
        cause: "the weights do not add up to 1: divide by the sum of the products",
        hint: Some(5),
        versions: &[
            Perspective { perspective_weights: |weights, inverse_w| weights * inverse_w, ..RIGHT },
            Perspective {
                perspective_weights: |weights, inverse_w| weights * inverse_w / inverse_w.element_sum(),
                ..RIGHT
            },
            Perspective {
                perspective_weights: |weights, inverse_w| weights * inverse_w / weights.element_sum(),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "what is far counts more: multiply by 1/w, which is what you are given, and do not divide by it",
        hint: Some(5),
        versions: &[
            Perspective { perspective_weights: |weights, inverse_w| each_over(weights / inverse_w), ..RIGHT },
            Perspective { perspective_weights: |weights, inverse_w| weights / inverse_w, ..RIGHT },
        ],
    },
    Fault {
        cause: "multiplied by the pixel's depth and not by its corners' 1/w: each corner has a factor of its own",
        hint: Some(5),
        versions: &[Perspective {
            perspective_weights: |weights, inverse_w| weights / weights.dot(inverse_w),
            ..RIGHT
        }],
    },
    Fault {
        cause: "the reciprocal of the depth is interpolated wrongly: it is the mean of the 1/w, not one over the mean of the w",
        hint: Some(5),
        versions: &[Perspective {
            perspective_weights: |weights, inverse_w| weights * inverse_w * weights.dot(inverse_w.recip()),
            ..RIGHT
        }],
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
        JUDGE.earns_nothing(&Perspective {
            frustum: |_, _, _, _, _, _| None,
            perspective_weights: |weights, _| weights,
        });
    }

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let frustum =
            |frustum, check, words| JUDGE.recognises(&Perspective { frustum, ..RIGHT }, check, words);
        frustum(
            |l, r, b, t, n, f| {
                // As one of the hand-written drafts of the derivation has it.
                let depth = [0.0, 0.0, -(f + n) / (f - n), -2.0 * f / (f - n)];
                (RIGHT.frustum)(l, r, b, t, n, f)?;
                let x = [2.0 * n / (r - l), 0.0, (r + l) / (r - l), 0.0];
                let y = [0.0, 2.0 * n / (t - b), (t + b) / (t - b), 0.0];
                Some(Mat4::from_cols_array_2d(&[x, y, depth, [0.0, 0.0, -1.0, 0.0]]).transpose())
            },
            "frustum",
            "a factor is missing",
        );
        frustum(
            |l, r, b, t, n, f| Some((RIGHT.frustum)(l, r, b, t, n, f)?.transpose()),
            "frustum",
            "rows and columns",
        );
        frustum(
            |l, r, b, t, n, f| {
                let bad = n <= 0.0 || f <= n || l == r || b == t;
                (!bad).then(|| as_it_stands(l, r, b, t, n, f))
            },
            "far",
            "infinite f",
        );
        let weights = |perspective_weights, words| {
            JUDGE.recognises(&Perspective { perspective_weights, ..RIGHT }, "weights", words);
        };
        weights(|weights, _| weights, "those in the picture");
        weights(|weights, inverse_w| weights * inverse_w, "do not add up");
        weights(
            |weights, inverse_w| {
                let far = weights * (1.0 / inverse_w);
                far / (far.x + far.y + far.z)
            },
            "what is far counts more",
        );
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
