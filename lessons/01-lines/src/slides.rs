//! The way to the algorithm, step by step, faults included.
//!
//! Each function mends something of the one before it. They follow the course's slides (section *Dessiner
//! une ligne*), whose C++ truncates real numbers towards 0 when it makes integers of them; so do these.

use std::mem::swap;
use std::num::Wrapping;

use common::{Bounds, IVec2, Vec2Swizzles};

use crate::FULL;

/// The first attempt, with ten steps.
pub fn step_tenth(a: IVec2, b: IVec2, _: Bounds, plot: impl FnMut(i32, i32, u8)) {
    fixed_step(0.1, a, b, plot);
}

/// The first attempt, with a hundred steps.
pub fn step_hundredth(a: IVec2, b: IVec2, _: Bounds, plot: impl FnMut(i32, i32, u8)) {
    fixed_step(0.01, a, b, plot);
}

/// Walks from *a* to *b* in steps of a magic number: too few leave gaps, too many cost time.
// ANCHOR: fixed_step
fn fixed_step(step: f32, a: IVec2, b: IVec2, mut plot: impl FnMut(i32, i32, u8)) {
    let mut t = 0.0;
    while t < 1.0 {
        plot(between(a.x, b.x, t), between(a.y, b.y, t), FULL);
        t += step;
    }
}
// ANCHOR_END: fixed_step

/// The number at the share `t` of the way.
fn between(from: i32, to: i32, t: f32) -> i32 {
    (from as f32 + (to as f32 - from as f32) * t) as i32
}

/// Computes t from x, so that every column gets its pixel: right for lines that go right and are not steep.
// ANCHOR: per_column
pub fn per_column(a: IVec2, b: IVec2, _: Bounds, mut plot: impl FnMut(i32, i32, u8)) {
    for x in a.x..=b.x {
        // Where both ends are one, this is 0/0, and y becomes 0.
        let t = (x as f32 - a.x as f32) / (b.x as f32 - a.x as f32);
        plot(x, between(a.y, b.y, t), FULL);
    }
}
// ANCHOR_END: per_column

/// Swaps x and y of steep lines, and the ends of those that go left; `plot` will swap x and y back.
// ANCHOR: transpose
fn transpose(
    mut a: IVec2,
    mut b: IVec2,
    mut plot: impl FnMut(i32, i32, u8),
) -> (IVec2, IVec2, impl FnMut(i32, i32)) {
    let steep = a.x.abs_diff(b.x) < a.y.abs_diff(b.y);
    if steep {
        (a, b) = (a.yx(), b.yx());
    }
    if a.x > b.x {
        swap(&mut a, &mut b);
    }
    (a, b, move |x, y| if steep { plot(y, x, FULL) } else { plot(x, y, FULL) })
}

/// [`per_column`], mended for steep and for leftward lines.
pub fn transposed(a: IVec2, b: IVec2, window: Bounds, plot: impl FnMut(i32, i32, u8)) {
    let (a, b, mut plot) = transpose(a, b, plot);
    per_column(a, b, window, |x, y, _| plot(x, y));
}
// ANCHOR_END: transpose

/// Adds the slope once a column: no multiplication or division in the loop, but each sum is rounded.
// ANCHOR: slope
pub fn slope(a: IVec2, b: IVec2, _: Bounds, plot: impl FnMut(i32, i32, u8)) {
    let (a, b, mut plot) = transpose(a, b, plot);
    let step = (b.y as f32 - a.y as f32) / (b.x as f32 - a.x as f32);
    let mut y = a.y as f32;
    for x in a.x..=b.x {
        plot(x, y as i32);
        y += step;
    }
}
// ANCHOR_END: slope

/// Keeps the whole part of y apart from the fraction, which stays between −½ and ½ and so loses less.
// ANCHOR: fraction
pub fn fraction(a: IVec2, b: IVec2, _: Bounds, plot: impl FnMut(i32, i32, u8)) {
    let (a, b, mut plot) = transpose(a, b, plot);
    let step = (b.y as f32 - a.y as f32).abs() / (b.x as f32 - a.x as f32);
    let sign = if b.y > a.y { 1 } else { -1 };
    let mut y = a.y;
    let mut part = 0.0;
    for x in a.x..=b.x {
        plot(x, y);
        part += step;
        if part > 0.5 {
            part -= 1.0;
            y = y.wrapping_add(sign);
        }
    }
}
// ANCHOR_END: fraction

/// dx, 2·|dy|, and the way y goes; as in C, 32 bits wrap around.
fn doubled(a: IVec2, b: IVec2) -> (Wrapping<i32>, Wrapping<i32>, i32) {
    let dx = Wrapping(b.x) - Wrapping(a.x);
    let step = Wrapping(2) * Wrapping((Wrapping(b.y) - Wrapping(a.y)).0.wrapping_abs());
    (dx, step, if b.y > a.y { 1 } else { -1 })
}

/// Multiplies everything by 2dx: the same in whole numbers, and therefore exact.
///
/// Sums of up to dx + 2dy do not fit into 32 bits on lines of some 2³⁰ pixels.
// ANCHOR: scaled
pub fn scaled(a: IVec2, b: IVec2, _: Bounds, plot: impl FnMut(i32, i32, u8)) {
    let (a, b, mut plot) = transpose(a, b, plot);
    let (dx, step, sign) = doubled(a, b);
    let mut y = a.y;
    let mut part = Wrapping(0);
    for x in a.x..=b.x {
        plot(x, y);
        part += step;
        if part > dx {
            part -= Wrapping(2) * dx;
            y = y.wrapping_add(sign);
        }
    }
}
// ANCHOR_END: scaled

/// The slides' last version as printed: starts at −dx, so as to compare with 0, but steps before it plots.
///
/// On slopes above ½ the first column is already one row too far, and the last one lies past the end.
// ANCHOR: listing
pub fn listing(a: IVec2, b: IVec2, _: Bounds, plot: impl FnMut(i32, i32, u8)) {
    let (a, b, mut plot) = transpose(a, b, plot);
    let (dx, step, sign) = doubled(a, b);
    let mut y = a.y;
    let mut part = -dx;
    for x in a.x..=b.x {
        part += step;
        if part > Wrapping(0) {
            part -= Wrapping(2) * dx;
            y = y.wrapping_add(sign);
        }
        plot(x, y);
    }
}
// ANCHOR_END: listing
