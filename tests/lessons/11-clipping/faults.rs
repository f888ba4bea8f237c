//! Wrong versions of mission 11, by which the judge knows what was done.

use clipping_tasks::Clipping;
use clipping_tasks::given::ClipVertex;
use common::{DVec3, Vec2, Vec4, Vec4Swizzles};
use judge::Fault;

use crate::RIGHT;

/// The lesson's clipper, side by side, to be spoilt.
fn sides(
    polygon: &[ClipVertex],
    plane: Vec4,
    count: usize,
    mut side: impl FnMut(&mut Vec<ClipVertex>, [ClipVertex; 2], [f32; 2]),
) -> Vec<ClipVertex> {
    let mut result = Vec::new();
    for i in 0..count {
        let ends = [polygon[i], polygon[(i + 1) % polygon.len()]];
        side(&mut result, ends, ends.map(|end| plane.dot(end.position)));
    }
    result
}

/// At the share t of the way.
fn at([a, b]: [ClipVertex; 2], t: f32) -> ClipVertex {
    ClipVertex { position: a.position + (b.position - a.position) * t, uv: a.uv + (b.uv - a.uv) * t }
}

fn right_cut(ends: [ClipVertex; 2], [from, to]: [f32; 2]) -> ClipVertex {
    let (weight_a, weight_b) = (-to / (from - to), from / (from - to));
    ClipVertex {
        position: ends[0].position * weight_a + ends[1].position * weight_b,
        uv: ends[0].uv * weight_a + ends[1].uv * weight_b,
    }
}

/// All sides but the last.
fn open(polygon: &[ClipVertex], plane: Vec4) -> Vec<ClipVertex> {
    sides(polygon, plane, polygon.len().saturating_sub(1), |result, ends, distances| {
        if distances[0] >= 0.0 {
            result.push(ends[0]);
        }
        if (distances[0] >= 0.0) != (distances[1] >= 0.0) {
            result.push(right_cut(ends, distances));
        }
    })
}

/// The clipper with another cut.
fn with_cut(
    polygon: &[ClipVertex],
    plane: Vec4,
    cut: fn([ClipVertex; 2], [f32; 2]) -> ClipVertex,
) -> Vec<ClipVertex> {
    sides(polygon, plane, polygon.len(), |result, ends, [from, to]| {
        if from >= 0.0 {
            result.push(ends[0]);
        }
        if (from >= 0.0) != (to >= 0.0) {
            result.push(cut(ends, [from, to]));
        }
    })
}

macro_rules! cut {
    (|$ends:ident, $distances:ident| $cut:expr) => {
        Clipping { clip: |polygon, plane| with_cut(polygon, plane, |$ends, $distances| $cut), ..RIGHT }
    };
}

/// The clipper that adds, for a side whose ends are inside or not, its first corner, the cut, its second corner.
fn adding(polygon: &[ClipVertex], plane: Vec4, adds: fn(bool, bool) -> [bool; 3]) -> Vec<ClipVertex> {
    sides(polygon, plane, polygon.len(), |result, ends, distances| {
        let [first, cut, second] = adds(distances[0] >= 0.0, distances[1] >= 0.0);
        if first {
            result.push(ends[0]);
        }
        if cut && (distances[0] >= 0.0) != (distances[1] >= 0.0) {
            result.push(right_cut(ends, distances));
        }
        if second {
            result.push(ends[1]);
        }
    })
}

macro_rules! adds {
    (|$from:ident, $to:ident| $adds:expr) => {
        Clipping { clip: |polygon, plane| adding(polygon, plane, |$from, $to| $adds), ..RIGHT }
    };
}

fn determinant([a, b, c]: [DVec3; 3]) -> f64 {
    a.cross(b).dot(c)
}

macro_rules! facing {
    (|$corners:ident| $facing:expr) => {
        Clipping { facing: |$corners| $facing, ..RIGHT }
    };
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Clipping>] = &[
    Fault {
        cause: "z stands where w belongs: the determinant is that of x, y and w",
        hint: Some(1),
        versions: &[facing!(|corners| determinant(corners.map(|corner| corner.xyz().as_dvec3())))],
    },
    Fault {
        cause: "the sign is turned: what faces the eye is above 0, with the corners in the order in which they come",
        hint: Some(1),
        versions: &[facing!(|corners| -(RIGHT.facing)(corners))],
    },
    Fault {
        cause: "the area after the division by w has the wrong sign for each corner behind the eye: divide nothing",
        hint: Some(1),
        versions: &[
            facing!(|corners| {
                let [a, b, c] = corners.map(|corner| corner.xy().as_dvec2() / f64::from(corner.w));
                (b - a).perp_dot(c - a)
            }),
            facing!(|corners| {
                let [a, b, c] = corners.map(|corner| corner.xy() / corner.w);
                f64::from((b - a).perp_dot(c - a))
            }),
        ],
    },
    Fault {
        cause: "computed in f32, where the terms cancel: as_dvec3() before anything is multiplied",
        hint: Some(1),
        versions: &[
            facing!(|corners| {
                let [a, b, c] = corners.map(Vec4Swizzles::xyw);
                f64::from(a.cross(b).dot(c))
            }),
            facing!(|corners| {
                let [a, b, c] = corners.map(Vec4Swizzles::xyw);
                a.cross(b).as_dvec3().dot(c.as_dvec3())
            }),
        ],
    },
    Fault {
        cause: "inside and outside are exchanged: inside is where plane.dot(position) is at least 0",
        hint: Some(2),
        versions: &[Clipping { clip: |polygon, plane| (RIGHT.clip)(polygon, -plane), ..RIGHT }],
    },
    Fault {
        cause: "the side from the last corner back to the first is missing",
        hint: Some(2),
        versions: &[
            Clipping { clip: |polygon, plane| open(polygon, plane), ..RIGHT },
            // The last corner is added, but not the cut after it.
            Clipping {
                clip: |polygon, plane| {
                    let mut result = open(polygon, plane);
                    result.extend(polygon.last().filter(|last| plane.dot(last.position) >= 0.0));
                    result
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "corners come twice: a side adds its first corner and its cut, and leaves its second corner to the next side",
        hint: Some(2),
        versions: &[
            adds!(|from, to| [from, true, to]),
            adds!(|from, to| [from, true, to && !from]),
            adds!(|from, to| [from, true, from && to]),
        ],
    },
    Fault {
        cause: "a side that leaves the inside adds no cut",
        hint: Some(2),
        versions: &[adds!(|from, _to| [from, !from, false])],
    },
    Fault {
        cause: "a side that comes in adds no cut",
        hint: Some(2),
        versions: &[
            adds!(|from, _to| [from, from, false]),
            // The second corner in place of the cut.
            adds!(|from, to| [from, from, to && !from]),
        ],
    },
    Fault {
        cause: "there are no cuts: corners outside are left out, and nothing takes their place",
        hint: Some(2),
        versions: &[adds!(|from, _to| [from, false, false])],
    },
    Fault {
        cause: "a side that leaves the inside does not add its first corner",
        hint: Some(2),
        versions: &[adds!(|from, to| [from && to, true, false])],
    },
    Fault {
        cause: "a polygon is cut only if all of it is outside, or left out if any corner is: a plane may pass through it",
        hint: Some(2),
        versions: &[
            Clipping {
                clip: |polygon, plane| {
                    let outside = |corner: &ClipVertex| plane.dot(corner.position) < 0.0;
                    if polygon.iter().all(outside) { Vec::new() } else { polygon.to_vec() }
                },
                ..RIGHT
            },
            Clipping {
                clip: |polygon, plane| {
                    let outside = |corner: &ClipVertex| plane.dot(corner.position) < 0.0;
                    if polygon.iter().any(outside) { Vec::new() } else { polygon.to_vec() }
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "only three sides are looked at: what was cut before has more corners",
        hint: Some(2),
        versions: &[Clipping {
            clip: |polygon, plane| (RIGHT.clip)(&polygon[..polygon.len().min(3)], plane),
            ..RIGHT
        }],
    },
    Fault {
        cause: "a corner right on the plane is outside: inside is where the product is at least 0, and not above it",
        hint: Some(5),
        versions: &[Clipping {
            clip: |polygon, plane| {
                sides(polygon, plane, polygon.len(), |result, ends, distances| {
                    if distances[0] > 0.0 {
                        result.push(ends[0]);
                    }
                    if (distances[0] > 0.0) != (distances[1] > 0.0) {
                        result.push(right_cut(ends, distances));
                    }
                })
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the share of the way is wrong: it is the first product over the first minus the second",
        hint: Some(3),
        versions: &[
            cut!(|ends, distances| at(ends, distances[0] / (distances[0] + distances[1]))),
            cut!(|ends, distances| at(ends, distances[0] / (distances[1] - distances[0]))),
            cut!(|ends, distances| at(ends, -distances[0] / distances[1])),
            cut!(|ends, _distances| at(ends, 0.5)),
        ],
    },
    Fault {
        cause: "the share is counted from the wrong end: at 0 the cut is the first corner",
        hint: Some(3),
        versions: &[
            cut!(|ends, distances| at([ends[1], ends[0]], distances[0] / (distances[0] - distances[1]))),
            cut!(|ends, distances| at(ends, distances[1] / (distances[1] - distances[0]))),
        ],
    },
    Fault {
        cause: "the cut is made after the division by w: its place is a share of the way in clip space, all four numbers",
        hint: Some(3),
        versions: &[cut!(|ends, distances| {
            let t = distances[0] / (distances[0] - distances[1]);
            let [a, b] = ends.map(|end| end.position / end.position.w);
            ClipVertex { position: a + (b - a) * t, ..at(ends, t) }
        })],
    },
    Fault {
        cause: "the texture coordinates are not cut: they go the same share of the way as the position",
        hint: Some(3),
        versions: &[
            cut!(|ends, distances| ClipVertex { uv: ends[0].uv, ..right_cut(ends, distances) }),
            cut!(|ends, distances| ClipVertex { uv: ends[1].uv, ..right_cut(ends, distances) }),
            cut!(|ends, distances| {
                let inside = if distances[0] >= 0.0 { ends[0] } else { ends[1] };
                ClipVertex { uv: inside.uv, ..right_cut(ends, distances) }
            }),
            cut!(|ends, distances| ClipVertex { uv: Vec2::ZERO, ..right_cut(ends, distances) }),
        ],
    },
    Fault {
        cause: "the texture coordinates are exchanged: each end's go with the weight that its position has",
        hint: Some(3),
        versions: &[cut!(|ends, distances| {
            let turned = right_cut(ends, [-distances[1], -distances[0]]);
            ClipVertex { uv: turned.uv, ..right_cut(ends, distances) }
        })],
    },
    Fault {
        cause: "the texture coordinates are corrected by w: before the division a share of the way is one in space already",
        hint: Some(3),
        versions: &[cut!(|ends, distances| {
            let t = distances[0] / (distances[0] - distances[1]);
            let [a, b] = ends.map(|end| end.position.w.recip());
            let share = t * b / ((1.0 - t) * a + t * b);
            ClipVertex { uv: at(ends, share).uv, ..right_cut(ends, distances) }
        })],
    },
    Fault {
        cause: "the last bits of a cut depend on the end that comes first: give each end a weight of its own",
        hint: Some(4),
        versions: &[
            cut!(|ends, distances| at(ends, distances[0] / (distances[0] - distances[1]))),
            cut!(|ends, distances| {
                let t = distances[0] / (distances[0] - distances[1]);
                ClipVertex {
                    position: ends[0].position * (1.0 - t) + ends[1].position * t,
                    uv: ends[0].uv * (1.0 - t) + ends[1].uv * t,
                }
            }),
            cut!(|ends, distances| {
                let t = distances[0] / (distances[0] - distances[1]);
                ClipVertex {
                    position: ends[0].position.lerp(ends[1].position, t),
                    uv: ends[0].uv.lerp(ends[1].uv, t),
                }
            }),
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
        JUDGE.earns_nothing(&Clipping { facing: |_| 0.0, clip: |_, _| Vec::new() });
    }

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let clip = |clip, check, words| JUDGE.recognises(&Clipping { clip, ..RIGHT }, check, words);
        clip(|polygon, plane| (RIGHT.clip)(polygon, plane * -2.0), "corners", "exchanged");
        // From the inner end, which is right for neighbours, but with the share of the other.
        clip(
            |polygon, plane| {
                with_cut(polygon, plane, |ends, distances| {
                    let t = distances[1] / (distances[1] - distances[0]);
                    at([ends[0], ends[1]], t)
                })
            },
            "corners",
            "wrong end",
        );
        JUDGE.recognises(
            &Clipping {
                facing: |corners| {
                    let [a, b, c] = corners.map(|corner| corner.xyw().as_dvec3());
                    b.cross(a).dot(c)
                },
                ..RIGHT
            },
            "facing",
            "the sign is turned",
        );
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
