//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.

use common::{Vec2, Vec3};
use transforms::{place, projection, viewport};

#[test]
fn points_seen_from_four() {
    let m = projection(4.0);
    assert_eq!(place(&m, Vec3::new(1.0, 2.0, 2.0)), Some(Vec3::new(2.0, 4.0, 4.0)));
    assert_eq!(place(&m, Vec3::new(1.0, 2.0, -4.0)), Some(Vec3::new(0.5, 1.0, -2.0)));
    assert_eq!(place(&m, Vec3::new(1.0, 2.0, 6.0)), None);
}

#[test]
fn products_of_the_plane() {
    use glam::Mat2;
    let (quarter, shear) =
        (Mat2::from_angle(std::f32::consts::FRAC_PI_2), Mat2::from_cols_array(&[1.0, 0.0, 1.0 / 3.0, 1.0]));
    let point = Vec2::new(2.0, 1.0);
    for (matrix, expected) in [
        (Mat2::from_diagonal(Vec2::splat(1.5)), (3.0, 1.5)),
        (shear, (7.0 / 3.0, 1.0)),
        (quarter, (-1.0, 2.0)),
        (quarter * shear, (-1.0, 7.0 / 3.0)),
        (shear * quarter, (-1.0 / 3.0, 2.0)),
    ] {
        assert!((matrix * point).distance(expected.into()) < 1e-6, "{matrix}: {}", matrix * point);
    }
    // The quiz: a move by 3 along x after and before the quarter turn.
    let by = Vec2::new(3.0, 0.0);
    assert!((quarter * Vec2::X + by).distance(Vec2::new(3.0, 1.0)) < 1e-6);
    assert!((quarter * (Vec2::X + by)).distance(Vec2::new(0.0, 4.0)) < 1e-6);
    // The products as they are written out.
    let (k, a) = (0.7_f32, 0.4_f32);
    let (r, h) = (Mat2::from_angle(a), Mat2::from_cols_array(&[1.0, 0.0, k, 1.0]));
    let (s, c) = a.sin_cos();
    let rows = |[a, b, c, d]: [f32; 4]| Mat2::from_cols_array(&[a, c, b, d]);
    assert!((r * h).abs_diff_eq(rows([c, k * c - s, s, k * s + c]), 1e-6));
    assert!((h * r).abs_diff_eq(rows([c + k * s, k * c - s, s, c]), 1e-6));
}

#[test]
fn a_point_on_its_way_to_infinity() {
    for (w, expected) in [(1.0, (3.0, 2.0)), (0.5, (6.0, 4.0)), (0.25, (12.0, 8.0)), (0.01, (300.0, 200.0))] {
        assert!((Vec2::new(3.0, 2.0) / w).distance(expected.into()) < 1e-4);
    }
}

#[test]
fn the_plane_is_projected_as_space_is() {
    let d = 4.0;
    let of_plane = common::Mat3::from_cols_array(&[1.0, 0.0, 0.0, 0.0, 1.0, -1.0 / d, 0.0, 0.0, 1.0]);
    let point = of_plane * Vec3::new(1.0, 2.0, 1.0);
    let in_space = place(&projection(d), Vec3::new(1.0, 0.0, 2.0)).unwrap();
    assert_eq!(Vec2::new(point.x, point.y) / point.z, Vec2::new(in_space.x, in_space.z));
}

#[test]
fn a_viewport_with_a_border() {
    let at = place(&viewport(200.0, 100.0, 0.4), Vec3::new(-1.0, 1.0, 0.0)).unwrap();
    assert!(at.truncate().distance(Vec2::new(20.0, 90.0)) < 1e-4, "{at}");
}
