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
fn a_viewport_with_a_border() {
    let at = place(&viewport(200.0, 100.0, 0.4), Vec3::new(-1.0, 1.0, 0.0)).unwrap();
    assert!(at.truncate().distance(Vec2::new(20.0, 90.0)) < 1e-4, "{at}");
}
