use std::cell::RefCell;

use assets::sphere::sphere;
use clipping::facing::{Facing, View, area};
use clipping::homogeneous;
use clipping::mesh::Assemble;
use clipping::{
    ASSEMBLIES, ClipVertex, Clipping, Counts, Cull, FACINGS, LESSON, METHODS, Mesh, draw, render,
};
use common::{Attributes, Format, Image, Mat4, Method, Model, Vec2, Vec3, Vec4, Vec4Swizzles};
use fastrand::Rng;
use gouraud::corner_normals;
use perspective::{perspective, view, window};
use shaders::lighting::{Flat, Gouraud, Lighting, Quantized};
use shaders::shader::{Fragment, Shader};
use shaders::source::{Source, Texture, White};
use shaders::{Lit, SHADERS, Uniforms};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, Row, counted, every_method};
use verify::{CRATE, SPHERE, method};

use crate::soup::{Log, Seen, certain, drawn, eye};

const SIDE: i32 = 48;

/// Where every method is right.
const ALL_EXACT: &[Row] = &[("leave-out, near, six-planes, guard-band, homogeneous", Exact)];

/// Makes triangles of clip space.
type Make = fn() -> Vec<[Vec4; 3]>;

/// What `leave-out` gets wrong, where all others are right.
macro_rules! but_leave_out {
    ($faults:literal) => {
        &[("leave-out", Fails($faults)), ("near, six-planes, guard-band, homogeneous", Exact)]
    };
}

/// Triangles of clip space, and what each method must do: exact is what rays through the pixels meet, which triangle, with
/// which weights and at which depth.
const TABLE: &[Case<Make>] = &[
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

/// What is wrong in the picture that a way to clip makes of some triangles, pixel by pixel.
pub(crate) fn faults(clipping: Clipping, triangles: &[[Vec4; 3]]) -> Vec<String> {
    let (log, counts) = drawn(triangles, clipping, Cull::None, SIDE);
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
    every_method(LESSON.name, METHODS, TABLE, |method, triangles| faults(method.run, &triangles()));
}

/// A triangle before an eye at the origin, in whole numbers, and the power of 2 that these are multiplied by.
type Before = ([[i64; 3]; 3], i32);

const ALL_FACINGS: &[Row] = &[("world-normal, determinant, signed-area", Exact)];

/// Triangles, and which side of them each method says is seen.
const SIDES: &[Case<Before>] = &[
    ("facing the eye", ([[-1, -1, -3], [2, -1, -4], [0, 1, -3]], 0), ALL_FACINGS),
    ("facing away", ([[-1, -1, -3], [0, 1, -3], [2, -1, -4]], 0), ALL_FACINGS),
    ("edge-on", ([[-1, 0, -2], [1, 0, -2], [1, 0, -4]], 0), ALL_FACINGS),
    ("without area", ([[-1, -1, -2], [1, 1, -2], [0, 0, -2]], 0), ALL_FACINGS),
    (
        "a corner behind the eye",
        ([[-1, -1, -3], [1, -1, -3], [0, 2, 2]], 0),
        &[("world-normal, determinant", Exact), ("signed-area", Fails("says back"))],
    ),
    ("two corners behind the eye", ([[-1, -1, 2], [1, -1, 3], [0, 1, -3]], 0), ALL_FACINGS),
    (
        "all corners behind the eye",
        ([[-1, -1, 3], [2, -1, 4], [0, 1, 3]], 0),
        &[("world-normal, determinant", Exact), ("signed-area", Fails("says front"))],
    ),
    (
        "a corner at w = 0",
        ([[-1, -1, -3], [1, -1, -3], [0, 2, 0]], 0),
        &[("world-normal, determinant", Exact), ("signed-area", Fails("says nothing"))],
    ),
    (
        "smaller than 1/256 px",
        ([[0, 0, -999_999], [1, 0, -999_999], [0, 1, -999_999]], 0),
        &[("world-normal, determinant", Exact), ("signed-area", Fails("says edge-on"))],
    ),
    (
        "nearly edge-on, in numbers of 12 bits",
        ([[3183, 590, -3669], [-3370, -3305, -3199], [-1186, -2007, -3356]], 0),
        &[("world-normal, signed-area", Fails("says back")), ("determinant", Exact)],
    ),
    (
        "nearly edge-on, in numbers of 14 bits, turned away",
        ([[7170, 16008, -999], [-13655, -10229, -8605], [-6714, -1484, -6070]], 0),
        &[("world-normal", Fails("says front")), ("determinant, signed-area", Exact)],
    ),
    (
        "nearly edge-on, in numbers of 21 bits: beyond f64",
        (
            [
                [1_435_697, 1_139_728, -1_471_826],
                [1_321_842, -147_753, -1_412_495],
                [475_155, -12_947, -505_816],
            ],
            0,
        ),
        &[("world-normal, determinant, signed-area", Fails("says front"))],
    ),
    (
        "to 1e5",
        ([[-100_000, -1, 100_000], [100_000, -1, 100_000], [0, -1, -100_000]], 0),
        &[("world-normal, determinant", Exact), ("signed-area", Fails("says edge-on"))],
    ),
    (
        "to 1e30",
        ([[-1, -1, -3], [2, -1, -4], [0, 1, -3]], 99),
        &[("world-normal", Fails("says nothing")), ("determinant, signed-area", Exact)],
    ),
    (
        "as small as 1e-30",
        ([[-1, -1, -3], [2, -1, -4], [0, 1, -3]], -99),
        &[("world-normal", Fails("says edge-on")), ("determinant, signed-area", Exact)],
    ),
];

#[test]
fn the_side_that_is_seen_is_told_by_a_sign() {
    every_method(LESSON.name, FACINGS, SIDES, |method: &Method<Facing>, &(corners, power)| {
        let world = corners.map(|corner| Vec3::from_array(corner.map(|n| n as f32)) * 2f32.powi(power));
        // 90° from side to side: x and y stay, and w = −z.
        let clip = world.map(|Vec3 { x, y, z }| Vec4::new(x, y, 0.0, -z));
        let facing = (method.run)(&View { world, eye: Vec3::ZERO, clip, size: Vec2::splat(SIDE as f32) });
        let says = if facing.is_nan() {
            "says nothing"
        } else {
            ["says back", "says edge-on", "says front"]
                [(1 + i32::from(facing > 0.0) - i32::from(facing < 0.0)) as usize]
        };
        let exact =
            ["says back", "says edge-on", "says front"][(1 + checks::clipspace::side(corners)) as usize];
        counted_if(says != exact, says)
    });
}

/// What is filled has its corners rounded twice, to an `f32` in the picture and then to 1/256 px: so has what is measured,
/// also in the largest picture, where an `f32` holds no more than 1/256 px.
#[test]
fn the_signed_area_is_that_of_what_is_filled() {
    let mut rng = Rng::with_seed(17);
    for n in 0..3000 {
        let size = [Vec2::new(101.0, 77.0), Vec2::new(4096.0, 1024.0), Vec2::splat(65_536.0)][n % 3];
        let clip = [(); 3].map(|()| {
            let [x, y, w] = [(); 3].map(|()| 2.0 * rng.f32() - 1.0);
            Vec4::new(x, y, 0.0, w.abs() + 0.5)
        });
        let filled = clip.map(|corner| window(corner, size).unwrap().xy());
        let view = View { world: [Vec3::ZERO; 3], eye: Vec3::ZERO, clip, size };
        assert_eq!(method(FACINGS, "signed-area")(&view), area(filled), "{clip:?} in {size}");
    }
}

/// Without clipping, too, pixels are gone through where a triangle is between near and far, not elsewhere only to be
/// refused by the target.
#[test]
fn without_clipping_only_pixels_between_near_and_far_are_visited() {
    for far in [false, true] {
        let z = if far { -30.0 } else { -0.125 };
        let triangles = eye(&[[[-1.0, -1.0, -3.0], [z / 3.0, -0.25, z], [0.0, 1.5, -3.0]]]);
        let vertices = triangles[0].map(|position| ClipVertex { position, varying: () });
        let mut visited = [false; (SIDE * SIDE) as usize];
        homogeneous::fill(vertices, verify::window(SIDE, SIDE), |x: i32, y: i32, _: f32, ()| {
            visited[(y * SIDE + x) as usize] = true;
        });
        let mut seen = 0;
        for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
            let Some(hits) = certain(&triangles, x, y, SIDE) else { continue };
            assert_eq!(visited[(y * SIDE + x) as usize], hits[4].is_some(), "({x}, {y})");
            seen += u32::from(hits[4].is_some());
        }
        assert!(seen > 20, "{seen}");
    }
}

/// Through the eye: each of the three sides is the triangle's own plane, and half of the picture on one side of all three.
#[test]
fn what_is_seen_edge_on_covers_nothing_without_clipping() {
    let corners = [(-1.0, 2.0), (1.0, 2.0), (0.5, -4.0)];
    let vertices = corners.map(|(x, w)| ClipVertex { position: Vec4::new(x, 0.0, 0.0, w), varying: () });
    homogeneous::fill(vertices, verify::window(SIDE, SIDE), |x: i32, y: i32, depth: f32, ()| {
        panic!("({x}, {y}) at {depth}");
    });
}

fn counted_if(wrong: bool, what: &str) -> Vec<String> {
    if wrong { vec![what.to_string()] } else { Vec::new() }
}

/// What is left out for its side is not in the picture, and all else is.
#[test]
fn what_shows_the_wrong_side_is_left_out() {
    let front = [[-1.0, -1.0, -3.0], [2.0, -1.0, -4.0], [0.0, 1.5, -3.0]];
    let back = [front[0], front[2], front[1]];
    let behind = [[-1.0, -1.0, -3.0], [1.0, -1.0, -3.0], [0.0, 2.0, 2.0]];
    let edge = [[-1.0, 0.0, -2.0], [1.0, 0.0, -2.0], [0.5, 0.0, -4.0]];
    let (facing, away) = (eye(&[front, behind]), eye(&[back, [behind[1], behind[0], behind[2]]]));
    for method in METHODS.iter().filter(|method| method.name != "leave-out") {
        let covered = |triangles: &[[Vec4; 3]], cull| {
            let (log, counts) = drawn(triangles, method.run, cull, SIDE);
            (log.covered.iter().sum::<u32>(), counts.culled)
        };
        let all = covered(&facing, Cull::None);
        assert!(all.0 > 500 && covered(&away, Cull::None) == all, "{}", method.name);
        assert_eq!([covered(&facing, Cull::Back), covered(&away, Cull::Front)], [all; 2], "{}", method.name);
        assert_eq!(
            [covered(&facing, Cull::Front), covered(&away, Cull::Back)],
            [(0, 2); 2],
            "{}",
            method.name
        );
        let edge = eye(&[edge]);
        assert_eq!(
            [Cull::Back, Cull::Front, Cull::None].map(|cull| covered(&edge, cull)),
            [(0, 1), (0, 1), (0, 0)]
        );
    }
}

/// What became of each triangle, by each method: one of each kind, and of some kinds more than one.
#[test]
fn what_became_of_each_triangle_is_counted() {
    let whole = [[-1.0, -1.0, -3.0], [1.0, -1.0, -3.0], [0.0, 1.0, -3.0]];
    let back = [whole[0], whole[2], whole[1]];
    let through_near = [[-1.0, -1.0, -3.0], [1.0, -1.0, -3.0], [0.0, 1.0, -0.25]];
    let behind = [[-1.0, -1.0, 3.0], [0.0, 1.0, 3.0], [1.0, -1.0, 3.0]];
    let aside = [[-9.0, -1.0, -3.0], [-8.0, -1.0, -3.0], [-8.0, 1.0, -3.0]];
    let triangles = eye(&[
        whole,
        whole,
        back,
        back,
        back,
        through_near,
        through_near,
        behind,
        behind,
        behind,
        behind,
        aside,
    ]);
    let counts = |name: &str| {
        let Counts { vertices, outside, culled, cut, left_out, filled } =
            drawn(&triangles, *method(METHODS, name), Cull::Back, SIDE).1;
        [vertices, outside, culled, cut, left_out, filled]
    };
    assert_eq!(counts("leave-out"), [36, 0, 3, 0, 4, 5]);
    // The part of a triangle before near is a quadrangle, and is filled as two.
    assert_eq!(counts("near"), [36, 4, 3, 2, 0, 7]);
    assert_eq!(counts("six-planes"), [36, 5, 3, 2, 0, 6]);
    assert_eq!(counts("guard-band"), [36, 5, 3, 2, 0, 6]);
    assert_eq!(counts("homogeneous"), [36, 5, 3, 0, 0, 4]);
}

/// A model, with what a look of normals and texture needs.
type Load = fn() -> Model;

const BOTH: Attributes = Attributes { normals: true, uvs: true };
const ALL_ASSEMBLIES: &[Row] = &[("per-corner, indexed, strip", Exact)];

fn parsed(text: &str) -> Model {
    Model::parse(text.as_bytes(), BOTH).unwrap()
}

/// Models of which each method must make each triangle once, with its own corners and not turned round.
const MODELS: &[Case<Load>] = &[
    (
        "a triangle",
        || parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"),
        ALL_ASSEMBLIES,
    ),
    (
        "a square with a seam in its texture",
        || {
            parsed(
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/2/1 4/2/1\n",
            )
        },
        ALL_ASSEMBLIES,
    ),
    (
        "two sheets at one side, which both walk the same way",
        || {
            parsed(
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 2/1/1 4/1/1\n",
            )
        },
        ALL_ASSEMBLIES,
    ),
    (
        "the same triangle twice, and turned round",
        || {
            parsed(
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 2/1/1\n",
            )
        },
        ALL_ASSEMBLIES,
    ),
    (
        "a cube, whose corners have three normals each",
        || parsed(&assets::cube::cube().to_obj()),
        ALL_ASSEMBLIES,
    ),
    ("a sphere", || Model::read(SPHERE.as_ref(), BOTH).unwrap(), ALL_ASSEMBLIES),
    ("a knot", || parsed(&assets::torus_knot::torus_knot(40, 6).to_obj()), ALL_ASSEMBLIES),
];

/// All that a corner of a model is, bit by bit.
fn corner_of(model: &Model, normals: &[[Vec3; 3]], face: usize, corner: usize) -> [u32; 6] {
    let (normal, uv) = (normals[face][corner], model.uv(face, corner));
    let position = model.triangles()[face][corner];
    [position, normal.x.to_bits(), normal.y.to_bits(), normal.z.to_bits(), uv.x.to_bits(), uv.y.to_bits()]
}

#[test]
fn each_triangle_is_made_once_and_runs_as_it_did() {
    every_method(LESSON.name, ASSEMBLIES, MODELS, |method: &Method<Assemble>, load| {
        let model = load();
        let normals = corner_normals(&model);
        let mesh = (method.run)(&model, &normals, BOTH);
        let mut times = vec![0_usize; model.triangles().len()];
        let mut turned = 0;
        for (face, triangle) in mesh.triangles() {
            times[face] += 1;
            let made = triangle.map(|number| {
                let vertex = mesh.vertices[number as usize];
                let corner = corner_of(&model, &normals, vertex.face as usize, vertex.corner as usize);
                assert_eq!(corner[0], vertex.position);
                corner
            });
            let given = [0, 1, 2].map(|corner| corner_of(&model, &normals, face, corner));
            let [a, b, c] = given;
            turned += usize::from(![given, [b, c, a], [c, a, b]].contains(&made));
        }
        let missing = times.iter().filter(|&&times| times == 0).count();
        let twice = times.iter().filter(|&&times| times > 1).count();
        counted([("missing", missing), ("twice", twice), ("turned", turned)])
    });
}

/// What an index buffer saves, and a strip: vertices computed and numbers read for the head's 5,888 triangles.
#[test]
fn an_index_buffer_saves_vertices_and_a_strip_saves_numbers() {
    let head = common::program::model::DEFAULT_MODEL;
    let model = Model::read(head.as_ref(), BOTH).unwrap();
    let normals = corner_normals(&model);
    let sizes = |needs| {
        ["per-corner", "indexed", "strip"].map(|name| {
            let mesh = method(ASSEMBLIES, name)(&model, &normals, needs);
            (mesh.vertices.len(), mesh.indices.len())
        })
    };
    assert_eq!((model.triangles().len(), model.positions().len()), (5888, 2950));
    assert_eq!(sizes(BOTH), [(17_664, 17_664), (3368, 17_664), (3368, 9868)]);
    assert_eq!(sizes(Attributes::default()), [(17_664, 17_664), (2950, 17_664), (2950, 9349)]);
}

/// Asks for each vertex are counted.
struct Asked<'a> {
    positions: RefCell<&'a mut [u32]>,
    corners: RefCell<u32>,
}

impl Shader for Asked<'_> {
    type Constant = ();
    type Varying = ();
    type Output = Seen;

    fn position(&self, vertex: usize) -> Vec4 {
        self.positions.borrow_mut()[vertex] += 1;
        Vec4::new(0.5 * (vertex & 1) as f32, 0.5 * (vertex >> 1) as f32, 0.0, 1.0)
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, _: usize, _: usize) {
        *self.corners.borrow_mut() += 1;
    }

    fn fragment(&self, (): (), _: Fragment<()>) -> Option<Seen> {
        None
    }
}

#[test]
fn a_vertex_that_triangles_share_is_computed_once() {
    let text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 2/1/1 4/1/1 3/1/1\n";
    let model = parsed(text);
    let normals = corner_normals(&model);
    for (name, each, in_all) in
        [("per-corner", [1, 2, 2, 1], 6), ("indexed", [1; 4], 4), ("strip", [1; 4], 4)]
    {
        let mut positions = [0; 4];
        let shader = Asked { positions: RefCell::new(&mut positions), corners: RefCell::new(0) };
        let mesh: Mesh = method(ASSEMBLIES, name)(&model, &normals, BOTH);
        let counts = render(&shader, &mesh, Cull::None, Clipping::GuardBand, &mut Log::new(8));
        assert_eq!(
            (*shader.corners.borrow(), counts.vertices, counts.filled),
            (in_all, in_all as usize, 2),
            "{name}"
        );
        assert_eq!(positions, each, "{name}");
    }
}

/// From infinitely far away, where w = 1 everywhere, lesson 11 draws each look of lesson 9 to the last pixel.
#[test]
fn the_looks_of_lesson_9_are_drawn_unchanged() {
    let model = Model::read(SPHERE.as_ref(), BOTH).unwrap();
    let (normals, texture) = (corner_normals(&model), Image::read(CRATE.as_ref()).unwrap());
    let light = Vec3::new(0.6, 0.0, 0.8);
    let given = Uniforms { normals: &normals, texture: Some(&texture), light, ..Uniforms::new(&model) };
    // What is nearer has the larger z there, and the smaller one here.
    let turned = Uniforms { to_clip: Mat4::from_diagonal(Vec4::new(1.0, 1.0, -1.0, 1.0)), ..given };
    type Looks<'a> = [(&'static str, &'a dyn Fn(&mut Image)); 5];
    let looks: Looks = [
        ("flat", &|image| look(turned, White, Flat, image)),
        ("flat-texture", &|image| look(turned, Texture, Flat, image)),
        ("gouraud", &|image| look(turned, White, Gouraud, image)),
        ("gouraud-texture", &|image| look(turned, Texture, Gouraud, image)),
        ("quantized", &|image| look(turned, White, Quantized, image)),
    ];
    assert_eq!(looks.map(|look| look.0).as_slice(), SHADERS.iter().map(|look| look.name).collect::<Vec<_>>());
    for (name, draw) in looks {
        let mut expected = shaders::Framebuffer::new(Image::new(99, 99, Format::Rgb));
        (method(SHADERS, name).generic)(&given, &mut expected);
        let mut image = Image::new(99, 99, Format::Rgb);
        draw(&mut image);
        assert!(image == expected.image, "{name}");
    }
}

fn look(uniforms: Uniforms, source: impl Source, lighting: impl Lighting, image: &mut Image) {
    let mesh = method(ASSEMBLIES, "indexed")(uniforms.model, uniforms.normals, BOTH);
    let mut target = perspective::Framebuffer::new(image, perspective::depth::ZF32);
    render(&Lit::new(uniforms, source, lighting), &mesh, Cull::None, Clipping::GuardBand, &mut target);
}

/// Twice as many triangles, and four times the fragments, allocate as often, also where triangles are cut: the depths
/// once, the vertices once.
#[test]
fn drawing_allocates_nothing_per_triangle_or_fragment() {
    let texture = Image::read(CRATE.as_ref()).unwrap();
    // From inside the sphere.
    let to_clip = perspective(90.0, 1.0, 0.1, 10.0).unwrap()
        * view(Vec3::new(0.3, 0.2, 0.1), Vec3::new(1.0, 0.5, 0.0), Vec3::Y).unwrap();
    for method in METHODS {
        let counts = [(1, 50), (2, 50), (1, 100)].map(|(times, side)| {
            let text = sphere(8, 12).to_obj();
            let faces: String =
                text.lines().filter(|line| line.starts_with('f')).map(|line| format!("{line}\n")).collect();
            let model = parsed(&(text + &faces.repeat(times - 1)));
            let normals = corner_normals(&model);
            let mesh = clipping::mesh::indexed(&model, &normals, BOTH);
            let uniforms =
                Uniforms { normals: &normals, texture: Some(&texture), to_clip, ..Uniforms::new(&model) };
            let mut image = Image::new(side, side, Format::Rgb);
            let draw = || {
                let drawn = draw(&[(uniforms, &mesh)], Cull::None, method.run, &mut image);
                let cuts = matches!(method.name, "near" | "six-planes" | "guard-band");
                assert_eq!(drawn.counts.cut > 0, cuts);
            };
            allocation_counter::measure(draw).count_total
        });
        assert_eq!(counts, [2; 3], "{}", method.name);
    }
}
