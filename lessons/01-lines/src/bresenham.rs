//! Bresenham's algorithm, with a head start to where the segment can be seen.
//!
//! At step *i* the ideal line has risen by *i·rise/length*; the pixel nearest to it, the lower one in a tie,
//! has risen by *k(i) = ⌈i·rise/length − ½⌉ = ⌊(2·i·rise + length − 1) / (2·length)⌋*. The loop keeps the
//! error *2·i·rise − 2·length·k − length*, which is positive exactly when k is one too small (J. Bresenham,
//! *Algorithm for computer control of a digital plotter*, IBM Systems Journal 4, 1965).
//!
//! As k never falls, the steps that can be seen are an interval. Its ends follow from the formula, and the
//! loop starts there in the very state in which it would have arrived.

use common::{Bounds, IVec2};

use crate::FULL;
use crate::major::Major;

/// Visits the pixels of the segment that lie in the window: exactly max(|dx|, |dy|) + 1 if all do, none
/// more than ½ px from the ideal line, the same ones for b→a. A tie goes to the side of the lower end of
/// the major axis. Time: what is visible.
// ANCHOR: bresenham
pub fn bresenham(a: IVec2, b: IVec2, window: Bounds, mut plot: impl FnMut(i32, i32, u8)) {
    let line = Major::new(a, b);
    let (length, rise) = (line.length, line.rise);
    let visible = line.visible(window, 0, |risen| reach(risen, length, rise));
    let mut risen = risen_at(*visible.start(), length, rise);
    let mut error = error_at(*visible.start(), risen, length, rise);
    for step in visible {
        let (x, y) = line.pixel(step, risen);
        plot(x, y, FULL);
        error += 2 * rise;
        if error > 0 {
            error -= 2 * length;
            risen += 1;
        }
    }
}
// ANCHOR_END: bresenham

/// k(i): how far the pixels have risen at a step. A segment of one pixel counts as one step long.
fn risen_at(step: i64, length: i64, rise: i64) -> i64 {
    let [step, length, rise] = [step, length.max(1), rise].map(i128::from);
    (2 * step * rise + length - 1).div_euclid(2 * length) as i64
}

/// The loop's error at a step. Its products need 67 bits, the difference 35.
fn error_at(step: i64, risen: i64, length: i64, rise: i64) -> i64 {
    let [step, risen, length, rise] = [step, risen, length, rise].map(i128::from);
    (2 * step * rise - 2 * length * risen - length) as i64
}

/// The first step with k(step) ≥ risen: the smallest with 2·step·rise > length·(2·risen − 1).
fn reach(risen: i64, length: i64, rise: i64) -> i128 {
    let [risen, length, rise] = [risen, length, rise].map(i128::from);
    match (risen, rise) {
        (..=0, _) => 0,
        (_, 0) => i128::MAX,
        _ => length * (2 * risen - 1) / (2 * rise) + 1,
    }
}
