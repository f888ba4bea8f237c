//! Smooth lines that are equally thick in every direction: the coverage of a pixel follows from its distance.
//!
//! [`wu`](crate::wu()) measures across the major axis, along a row or a column; a line of slope 1 is 1/√2 px thick
//! that way. Here the distance is at a right angle to the line, which the fixed-point height gives by one factor:
//! the cosine of the line's angle. A pixel gets the share 1 − distance. (S. Gupta and R. Sproull, *Filtering edges
//! for gray-scale displays*, SIGGRAPH 1981, look the share up by this distance, in a table made for a round filter.)

use common::{Bounds, IVec2};

use crate::major::Major;
use crate::wu::reach;

/// Visits the pixels of the segment that lie in the window (and perhaps neighbours of one at its border), with
/// their coverage, never 0: up to three in a step. Time: what is visible.
// ANCHOR: distance
pub fn distance(a: IVec2, b: IVec2, window: Bounds, mut plot: impl FnMut(i32, i32, u8)) {
    let line = Major::new(a, b);
    let slope = ((line.rise as u128) << 64) / line.length.max(1) as u128;
    // The cosine of the line's angle, times 2¹⁶: a distance across the major axis times this is one at a right angle.
    let [length, rise] = [line.length.max(1), line.rise].map(|side| side as f64);
    let cosine = (length / (length * length + rise * rise).sqrt() * 65536.0) as i64;
    // The lowest of four pixels in a column lies one below the line's.
    let visible = line.visible(window, 3, |risen| reach(risen + 1, slope));
    let mut height = *visible.start() as u128 * slope;
    for step in visible {
        let (whole, part) = ((height >> 64) as i64, (height >> 48) as u16);
        for risen in -1..=2 {
            let across = (risen * 65536 - i64::from(part)).abs();
            let share = 65536 - ((across * cosine) >> 16);
            let coverage = (share * 255 + 32768) >> 16;
            if coverage > 0
                && let Some((x, y)) = line.neighbour(step, whole + risen)
            {
                plot(x, y, coverage as u8);
            }
        }
        height += slope;
    }
}
// ANCHOR_END: distance
