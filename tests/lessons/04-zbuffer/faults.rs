//! Wrong versions of mission 4, by which the judge knows what was done.

use common::{Image, Vec3};
use judge::Fault;
use zbuffer::depth_at;
use zbuffer_tasks::Zbuffer;
use zbuffer_tasks::given::{DepthBuffer, Surface};

use crate::RIGHT;

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Zbuffer>] = &[
    Fault {
        cause: "the second of two equal ones covers the first: nearer is >, not >=",
        hint: None,
        versions: &[
            Zbuffer {
                z_f32: |surfaces, image| nearest(surfaces, image, not_farther),
                fill_nearest: |c, depths, store, visit| not_farther(c, depths, store, visit),
            },
            Zbuffer { z_f32: |surfaces, image| nearest(surfaces, image, not_farther), ..RIGHT },
        ],
    },
    Fault {
        cause: "the depth itself is compared or kept: the buffer holds store(depth), so compare that",
        hint: None,
        versions: &[
            Zbuffer {
                fill_nearest: |c, depths, _, visit| (RIGHT.fill_nearest)(c, depths, |depth| depth, visit),
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| {
                    each(c, depths, |depths, x, y, w, depth| {
                        if depth > depths.get(x, y) {
                            depths.set(x, y, store(depth));
                            visit(x, y, w);
                        }
                    });
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the last one drawn is seen: draw only what is nearer than the buffer says, and keep its depth there",
        hint: Some(3),
        versions: &[
            Zbuffer {
                fill_nearest: |c, depths, _, visit| each(c, depths, |_, x, y, w, _| visit(x, y, w)),
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| {
                    each(c, depths, |depths, x, y, w, depth| {
                        depths.set(x, y, store(depth));
                        visit(x, y, w);
                    });
                },
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| {
                    each(c, depths, |depths, x, y, w, depth| {
                        if store(depth) > depths.get(x, y) {
                            visit(x, y, w);
                        }
                    });
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the first one drawn is seen: what is nearer than the buffer says must be drawn over it",
        hint: None,
        versions: &[Zbuffer {
            fill_nearest: |c, depths, store, visit| {
                each(c, depths, |depths, x, y, w, depth| {
                    if depths.get(x, y) == f32::NEG_INFINITY {
                        depths.set(x, y, store(depth));
                        visit(x, y, w);
                    }
                });
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "nothing passes the depth test: a larger depth is nearer, so compare with >",
        hint: Some(2),
        versions: &[Zbuffer {
            fill_nearest: |c, depths, store, visit| {
                each(c, depths, |depths, x, y, w, depth| {
                    if store(depth) < depths.get(x, y) {
                        depths.set(x, y, store(depth));
                        visit(x, y, w);
                    }
                });
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "wrong sign of depth, the far one is seen: a larger depth is nearer, and is kept as it is",
        hint: None,
        versions: &[Zbuffer {
            fill_nearest: |c, depths, store, visit| {
                (RIGHT.fill_nearest)(c.map(|corner| Vec3 { z: -corner.z, ..corner }), depths, store, visit);
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the depth is kept of each pixel, also where it is farther: set() belongs into the if",
        hint: None,
        versions: &[Zbuffer {
            fill_nearest: |c, depths, store, visit| {
                each(c, depths, |depths, x, y, w, depth| {
                    if store(depth) > depths.get(x, y) {
                        visit(x, y, w);
                    }
                    depths.set(x, y, store(depth));
                });
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the whole triangle has one depth: at each pixel it is the sum of the corners' z times their weights",
        hint: None,
        versions: &[
            Zbuffer {
                fill_nearest: |c, depths, store, visit| level(c, depths, store, visit, c[0].z),
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| {
                    let mean = (c[0].z + c[1].z + c[2].z) / 3.0;
                    level(c, depths, store, visit, mean);
                },
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| {
                    let nearest = c[0].z.max(c[1].z).max(c[2].z);
                    level(c, depths, store, visit, nearest);
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the weights are turned: the first one belongs to the first corner's z",
        hint: None,
        versions: &[
            Zbuffer {
                fill_nearest: |c, depths, store, visit| turned(c, depths, store, visit, [1, 2, 0]),
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| turned(c, depths, store, visit, [2, 0, 1]),
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| turned(c, depths, store, visit, [0, 2, 1]),
                ..RIGHT
            },
            Zbuffer {
                fill_nearest: |c, depths, store, visit| turned(c, depths, store, visit, [2, 1, 0]),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the buffer starts too near, what is behind that is not drawn: begin with f32::NEG_INFINITY",
        hint: Some(2),
        versions: &[
            Zbuffer { z_f32: |surfaces, image| starting_at(surfaces, image, 0.0), ..RIGHT },
            Zbuffer { z_f32: |surfaces, image| starting_at(surfaces, image, -1.0), ..RIGHT },
            Zbuffer { z_f32: |surfaces, image| starting_at(surfaces, image, f32::MIN), ..RIGHT },
            Zbuffer { z_f32: |surfaces, image| starting_at(surfaces, image, f32::MIN_POSITIVE), ..RIGHT },
        ],
    },
    Fault {
        cause: "the buffer starts at infinity, which nothing is nearer than: begin with f32::NEG_INFINITY",
        hint: Some(2),
        versions: &[
            Zbuffer { z_f32: |surfaces, image| starting_at(surfaces, image, f32::INFINITY), ..RIGHT },
            Zbuffer { z_f32: |surfaces, image| starting_at(surfaces, image, f32::MAX), ..RIGHT },
        ],
    },
    Fault {
        cause: "each surface has a buffer of its own: make one, before the loop",
        hint: None,
        versions: &[Zbuffer {
            z_f32: |surfaces, image| {
                let empty = DepthBuffer::new(image, f32::NEG_INFINITY);
                surfaces.iter().fold(empty, |_, &surface| nearest(&[surface], image, nearer))
            },
            ..RIGHT
        }],
    },
];

type Depths<'a> = &'a mut DepthBuffer<f32>;
type Visit<'a> = &'a mut dyn FnMut(i32, i32, Vec3);
/// A loop of corners, depths, how a depth is stored, and what is done with the pixels that are seen.
type Fill = fn([Vec3; 3], Depths, fn(f32) -> f32, Visit);

/// Each pixel of a triangle, with its weights and depth.
fn each(corners: [Vec3; 3], depths: Depths, mut pixel: impl FnMut(Depths, i32, i32, Vec3, f32)) {
    let z = Vec3::from_array(corners.map(|corner| corner.z));
    triangles::fill(corners.map(Vec3::truncate), depths.bounds(), |x, y, weights| {
        pixel(depths, x, y, weights, depth_at(z, weights));
    });
}

fn level(corners: [Vec3; 3], depths: Depths, store: fn(f32) -> f32, visit: Visit, z: f32) {
    (RIGHT.fill_nearest)(corners.map(|corner| Vec3 { z, ..corner }), depths, store, visit);
}

fn turned(corners: [Vec3; 3], depths: Depths, store: fn(f32) -> f32, visit: Visit, order: [usize; 3]) {
    let z = order.map(|n| corners[n].z);
    let other = [0, 1, 2].map(|n| Vec3 { z: z[n], ..corners[n] });
    (RIGHT.fill_nearest)(other, depths, store, visit);
}

/// As it should be. The lesson's own would be on another buffer, and all of it copied for each triangle.
fn nearer(corners: [Vec3; 3], depths: Depths, store: fn(f32) -> f32, visit: Visit) {
    each(corners, depths, |depths, x, y, weights, depth| {
        if store(depth) > depths.get(x, y) {
            depths.set(x, y, store(depth));
            visit(x, y, weights);
        }
    });
}

fn not_farther(corners: [Vec3; 3], depths: Depths, store: fn(f32) -> f32, visit: Visit) {
    each(corners, depths, |depths, x, y, weights, depth| {
        if store(depth) >= depths.get(x, y) {
            depths.set(x, y, store(depth));
            visit(x, y, weights);
        }
    });
}

fn nearest(surfaces: &[Surface], image: &mut Image, fill: Fill) -> DepthBuffer<f32> {
    drawn(surfaces, image, fill, f32::NEG_INFINITY)
}

fn starting_at(surfaces: &[Surface], image: &mut Image, nothing: f32) -> DepthBuffer<f32> {
    drawn(surfaces, image, nearer, nothing)
}

fn drawn(surfaces: &[Surface], image: &mut Image, fill: Fill, nothing: f32) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, nothing);
    for surface in surfaces {
        fill(surface.corners, &mut depths, |depth| depth, &mut |x, y, _| image.set(x, y, surface.color));
    }
    depths
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
        JUDGE.earns_nothing(&Zbuffer {
            fill_nearest: |_, _, _, _| (),
            z_f32: |_, image| DepthBuffer::new(image, f32::NEG_INFINITY),
        });
    }

    #[test]
    fn each_fault_is_recognised() {
        let reference = JUDGE.reference;
        let check = |fill_nearest, check, words| {
            let functions = Zbuffer { fill_nearest, z_f32: reference.z_f32 };
            JUDGE.recognises(&functions, check, words);
        };
        check(
            |corners, depths, store, visit| {
                (RIGHT.fill_nearest)(corners.map(|c| Vec3 { z: -c.z, ..c }), depths, store, visit);
            },
            "pairs",
            "wrong sign of depth",
        );
        check(
            |corners, depths, store, visit| {
                (RIGHT.fill_nearest)(corners.map(|c| Vec3 { z: -c.z, ..c }), depths, store, visit);
            },
            "depths",
            "wrong sign of depth",
        );
        check(
            |corners, depths, _, visit| {
                triangles::fill(corners.map(Vec3::truncate), depths.bounds(), visit);
            },
            "pairs",
            "the last one drawn is seen",
        );
        check(
            |corners, depths, store, visit| {
                let z = Vec3::from_array(corners.map(|corner| corner.z));
                triangles::fill(corners.map(Vec3::truncate), depths.bounds(), |x, y, weights| {
                    if store(weights.dot(z)) < depths.get(x, y) {
                        depths.set(x, y, store(weights.dot(z)));
                        visit(x, y, weights);
                    }
                });
            },
            "pairs",
            "nothing passes",
        );
        let equal = Zbuffer {
            z_f32: |surfaces, image| {
                let reversed: Vec<_> = surfaces.iter().rev().copied().collect();
                (RIGHT.z_f32)(&reversed, image)
            },
            ..reference
        };
        JUDGE.recognises(&equal, "equal", "nearer is >");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
