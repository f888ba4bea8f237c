//! Xiaolin Wu's smooth lines (*An efficient antialiasing technique*, SIGGRAPH 1991).
//!
//! The line passes between two pixels of each column. Both get a share, together 255/255, so that their
//! centre of mass is where the line is. The height is a fixed-point number with 64 bits of fraction: after
//! 2³² steps its error is below 2⁻³² px, a segment of any length is drawn to the precision of a coverage,
//! and any step's height is a product, so that the loop can start where the segment comes into view.

use common::{Bounds, IVec2};

use crate::major::Major;

/// Visits the pixels of the segment that lie in the window (and perhaps the neighbour of one at its
/// border), with their coverage, never 0. The ends are covered in full. Time: what is visible.
// ANCHOR: wu
pub fn wu(a: IVec2, b: IVec2, window: Bounds, mut plot: impl FnMut(i32, i32, u8)) {
    let line = Major::new(a, b);
    // How much the line rises in one step, as a 64.64 fixed-point number between 0 and 1.
    let slope = ((line.rise as u128) << 64) / line.length.max(1) as u128;
    let visible = line.visible(window, 1, |risen| reach(risen, slope));
    let mut height = *visible.start() as u128 * slope;
    for step in visible {
        let upper = (height >> 56) as u8;
        for (risen, coverage) in [(0, 255 - upper), (1, upper)] {
            if coverage > 0 {
                let (x, y) = line.pixel(step, (height >> 64) as i64 + risen);
                plot(x, y, coverage);
            }
        }
        height += slope;
    }
}
// ANCHOR_END: wu

/// The first step in which the whole part of the height is at least `risen`.
pub(crate) fn reach(risen: i64, slope: u128) -> i128 {
    match (risen, slope) {
        (..=0, _) => 0,
        (_, 0) => i128::MAX,
        _ => ((risen as u128) << 64).div_ceil(slope) as i128,
    }
}
