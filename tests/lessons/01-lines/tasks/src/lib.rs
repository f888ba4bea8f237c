//! Mission 1: the pixels of a segment.

use common::{Color, Format, IVec2, Image, Vec3};
use fastrand::Rng;
use tasks::{Check, Code, Mission, Precision, Raw, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Lines {
    /// The lesson's `line`.
    pub line: fn(IVec2, IVec2, &mut Image, Color),
}

type Segment = (IVec2, IVec2, Color);

/// The mission.
pub const MISSION: Mission<Lines> = Mission {
    lesson: "01-lines",
    checks: &[
        Check {
            name: "picture",
            asks: "the lesson's two lines, and two others",
            points: 2,
            tasks: |rng| {
                let white = (IVec2::new(13, 20), IVec2::new(80, 40), Color::WHITE);
                let red = (IVec2::new(20, 13), IVec2::new(40, 80), Color::RED);
                // Of odd lengths, as in `some`.
                let along = 2 * rng.i32(15..30) + 1;
                let up = rng.i32(2..along - 1);
                let a = IVec2::new(rng.i32(1..30), rng.i32(1..30));
                let two = [IVec2::new(along, up), IVec2::new(up, along)];
                let others = [(two[0], Color::WHITE), (two[1], Color::RED)];
                let others = others.map(|(way, color)| (a, a + way, color));
                vec![drawing(100, vec![white, red]), drawing(100, others.into())]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "gentle",
            asks: "to the right, more across than up or down",
            points: 2,
            tasks: |rng| some(rng, false, |low, high| (low, high)),
            precision: Precision::EXACT,
        },
        Check {
            name: "steep",
            asks: "upwards, more up than across",
            points: 2,
            tasks: |rng| some(rng, true, |low, high| (low, high)),
            precision: Precision::EXACT,
        },
        Check {
            name: "backward",
            asks: "from the right or from above: the same pixels as from the other end",
            points: 1,
            tasks: |rng| {
                // One to the right: whoever draws nothing at all has no fault of direction.
                let mut tasks = some(rng, false, |low, high| (low, high));
                tasks.truncate(1);
                tasks.extend(some(rng, false, |low, high| (high, low)));
                tasks.extend(some(rng, true, |low, high| (high, low)));
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "halves",
            asks: "half-way between two pixels it is the lower end's, from either end",
            points: 1,
            tasks: |rng| {
                let mut tasks = Vec::new();
                // Half-way, these are exactly between two pixels, of which the lower end's is right.
                for end in [(10, 5), (10, -5), (5, 10), (-5, 10)] {
                    let a = IVec2::new(rng.i32(10..40), rng.i32(10..40));
                    let b = a + IVec2::from(end);
                    tasks.extend([(a, b), (b, a)].map(|(a, b)| drawing(64, vec![(a, b, Color::WHITE)])));
                }
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "straight",
            asks: "level, upright, diagonal, and a single pixel",
            points: 1,
            tasks: |rng| {
                let a = IVec2::new(rng.i32(12..52), rng.i32(12..52));
                let ends = [(0, 0), (9, 0), (-9, 0), (0, 9), (0, -9), (7, 7), (-7, 7), (7, -7), (-7, -7)];
                ends.map(|end| drawing(64, vec![(a, a + IVec2::from(end), Color::WHITE)])).into()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "far",
            asks: "ends far outside: what can be seen is right to the pixel",
            points: 1,
            tasks: |rng| {
                let mut far = || {
                    // Both ends a few million pixels away, on opposite sides of the picture.
                    let end = IVec2::new(rng.i32(1_000_000..4_000_000), rng.i32(-900_000..900_000));
                    let shift = IVec2::new(rng.i32(20..44), rng.i32(20..44));
                    // Twice the end, and 1: an odd length, on which no pixel is exactly half-way.
                    (shift - end, shift + end + IVec2::X, Color::WHITE)
                };
                (0..3).map(|_| drawing(64, vec![far()])).collect()
            },
            precision: Precision::EXACT,
        },
    ],
};

/// Draws segments into a square picture.
fn drawing(side: u16, segments: Vec<Segment>) -> Task<Lines> {
    let call = |(a, b, _): &Segment| format!("line(({}, {}), ({}, {}))", a.x, a.y, b.x, b.y);
    let input = segments.iter().map(call).collect::<Vec<_>>().join(" and ");
    let mut code = format!("let mut got = Image::new({side}, {side}, Format::Rgb);\n");
    for (a, b, color) in &segments {
        code += &format!("line({}, {}, &mut got, {});\n", a.code(), b.code(), color.code());
    }
    let shapes: Vec<_> =
        segments.iter().map(|(a, b, _)| vec![a, b].into_iter().map(center).collect()).collect();
    Task::new(input, code, move |student: &Lines| {
        let mut image = Image::new(side, side, Format::Rgb);
        for &(a, b, color) in &segments {
            (student.line)(a, b, &mut image, color);
        }
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}

fn center(pixel: &IVec2) -> Vec3 {
    (pixel.as_vec2() + 0.5).extend(0.0)
}

/// Six segments, steep or not, with the ends in the order that `order` says. Their lengths are odd, so that
/// no pixel is exactly half-way and there is but one right picture.
fn some(rng: &mut Rng, steep: bool, order: fn(IVec2, IVec2) -> (IVec2, IVec2)) -> Vec<Task<Lines>> {
    let mut segment = || {
        let length = 2 * rng.i32(8..20) + 1;
        let along = rng.i32(2..20);
        // Neither level nor diagonal.
        let rise = rng.i32(2..length - 1) * if rng.bool() { 1 } else { -1 };
        let across = rng.i32(2..20) + if rise < 0 { 40 } else { 0 };
        let ends = [(along, across), (along + length, across + rise)];
        let [low, high] = ends.map(|(m, n)| if steep { IVec2::new(n, m) } else { IVec2::new(m, n) });
        let (a, b) = order(low, high);
        (a, b, Color::WHITE)
    };
    (0..6).map(|_| drawing(64, vec![segment()])).collect()
}
