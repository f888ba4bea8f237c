//! Lesson 1: the pixels of a segment.

use common::{Color, Format, IVec2, Image};
use fastrand::Rng;

use super::causes::{self, picture_and};
use super::{Cause, Check, Mission, Precision, Raw, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Lines {
    /// [`lines::line`].
    pub line: fn(IVec2, IVec2, &mut Image, Color),
}

type Segment = (IVec2, IVec2, Color);

/// The mission.
pub const MISSION: Mission<Lines> = Mission {
    lesson: "01-lines",
    reference: Lines { line: lines::line },
    checks: &[
        Check {
            name: "picture",
            asks: "the lesson's two lines",
            points: 2,
            tasks: |_| {
                let white = (IVec2::new(13, 20), IVec2::new(80, 40), Color::WHITE);
                let red = (IVec2::new(20, 13), IVec2::new(40, 80), Color::RED);
                vec![drawing(100, vec![white, red])]
            },
            precision: Precision::EXACT,
            causes: || picture_and(&[]),
        },
        Check {
            name: "gentle",
            asks: "to the right, more across than up or down",
            points: 2,
            tasks: |rng| some(rng, false, |low, high| (low, high)),
            precision: Precision::EXACT,
            causes: || picture_and(&[END]),
        },
        Check {
            name: "steep",
            asks: "upwards, more up than across",
            points: 2,
            tasks: |rng| some(rng, true, |low, high| (low, high)),
            precision: Precision::EXACT,
            causes: || picture_and(&[END, GAPS]),
        },
        Check {
            name: "backward",
            asks: "from the right or from above: the same pixels as from the other end, halves included",
            points: 2,
            tasks: |rng| {
                let mut tasks = some(rng, false, |low, high| (high, low));
                tasks.extend(some(rng, true, |low, high| (high, low)));
                // Half-way, this one is exactly between two pixels, of which the lower end's is right.
                let (a, b) = (IVec2::new(3, 3), IVec2::new(13, 8));
                tasks.extend([
                    drawing(64, vec![(a, b, Color::WHITE)]),
                    drawing(64, vec![(b, a, Color::WHITE)]),
                ]);
                tasks
            },
            precision: Precision::EXACT,
            causes: || picture_and(&[END, GAPS, HALF]),
        },
        Check {
            name: "straight",
            asks: "level, upright, diagonal, and a single pixel",
            points: 1,
            tasks: |_| {
                let a = IVec2::new(20, 30);
                let ends = [(0, 0), (9, 0), (-9, 0), (0, 9), (0, -9), (7, 7), (-7, 7), (7, -7), (-7, -7)];
                ends.map(|end| drawing(64, vec![(a, a + IVec2::from(end), Color::WHITE)])).into()
            },
            precision: Precision::EXACT,
            causes: || picture_and(&[END]),
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
            causes: || picture_and(&[]),
        },
    ],
};

const END: Cause = Cause {
    name: "the pixel at an end is missing: both ends belong to the segment",
    explains: |asked, got| {
        asked.becomes(got, |raw| without_end(raw, |along, so_far| along >= so_far))
            || asked.becomes(got, |raw| without_end(raw, |along, so_far| along < so_far))
    },
};

const GAPS: Cause = Cause {
    name: "gaps: a steep line needs a pixel in each row, not in each column",
    explains: |asked, got| {
        let one = |counts: Vec<usize>| counts.into_iter().map(|count| count.min(1)).collect::<Vec<_>>();
        let expected = columns(&asked.expected);
        columns(got) != expected && columns(got) == one(expected)
    },
};

const HALF: Cause = Cause {
    name: "half-way between two pixels the wrong one is taken: it is the one on the lower end's side",
    // Turned by half a turn, a segment is the same but where it is half-way between two pixels.
    explains: |asked, got| {
        asked.becomes(got, |raw| {
            let [min, max] = [IVec2::min, IVec2::max].map(|of| drawn(raw).into_iter().reduce(of));
            let sum = min.unwrap_or_default() + max.unwrap_or_default();
            causes::picture(raw, |from, x, y| from.get(sum.x - x, sum.y - y))
        })
    },
};

/// The pixels drawn in a picture.
fn drawn(raw: &Raw) -> Vec<IVec2> {
    let Raw::Picture(image) = raw else { return Vec::new() };
    image.pixels().filter(|pixel| pixel.2 != Color::BLACK).map(|(x, y, _)| IVec2::new(x, y)).collect()
}

/// How many pixels are drawn in each column.
fn columns(raw: &Raw) -> Vec<usize> {
    let drawn = drawn(raw);
    (0..64).map(|x| drawn.iter().filter(|pixel| pixel.x == x).count()).collect()
}

/// The picture of one segment without the pixel that `beats` all others along its longer side.
fn without_end(raw: &Raw, beats: fn(i32, i32) -> bool) -> Raw {
    let drawn = drawn(raw);
    let extent = |side: fn(&IVec2) -> i32| {
        drawn.iter().map(side).max().unwrap_or(0) - drawn.iter().map(side).min().unwrap_or(0)
    };
    let along: fn(&IVec2) -> i32 = if extent(|p| p.x) >= extent(|p| p.y) { |p| p.x } else { |p| p.y };
    let end = drawn.iter().copied().reduce(|end, p| if beats(along(&p), along(&end)) { p } else { end });
    causes::picture(raw, |from, x, y| from.get(x, y).filter(|_| end != Some(IVec2::new(x, y))))
}

/// Draws segments into a square picture.
fn drawing(side: u16, segments: Vec<Segment>) -> Task<Lines> {
    let ends = segments.iter().map(|(a, b, _)| format!("({}, {})-({}, {})", a.x, a.y, b.x, b.y));
    Task::new(ends.collect::<Vec<_>>().join(" and "), move |student: &Lines| {
        let mut image = Image::new(side, side, Format::Rgb);
        for &(a, b, color) in &segments {
            (student.line)(a, b, &mut image, color);
        }
        Raw::Picture(image)
    })
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
