use checks::ray::{Screen, hit};
use common::{DVec2, DVec3, Vec2, Vec3, Vec4};
use perspective::{METHODS, Planes, frustum, perspective, perspective_weights};
use proptest::num::f32::ANY;
use proptest::prelude::*;
use verify::{method, window};

const SIDE: i32 = 96;

/// What a method says of each pixel: x, y, the depth's bits, (u, v).
fn visited(name: &str, corners: [Vec4; 3], varyings: [Vec2; 3]) -> Vec<(i32, i32, u32, Vec2)> {
    let mut seen = Vec::new();
    (method(METHODS, name).visit)(corners, varyings, window(SIDE, SIDE), &mut |x, y, depth, uv| {
        seen.push((x, y, depth.to_bits(), uv));
    });
    seen
}

/// A corner in and about the picture, on the grid of 1/256 px, its w from 2⁻²⁰ to 2²⁰.
fn corner() -> impl Strategy<Value = Vec4> {
    let place = -64 * 256..(SIDE + 64) * 256;
    (place.clone(), place, 0.0_f32..1.0, -20.0_f32..20.0)
        .prop_map(|(x, y, z, w)| Vec4::new(x as f32 / 256.0, y as f32 / 256.0, z, w.exp2()))
}

fn triangle() -> impl Strategy<Value = [Vec4; 3]> {
    [corner(), corner(), corner()]
}

const UVS: [Vec2; 3] = [Vec2::ZERO, Vec2::X, Vec2::Y];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// At each pixel per-pixel finds the weights of the ray through it: off by at most 2⁻²¹, four units in the last
    /// place of 1.
    #[test]
    fn per_pixel_is_what_a_ray_meets(corners in triangle()) {
        let screen = Screen { low: DVec2::NEG_ONE, high: DVec2::ONE, pixels: DVec2::splat(SIDE.into()) };
        let points = corners.map(|corner| screen.point(corner));
        for (x, y, _, uv) in visited("per-pixel", corners, UVS) {
            let exact = hit(points, screen.through(x, y)).weights;
            let off = (uv.as_dvec2() - DVec2::new(exact.y, exact.z)).abs().max_element();
            prop_assert!(off <= 2f64.powi(-21), "({x}, {y}): {uv}, not {exact}");
        }
    }

    /// All methods find the same pixels and the same depths, and nothing that is not between the corners.
    #[test]
    fn methods_differ_in_nothing_but_what_they_interpolate(corners in triangle()) {
        let expected: Vec<_> = visited("per-pixel", corners, UVS).into_iter().map(|(x, y, depth, _)| (x, y, depth)).collect();
        for row in METHODS {
            let seen = visited(row.name, corners, UVS);
            let places: Vec<_> = seen.iter().map(|&(x, y, depth, _)| (x, y, depth)).collect();
            prop_assert!(places == expected, "{}", row.name);
            for (x, y, _, uv) in seen {
                let between = uv.min_element() >= -1e-6 && uv.element_sum() <= 1.0 + 1e-6;
                prop_assert!(between, "{} at ({x}, {y}): {uv}", row.name);
            }
        }
    }

    /// Whichever corner comes first: the same pixels, and depths and (u, v) to rounding.
    #[test]
    fn the_order_of_the_corners_changes_nothing(corners in triangle(), order in Just([0, 1, 2]).prop_shuffle()) {
        let moved = (order.map(|n| corners[n]), order.map(|n| UVS[n]));
        for row in METHODS {
            let [here, there] = [visited(row.name, corners, UVS), visited(row.name, moved.0, moved.1)];
            prop_assert_eq!(here.len(), there.len());
            for (a, b) in here.iter().zip(&there) {
                prop_assert_eq!((a.0, a.1), (b.0, b.1));
                let [z, other] = [a.2, b.2].map(f32::from_bits);
                prop_assert!((z - other).abs() <= 2f32.powi(-23), "{z} {other}");
                prop_assert!((a.3 - b.3).abs().max_element() <= 2f32.powi(-21), "{} {}", a.3, b.3);
            }
        }
    }

    /// Where all corners are equally far there is no perspective: per-pixel is affine, bit by bit.
    #[test]
    fn without_perspective_per_pixel_is_affine(corners in triangle(), w in -60.0_f32..60.0) {
        let corners = corners.map(|corner| corner.with_w(w.exp2()));
        let [affine, exact] = ["affine", "per-pixel"].map(|name| visited(name, corners, UVS));
        prop_assert_eq!(affine, exact);
    }

    /// The depth before the eye, interpolated, lies between the corners' and is one over the interpolated 1/w.
    #[test]
    fn depth_before_the_eye_lies_between_the_corners(corners in triangle()) {
        let depths = corners.map(|corner| 1.0 / corner.w);
        let [near, far] = [depths.into_iter().fold(f32::MAX, f32::min), depths.into_iter().fold(0.0, f32::max)];
        for (x, y, _, uv) in visited("per-pixel", corners, depths.map(Vec2::splat)) {
            let between = uv.x >= near * (1.0 - 1e-6) && uv.x <= far * (1.0 + 1e-6);
            prop_assert!(between, "({x}, {y}): {} is not from {near} to {far}", uv.x);
        }
    }

    /// Weights in perspective are those of f64 to 8 half units in their last place, and sum to 1 to as much.
    #[test]
    fn weights_are_exact_to_rounding(parts in [0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0], w in [-40.0_f32..40.0, -40.0_f32..40.0, -40.0_f32..40.0]) {
        let parts = Vec3::from_array(parts) + 1e-6;
        let weights = parts / parts.element_sum();
        let inverse_w = Vec3::from_array(w.map(f32::exp2));
        let got = perspective_weights(weights, inverse_w).as_dvec3();
        let exact = weights.as_dvec3() * inverse_w.as_dvec3();
        let exact = exact / exact.element_sum();
        let off = ((got - exact) / exact).abs().max_element();
        prop_assert!(off <= 8.0 * 2f64.powi(-24), "{got}, not {exact}");
        prop_assert!((got.element_sum() - 1.0).abs() <= 8.0 * 2f64.powi(-24));
    }

    /// Whatever the corners are, NaN and infinity among them: no panic, no pixel outside, and (u, v) are numbers.
    #[test]
    fn any_corner_is_drawn_or_left_out(numbers in prop::array::uniform12(ANY), mild in any::<bool>()) {
        let corners: [Vec4; 3] = std::array::from_fn(|n| {
            let [x, y, z, w] = [0, 1, 2, 3].map(|k| numbers[4 * n + k]);
            // Else hardly any triangle would reach into the picture.
            if mild { Vec4::new(x % 200.0, y % 200.0, z, w.abs()) } else { Vec4::new(x, y, z, w) }
        });
        for row in METHODS {
            for (x, y, _, uv) in visited(row.name, corners, UVS) {
                prop_assert!((0..SIDE).contains(&x) && (0..SIDE).contains(&y));
                prop_assert!(!uv.is_nan(), "{} at ({x}, {y}) of {corners:?}", row.name);
            }
        }
    }

    /// A field of view is the frustum with the same sides, and brings these, the near and the far plane to ±1.
    #[test]
    fn a_field_of_view_is_a_frustum(fov in 1.0_f32..179.0, aspect in 0.1_f32..10.0, near in 1e-3_f32..10.0, ratio in 1.1_f32..1e6) {
        let far = near * ratio;
        let top = (f64::from(fov) / 2.0).to_radians().tan() * f64::from(near);
        let right = top * f64::from(aspect);
        let [t, r] = [top as f32, right as f32];
        let by_sides = frustum(-r, r, -t, t, near, far).unwrap();
        let m = perspective(fov, aspect, near, far).unwrap();
        for column in 0..4 {
            let (a, b) = (m.col(column), by_sides.col(column));
            prop_assert!((a - b).abs().cmple(a.abs() * 2.5e-7).all(), "{m} {by_sides}");
        }
        for (depth, z) in [(near, -1.0), (far, 1.0)] {
            let scale = f64::from(depth) / f64::from(near);
            let corner = DVec3::new(right * scale, top * scale, -f64::from(depth)).as_vec3();
            let clip = m * corner.extend(1.0);
            let ndc = clip.truncate() / clip.w;
            // What rounding to f32 did to the far corner's sum is a part of its w.
            prop_assert!((ndc - Vec3::new(1.0, 1.0, z)).abs().max_element() < 1e-6, "{ndc} at {depth}");
        }
    }

    /// Farther is never kept as nearer, and on the far plane it is as if nothing was there.
    #[test]
    fn what_is_kept_is_in_the_order_of_distance(near in 1e-3_f32..10.0, ratio in 1.5_f32..1e7, places in [0.0_f64..1.0, 0.0_f64..1.0]) {
        let planes = Planes { near, far: near * ratio };
        let at = |place: f64| f64::from(near) * f64::from(ratio).powf(place);
        let [first, last] = [places[0].min(places[1]), places[0].max(places[1])].map(at);
        for row in perspective::DEPTHS {
            let [a, b] = [first, last].map(|distance| (row.run.kept)(planes, distance));
            let larger_is_nearer = row.name == "reversed-z-f32";
            prop_assert!(if larger_is_nearer { a >= b } else { a <= b }, "{}: {a} at {first}, {b} at {last}", row.name);
            let alike = (row.run.alike)(planes, first);
            prop_assert!(alike.contains(&first));
            prop_assert_eq!(a == b, alike.contains(&last), "{}", row.name);
        }
    }
}
