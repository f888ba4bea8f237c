//! The numbers of the chapter's worked example and of its quiz, computed by the lesson's own code.

use common::Vec3;
use triangles::flat_intensity;

#[test]
fn a_triangle_that_leans_back() {
    let [a, b, c] = [Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 2.0, 2.0)];
    let half = std::f32::consts::FRAC_1_SQRT_2;
    assert!((flat_intensity([a, b, c], Vec3::Z) - half).abs() < 1e-6);
    assert!((flat_intensity([a, c, b], Vec3::Z) + half).abs() < 1e-6);
}
