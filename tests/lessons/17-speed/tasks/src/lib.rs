//! Mission 17: how much of a block a triangle covers.

pub use speed_given as given;

use common::{Color, Vec2};
use fastrand::Rng;
use tasks::scenery::canvas;
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

use given::{CoverOf, Edges, SIDE, draw};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Speed {
    /// The lesson's `cover`.
    pub cover: CoverOf,
}

/// The mission.
pub const MISSION: Mission<Speed> = Mission {
    lesson: "17-speed",
    checks: &[
        Check {
            name: "one side",
            asks: "blocks outside, across and inside of one side; and one with a triangle in it",
            points: 3,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for quarter in 0..4_u8 {
                    let angle = (f32::from(quarter) + 0.2 + 0.6 * rng.f32()) * std::f32::consts::FRAC_PI_2;
                    let through = Vec2::new(200.0 + rng.f32(), 200.0 + rng.f32());
                    tasks.extend(crossing(rng, through, Vec2::from_angle(angle)));
                }
                tasks.extend(around(rng));
                rng.shuffle(&mut tasks);
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "on a side",
            asks: "blocks with pixels on a side: of top and left ones, and of others",
            points: 2,
            tasks: |rng| {
                let ways = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
                let mut tasks = Vec::new();
                for (x, y) in ways {
                    let through = Vec2::new(rng.i32(190..210) as f32, rng.i32(190..210) as f32) + 0.5;
                    tasks.extend(crossing(rng, through, Vec2::new(x as f32, y as f32)));
                }
                rng.shuffle(&mut tasks);
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "three sides",
            asks: "blocks at narrow, small and large triangles",
            points: 2,
            tasks: |rng| {
                let mut tasks = Vec::new();
                for _ in 0..6 {
                    tasks.extend(blocks_of(rng, narrow, 2));
                    tasks.extend(blocks_of(rng, small, 2));
                    tasks.extend(blocks_of(rng, large, 2));
                }
                rng.shuffle(&mut tasks);
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "triangles, drawn block by block",
            points: 3,
            tasks: |rng| (0..2).map(|_| picture(rng.u64(..1_000_000))).collect(),
            precision: Precision::EXACT,
        },
    ],
};

/// Width and height of the pictures.
const SIZE: [u16; 2] = [160, 120];

/// A place in 1/256 px.
fn rounded(place: Vec2) -> Vec2 {
    (place * 256.0).round() / 256.0
}

/// Four blocks along a row or a column that crosses a long side of a triangle, through a point and along a way; the other sides are
/// far from there. They are the last one outside of the side, the first and the last of which a part is inside, and the first one
/// inside.
fn crossing(rng: &mut Rng, through: Vec2, way: Vec2) -> Vec<Task<Speed>> {
    let long = way * f32::from(rng.u8(100..140));
    // What belongs to a side stands at the place of the corner opposite to it.
    let side = rng.usize(..3);
    let mut corners = [through + long.perp(), through - long, through + long].map(rounded);
    corners.rotate_right(side);
    let Some(edges) = Edges::new(corners) else { return Vec::new() };
    let (right, up) = (edges.right[side], edges.up[side]);
    let along_x = if right == 0.0 || up == 0.0 { up == 0.0 } else { rng.bool() };
    // Towards the inside.
    let (x, y) = if along_x { (right.signum() as i32, 0) } else { (0, up.signum() as i32) };
    let middle = through.as_ivec2();
    let place = |n: i32| (middle.x + n * x, middle.y + n * y);
    let inside = |n: i32| {
        let (x, y) = place(n);
        edges.counts(x, y)[side]
    };
    let far = 5 * SIDE;
    let first = |least: i32| (-far..far).find(|&n| inside(n) >= least).unwrap_or(far);
    let (some, all) = (first(1), first(SIDE * SIDE));
    [some - 1, some, all - 1, all].map(|n| said(&edges, place(n))).into()
}

/// The block around a small triangle.
fn around(rng: &mut Rng) -> Option<Task<Speed>> {
    let (x, y) = (rng.i32(10..90), rng.i32(10..90));
    let at = |right: f32, up: f32| rounded(Vec2::new(x as f32 + right, y as f32 + up));
    let corners = [at(1.0 + rng.f32(), 1.0 + rng.f32()), at(6.0 + rng.f32(), 2.5), at(3.5, 6.0 + rng.f32())];
    Edges::new(corners).map(|edges| said(&edges, (x, y)))
}

/// Blocks at random about a triangle; of each of the answers, if it is found, so many.
fn blocks_of(rng: &mut Rng, corners: fn(&mut Rng) -> [Vec2; 3], each: usize) -> Vec<Task<Speed>> {
    let Some(edges) = Edges::new(corners(rng)) else { return Vec::new() };
    let mut found: [Vec<(i32, i32)>; 3] = Default::default();
    for _ in 0..1000 {
        let place = (rng.i32(0..i32::from(SIZE[0])), rng.i32(0..i32::from(SIZE[1])));
        let (x, y) = place;
        let counts = edges.counts(x, y);
        let kind = match counts {
            _ if edges.is_open(x, y) => continue,
            _ if counts.contains(&0) => 0,
            _ if counts.iter().all(|&count| count == SIDE * SIDE) => 2,
            _ => 1,
        };
        if found[kind].len() < each {
            found[kind].push(place);
        }
    }
    found.into_iter().flatten().map(|place| said(&edges, place)).collect()
}

/// A point in the picture.
fn any(rng: &mut Rng) -> Vec2 {
    Vec2::new(rng.f32() * f32::from(SIZE[0]), rng.f32() * f32::from(SIZE[1]))
}

/// Some pixels wide at one end, and long: corners of blocks are seldom in it.
fn narrow(rng: &mut Rng) -> [Vec2; 3] {
    let tip = any(rng);
    let way = Vec2::from_angle(rng.f32() * std::f32::consts::TAU);
    let end = tip + way * (60.0 + 60.0 * rng.f32());
    [tip, end, end + way.perp() * (2.0 + 3.0 * rng.f32())].map(rounded)
}

/// Smaller than a block.
fn small(rng: &mut Rng) -> [Vec2; 3] {
    let middle = any(rng);
    let turn = rng.f32();
    [0.0, 1.0, 2.0].map(|n| {
        rounded(middle + Vec2::from_angle((turn + n / 3.0) * std::f32::consts::TAU) * (2.0 + 2.0 * rng.f32()))
    })
}

/// As large as half the picture.
fn large(rng: &mut Rng) -> [Vec2; 3] {
    let find = |_| {
        let corners = [(); 3].map(|()| any(rng));
        let [a, b, c] = corners;
        ((b - a).perp_dot(c - a).abs() > 8000.0).then(|| corners.map(rounded))
    };
    (0..).find_map(find).unwrap_or_default()
}

/// What is said of the block with that lower left pixel.
fn said(edges: &Edges, (x, y): (i32, i32)) -> Task<Speed> {
    let Edges { right, up, inside, .. } = *edges;
    let start = edges.at(x, y);
    let call = format!("cover({}) as u8", [start, right, up, inside].map(|v| v.code()).join(", "));
    let code = format!("let got = [f32::from({call})];");
    Task::new(call, code, move |student: &Speed| {
        Raw::value([f32::from((student.cover)(start, right, up, inside) as u8)])
    })
}

/// Triangles of all kinds, in bright colours.
#[must_use]
pub fn triangles(seed: u64) -> Vec<([Vec2; 3], Color)> {
    let mut rng = Rng::with_seed(seed);
    let kinds = [large, large, narrow, narrow, small, small, small];
    kinds.map(|corners| (corners(&mut rng), bright(&mut rng))).into()
}

fn bright(rng: &mut Rng) -> Color {
    Color::rgb(rng.u8(128..), rng.u8(128..), rng.u8(128..))
}

fn picture(seed: u64) -> Task<Speed> {
    let [width, height] = SIZE;
    let code = format!(
        "let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         draw(&speed_tasks::triangles({seed}), cover, &mut got);"
    );
    let input = format!("7 triangles, {width}x{height}");
    let shapes: Vec<Shape> =
        triangles(seed).iter().map(|(corners, _)| corners.map(|corner| corner.extend(0.0)).into()).collect();
    Task::new(input, code, move |student: &Speed| {
        let mut image = canvas(width, height);
        draw(&triangles(seed), student.cover, &mut image);
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}
