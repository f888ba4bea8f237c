use std::collections::BTreeSet;

use assets::sphere::sphere;
use checks::coverage::Triangle;
use clipping::clip::MOST_CORNERS;
use clipping::plane::{PLANES, guard_band};
use clipping::render::fan;
use clipping::{ClipVertex, Clipping, Cull, METHODS, Polygon, clip};
use common::{Mat4, Vec2, Vec3, Vec4, Vec4Swizzles};
use fastrand::Rng;
use perspective::{perspective, view, window};
use proptest::prelude::*;
use triangles::fill;

use crate::soup::{drawn, eye};
use crate::stability::faults;

/// All ways but `leave-out`.
fn cutting() -> impl Iterator<Item = (&'static str, Clipping)> {
    METHODS.iter().filter(|method| method.name != "leave-out").map(|method| (method.name, method.run))
}

/// Within ±`reach`.
fn within(rng: &mut Rng, reach: f32) -> f32 {
    (2.0 * rng.f32() - 1.0) * reach
}

fn vertices<V: Copy>(positions: [Vec4; 3], varyings: [V; 3]) -> [ClipVertex<V>; 3] {
    [0, 1, 2].map(|n| ClipVertex { position: positions[n], varying: varyings[n] })
}

const SIDE: i32 = 16;

/// How often each pixel is covered by a polygon, as the renderer fills it, a fan of triangles.
fn covered(polygon: &Polygon<()>, counts: &mut [u32]) {
    let windows = polygon.corners().iter().map(|corner| window(corner.position, size()).unwrap());
    let windows: Vec<Vec4> = windows.collect();
    fan(&windows, &mut |triangle| {
        let corners = triangle.map(|corner| windows[corner].xy());
        fill(corners, verify::window(SIDE, SIDE), |x, y, _| counts[(y * SIDE + x) as usize] += 1);
    });
}

fn size() -> Vec2 {
    Vec2::splat(SIDE as f32)
}

/// Whether a pixel's centre is at most so many pixels from a side of a triangle.
fn near_a_side(corners: [Vec2; 3], x: i32, y: i32, distance: f64) -> bool {
    let p = (Vec2::new(x as f32, y as f32) + 0.5).as_dvec2();
    let [a, b, c] = corners.map(Vec2::as_dvec2);
    [[a, b], [b, c], [c, a]].into_iter().any(|[from, to]| {
        let along = to - from;
        let t = ((p - from).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
        p.distance(from + along * t) <= distance
    })
}

/// A plane cuts a triangle in two, with the same new corners: no pixel is drawn twice, and each pixel of the triangle once, but for some at its sides, which the new corners, rounded to 1/256 px, bend by as much.
#[test]
fn complementary_halves_lose_no_pixel_and_double_none() {
    let mut rng = Rng::with_seed(11);
    let (mut cut, mut pixels, mut bent) = (0, 0_u64, 0_u64);
    while cut < 100_000 {
        let positions = [(); 3].map(|()| {
            let w = 0.5 + 3.5 * rng.f32();
            Vec4::new(within(&mut rng, 1.5 * w), within(&mut rng, 1.5 * w), within(&mut rng, w), w)
        });
        let plane = Vec4::from_array([(); 4].map(|()| within(&mut rng, 1.0)));
        let whole = Polygon::new(&vertices(positions, [(); 3]));
        let halves = [clip(&whole, plane), clip(&whole, -plane)];
        if halves.iter().any(|half| half.corners().is_empty()) {
            continue;
        }
        cut += 1;
        let bits = |polygon: &Polygon<()>| -> BTreeSet<[u32; 4]> {
            polygon.corners().iter().map(|corner| corner.position.to_array().map(f32::to_bits)).collect()
        };
        let [a, b] = [bits(&halves[0]), bits(&halves[1])];
        let given = bits(&whole);
        assert!(
            a.symmetric_difference(&b).all(|corner| given.contains(corner)),
            "both parts have the same new corners"
        );

        let corners = positions.map(|position| window(position, size()).unwrap().xy());
        let exact = Triangle::new(corners);
        let mut counts = vec![0; (SIDE * SIDE) as usize];
        halves.iter().for_each(|half| covered(half, &mut counts));
        for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
            let count = counts[(y * SIDE + x) as usize];
            let expected = u32::from(exact.covers(x, y));
            pixels += u64::from(expected);
            if count != expected {
                bent += 1;
                let doubled = count > 1;
                assert!(
                    !doubled && near_a_side(corners, x, y, 1.0 / 128.0),
                    "({x}, {y}): {count} of {positions:?}, {plane}"
                );
            }
        }
    }
    assert!(pixels > 3_000_000 && bent * 2500 < pixels, "{bent} of {pixels}");
}

/// Two triangles at a side walk along it in opposite directions; whatever cuts them, cuts it at the same points, to the
/// last bit, and interpolates the same there.
#[test]
fn a_shared_side_is_cut_bit_for_bit_alike() {
    let mut rng = Rng::with_seed(12);
    let band = guard_band(Vec2::splat(800.0));
    let mut cuts = 0;
    for n in 0..100_000 {
        let scale = [4.0, 1e4, 1e30][n % 3];
        let [a, b, c, d] = [(); 4].map(|()| Vec4::from_array([(); 4].map(|()| within(&mut rng, scale))));
        // The third number is the share of the corner that is not on the side.
        let (at_a, at_b, aside) = ((Vec2::X, 0.0), (Vec2::new(0.3, 0.7), 0.0), (Vec2::Y, 1.0));
        for planes in [PLANES, band] {
            let on_side = |positions, varyings: [(Vec2, f32); 3]| {
                let polygon = planes
                    .iter()
                    .fold(Polygon::new(&vertices(positions, varyings)), |p, &plane| clip(&p, plane));
                let on = polygon.corners().iter().filter(|corner| corner.varying.1 == 0.0);
                on.map(|c| {
                    (c.position.to_array().map(f32::to_bits), c.varying.0.to_array().map(f32::to_bits))
                })
                .collect::<BTreeSet<_>>()
            };
            let one = on_side([a, b, c], [at_a, at_b, aside]);
            let other = on_side([b, a, d], [at_b, at_a, aside]);
            assert_eq!(one, other, "{a} {b} {c} {d}");
            cuts += one.len();
        }
    }
    assert!(cuts > 20_000, "{cuts}");
}

/// Six planes never make more than nine corners of three, and now and then they do make nine.
#[test]
fn nine_corners_are_enough_and_needed() {
    let mut rng = Rng::with_seed(13);
    let mut most = 0;
    for n in 0..100_000 {
        // A third of them lie in a plane of the picture, or as near to it as rounding lets them.
        let positions = [(); 3].map(|()| {
            let w = within(&mut rng, 1.0);
            let [x, y, z] = [(); 3].map(|()| within(&mut rng, 3.0));
            match n % 3 {
                0 => Vec4::new(x, y, -w * 1.000_000_1, w),
                1 => Vec4::new(w, y, z, w),
                _ => Vec4::new(x, y, z, 1.0),
            }
        });
        let mut polygon = Polygon::new(&vertices(positions, [(); 3]));
        for plane in PLANES {
            let before = polygon.corners().len();
            polygon = clip(&polygon, plane);
            assert!(polygon.corners().len() <= before + 1);
            most = most.max(polygon.corners().len());
        }
    }
    assert_eq!(most, MOST_CORNERS);
}

/// Whatever a triangle was, what the guard band's planes leave of it has all corners within ±2¹⁶ px, where the fill computes
/// with whole numbers of an `f64`: in the smallest picture, in the largest, and in a very flat one.
#[test]
fn the_guard_band_leaves_what_the_fill_computes_exactly() {
    let mut rng = Rng::with_seed(16);
    let mut farthest = 0_f32;
    for n in 0..60_000 {
        let size = [Vec2::ONE, Vec2::splat(800.0), Vec2::splat(65_535.0), Vec2::new(16_384.0, 1.0)][n % 4];
        let scale = [2.0, 1e3, 1e30][n % 3];
        let positions = [(); 3].map(|()| {
            // One corner in three is near the picture, so that something is left.
            let reach = if rng.u8(0..3) == 0 { 1.0 } else { scale };
            Vec4::from_array([(); 4].map(|()| within(&mut rng, reach)))
        });
        let whole = Polygon::new(&vertices(positions, [(); 3]));
        let left = guard_band(size).iter().fold(whole, |polygon, &plane| clip(&polygon, plane));
        for place in left.corners().iter().filter_map(|corner| window(corner.position, size)) {
            // The cut and the window round, each by some 2⁻²⁴ of 2¹⁶ px.
            let reach = place.xy().abs().max_element();
            assert!(reach <= 65_536.0 + 1.0 / 64.0, "{place} of {positions:?} in {size}");
            farthest = farthest.max(reach);
        }
    }
    assert!(farthest > 65_000.0, "{farthest}");
}

/// A square whose sides and diagonal run through centres of pixels: each centre on them belongs to one triangle, and to the
/// one that lesson 3's rule says.
#[test]
fn a_centre_on_a_side_belongs_to_one_triangle() {
    let at = |n: i32| (2 * n + 1) as f32 / 16.0 - 1.0;
    let square = [(2, 3), (12, 3), (12, 13), (2, 13)];
    for w in [1.0, 0.5, 3.0] {
        let clip = square.map(|(x, y)| Vec4::new(at(x), at(y), 0.0, 1.0) * w);
        let window = square.map(|(x, y)| Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
        for halves in [[[0, 1, 2], [0, 2, 3]], [[0, 1, 3], [1, 2, 3]], [[2, 1, 0], [3, 2, 0]]] {
            for method in METHODS {
                for half in halves {
                    let (log, _) = drawn(&[half.map(|corner| clip[corner])], method.run, Cull::None, 16);
                    let exact = Triangle::new(half.map(|corner| window[corner]));
                    for (x, y) in (0..16).flat_map(|y| (0..16).map(move |x| (x, y))) {
                        let expected = u32::from(exact.covers(x, y));
                        assert_eq!(
                            log.covered[(y * 16 + x) as usize],
                            expected,
                            "{}, {half:?} ({x}, {y})",
                            method.name
                        );
                    }
                }
            }
        }
    }
}

/// What a ray from inside meets of a sphere: one triangle. So each pixel is covered once, wherever the eye is in it and
/// wherever it looks.
#[test]
fn a_mesh_seen_from_inside_has_no_hole() {
    let mesh = sphere(10, 14);
    let mut rng = Rng::with_seed(14);
    for _ in 0..60 {
        let from = Vec3::from_array([(); 3].map(|()| within(&mut rng, 0.5)));
        let to = from + Vec3::from_array([(); 3].map(|()| within(&mut rng, 1.0)));
        let fov = 20.0 + 140.0 * rng.f32();
        let to_clip = perspective(fov, 1.0, 0.01, 10.0).unwrap() * view(from, to, Vec3::Y).unwrap();
        let corner = |n: usize| to_clip * mesh.positions[n].as_vec3().extend(1.0);
        let triangles: Vec<_> = mesh.triangles.iter().map(|t| t.map(|c| corner(c.position))).collect();
        for (name, clipping) in cutting() {
            for (cull, times) in [(Cull::None, 1), (Cull::Front, 1), (Cull::Back, 0)] {
                let (log, counts) = drawn(&triangles, clipping, cull, 64);
                let wrong = log.covered.iter().filter(|&&covered| covered != times).count();
                assert_eq!(
                    (wrong, counts.left_out),
                    (0, 0),
                    "{name}, {cull:?}: from {from} to {to}, {fov} degrees"
                );
            }
        }
    }
}

/// A corner in eye space, in front of the eye or behind it.
fn corner() -> impl Strategy<Value = [f32; 3]> {
    [-8.0f32..8.0, -8.0f32..8.0, -12.0f32..6.0]
}

/// Any number that is not NaN or infinite, each exponent as likely as the next, and 0.
fn finite() -> impl Strategy<Value = f32> {
    prop_oneof![8 => any::<u32>().prop_map(f32::from_bits).prop_filter("finite", |n| n.is_finite()), 1 => Just(0.0)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Wherever the corners are, each way but `leave-out` draws what rays meet, and so they agree.
    #[test]
    fn all_ways_draw_what_rays_meet(corners in proptest::collection::vec([corner(), corner(), corner()], 1..5)) {
        let triangles = eye(&corners);
        for (name, clipping) in cutting() {
            prop_assert_eq!(faults(clipping, &triangles), Vec::<String>::new(), "{}", name);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    /// Any finite numbers: what is drawn lies in the picture, has a depth and weights, and comes no more often than there
    /// are triangles in a polygon; what is not is left out. (The target itself refuses NaN and pixels outside.)
    #[test]
    fn any_finite_triangle_draws_or_is_refused(
        corners in proptest::collection::vec([finite(), finite(), finite(), finite()], 3),
        same_w in proptest::option::of(finite()), cull in prop_oneof![Just(Cull::None), Just(Cull::Back), Just(Cull::Front)],
    ) {
        let corner = |n: usize| {
            let [x, y, z, w] = corners[n];
            Vec4::new(x, y, z, same_w.unwrap_or(w))
        };
        for method in METHODS {
            let (log, counts) = drawn(&[[corner(0), corner(1), corner(2)]], method.run, cull, 16);
            let most = (MOST_CORNERS - 2) as u32;
            prop_assert!(log.covered.iter().all(|&times| times <= most), "{}", method.name);
            for seen in log.seen.iter().flatten() {
                prop_assert!(seen.weights.is_finite() && seen.depth.is_finite(), "{}: {seen:?}", method.name);
            }
            prop_assert!(counts.outside + counts.culled + counts.left_out <= 1 && counts.filled <= MOST_CORNERS - 2);
        }
    }
}

/// The notes' derivation, in numbers: under any camera, the sign that tells the side in clip space is that in eye space.
#[test]
fn no_camera_changes_the_side() {
    let mut rng = Rng::with_seed(15);
    for _ in 0..10_000 {
        let near = 0.01 + rng.f32();
        let camera: Mat4 =
            perspective(1.0 + 178.0 * rng.f32(), 0.2 + 4.0 * rng.f32(), near, near * (1.1 + 1e4 * rng.f32()))
                .unwrap();
        let whole = [(); 3].map(|()| [(); 3].map(|()| rng.i64(-1000..1000)));
        let clip = whole.map(|corner| camera * Vec3::from_array(corner.map(|n| n as f32)).extend(1.0));
        let volume = whole_volume(whole);
        // Rounded entries of the matrix move a corner by some 1e-7 of its distance.
        if volume.abs() > 1000 {
            let facing = clipping::facing(clip);
            assert_side(facing, checks::clipspace::side(whole));
        }
    }
}

fn whole_volume([a, b, c]: [[i64; 3]; 3]) -> i64 {
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    (0..3).map(|n| a[n] * cross[n]).sum()
}

fn assert_side(facing: f64, side: i32) {
    assert_eq!(facing.partial_cmp(&0.0).map(|order| order as i32), Some(side));
}
