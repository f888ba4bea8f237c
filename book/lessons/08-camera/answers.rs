//! The numbers of the chapter's worked example and of its quizzes, computed by the lesson's own code.

use camera::{basis, lookat};
use common::Vec3;

#[test]
fn an_eye_five_away() {
    let eye = Vec3::new(3.0, 0.0, 4.0);
    let rows = basis(eye, Vec3::ZERO, Vec3::Y).unwrap().transpose();
    for (row, expected) in [
        (rows.x_axis, Vec3::new(0.8, 0.0, -0.6)),
        (rows.y_axis, Vec3::Y),
        (rows.z_axis, Vec3::new(0.6, 0.0, 0.8)),
    ] {
        assert!(row.distance(expected) < 1e-6, "{row}");
    }
    let seen = |center: Vec3, point: Vec3| lookat(eye, center, Vec3::Y).unwrap().transform_point3(point);
    assert!(seen(Vec3::ZERO, eye).distance(Vec3::Z * 5.0) < 1e-5);
    let center = Vec3::Z * 4.0;
    assert!(seen(center, center).length() < 1e-6 && seen(center, eye).distance(Vec3::Z * 3.0) < 1e-5);
}
