//! Mission 11: which side of a triangle is seen, and what a plane leaves of a polygon.

pub use clipping_given as given;
pub use tasks::scenery::pattern;

use common::{Color, Image, Mat4, Vec2, Vec3, Vec4, Vec4Swizzles};
use fastrand::Rng;
use perspective::{perspective, window};
use tasks::scenery::{canvas, signed};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};
use transforms::translate;

use given::{ClipVertex, PLANES, draw, fan, pixels};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Clipping {
    /// The lesson's `facing`.
    pub facing: fn([Vec4; 3]) -> f64,
    /// The lesson's `clip`.
    pub clip: fn(&[ClipVertex], Vec4) -> Vec<ClipVertex>,
}

/// The mission.
pub const MISSION: Mission<Clipping> = Mission {
    lesson: "11-clipping",
    checks: &[
        Check {
            name: "facing",
            asks: "which side of a triangle is seen",
            points: 2,
            tasks: |rng| {
                let mut tasks: Vec<_> = [1.0, -1.0]
                    .into_iter()
                    .flat_map(|w| [[w, w, w], [-w, w, w], [w, -w, w], [w, w, -w], [0.0, w, w]])
                    .map(|signs| facing(triangle(rng, signs).map(|corner| corner.position)))
                    .collect();
                tasks.extend((0..4).map(|_| facing(nearly_edge_on(rng))));
                let place = |x: f32, y: f32| Vec4::new(x, y, 0.5, 1.0);
                // On one line with the eye: seen edge-on.
                tasks.push(facing([place(1.0, 2.0), place(2.0, 4.0), place(4.0, 8.0)]));
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "corners",
            asks: "the corners that a plane leaves of a triangle, and of what other planes left",
            points: 3,
            tasks: |rng| {
                // As many corners inside as these signs say.
                let sides: [[i32; 3]; 8] = [
                    [1, 1, 1],
                    [1, 1, -1],
                    [1, -1, 1],
                    [-1, 1, 1],
                    [1, -1, -1],
                    [-1, 1, -1],
                    [-1, -1, 1],
                    [-1, -1, -1],
                ];
                let mut tasks: Vec<_> = sides
                    .map(|sides| {
                        let (triangle, plane) = cut_triangle(rng, sides);
                        clipped(triangle, vec![plane], Columns::Positions)
                    })
                    .into();
                tasks.push(touching(rng));
                tasks.push(lying_in(rng));
                tasks.extend((0..3).map(|_| {
                    let (triangle, planes) = much_cut(rng);
                    clipped(triangle, planes, Columns::Positions)
                }));
                let (triangle, plane) = cut_triangle(rng, [-1, -1, -1]);
                tasks.push(clipped(triangle, vec![plane, PLANES[0]], Columns::Positions));
                tasks
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "attributes",
            asks: "the texture coordinates of these corners",
            points: 1,
            tasks: |rng| {
                let mut tasks: Vec<_> = [[1, 1, -1], [1, -1, -1], [-1, 1, 1]]
                    .map(|sides| {
                        let (triangle, plane) = cut_triangle(rng, sides);
                        clipped(triangle, vec![plane], Columns::Uvs)
                    })
                    .into();
                let (triangle, planes) = much_cut(rng);
                tasks.push(clipped(triangle, planes, Columns::Uvs));
                tasks
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "neighbours",
            asks: "the same corner on a common side, to the last bit",
            points: 1,
            tasks: |rng| vec![neighbours(rng)],
            precision: Precision::EXACT,
        },
        Check {
            name: "halves",
            asks: "two halves of a triangle: no pixel missing, none in both",
            points: 1,
            tasks: |rng| (0..2).map(|_| halves(rng)).collect(),
            // Where a cut is rounded in another way, a corner may move by 1/256 px.
            precision: Precision { tolerance: 0.0, strays: 6 },
        },
        Check {
            name: "picture",
            asks: "a room seen from inside, with a board in it that shows its back",
            points: 2,
            tasks: |rng| (0..2).map(|_| room(rng)).collect(),
            // In some pixels the last bit decides between two squares of the pattern.
            precision: Precision { tolerance: 2.0, strays: 60 },
        },
    ],
};

/// A number from 0.5 to 3, and so not near 0; in eighths, to be read.
fn size(rng: &mut Rng) -> f32 {
    eighths(0.5 + 2.5 * rng.f32())
}

fn eighths(number: f32) -> f32 {
    (number * 8.0).round() / 8.0
}

/// A triangle of clip space whose w have these signs, or are 0.
fn triangle(rng: &mut Rng, signs: [f32; 3]) -> [ClipVertex; 3] {
    signs.map(|sign| {
        let mut place = || eighths(3.0 * signed(rng));
        let position = Vec4::new(place(), place(), place(), sign * size(rng));
        ClipVertex { position, uv: Vec2::new(eighths(rng.f32()), eighths(rng.f32())) }
    })
}

/// A triangle and a plane of which its corners lie inside (1) or outside (−1), none near it.
fn cut_triangle(rng: &mut Rng, sides: [i32; 3]) -> ([ClipVertex; 3], Vec4) {
    loop {
        let triangle = triangle(rng, [1.0; 3]);
        let plane = Vec4::from_array([(); 4].map(|()| eighths(signed(rng))));
        let fits = |(corner, side): (&ClipVertex, i32)| plane.dot(corner.position) * side as f32 > 0.3;
        if triangle.iter().zip(sides).all(fits) {
            return (triangle, plane);
        }
    }
}

/// A triangle and four of the camera's planes, each of which cuts what the ones before left of it.
fn much_cut(rng: &mut Rng) -> ([ClipVertex; 3], Vec<Vec4>) {
    let turn = rng.f32();
    let corners = [0.0, 1.0, 2.0].map(|third| {
        let angle = std::f32::consts::TAU * (third + turn) / 3.0;
        let w = size(rng);
        let [x, y, z] = [2.2 * angle.cos(), 2.2 * angle.sin(), 0.3 * signed(rng)].map(|n| eighths(n * w));
        ClipVertex { position: Vec4::new(x, y, z, w), uv: Vec2::new(eighths(rng.f32()), eighths(rng.f32())) }
    });
    (corners, PLANES[2..].to_vec())
}

/// Three corners of whole numbers, so large that products in f32 are rounded, and nearly on one line with the eye.
fn nearly_edge_on(rng: &mut Rng) -> [Vec4; 3] {
    let n = rng.i32(50_000..60_000) as f32;
    let corners = [(n, n + 1.0), (n + 1.0, n + 2.0), (n + 2.0, n + if rng.bool() { 4.0 } else { 2.0 })];
    corners.map(|(x, y)| Vec4::new(x, y, signed(rng), 1.0) * rng.i32(1..4) as f32)
}

fn facing(corners: [Vec4; 3]) -> Task<Clipping> {
    let call = format!("facing({})", corners.code());
    let code = format!("let got = {call};");
    Task::new(format!("the sign of {call}"), code, move |student: &Clipping| {
        let facing = (student.facing)(corners);
        Raw::value([if facing == 0.0 { 0.0 } else { facing.signum() as f32 }])
    })
}

/// What is looked at of corners.
#[derive(Clone, Copy)]
enum Columns {
    Positions,
    Uvs,
}

impl Columns {
    /// A row for each corner, in their order; the first one is that which lies farthest in some direction, as any may be
    /// begun with.
    fn of(self, polygon: &[ClipVertex]) -> Raw {
        let far = |corner: &ClipVertex| corner.position.dot(Vec4::new(0.61, 0.37, -0.23, 0.11));
        let first = (0..polygon.len()).max_by(|&a, &b| far(&polygon[a]).total_cmp(&far(&polygon[b])));
        let first = first.unwrap_or_default();
        let corners = polygon[first..].iter().chain(&polygon[..first]);
        match self {
            Self::Positions => Raw::list(corners.map(|corner| corner.position.to_array())),
            Self::Uvs => Raw::list(corners.map(|corner| corner.uv.to_array())),
        }
    }
}

fn corner_code(corner: &ClipVertex) -> String {
    format!("ClipVertex {{ position: {}, uv: {} }}", corner.position.code(), corner.uv.code())
}

/// What planes leave of a triangle, one after the other.
fn clipped(triangle: [ClipVertex; 3], planes: Vec<Vec4>, columns: Columns) -> Task<Clipping> {
    let corners = triangle.each_ref().map(corner_code).join(", ");
    let call = planes
        .iter()
        .fold(format!("[{corners}]"), |polygon, plane| format!("clip(&{polygon}, {})", plane.code()));
    Task::call("", call, move |student: &Clipping| {
        let polygon =
            planes.iter().fold(triangle.to_vec(), |polygon, &plane| (student.clip)(&polygon, plane));
        columns.of(&polygon)
    })
}

/// A triangle with one corner right on a plane, the others inside.
fn touching(rng: &mut Rng) -> Task<Clipping> {
    let mut corners = triangle(rng, [1.0; 3]);
    for corner in &mut corners {
        corner.position.x = size(rng);
    }
    corners[1].position.x = 0.0;
    clipped(corners, vec![Vec4::X], Columns::Positions)
}

/// A triangle that lies in a plane.
fn lying_in(rng: &mut Rng) -> Task<Clipping> {
    let corners = triangle(rng, [1.0; 3]).map(|corner| {
        let position = corner.position.xyw().extend(0.0);
        // z is 0.
        ClipVertex { position: Vec4::new(position.x, position.y, 0.0, position.z), ..corner }
    });
    clipped(corners, vec![Vec4::Z], Columns::Positions)
}

/// On how many sides two neighbours find the same corner.
fn neighbours(rng: &mut Rng) -> Task<Clipping> {
    let (sides, seed) = (rng.usize(150..250), rng.u64(..));
    let input =
        format!("on {sides} sides, how often clip(&[a, b, c], plane) and clip(&[b, a, d], plane) agree");
    let code = format!("let got = clipping_tasks::agreeing(clip, {sides}, {seed});");
    Task::new(input, code, move |student: &Clipping| Raw::value([agreeing(student.clip, sides, seed) as f32]))
}

/// On how many of random sides, one end inside of a plane and one outside, the triangles on both sides of it have the same
/// new corner.
#[must_use]
pub fn agreeing(clip: fn(&[ClipVertex], Vec4) -> Vec<ClipVertex>, sides: usize, seed: u64) -> usize {
    let mut rng = Rng::with_seed(seed);
    let agree = |_: &usize| {
        let (corners, plane) = cut_triangle(&mut rng, [1, -1, 1]);
        // Numbers that fill their bits, so that nothing is exact by luck.
        let [a, b, c] = corners
            .map(|corner| ClipVertex { position: corner.position * (0.9 + 0.2 * rng.f32()), ..corner });
        let d = ClipVertex { position: 2.0 * a.position - c.position * 0.1, ..c };
        let new = |polygon: [ClipVertex; 3]| -> Vec<ClipVertex> {
            clip(&polygon, plane).into_iter().filter(|corner| !polygon.contains(corner)).collect()
        };
        let other = new([b, a, d]);
        new([a, b, c]).iter().any(|corner| other.contains(corner))
    };
    (0..sides).filter(agree).count()
}

/// Width and height of the pictures.
const SIZE: [u16; 2] = [240, 180];

/// A triangle in the picture, the two halves that a plane and the same one turned round make of it, one red, one green.
fn halves(rng: &mut Rng) -> Task<Clipping> {
    let triangle = [(-0.9, -0.8), (0.8, -0.9 + 0.3 * rng.f32()), (0.5 * signed(rng), 0.9)].map(|(x, y)| {
        let w = size(rng);
        ClipVertex { position: Vec4::new(x * w, y * w, 0.0, w), uv: Vec2::ZERO }
    });
    let plane = Vec4::new(signed(rng), 1.0, 0.0, 0.2 * signed(rng));
    let [width, height] = SIZE;
    let code = format!(
        "let triangle = [{}];\n\
         let got = clipping_tasks::both_halves(&triangle, {}, clip);",
        triangle.each_ref().map(corner_code).join(", "),
        plane.code()
    );
    let input = format!("the halves of a triangle, {width}x{height}, cut by {}", plane.code());
    Task::new(input, code, move |student: &Clipping| {
        Raw::Picture(both_halves(&triangle, plane, student.clip))
    })
    .of(move |functions| placed(&triangle, &[plane], functions))
}

/// The two halves of a triangle: pixels on the inner side of the plane are red, those of the other side green, each as often as
/// they are covered.
#[must_use]
pub fn both_halves(
    triangle: &[ClipVertex; 3],
    plane: Vec4,
    clip: fn(&[ClipVertex], Vec4) -> Vec<ClipVertex>,
) -> Image {
    let mut image = canvas(SIZE[0], SIZE[1]);
    let bounds = image.bounds();
    for (plane, step) in [(plane, [100, 0]), (-plane, [0, 100])] {
        for triangle in fan(&clip(triangle, plane)) {
            pixels(triangle, bounds, |x, y, _, _| {
                if let Some(Color { r, g, .. }) = image.get(x, y) {
                    image.set(x, y, Color::rgb(r.saturating_add(step[0]), g.saturating_add(step[1]), 0));
                }
            });
        }
    }
    image
}

/// What planes leave of a triangle, in the window.
fn placed(triangle: &[ClipVertex; 3], planes: &[Vec4], functions: &Clipping) -> Vec<Shape> {
    let size = Vec2::new(SIZE[0].into(), SIZE[1].into());
    let polygon = planes.iter().fold(triangle.to_vec(), |polygon, &plane| (functions.clip)(&polygon, plane));
    let corner = |corner: ClipVertex| Some(window(corner.position, size)?.xyz());
    fan(&polygon).filter_map(|triangle| triangle.map(corner).into_iter().collect()).collect()
}

/// The walls of a room around the origin, seen from inside, and a board in it that shows its back to whoever looks along −z;
/// in clip space.
#[must_use]
pub fn walls(to_clip: Mat4) -> Vec<[ClipVertex; 3]> {
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z];
    // The middle, and the ways to the right and up, as they are seen from inside.
    let walls = [[-z, x, y], [z, -x, y], [x, z, y], [-x, -z, y], [-y, x, -z], [y, x, z]];
    let board = [-z * 0.3, -x * 0.2, y * 0.2];
    let mut triangles = Vec::new();
    for [middle, right, up] in walls.into_iter().chain([board]) {
        let [p, q, r, s] =
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(across, along)| ClipVertex {
                position: to_clip * (2.0 * (middle + across * right + along * up)).extend(1.0),
                uv: Vec2::new(across, along) + 1.0,
            });
        triangles.extend([[p, q, r], [p, r, s]]);
    }
    triangles
}

/// A camera at that place, which looks along −z.
#[must_use]
pub fn camera(eye: Vec3) -> Mat4 {
    let aspect = f32::from(SIZE[0]) / f32::from(SIZE[1]);
    perspective(90.0, aspect, 0.1, 10.0).map_or(Mat4::IDENTITY, |camera| camera * translate(-eye))
}

/// The room from a place inside of it.
fn room(rng: &mut Rng) -> Task<Clipping> {
    let [width, height] = SIZE;
    let eye = Vec3::new(signed(rng), signed(rng), 0.6 + 0.8 * rng.f32());
    let code = format!(
        "let to_clip = clipping_tasks::camera({});\n\
         let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         draw(&clipping_tasks::walls(to_clip), &clipping_tasks::pattern(), facing, clip, &mut got);",
        eye.code()
    );
    let to_clip = camera(eye);
    let input = format!("a room around the eye, {width}x{height}, from {}", eye.code());
    Task::new(input, code, move |student: &Clipping| {
        let mut image = canvas(width, height);
        draw(&walls(to_clip), &pattern(), student.facing, student.clip, &mut image);
        Raw::Picture(image)
    })
    .of(move |functions| {
        let seen =
            |triangle: &[ClipVertex; 3]| (functions.facing)(triangle.map(|corner| corner.position)) > 0.0;
        walls(to_clip)
            .iter()
            .filter(|triangle| seen(triangle))
            .flat_map(|triangle| placed(triangle, &PLANES, functions))
            .collect()
    })
}
