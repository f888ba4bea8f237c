//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.

use common::{Mat4, Vec2, Vec3, Vec4};
use perspective::{frustum, perspective, perspective_weights, window};

/// z/w of a point of the axis.
fn depth(m: Mat4, distance: f32) -> f32 {
    let p = m * Vec4::new(0.0, 0.0, -distance, 1.0);
    p.z / p.w
}

#[test]
fn a_point_at_two_between_one_and_five() {
    let m = frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 5.0).unwrap();
    assert_eq!((m.z_axis.z, m.w_axis.z), (-1.5, -2.5));
    assert_eq!(depth(m, 2.0), 0.25);
    let clip = m * Vec4::new(0.0, 0.0, -2.0, 1.0);
    assert_eq!(clip.z, 0.5);
    // As by Vulkan's range: (5/4 · 2 − 5/4) / 2.
    let at = window(clip, Vec2::splat(100.0)).unwrap();
    assert_eq!((at.z, at.w), (0.625, 0.5));
}

#[test]
fn half_of_all_depths_lie_before_twice_the_near_plane() {
    let m = frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0).unwrap();
    let in_window = depth(m, 2.0) / 2.0 + 0.5;
    assert!((in_window - 10.0 / 18.0).abs() < 1e-6, "{in_window}");
}

#[test]
fn twice_the_planes_is_twice_the_size() {
    let [near, far] = [1.0, 2.0].map(|n| frustum(-1.0, 1.0, -1.0, 1.0, n, 5.0 * n).unwrap());
    assert_eq!(far.x_axis.x, 2.0 * near.x_axis.x);
    let square = perspective(90.0, 1.0, 1.0, 5.0).unwrap();
    assert!((square.x_axis.x - 1.0).abs() < 1e-6 && (square.y_axis.y - 1.0).abs() < 1e-6);
}

#[test]
fn limits() {
    let far = frustum(-1.0, 1.0, -1.0, 1.0, 2.0, f32::INFINITY).unwrap();
    assert_eq!((far.z_axis.z, far.w_axis.z), (-1.0, -4.0));
    assert!(frustum(-1.0, 1.0, -1.0, 1.0, 0.0, 5.0).is_err());
    let near = perspective(90.0, 1.0, 0.0, 5.0).unwrap();
    assert_eq!((near.z_axis.z, near.w_axis.z, near.determinant()), (-1.0, 0.0, 0.0));
    assert_eq!(depth(near, 3.0), 1.0);
}

#[test]
fn weights_in_perspective() {
    let weights = perspective_weights(Vec3::splat(1.0 / 3.0), Vec3::new(1.0, 0.5, 0.25));
    assert!(weights.distance(Vec3::new(4.0, 2.0, 1.0) / 7.0) < 1e-6, "{weights}");
    assert!((weights.dot(Vec3::new(1.0, 2.0, 4.0)) - 12.0 / 7.0).abs() < 1e-6);
    let halfway = perspective_weights(Vec3::new(0.5, 0.5, 0.0), Vec3::new(1.0, 1.0 / 3.0, 1.0));
    assert!(halfway.distance(Vec3::new(0.75, 0.25, 0.0)) < 1e-6, "{halfway}");
}

/// The trick's constant for c = 5 − √24, its error, and what steps make of it.
#[test]
fn five_percent_and_its_squares() {
    let c = 5.0 - 24f64.sqrt();
    let constant = ((254.0 - c) * f64::from(1 << 23)).round();
    assert!((constant - f64::from(perspective::division::MAGIC)).abs() < 8.0, "{constant}");
    let worst = |name: &str| {
        let one = perspective::DIVISIONS.iter().find(|row| row.name == name).unwrap().run.one;
        let numbers = (0..4000).map(|n| 1.0 + n as f32 / 4000.0);
        numbers.map(|x| (f64::from(x) * f64::from(one(x)) - 1.0).abs()).fold(0.0, f64::max)
    };
    let all = ["fast-0", "fast-1", "fast-2"].map(worst);
    for (got, expected) in all.into_iter().zip([0.0505, 0.00255, 6.5e-6]) {
        assert!((got / expected - 1.0).abs() < 0.05, "{got}, not {expected}");
    }
}
