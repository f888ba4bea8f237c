use common::{Color, Format, IVec2, Image};
use lines::{LESSON, METHODS};
use verify::{assert_drawn, assert_each_drawn, assert_each_text};

/// Outwards in sixteen directions, leaving the middle free; and one pixel alone.
const STAR: [[i32; 4]; 17] = [
    [24, 16, 32, 16],
    [24, 18, 32, 21],
    [23, 20, 30, 26],
    [21, 22, 26, 31],
    [16, 24, 16, 32],
    [14, 24, 11, 32],
    [12, 23, 6, 30],
    [10, 21, 1, 26],
    [8, 16, 0, 16],
    [8, 14, 0, 11],
    [9, 12, 2, 6],
    [11, 10, 6, 1],
    [16, 8, 16, 0],
    [18, 8, 21, 0],
    [20, 9, 26, 2],
    [22, 11, 31, 6],
    [16, 16, 16, 16],
];

#[test]
fn every_method_draws_its_star() {
    assert_each_text(&LESSON, "star", METHODS, |method| {
        let mut image = Image::new(33, 33, Format::Gray);
        for [x0, y0, x1, y1] in STAR {
            (method.run.draw)(IVec2::new(x0, y0), IVec2::new(x1, y1), &mut image, Color::WHITE);
        }
        image
    });
}

#[test]
fn every_method_draws_the_slides_picture() {
    assert_each_drawn(&LESSON, METHODS, &[]);
}

#[test]
fn a_comparison_shows_what_is_missing_and_what_is_extra() {
    assert_drawn(&LESSON, "compare", &["--compare", "bresenham,listing"]);
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
