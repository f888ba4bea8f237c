use std::panic::{AssertUnwindSafe, catch_unwind};

use checks::visibility::nearest;
use common::{Color, Format, Image, Model, Vec2, Vec3};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, every_method};
use zbuffer::{DepthBuffer, LESSON, METHODS, Surface, surfaces, z_f32};

/// Makes triangles.
type Scene = fn() -> Vec<[Vec3; 3]>;

/// Triangles in the order in which they are drawn, and what each method must make of them in a picture of 24×24 px:
/// exact is at every pixel the surface that is nearest, the first one of equals.
const TABLE: &[Case<Scene>] = &[
    ("far, then near", || vec![triangle(0, -0.5), triangle(1, 0.5)], &[("painter, z16, z24, z-f32", Exact)]),
    ("near, then far", || vec![triangle(0, 0.5), triangle(1, -0.5)], &[("painter, z16, z24, z-f32", Exact)]),
    (
        "two that cut each other",
        || vec![tilted(0, -0.5, 0.5), tilted(1, 0.5, -0.5)],
        &[("painter", Fails("31 wrong")), ("z16, z24, z-f32", Exact)],
    ),
    ("three in a circle", || cycle().to_vec(), &[("painter", Fails("14 wrong")), ("z16, z24, z-f32", Exact)]),
    (
        "a long one, nearer on the whole but farther here",
        || {
            let long = [Vec3::new(1.0, 1.0, -1.0), Vec3::new(23.0, 1.0, 1.0), Vec3::new(23.0, 23.0, 1.0)];
            let small = [Vec3::new(2.0, 0.0, -0.5), Vec3::new(8.0, 1.0, -0.5), Vec3::new(6.0, 7.0, -0.5)];
            vec![long, small]
        },
        &[("painter", Fails("10 wrong")), ("z16, z24, z-f32", Exact)],
    ),
    (
        "at one depth",
        || vec![triangle(0, 0.3), triangle(1, 0.3), triangle(2, 0.3), triangle(0, -1.0)],
        &[("painter, z16, z24, z-f32", Exact)],
    ),
    (
        "the whole scene at one depth",
        || vec![triangle(0, 0.3), triangle(1, 0.3)],
        &[("painter, z16, z24, z-f32", Exact)],
    ),
    (
        "so near that three depths add up to no f32, the far one first",
        || vec![triangle(0, 2e38), triangle(1, 3e38)],
        &[("painter, z16, z24, z-f32", Exact)],
    ),
    (
        "in one slanting plane",
        || [0, 1, 2].map(|n| triangle(n, 0.0).map(|c| c.with_z((c.x + c.y) / 48.0 - 0.7))).to_vec(),
        &[
            ("painter", Exact),
            ("z16", Fails("163 wrong")),
            ("z24", Fails("123 wrong")),
            ("z-f32", Fails("107 wrong")),
        ],
    ),
    ("1e-4 apart, the far one first", || apart(1e-4), &[("painter, z16, z24, z-f32", Exact)]),
    (
        "1e-5 apart, the far one first",
        || apart(1e-5),
        &[("painter, z24, z-f32", Exact), ("z16", Fails("118 wrong"))],
    ),
    (
        "1e-7 apart, the far one first",
        || apart(1e-7),
        &[("painter, z24, z-f32", Exact), ("z16", Fails("118 wrong"))],
    ),
    (
        "a level of z16 apart at the far end, the far one first",
        || vec![triangle(0, -1.0), triangle(1, -1.0 + 2.0 / 65_534.0), triangle(2, 1.0)],
        &[("painter, z16, z24, z-f32", Exact)],
    ),
    (
        "1e-9 apart near the depth 0, the far one first",
        || vec![triangle(0, 0.0), triangle(1, 1e-9), triangle(2, 1.0)],
        &[("painter, z-f32", Exact), ("z16, z24", Fails("22 wrong"))],
    ),
    (
        "1/128 apart at the depth 10^5, the far one first",
        || vec![triangle(0, 1e5), triangle(1, 1e5 + 0.0078125), triangle(2, 99_999.0)],
        &[("painter, z16, z24, z-f32", Exact)],
    ),
    (
        "slanting, 1e-4 apart, the far one first",
        || slanting(1e-4),
        &[("painter", Fails("118 wrong")), ("z16, z24, z-f32", Exact)],
    ),
    (
        "slanting, 1e-6 apart, the far one first",
        || slanting(1e-6),
        &[("painter", Fails("118 wrong")), ("z16", Fails("112 wrong")), ("z24, z-f32", Exact)],
    ),
    (
        "slanting, 1e-7 apart, the far one first",
        || slanting(1e-7),
        &[("painter, z16", Fails("118 wrong")), ("z24", Fails("24 wrong")), ("z-f32", Exact)],
    ),
    (
        "slanting, 6e-8 apart, a step of f32 and the far one first",
        || slanting(6e-8),
        &[("painter, z16", Fails("118 wrong")), ("z24", Fails("100 wrong")), ("z-f32", Fails("23 wrong"))],
    ),
    (
        "1e-8 apart near the depth 1/2, the far one first: one f32",
        || vec![triangle(0, 0.5), triangle(1, 0.5 + 1e-8), triangle(2, 1.0)],
        &[("painter, z16, z24, z-f32", Exact)],
    ),
    ("sixty at random", || soup(60), &[("painter", Fails("193 wrong")), ("z16, z24, z-f32", Exact)]),
    (
        "a NaN depth in front",
        || vec![triangle(0, 0.0), triangle(1, f32::NAN)],
        &[("painter", Fails("167 wrong")), ("z16, z24, z-f32", Exact)],
    ),
    (
        "a NaN depth at one corner",
        || vec![triangle(0, 0.0), corner_at(f32::NAN)],
        &[("painter", Fails("167 wrong")), ("z16, z24, z-f32", Exact)],
    ),
    (
        "a NaN place",
        || vec![triangle(0, 0.0), triangle(1, 0.5).map(|corner| corner.with_x(f32::NAN))],
        &[("painter, z16, z24, z-f32", Exact)],
    ),
    (
        "infinitely near",
        || vec![triangle(0, 0.0), triangle(1, f32::INFINITY), triangle(2, 1.0)],
        &[("painter", Fails("167 wrong")), ("z16, z24, z-f32", Exact)],
    ),
    (
        "infinitely near at one corner",
        || vec![triangle(0, 0.0), corner_at(f32::INFINITY), triangle(2, 1.0)],
        &[("painter", Fails("167 wrong")), ("z16, z24, z-f32", Exact)],
    ),
    (
        "infinitely far",
        || vec![triangle(0, f32::NEG_INFINITY), triangle(1, 0.0), triangle(2, 1.0)],
        &[("painter", Fails("47 wrong")), ("z16, z24, z-f32", Exact)],
    ),
];

/// One of three triangles that overlap in the middle, at one depth.
fn triangle(n: usize, depth: f32) -> [Vec3; 3] {
    let corners = [
        [(1.0, 2.0), (22.0, 4.5), (9.25, 21.0)],
        [(3.0, 18.5), (5.5, 1.25), (23.0, 14.0)],
        [(20.5, 22.0), (0.75, 12.0), (15.0, 0.5)],
    ];
    corners[n].map(|(x, y)| Vec3::new(x, y, depth))
}

/// The same with the depth of `left` at x = 0 and of `right` at x = 24.
fn tilted(n: usize, left: f32, right: f32) -> [Vec3; 3] {
    triangle(n, 0.0).map(|corner| corner.with_z(left + (right - left) * corner.x / 24.0))
}

/// The second of them with one corner at that depth, the others at 0.5.
fn corner_at(depth: f32) -> [Vec3; 3] {
    let [a, b, c] = triangle(1, 0.5);
    [a, b, c.with_z(depth)]
}

/// Three bars, each over the next one at one end and under the other at the other.
pub(crate) fn cycle() -> [[Vec3; 3]; 3] {
    let bar = |turn: usize| {
        let corners = [(0.0, 2.0, 0.4), (2.0, 10.0, 0.4), (23.0, 7.5, -0.8)];
        corners.map(|(x, y, z)| {
            // Turned by a third of a full turn about the middle.
            let (mut p, third) = (Vec2::new(x - 12.0, y - 12.0), Vec2::new(-0.5, 0.866_025_4));
            (0..turn).for_each(|_| p = third.rotate(p));
            (p + 12.0).extend(z)
        })
    };
    [bar(0), bar(1), bar(2)]
}

/// Two level triangles that far apart, and two that stretch the scene's depth from -1 to 1.
fn apart(distance: f32) -> Vec<[Vec3; 3]> {
    let tiny = |depth: f32| [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Vec3::new(x, y, depth));
    vec![triangle(0, 0.5), triangle(1, 0.5 + distance), tiny(-1.0), tiny(1.0)]
}

/// The same with both in parallel slanting planes.
fn slanting(distance: f32) -> Vec<[Vec3; 3]> {
    let mut all = apart(distance);
    all[..2].iter_mut().flatten().for_each(|corner| corner.z += corner.x / 64.0 - corner.y / 48.0);
    all
}

/// Triangles at random, all over the picture, with depths from -1 to 1.
fn soup(count: u64) -> Vec<[Vec3; 3]> {
    let number = |n: u64| f32::from(Color::random(n).r) / 255.0;
    let corner =
        |n: u64| Vec3::new(number(n) * 28.0 - 2.0, number(n + 1) * 28.0 - 2.0, number(n + 2) * 2.0 - 1.0);
    (0..count).map(|n| [0, 3, 6].map(|k| corner(9 * n + k))).collect()
}

/// The triangles, the n-th one in a colour that says n.
fn numbered(triangles: &[[Vec3; 3]]) -> Vec<Surface> {
    let color = |n: usize| Color::rgb(n as u8 + 1, 0, 0);
    triangles.iter().enumerate().map(|(n, &corners)| Surface { corners, color: color(n) }).collect()
}

/// How many pixels do not show the triangle that is seen there.
fn wrong(triangles: &[[Vec3; 3]], picture: &Image) -> usize {
    let expected = |x, y| nearest(triangles, x, y).map_or(0, |seen| seen.triangle + 1);
    picture.pixels().filter(|&(x, y, color)| usize::from(color.r) != expected(x, y)).count()
}

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method, make| {
        let mut picture = Image::new(24, 24, Format::Rgb);
        (method.run.draw)(&numbered(&make()), &mut picture);
        match wrong(&make(), &picture) {
            0 => vec![],
            count => vec![format!("{count} wrong")],
        }
    });
}

/// What lesson 3 left wrong: in the file's order, what is far covers what is near.
#[test]
fn the_order_of_drawing_is_what_lesson_3_shows() {
    let triangles = soup(60);
    let mut picture = Image::new(24, 24, Format::Rgb);
    for Surface { corners, color } in numbered(&triangles) {
        triangles::fill(corners.map(Vec3::truncate), picture.bounds(), |x, y, _| picture.set(x, y, color));
    }
    assert_eq!(wrong(&triangles, &picture), 356);
}

/// The depth picture against the depths in f64: within half a level of 254, where a method has levels enough.
#[test]
fn the_depth_picture_goes_from_the_darkest_grey_to_white() {
    let triangles = soup(20);
    let blank = Image::new(24, 24, Format::Rgb);
    let depths: Vec<Option<f64>> =
        blank.pixels().map(|(x, y, _)| nearest(&triangles, x, y).map(|seen| seen.depth)).collect();
    let (far, near) = depths
        .iter()
        .flatten()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(far, near), &depth| (far.min(depth), near.max(depth)));
    for method in METHODS {
        assert_eq!(method.run.depth.is_none(), method.name == "painter");
        let Some(depth_picture) = method.run.depth else { continue };
        let picture = depth_picture(&numbered(&triangles), &blank);
        for (level, depth) in picture.buffer().iter().zip(&depths) {
            let expected = depth.map_or(0.0, |depth| 1.0 + 254.0 * (depth - far) / (near - far));
            assert!((f64::from(*level) - expected).abs() < 0.51, "{}: {level}, not {expected}", method.name);
        }
        assert_eq!(picture.buffer().iter().max(), Some(&255));
    }
}

/// Nothing drawn is black, one depth alone is white, and a picture without pixels has one of its depths.
#[test]
fn a_depth_picture_of_little_is_defined() {
    let depths = |image: &Image| z_f32(&numbered(&[triangle(0, -3.0)]), &mut image.clone()).picture();
    let picture = depths(&Image::new(24, 24, Format::Rgb));
    assert!(picture.buffer().iter().all(|level| [0, 255].contains(level)));
    assert_eq!(picture.get(10, 10), Some(Color::WHITE));
    assert_eq!(depths(&Image::new(0, 7, Format::Rgb)), Image::new(0, 7, Format::Gray));
}

/// A face that lies along the light or has no area has the intensity 0 and stays; one that faces away goes.
#[test]
fn what_faces_away_from_the_light_is_left_out() {
    let positions = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Vec3::new(x, y, 0.0)).to_vec();
    let model = Model::from_triangles(positions, vec![[0, 1, 2], [0, 2, 1], [0, 0, 0]]).unwrap();
    let levels = |light| {
        let surfaces = surfaces(&model, light, &Image::new(9, 9, Format::Rgb));
        surfaces.iter().map(|surface| surface.color.r).collect::<Vec<_>>()
    };
    assert_eq!(levels(Vec3::Z), [255, 0]);
    assert_eq!(levels(Vec3::NEG_Z), [255, 0]);
    assert_eq!(levels(Vec3::X), [0, 0, 0]);
}

/// Beside the picture there is no depth, least of all that of a pixel in the next row.
#[test]
fn a_depth_buffer_has_no_pixel_outside() {
    let mut depths = DepthBuffer::new(&Image::new(3, 2, Format::Rgb), f32::NEG_INFINITY);
    for (x, y) in [(0, 0), (2, 0), (0, 1), (2, 1)] {
        assert!(depths.is_nearer(x, y, 1.0));
        depths.set(x, y, 1.0);
        assert!(depths.get(x, y) == 1.0 && !depths.is_nearer(x, y, 1.0));
    }
    for (x, y) in
        [(3, 0), (3, 1), (-1, 0), (-1, 1), (0, -1), (0, 2), (i32::MIN, 1), (1, i32::MIN), (2, i32::MAX)]
    {
        let outside = |what: &mut dyn FnMut()| catch_unwind(AssertUnwindSafe(what)).is_err();
        assert!(outside(&mut || _ = depths.get(x, y)), "({x}, {y})");
        assert!(outside(&mut || depths.set(x, y, 5.0)), "({x}, {y})");
    }
    depths.clear();
    assert!(depths == DepthBuffer::new(&Image::new(3, 2, Format::Rgb), f32::NEG_INFINITY));
}
