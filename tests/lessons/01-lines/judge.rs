//! Mission 1: the pixels of a segment, judged.

#[cfg(test)]
mod faults;

use std::process::ExitCode;

use common::{Color, IVec2};
use judge::causes::{self, picture_and};
use judge::{Cause, Judge};
use lines_tasks::{Lines, MISSION};
use tasks::Raw;

const JUDGE: Judge<Lines> = Judge {
    mission: MISSION,
    reference: Lines { line: lines::line },
    causes: &[
        ("picture", || picture_and(&[])),
        ("gentle", || picture_and(&[END])),
        ("steep", || picture_and(&[END, GAPS])),
        ("backward", || picture_and(&[END, GAPS, HALF])),
        ("straight", || picture_and(&[END])),
        ("far", || picture_and(&[])),
    ],
};

fn main() -> ExitCode {
    JUDGE.run()
}

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
