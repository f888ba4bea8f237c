//! Turning about an axis, and how far a matrix is from it, in `f64`.

use common::{DVec3, Mat3};

/// A vector turned about an axis by an angle in radians, counterclockwise seen from the axis's tip.
///
/// The part along the axis stays; the part across it turns in its plane.
#[must_use]
pub fn turned(v: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let axis = axis.normalize();
    let along = axis * axis.dot(v);
    let across = v - along;
    along + across * angle.cos() + axis.cross(across) * angle.sin()
}

/// The largest distance between where a matrix takes the three unit vectors and where the rotation does.
#[must_use]
pub fn error(got: &Mat3, axis: DVec3, angle: f64) -> f64 {
    let off = |unit: DVec3, column: DVec3| (column - turned(unit, axis, angle)).length();
    let [x, y, z] = [got.x_axis, got.y_axis, got.z_axis].map(common::Vec3::as_dvec3);
    [off(DVec3::X, x), off(DVec3::Y, y), off(DVec3::Z, z)].into_iter().fold(0.0, f64::max)
}

/// By how much the columns of a matrix are not of length 1 or not at right angles: the largest difference of a
/// product of two of them from 1 or 0.
#[must_use]
pub fn skew(got: &Mat3) -> f64 {
    let columns = [got.x_axis, got.y_axis, got.z_axis].map(common::Vec3::as_dvec3);
    let pairs = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    pairs
        .map(|(i, j)| (columns[i].dot(columns[j]) - if i == j { 1.0 } else { 0.0 }).abs())
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn a_quarter_turn_is_counterclockwise() {
        assert!((turned(DVec3::X, DVec3::Z * 3.0, FRAC_PI_2) - DVec3::Y).length() < 1e-15);
        assert!((turned(DVec3::Z, DVec3::Z, 1.0) - DVec3::Z).length() < 1e-15);
        assert_eq!((error(&Mat3::IDENTITY, DVec3::Y, 0.0), skew(&Mat3::IDENTITY)), (0.0, 0.0));
        assert!((skew(&(Mat3::IDENTITY * 2.0)) - 3.0).abs() < 1e-12);
    }
}
