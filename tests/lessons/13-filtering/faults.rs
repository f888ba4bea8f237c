//! Wrong versions of mission 13, by which the judge knows what was done.

use common::{Vec2, Vec2Swizzles, Vec3};
use filtering_tasks::Filtering;
use filtering_tasks::given::{Footprint, Level, Wrap};
use judge::Fault;

use crate::RIGHT;

/// Where (u, v) lies in texels, centres being whole numbers.
fn place(texels: &Level, uv: Vec2) -> Vec2 {
    uv * size(texels) - 0.5
}

fn size(texels: &Level) -> Vec2 {
    Vec2::new(texels.width() as f32, texels.height() as f32)
}

/// The light of any texel.
fn light(texels: &Level, i: i32, j: i32, wrap: Wrap) -> Vec3 {
    texels.light(wrap.texel(i, texels.width()), wrap.texel(j, texels.height()))
}

/// Blends the four lights from (i, j) on, those of the columns on the right and of the rows above by these shares.
fn blend(texels: &Level, [i, j]: [i32; 2], share: Vec2, wrap: Wrap) -> Vec3 {
    let [below, above] = [j, j + 1].map(|j| {
        let [a, b] = [i, i + 1].map(|i| light(texels, i, j, wrap));
        a + (b - a) * share.x
    });
    below + (above - below) * share.y
}

/// At a place in texels, as if centres were whole numbers.
fn between(texels: &Level, place: Vec2, wrap: Wrap) -> Vec3 {
    let corner = place.floor();
    blend(texels, corner.as_ivec2().to_array(), place - corner, wrap)
}

/// What lies outside is in the bounds of a row, after the four texels were chosen.
fn clamped(texels: &Level, uv: Vec2) -> Vec3 {
    between(texels, place(texels, uv), Wrap::Clamp)
}

macro_rules! bilinear {
    (|$texels:ident, $uv:ident, $wrap:ident| $result:expr) => {
        Filtering {
            bilinear: |$texels, $uv, $wrap| {
                let _ = ($texels, $uv, $wrap);
                $result
            },
            ..RIGHT
        }
    };
}

/// The level by another length of the footprint, of its two sides in texels.
macro_rules! level {
    (|$x:ident, $y:ident| $length:expr) => {
        Filtering {
            level: |footprint, size| {
                let ($x, $y): (Vec2, Vec2) = (footprint.x * size, footprint.y * size);
                let _ = ($x, $y);
                let length: f32 = $length;
                length.log2()
            },
            ..RIGHT
        }
    };
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Filtering>] = &[
    Fault {
        cause: "half a texel off: the centre of the first texel is at ½, so take ½ off before you round down",
        hint: Some(1),
        versions: &[
            bilinear!(|texels, uv, wrap| between(texels, uv * size(texels), wrap)),
            bilinear!(|texels, uv, wrap| between(texels, uv * size(texels) + 0.5, wrap)),
        ],
    },
    Fault {
        cause: "the texture is a texel too small: (u, v) from 0 to 1 are as many texels as there are, not one less",
        hint: Some(1),
        versions: &[
            bilinear!(|texels, uv, wrap| between(texels, uv * (size(texels) - 1.0), wrap)),
            bilinear!(|texels, uv, wrap| between(texels, uv * (size(texels) - 1.0) - 0.5, wrap)),
        ],
    },
    Fault {
        cause: "width and height are one number here: u is counted in the width, v in the height",
        hint: None,
        versions: &[
            bilinear!(|texels, uv, wrap| between(texels, uv * size(texels).x - 0.5, wrap)),
            bilinear!(|texels, uv, wrap| between(texels, uv * size(texels).y - 0.5, wrap)),
            bilinear!(|texels, uv, wrap| between(texels, uv * size(texels).yx() - 0.5, wrap)),
        ],
    },
    Fault {
        cause: "u and v are exchanged: u goes along the columns, v up the rows",
        hint: None,
        versions: &[bilinear!(|texels, uv, wrap| between(texels, place(texels, uv.yx()), wrap))],
    },
    Fault {
        cause: "the texture is upside down: row 0 is at the bottom, where v is 0",
        hint: None,
        versions: &[bilinear!(|texels, uv, wrap| {
            between(texels, place(texels, Vec2::new(uv.x, 1.0 - uv.y)), wrap)
        })],
    },
    Fault {
        cause: "this is the texel that (u, v) is in, or a corner of the four: blend all four",
        hint: Some(2),
        versions: &[
            bilinear!(|texels, uv, wrap| {
                let [i, j] = (uv * size(texels)).floor().as_ivec2().to_array();
                light(texels, i, j, wrap)
            }),
            bilinear!(|texels, uv, wrap| {
                let [i, j] = place(texels, uv).floor().as_ivec2().to_array();
                light(texels, i, j, wrap)
            }),
        ],
    },
    Fault {
        cause: "the mean of the four, wherever (u, v) is: the nearer a centre, the more it counts",
        hint: Some(2),
        versions: &[bilinear!(|texels, uv, wrap| {
            let corner = place(texels, uv).floor().as_ivec2().to_array();
            blend(texels, corner, Vec2::splat(0.5), wrap)
        })],
    },
    Fault {
        cause: "blended in one direction only: first along the two rows, then between them",
        hint: Some(2),
        versions: &[
            bilinear!(|texels, uv, wrap| {
                let (place, corner) = (place(texels, uv), place(texels, uv).floor());
                blend(texels, corner.as_ivec2().to_array(), (place - corner) * Vec2::X, wrap)
            }),
            bilinear!(|texels, uv, wrap| {
                let (place, corner) = (place(texels, uv), place(texels, uv).floor());
                blend(texels, corner.as_ivec2().to_array(), (place - corner) * Vec2::Y, wrap)
            }),
        ],
    },
    Fault {
        cause: "weights are the wrong way round: the nearer a centre, the more it counts",
        hint: Some(2),
        versions: &[
            bilinear!(|texels, uv, wrap| {
                let (place, corner) = (place(texels, uv), place(texels, uv).floor());
                blend(texels, corner.as_ivec2().to_array(), 1.0 - (place - corner), wrap)
            }),
            bilinear!(|texels, uv, wrap| {
                let (place, corner) = (place(texels, uv), place(texels, uv).floor());
                blend(texels, corner.as_ivec2().to_array(), (place - corner).yx(), wrap)
            }),
        ],
    },
    Fault {
        cause: "codes are blended, not light: blend what texels.light gives",
        hint: None,
        versions: &[bilinear!(|texels, uv, wrap| {
            let (place, corner) = (place(texels, uv), place(texels, uv).floor());
            let code = |i: i32, j: i32| {
                let (i, j) = (wrap.texel(i, texels.width()), wrap.texel(j, texels.height()));
                texels
                    .image
                    .get(i, j)
                    .map_or(Vec3::ZERO, |c| Vec3::from_array([c.r, c.g, c.b].map(f32::from)))
            };
            let ([i, j], share) = (corner.as_ivec2().to_array(), place - corner);
            let [below, above] = [j, j + 1].map(|j| code(i, j) + (code(i + 1, j) - code(i, j)) * share.x);
            below + (above - below) * share.y
        })],
    },
    Fault {
        cause: "a cast cuts off, and so rounds up where the number is below 0: floor() first, then the cast",
        hint: Some(3),
        versions: &[
            // The share is taken from the rounded number.
            bilinear!(|texels, uv, wrap| {
                let place = place(texels, uv);
                let corner = place.trunc();
                blend(texels, corner.as_ivec2().to_array(), place - corner, wrap)
            }),
            // Or it is what stands behind the point.
            bilinear!(|texels, uv, wrap| {
                let place = place(texels, uv);
                blend(texels, place.trunc().as_ivec2().to_array(), place - place.floor(), wrap)
            }),
        ],
    },
    Fault {
        cause: "texels beyond the border are always those at the border: ask wrap for each of the four columns and rows",
        hint: Some(3),
        versions: &[
            bilinear!(|texels, uv, wrap| clamped(texels, uv)),
            // The first is wrapped, and the one after it clamped.
            bilinear!(|texels, uv, wrap| {
                let (place, corner) = (place(texels, uv), place(texels, uv).floor());
                let (w, h) = (texels.width(), texels.height());
                let [i, j] = corner.as_ivec2().to_array();
                let (i, j) = (wrap.texel(i, w), wrap.texel(j, h));
                blend(texels, [i, j], place - corner, Wrap::Clamp)
            }),
        ],
    },
    Fault {
        cause: "the neighbour is that of the wrapped texel: add 1 first, then ask wrap, since a mirror image runs back",
        hint: Some(3),
        versions: &[bilinear!(|texels, uv, wrap| {
            let (place, corner) = (place(texels, uv), place(texels, uv).floor());
            let [i, j] = corner.as_ivec2().to_array();
            let first = [wrap.texel(i, texels.width()), wrap.texel(j, texels.height())];
            blend(texels, first, place - corner, wrap)
        })],
    },
    Fault {
        cause: "the texture is always repeated: what is outside is for wrap to say",
        hint: Some(3),
        versions: &[bilinear!(|texels, uv, wrap| between(texels, place(texels, uv), Wrap::Repeat))],
    },
    Fault {
        cause: "the footprint is in textures, not in texels: multiply it by the size",
        hint: Some(4),
        versions: &[Filtering {
            level: |footprint: Footprint, _| footprint.x.length().max(footprint.y.length()).log2(),
            ..RIGHT
        }],
    },
    Fault {
        cause: "u is counted in the width, v in the height: multiply both sides by the size number by number, before their length",
        hint: Some(4),
        versions: &[
            Filtering {
                level: |f: Footprint, size| (f.x.length().max(f.y.length()) * size.x).log2(),
                ..RIGHT
            },
            Filtering {
                level: |f: Footprint, size| (f.x.length().max(f.y.length()) * size.max_element()).log2(),
                ..RIGHT
            },
            // One side by the width, the other by the height.
            Filtering {
                level: |f: Footprint, size| (f.x.length() * size.x).max(f.y.length() * size.y).log2(),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "this is the shorter side: by it the other direction flickers",
        hint: Some(4),
        versions: &[level!(|x, y| x.length().min(y.length()))],
    },
    Fault {
        cause: "the longer side counts, and not the area, the sum or the mean of the two",
        hint: Some(4),
        versions: &[
            level!(|x, y| x.perp_dot(y).abs().sqrt()),
            level!(|x, y| (x.length() * y.length()).sqrt()),
            level!(|x, y| x.length() + y.length()),
            level!(|x, y| (x.length() + y.length()) / 2.0),
            level!(|x, y| (x.length_squared() + y.length_squared()).sqrt()),
        ],
    },
    Fault {
        cause: "only one side of the footprint is looked at: the longer of the two counts",
        hint: Some(4),
        versions: &[level!(|x, y| x.length()), level!(|x, y| y.length())],
    },
    Fault {
        cause: "a side is as long as its vector, not as its longer coordinate or the sum of both",
        hint: Some(4),
        versions: &[
            level!(|x, y| x.abs().max_element().max(y.abs().max_element())),
            level!(|x, y| x.abs().element_sum().max(y.abs().element_sum())),
        ],
    },
    Fault {
        cause: "twice the level: the logarithm of the square is twice that of the length",
        hint: Some(4),
        versions: &[level!(|x, y| x.length_squared().max(y.length_squared()))],
    },
    Fault {
        cause: "how often 1 is doubled is the logarithm to the base 2: log2, not ln or log10, and not the length itself",
        hint: Some(4),
        versions: &[
            Filtering {
                level: |f: Footprint, size| (f.x * size).length().max((f.y * size).length()),
                ..RIGHT
            },
            Filtering {
                level: |f: Footprint, size| (f.x * size).length().max((f.y * size).length()).ln(),
                ..RIGHT
            },
            Filtering {
                level: |f: Footprint, size| (f.x * size).length().max((f.y * size).length()).log10(),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the level is a whole number, or never below 0: it may be any number, and whoever draws clamps it",
        hint: Some(4),
        versions: &[
            Filtering { level: |footprint, size| (RIGHT.level)(footprint, size).floor(), ..RIGHT },
            Filtering { level: |footprint, size| (RIGHT.level)(footprint, size).round(), ..RIGHT },
            Filtering { level: |footprint, size| (RIGHT.level)(footprint, size).max(0.0), ..RIGHT },
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
        JUDGE.earns_nothing(&Filtering { bilinear: |_, _, _| Vec3::ZERO, level: |_, _| 0.0 });
    }

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let filter = |bilinear, check, words| {
            JUDGE.recognises(&Filtering { bilinear, ..RIGHT }, check, words);
        };
        filter(
            |texels, uv, wrap| {
                let (w, h) = (texels.width(), texels.height());
                let (x, y) = (uv.x * w as f32, uv.y * h as f32);
                let (i, j) = (x.floor(), y.floor());
                let at = |i: i32, j: i32| texels.light(wrap.texel(i, w), wrap.texel(j, h));
                let (i0, j0, s, t) = (i as i32, j as i32, x - i, y - j);
                at(i0, j0) * ((1.0 - s) * (1.0 - t))
                    + at(i0 + 1, j0) * (s * (1.0 - t))
                    + at(i0, j0 + 1) * ((1.0 - s) * t)
                    + at(i0 + 1, j0 + 1) * (s * t)
            },
            "centres",
            "half a texel off",
        );
        filter(
            |texels, uv, wrap| {
                let (w, h) = (texels.width(), texels.height());
                let (x, y) = (uv.x * w as f32 - 0.5, uv.y * h as f32 - 0.5);
                let (i, j) = (x as i32, y as i32);
                let (s, t) = (x - i as f32, y - j as f32);
                let at = |i: i32, j: i32| texels.light(wrap.texel(i, w), wrap.texel(j, h));
                let below = at(i, j) * (1.0 - s) + at(i + 1, j) * s;
                let above = at(i, j + 1) * (1.0 - s) + at(i + 1, j + 1) * s;
                below * (1.0 - t) + above * t
            },
            "borders",
            "a cast cuts off",
        );
        let level = |level, words| JUDGE.recognises(&Filtering { level, ..RIGHT }, "level", words);
        level(
            |f, size| (f.x * size).length_squared().max((f.y * size).length_squared()).log2(),
            "twice the level",
        );
        level(|f, size| (f.x * size).length().hypot((f.y * size).length()).log2(), "not the area");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
