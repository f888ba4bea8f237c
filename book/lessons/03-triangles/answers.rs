//! The numbers of the chapter's worked examples and of its quizzes, computed by the lesson's own code.

use common::{Bounds, Vec2, Vec3};
use triangles::barycentric::weights;
use triangles::{fill, flat_intensity};

#[test]
fn a_triangle_that_leans_back() {
    let [a, b, c] = [Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 2.0, 2.0)];
    let half = std::f32::consts::FRAC_1_SQRT_2;
    assert!((flat_intensity([a, b, c], Vec3::Z) - half).abs() < 1e-6);
    assert!((flat_intensity([a, c, b], Vec3::Z) + half).abs() < 1e-6);
}

#[test]
fn weights_by_areas() {
    let corners @ [a, b, c] = [Vec2::ZERO, Vec2::new(8.0, 0.0), Vec2::new(0.0, 4.0)];
    assert_eq!(weights(corners, Vec2::new(2.0, 1.0)), Some(Vec3::new(0.5, 0.25, 0.25)));
    assert_eq!(weights([a, c, b], Vec2::new(2.0, 1.0)), Some(Vec3::new(0.5, 0.25, 0.25)));
    assert_eq!(weights(corners, Vec2::new(4.0, 3.0)), Some(Vec3::new(-0.25, 0.5, 0.75)));
}

#[test]
fn centres_on_sides() {
    let covered = |corners: [(f32, f32); 3]| {
        let mut pixels = Vec::new();
        fill(corners.map(Vec2::from), Bounds::EVERYTHING, |x, y, _| pixels.push((x, y)));
        pixels
    };
    let quiz = covered([(0.5, 0.5), (4.5, 0.5), (0.5, 4.5)]);
    // Left, not below, not on the slanted side.
    assert_eq!(quiz, [(0, 1), (1, 1), (2, 1), (0, 2), (1, 2), (0, 3)]);
    // The square's lower half has the diagonal, the upper one the left and the top side.
    let lower = covered([(0.5, 0.5), (4.5, 0.5), (4.5, 4.5)]);
    assert!((1..4).all(|n| lower.contains(&(n, n)) && !lower.contains(&(n, 0)) && !lower.contains(&(4, n))));
    let upper = covered([(0.5, 0.5), (4.5, 4.5), (0.5, 4.5)]);
    assert!((1..4).all(|n| upper.contains(&(0, n)) && upper.contains(&(n, 4)) && !upper.contains(&(n, n))));
}
