//! Wrong versions of mission 3, by which the judge knows what was done.

use common::{Bounds, DVec2, DVec3, IVec2, Vec2, Vec3};
use judge::Fault;
use triangles_tasks::Triangles;

use crate::RIGHT;

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Triangles>] = &[
    Fault {
        cause: "clockwise triangles are missing: all their areas are negative, so divide by the whole area, which is \
                negative too, before you compare with 0",
        hint: Some(2),
        versions: &[
            Triangles {
                fill: |c, bounds, visit| {
                    if turn(c) > 0.0 {
                        right(c, bounds, visit);
                    }
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    if turn(c) > 0.0 {
                        ask(c, bounds, visit, CENTER, not_negative);
                    }
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the last row and column of the box are left out: the range includes its end, min..=max",
        hint: None,
        versions: &[Triangles {
            fill: |c, bounds, visit| {
                let last = c.into_iter().reduce(Vec2::max).unwrap_or_default().floor().as_ivec2();
                right(c, Bounds { max: bounds.max.min(last - 1), ..bounds }, visit);
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "a triangle without area is not left out: its weights are 0 / 0, which is NaN and not below 0",
        hint: None,
        versions: &[
            Triangles {
                fill: |c, bounds, visit| match turn(c) {
                    0.0 => ask(c, bounds, visit, CENTER, |_, _, _| true),
                    _ => right(c, bounds, visit),
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| match turn(c) {
                    // The points on the line have three areas of 0.
                    0.0 => ask(c, bounds, visit, CENTER, |areas, _, _| areas.cmpge(DVec3::ZERO).all()),
                    _ => right(c, bounds, visit),
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the last row and column of the bounds are left out: bounds.max is the last pixel that may be visited",
        hint: None,
        versions: &[Triangles {
            fill: |c, bounds, visit| right(c, Bounds { max: bounds.max - 1, ..bounds }, visit),
            ..RIGHT
        }],
    },
    Fault {
        cause: "a small triangle is given up: with less than half a pixel it may cover a centre, only without area it \
                covers none",
        hint: None,
        versions: &[
            Triangles {
                fill: |c, bounds, visit| {
                    if area(c.map(Vec2::as_dvec2)).abs() >= 1.0 {
                        right(c, bounds, visit);
                    }
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    if area(c.map(Vec2::as_dvec2)).abs() >= 1.0 {
                        ask(c, bounds, visit, CENTER, not_negative);
                    }
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "x and y are swapped: it is visit(x, y, weights)",
        hint: None,
        versions: &[Triangles {
            fill: |c, bounds, visit| triangles::fill(c, bounds, |x, y, weights| visit(y, x, weights)),
            ..RIGHT
        }],
    },
    Fault {
        cause: "the corners are moved to whole pixels: they may lie anywhere",
        hint: None,
        versions: &[
            Triangles { fill: |c, bounds, visit| right(c.map(Vec2::floor), bounds, visit), ..RIGHT },
            Triangles { fill: |c, bounds, visit| right(c.map(Vec2::round), bounds, visit), ..RIGHT },
            Triangles {
                fill: |c, bounds, visit| ask(c.map(Vec2::floor), bounds, visit, CENTER, not_negative),
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| ask(c.map(Vec2::round), bounds, visit, CENTER, not_negative),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the whole box is filled: visit a pixel only if none of its weights is below 0",
        hint: Some(1),
        versions: &[Triangles {
            fill: |c, bounds, visit| ask(c, bounds, visit, CENTER, |_, _, _| true),
            ..RIGHT
        }],
    },
    Fault {
        cause: "it is upside down: y points up, row 0 is the lowest",
        hint: None,
        versions: &[Triangles {
            fill: |c, bounds, visit| {
                let ends = bounds.min.y + bounds.max.y;
                triangles::fill(c, bounds, |x, y, weights| visit(x, ends - y, weights));
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "clockwise corners were swapped, and their weights not swapped back",
        hint: None,
        versions: &[Triangles {
            fill: |c, bounds, visit| {
                let turned = turn(c) < 0.0;
                triangles::fill(c, bounds, |x, y, w| {
                    visit(x, y, if turned { Vec3::new(w.x, w.z, w.y) } else { w });
                });
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the weights are turned: that of a corner is the area of the point and the *other* two",
        hint: None,
        versions: &[
            Triangles { fill: |c, bounds, visit| turned(c, bounds, visit, [1, 2, 0]), ..RIGHT },
            Triangles { fill: |c, bounds, visit| turned(c, bounds, visit, [2, 0, 1]), ..RIGHT },
            Triangles { fill: |c, bounds, visit| turned(c, bounds, visit, [0, 2, 1]), ..RIGHT },
            Triangles { fill: |c, bounds, visit| turned(c, bounds, visit, [1, 0, 2]), ..RIGHT },
            Triangles { fill: |c, bounds, visit| turned(c, bounds, visit, [2, 1, 0]), ..RIGHT },
        ],
    },
    Fault {
        cause: "the areas are not divided by the whole area: the sum of the weights is 1",
        hint: None,
        versions: &[
            Triangles {
                fill: |c, bounds, visit| {
                    let area = area(c.map(Vec2::as_dvec2)).abs() as f32;
                    triangles::fill(c, bounds, |x, y, weights| visit(x, y, weights * area));
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    triangles::fill(c, bounds, |x, y, weights| visit(x, y, weights * 2.0));
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    triangles::fill(c, bounds, |x, y, weights| visit(x, y, weights / 2.0));
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "pixels outside the bounds are visited: cut the box down to them",
        hint: None,
        versions: &[Triangles {
            fill: |c, _, visit| {
                right(c, Bounds { min: IVec2::splat(-200), max: IVec2::splat(200) }, visit);
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the top-left rule is not turned for clockwise triangles: walk their sides in the other direction",
        hint: Some(4),
        versions: &[Triangles {
            fill: |c, bounds, visit| {
                ask(c, bounds, visit, CENTER, |weights, sides, _| owned(weights, sides));
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "centres on a side belong to both neighbours, or neither: a left or level top side has them",
        hint: Some(4),
        versions: &[
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, CENTER, not_negative), ..RIGHT },
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, CENTER, positive), ..RIGHT },
            Triangles { fill: |c, bounds, visit| triangles::barycentric(c, bounds, visit), ..RIGHT },
        ],
    },
    Fault {
        cause: "the wrong sides have their centres: it is the left ones and the level top ones, where y points up",
        hint: Some(4),
        versions: &[
            // Right and bottom, left and bottom, right and top, left alone, top alone.
            Triangles {
                fill: |c, bounds, visit| {
                    ask(c, bounds, visit, CENTER, |w, s, turn| owned(w, s.map(|s| s * -turn)));
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    ask(c, bounds, visit, CENTER, |w, s, turn| {
                        owned(w, s.map(|s| s * DVec2::new(-turn, turn)))
                    });
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    ask(c, bounds, visit, CENTER, |w, s, turn| {
                        owned(w, s.map(|s| s * DVec2::new(turn, -turn)))
                    });
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    ask(c, bounds, visit, CENTER, |w, s, turn| {
                        turn != 0.0 && owned(w, s.map(|s| DVec2::new(0.0, s.y * turn)))
                    });
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    ask(c, bounds, visit, CENTER, |w, s, turn| {
                        turn != 0.0 && owned(w, s.map(|s| if s.y == 0.0 { s * turn } else { DVec2::X }))
                    });
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "another side is asked than the one that the centre is on: a weight of 0 means the side opposite to its \
                corner",
        hint: Some(4),
        versions: &[
            Triangles {
                fill: |c, bounds, visit| {
                    ask(c, bounds, visit, CENTER, |w, [a, b, c], turn| top_left(w, [b, c, a], turn));
                },
                ..RIGHT
            },
            Triangles {
                fill: |c, bounds, visit| {
                    ask(c, bounds, visit, CENTER, |w, [a, b, c], turn| top_left(w, [c, a, b], turn));
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "1 - u - v misses 0 by a rounding error: compute all three weights by areas",
        hint: Some(4),
        versions: &[Triangles { fill: rest, ..RIGHT }],
    },
    Fault {
        cause: "half a pixel is taken off: the centre is at (x + 0.5, y + 0.5)",
        hint: Some(3),
        versions: &[
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, -CENTER, top_left), ..RIGHT },
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, -CENTER, not_negative), ..RIGHT },
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, -CENTER, positive), ..RIGHT },
        ],
    },
    Fault {
        cause: "half a pixel is forgotten: ask about the centre, (x + 0.5, y + 0.5)",
        hint: Some(3),
        versions: &[
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, DVec2::ZERO, top_left), ..RIGHT },
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, DVec2::ZERO, not_negative), ..RIGHT },
            Triangles { fill: |c, bounds, visit| ask(c, bounds, visit, DVec2::ZERO, positive), ..RIGHT },
        ],
    },
    Fault {
        cause: "the normal points inside, as if light came from behind: it is (b - a) x (c - a)",
        hint: Some(5),
        versions: &[Triangles {
            flat_intensity: |[a, b, c], light| triangles::flat_intensity([a, c, b], light),
            ..RIGHT
        }],
    },
    Fault {
        cause: "a triangle without area gives NaN: its normal has no length, use normalize_or_zero()",
        hint: None,
        versions: &[Triangles { flat_intensity: |c, light| normal(c).normalize().dot(light), ..RIGHT }],
    },
    Fault {
        cause: "the normal is not 1 long: make it so before the dot product",
        hint: Some(5),
        versions: &[Triangles { flat_intensity: |c, light| normal(c).dot(light), ..RIGHT }],
    },
    Fault {
        cause: "the sides are 1 long, their product is not: make the product 1 long",
        hint: Some(5),
        versions: &[Triangles {
            flat_intensity: |[a, b, c], light| {
                (b - a).normalize_or_zero().cross((c - a).normalize_or_zero()).dot(light)
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the corners are multiplied: the normal is the product of two sides, b - a and c - a",
        hint: Some(5),
        versions: &[
            Triangles { flat_intensity: |[a, b, _], l| a.cross(b).normalize_or_zero().dot(l), ..RIGHT },
            Triangles { flat_intensity: |[_, b, c], l| b.cross(c).normalize_or_zero().dot(l), ..RIGHT },
        ],
    },
    Fault {
        cause: "the light is not asked: the cosine is between the normal and `light`",
        hint: None,
        versions: &[Triangles { flat_intensity: |c, _| normal(c).normalize_or_zero().z, ..RIGHT }],
    },
    Fault {
        cause: "it is the angle: the intensity is its cosine, which the dot product is already",
        hint: None,
        versions: &[
            Triangles { flat_intensity: |c, light| triangles::flat_intensity(c, light).acos(), ..RIGHT },
            Triangles { flat_intensity: |c, light| triangles::flat_intensity(c, light).cos(), ..RIGHT },
        ],
    },
    Fault {
        cause: "what faces away is not below 0: leave the sign, so that the caller can tell",
        hint: None,
        versions: &[
            Triangles { flat_intensity: |c, light| triangles::flat_intensity(c, light).max(0.0), ..RIGHT },
            Triangles { flat_intensity: |c, light| triangles::flat_intensity(c, light).abs(), ..RIGHT },
        ],
    },
];

type Visit<'a> = &'a mut dyn FnMut(i32, i32, Vec3);

const CENTER: DVec2 = DVec2::splat(0.5);

fn area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - a)
}

/// 1 for counterclockwise corners, -1 for clockwise ones, 0 without area.
fn turn(corners: [Vec2; 3]) -> f64 {
    match area(corners.map(Vec2::as_dvec2)) {
        0.0 => 0.0,
        area => area.signum(),
    }
}

/// Visits the pixels of the box of which the weights at a place in the pixel, the sides opposite to the corners and
/// the turn make it say so.
fn ask(
    corners: [Vec2; 3],
    bounds: Bounds,
    visit: Visit,
    place: DVec2,
    inside: fn(DVec3, [DVec2; 3], f64) -> bool,
) {
    let [min, max] = [Vec2::min, Vec2::max].map(|of| corners.into_iter().reduce(of).unwrap_or_default());
    let (min, max) = (min.floor().as_ivec2().max(bounds.min), max.floor().as_ivec2().min(bounds.max));
    let turn = turn(corners);
    let [a, b, c] = corners.map(Vec2::as_dvec2);
    let whole = area([a, b, c]);
    for y in min.y..=max.y {
        for x in min.x..=max.x {
            let p = IVec2::new(x, y).as_dvec2() + place;
            let areas = DVec3::new(area([b, c, p]), area([c, a, p]), area([a, b, p]));
            let weights = if whole == 0.0 { areas } else { areas / whole };
            if inside(weights, [c - b, a - c, b - a], turn) {
                visit(x, y, weights.as_vec3());
            }
        }
    }
}

/// As right, but in `f32`, and with the first weight as what the other two leave.
fn rest(corners: [Vec2; 3], bounds: Bounds, visit: Visit) {
    let [a, b, c] = corners;
    let area = |a: Vec2, b: Vec2, p: Vec2| (b - a).perp_dot(p - a);
    let [min, max] = [Vec2::min, Vec2::max].map(|of| of(of(a, b), c));
    let (min, max) = (min.floor().as_ivec2().max(bounds.min), max.floor().as_ivec2().min(bounds.max));
    for y in min.y..=max.y {
        for x in min.x..=max.x {
            let p = IVec2::new(x, y).as_vec2() + 0.5;
            let (u, v) = (area(c, a, p) / area(a, b, c), area(a, b, p) / area(a, b, c));
            let weights = Vec3::new(1.0 - u - v, u, v);
            if top_left(weights.as_dvec3(), [c - b, a - c, b - a].map(Vec2::as_dvec2), turn(corners)) {
                visit(x, y, weights);
            }
        }
    }
}

fn right(corners: [Vec2; 3], bounds: Bounds, visit: Visit) {
    triangles::fill(corners, bounds, visit);
}

fn turned(corners: [Vec2; 3], bounds: Bounds, visit: Visit, order: [usize; 3]) {
    triangles::fill(corners, bounds, |x, y, weights| {
        visit(x, y, Vec3::from_array(order.map(|n| weights[n])));
    });
}

/// Whether a point is inside, where the sides run counterclockwise.
fn owned(weights: DVec3, sides: [DVec2; 3]) -> bool {
    let has = |side: DVec2| side.y < 0.0 || side.y == 0.0 && side.x < 0.0;
    (0..3).all(|n| weights[n] > 0.0 || weights[n] == 0.0 && has(sides[n]))
}

fn top_left(weights: DVec3, sides: [DVec2; 3], turn: f64) -> bool {
    turn != 0.0 && owned(weights, sides.map(|side| side * turn))
}

fn not_negative(weights: DVec3, _: [DVec2; 3], turn: f64) -> bool {
    turn != 0.0 && weights.cmpge(DVec3::ZERO).all()
}

fn positive(weights: DVec3, _: [DVec2; 3], turn: f64) -> bool {
    turn != 0.0 && weights.cmpgt(DVec3::ZERO).all()
}

fn normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a)
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
        JUDGE.earns_nothing(&Triangles { fill: |_, _, _| (), flat_intensity: |_, _| 0.0 });
    }

    #[test]
    fn each_fault_is_recognised() {
        let reference = JUDGE.reference;
        let check = |fill, check, words| {
            let functions = Triangles { fill, flat_intensity: reference.flat_intensity };
            JUDGE.recognises(&functions, check, words);
        };
        check(
            |corners, bounds, visit| triangles::barycentric(corners, bounds, visit),
            "sides",
            "belong to both neighbours",
        );
        check(
            |corners, bounds, visit| {
                triangles::fill(corners, bounds, |x, y, w| visit(x, y, Vec3::new(w.y, w.z, w.x)));
            },
            "weights",
            "the weights are turned",
        );
        let down: triangles::Visit = |corners, bounds, visit| {
            let top = bounds.max.y + bounds.min.y;
            triangles::fill(corners, bounds, |x, y, weights| visit(x, top - y, weights));
        };
        check(down, "coverage", "upside down");
        let behind = Triangles {
            flat_intensity: |[a, b, c], light| triangles::flat_intensity([a, c, b], light),
            ..reference
        };
        JUDGE.recognises(&behind, "intensity", "behind");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
