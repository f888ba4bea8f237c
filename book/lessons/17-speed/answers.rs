//! The numbers of the chapter's worked examples and of its quizzes, computed by the lesson's own code.

use common::DVec3;
use speed::blocks::{Cover, SIDE, cover};

use super::figures::crossing;
use super::sketches::{example, faster};

/// The block of four by four, and what its corners say.
#[test]
fn the_example_is_as_the_chapter_says() {
    assert_eq!([example(0, 0), example(3, 0), example(0, 3), example(3, 3)], [-3, 9, 12, 24]);
    let outside = (0..16).filter(|n| example(n % 4, n / 4) < 0).count();
    assert_eq!(outside, 1);
}

/// E = 100 − 9 x − 6 y of the quiz: least at the upper right corner.
#[test]
fn the_quiz_about_a_block() {
    let (right, up) = (DVec3::splat(-9.0), DVec3::splat(-6.0));
    let least = 100.0 + (-9.0 - 6.0) * f64::from(SIDE - 1);
    assert_eq!(least, -5.0);
    assert_eq!(cover(DVec3::splat(100.0), right, up, DVec3::ZERO), Cover::Part);
    assert_eq!(cover(DVec3::splat(105.0), right, up, DVec3::ZERO), Cover::Whole);
}

/// A sum depends on where the brackets stand, and a fused operation on what is not rounded.
#[test]
fn the_order_of_roundings_matters() {
    assert_eq!((1e8_f32 + 3.0) + 2.0, 100_000_000.0);
    assert_eq!(1e8_f32 + (3.0 + 2.0), 100_000_008.0);
    assert_eq!((1e8_f32 + 3.0) + (3.0 + 2.0), 100_000_008.0);
    assert_eq!(((1e8_f32 + 3.0) + 3.0) + 2.0, 100_000_000.0);
    let (x, y) = (1.0 + f32::EPSILON, 1.0 - f32::EPSILON);
    assert_eq!(x * y - 1.0, 0.0);
    assert!(x.mul_add(y, -1.0) < 0.0);
}

#[test]
fn what_threads_gain() {
    assert!((faster(0.05, 2.0) - 1.905).abs() < 0.001);
    assert!((faster(0.05, 64.0) - 15.4).abs() < 0.05);
    assert!((1.0 / 0.05_f32 - 20.0).abs() < 1e-4);
}

/// The figure's bound loses pixels, as it should.
#[test]
fn a_bound_at_the_middle_loses_pixels() {
    let [right, wrong] = [false, true].map(|by_middles| crossing(64, by_middles));
    let lost = right.iter().zip(&wrong).filter(|(right, wrong)| right != wrong).count();
    assert!(lost > 0, "{lost}");
}
