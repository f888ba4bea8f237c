//! The numbers of the chapter's worked example and of its quizzes, computed by the lesson's own code.

use common::{Bounds, IVec2};
use lines::bresenham::bresenham;

/// The row of each column of the segment from (0, 0) to (length, rise).
fn rows(length: i32, rise: i32) -> Vec<i32> {
    let bounds = Bounds { min: IVec2::ZERO, max: IVec2::splat(100) };
    let mut rows = Vec::new();
    bresenham(IVec2::ZERO, IVec2::new(length, rise), bounds, |_, y, _| rows.push(y));
    rows
}

#[test]
fn the_example_of_seven_columns() {
    assert_eq!(rows(7, 3), [0, 0, 1, 1, 2, 2, 3, 3]);
    // The two rows of errors: after adding, and after what is taken off.
    let (mut error, mut added, mut kept) = (-7, vec![-7], vec![-7]);
    for _ in 0..7 {
        error += 6;
        added.push(error);
        error -= if error > 0 { 14 } else { 0 };
        kept.push(error);
    }
    assert_eq!(added, [-7, -1, 5, -3, 3, -5, 1, -7]);
    assert_eq!(kept, [-7, -1, -9, -3, -11, -5, -13, -7]);
}

#[test]
fn a_tie_stays_below() {
    assert_eq!(rows(8, 3)[4], 1);
}
