use assets::sphere::sphere;
use clipping::{Clipping, Cull, LESSON, METHODS};
use common::{Method, Vec4};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, Row, counted, every_method};

use crate::soup::{certain, drawn, eye};

const SIDE: i32 = 48;

/// Where every method is right.
const ALL_EXACT: &[Row] = &[("leave-out, near, six-planes, guard-band, homogeneous", Exact)];

/// What `leave-out` gets wrong, where all others are right.
macro_rules! but_leave_out {
    ($faults:literal) => {
        &[("leave-out", Fails($faults)), ("near, six-planes, guard-band, homogeneous", Exact)]
    };
}

/// Triangles of clip space, and what each method must do: exact is what rays through the pixels meet, which triangle, with
/// which weights and at which depth.
const TABLE: &[Case<fn() -> Vec<[Vec4; 3]>>] = &[
    ("in the picture", || eye(&[[[-1.0, -1.0, -3.0], [2.0, -1.0, -4.0], [0.0, 1.5, -3.0]]]), ALL_EXACT),
    (
        "one corner behind the eye",
        || eye(&[[[-1.0, -1.0, -3.0], [1.0, -0.5, -3.0], [0.0, 1.5, 2.0]]]),
        but_leave_out!("left out 1, missing 768"),
    ),
    (
        "two corners behind the eye",
        || eye(&[[[-0.5, -1.0, 2.0], [1.0, -1.0, 3.0], [0.0, 0.25, -3.0]]]),
        but_leave_out!("left out 1, missing 287"),
    ),
    (
        "all behind the eye",
        || eye(&[[[-1.0, -1.0, 3.0], [1.0, -1.0, 4.0], [0.0, 1.0, 3.0]]]),
        but_leave_out!("left out 1"),
    ),
    (
        "a corner at w = 0",
        || eye(&[[[-1.0, -1.0, -3.0], [1.0, -0.5, -3.0], [0.5, 0.25, 0.0]]]),
        but_leave_out!("left out 1, missing 78"),
    ),
    (
        "two corners at w = 0",
        || eye(&[[[-1.0, -0.25, 0.0], [1.0, -0.5, 0.0], [0.5, 0.25, -4.0]]]),
        but_leave_out!("left out 1, missing 536"),
    ),
    (
        "three corners at w = 0",
        || eye(&[[[-1.0, -0.25, 0.0], [1.0, -0.5, 0.0], [0.5, 0.25, 0.0]]]),
        but_leave_out!("left out 1"),
    ),
    (
        "a corner in the eye: edge-on",
        || eye(&[[[-1.0, -1.0, -3.0], [1.0, -0.5, -3.0], [0.0, 0.0, 0.0]]]),
        but_leave_out!("left out 1"),
    ),
    (
        "a corner at x = y = z = w = 0",
        || vec![[Vec4::ZERO, Vec4::new(1.0, -1.0, 0.0, 2.0), Vec4::new(0.0, 1.0, 0.0, 2.0)]],
        &[("leave-out, near, six-planes, guard-band", Fails("left out 1")), ("homogeneous", Exact)],
    ),
    (
        "between the eye and near",
        || eye(&[[[-0.1, -0.1, -0.4], [0.1, -0.1, -0.4], [0.0, 0.1, -0.3]]]),
        but_leave_out!("extra 84"),
    ),
    (
        "through near, before the eye",
        || eye(&[[[-0.1, -0.1, -0.25], [1.0, -0.5, -3.0], [0.0, 1.0, -3.0]]]),
        but_leave_out!("extra 39"),
    ),
    ("through far", || eye(&[[[-1.0, -1.0, -3.0], [20.0, -10.0, -30.0], [0.0, 20.0, -30.0]]]), ALL_EXACT),
    ("beyond far", || eye(&[[[-9.0, -9.0, -20.0], [9.0, -9.0, -30.0], [0.0, 9.0, -20.0]]]), ALL_EXACT),
    (
        "through near and far",
        || eye(&[[[-1.0, -1.0, 1.0], [10.0, -10.0, -30.0], [0.0, 20.0, -30.0]]]),
        but_leave_out!("left out 1, missing 999"),
    ),
    (
        "near through a side",
        || eye(&[[[-0.25, -0.25, -0.5], [0.25, -0.25, -0.5], [0.0, 1.0, -3.0]]]),
        ALL_EXACT,
    ),
    (
        "near through a side, the third corner before it",
        || eye(&[[[-0.25, -0.25, -0.5], [0.25, -0.25, -0.5], [0.0, 0.1, -0.25]]]),
        but_leave_out!("extra 262"),
    ),
    (
        "near through a corner",
        || eye(&[[[-0.25, -0.25, -0.5], [1.0, -0.5, -3.0], [0.0, 1.0, 1.0]]]),
        but_leave_out!("left out 1, missing 210"),
    ),
    (
        "in the near plane",
        || eye(&[[[-0.25, -0.25, -0.5], [0.25, -0.25, -0.5], [0.0, 0.25, -0.5]]]),
        ALL_EXACT,
    ),
    ("left through a side", || eye(&[[[-2.0, -1.0, -2.0], [0.0, 0.0, -3.0], [-4.0, 1.0, -4.0]]]), ALL_EXACT),
    (
        "left through a corner",
        || eye(&[[[-2.0, 0.0, -2.0], [-4.0, -2.0, -3.0], [1.0, 1.5, -3.0]]]),
        ALL_EXACT,
    ),
    ("edge-on", || eye(&[[[-1.0, 0.0, -2.0], [1.0, 0.0, -2.0], [0.5, 0.0, -4.0]]]), ALL_EXACT),
    (
        "edge-on, through the eye",
        || eye(&[[[-1.0, 0.0, -2.0], [1.0, 0.0, -2.0], [0.5, 0.0, 4.0]]]),
        but_leave_out!("left out 1"),
    ),
    ("without area", || eye(&[[[-1.0, -1.0, -2.0], [1.0, 1.0, -2.0], [0.0, 0.0, -2.0]]]), ALL_EXACT),
    (
        "one corner 16 times as far",
        || eye(&[[[-1.0, -1.0, -3.0], [1.0, -1.0, -3.0], [0.0, 16.0, -48.0]]]),
        ALL_EXACT,
    ),
    (
        "a floor to 1e5, in front and behind",
        || eye(&[[[-1e5, -1.0, 1e5], [1e5, -1.0, 1e5], [0.0, -1.0, -1e5]]]),
        but_leave_out!("left out 1, missing 1056"),
    ),
    (
        "a wall to 1e5 on both sides",
        || eye(&[[[-1e5, -1e5, -3.0], [1e5, -1e5, -3.0], [0.0, 1e5, -3.0]]]),
        ALL_EXACT,
    ),
    (
        "a corner at 1e30, in front",
        || eye(&[[[-1.0, -1.0, -3.0], [1.0, -1.0, -3.0], [0.0, 1e29, -1e30]]]),
        ALL_EXACT,
    ),
    (
        "a corner at 1e30, behind",
        || eye(&[[[-1.0, -1.0, -3.0], [1.0, -1.0, -3.0], [0.0, -1e30, 1e30]]]),
        but_leave_out!("left out 1, missing 320"),
    ),
    (
        "two corners at 1e30",
        || eye(&[[[-1e30, -1e30, 1e29], [1e30, -1e30, -1e30], [0.0, 1.0, -3.0]]]),
        &[
            ("leave-out, near", Fails("left out 1, missing 846")),
            ("six-planes, guard-band, homogeneous", Exact),
        ],
    ),
    (
        "far aside at near",
        || eye(&[[[-1.0, -1.0, -3.0], [1e18, 0.0, 1.0], [-1.0, 1.0, -3.0]]]),
        &[
            ("leave-out", Fails("left out 1, missing 512")),
            ("near", Fails("missing 512")),
            ("six-planes, guard-band, homogeneous", Exact),
        ],
    ),
    (
        "all around the picture",
        || eye(&[[[-99.0, -99.0, -8.0], [99.0, -99.0, -8.0], [0.0, 199.0, -8.0]]]),
        ALL_EXACT,
    ),
    ("a cube about the eye", cube, but_leave_out!("left out 10, missing 1623")),
    ("a ball about the eye, which is not in its middle", ball, but_leave_out!("left out 152, missing 802")),
    ("a fan about the foot of the eye", fan, but_leave_out!("left out 8, missing 1054")),
];

/// The twelve triangles of a cube about the eye, at different distances.
fn cube() -> Vec<[Vec4; 3]> {
    let corner = |n: usize| [[-2.0, 1.0][n & 1], [-1.5, 2.0][n >> 1 & 1], [-3.0, 2.5][n >> 2]];
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6]];
    let halves = |[a, b, c, d]: [usize; 4]| [[a, b, c], [a, c, d]];
    let triangles: Vec<_> = faces.into_iter().flat_map(halves).map(|t| t.map(corner)).collect();
    eye(&triangles)
}

/// A sphere about the eye, which is nearer to one side of it.
fn ball() -> Vec<[Vec4; 3]> {
    let mesh = sphere(8, 12);
    let at = |n: usize| (mesh.positions[n] * 4.0).as_vec3().to_array();
    let moved = |[x, y, z]: [f32; 3]| [x + 1.5, y - 1.0, z + 2.0];
    let triangles: Vec<_> =
        mesh.triangles.iter().map(|t| t.map(|corner| moved(at(corner.position)))).collect();
    eye(&triangles)
}

/// A floor of eight triangles about a point below the eye, which is behind the near plane.
fn fan() -> Vec<[Vec4; 3]> {
    let ring = [[9, 0], [9, 9], [0, 9], [-9, 9], [-9, 0], [-9, -9], [0, -9], [9, -9]]
        .map(|[x, z]| [x as f32, -0.75, z as f32]);
    let triangles: Vec<_> = (0..8).map(|n| [[0.125, -0.75, 0.25], ring[(n + 1) % 8], ring[n]]).collect();
    eye(&triangles)
}

/// What is wrong in a method's picture of some triangles, pixel by pixel.
fn faults(method: &Method<Clipping>, triangles: &[[Vec4; 3]]) -> Vec<String> {
    let (log, counts) = drawn(triangles, method.run, Cull::None, SIDE);
    let [mut missing, mut extra, mut other, mut off] = [0; 4];
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let Some(hits) = certain(triangles, x, y, SIDE) else { continue };
        match (log.seen[(y * SIDE + x) as usize], hits[4]) {
            (None, None) => {}
            (None, Some(_)) => missing += 1,
            (Some(_), None) => extra += 1,
            (Some(seen), Some((face, _))) if seen.face != face => other += 1,
            (Some(seen), _) => {
                let between = |got: f32, value: &dyn Fn(&checks::clipspace::Hit) -> f64| {
                    let values = || hits.iter().flatten().map(|hit| value(&hit.1));
                    let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
                    (low - 1e-5..=high + 1e-5).contains(&f64::from(got))
                };
                let right = between(seen.depth, &|hit| hit.depth)
                    && between(seen.weights.x, &|hit| hit.weights.x)
                    && between(seen.weights.y, &|hit| hit.weights.y);
                off += usize::from(!right);
            }
        }
    }
    counted([
        ("left out", counts.left_out),
        ("missing", missing),
        ("extra", extra),
        ("of another triangle", other),
        ("off", off),
    ])
}

#[test]
fn every_triangle_is_drawn_wherever_the_eye_is() {
    every_method(LESSON.name, METHODS, TABLE, |method, triangles| faults(method, &triangles()));
}
