//! Which of several triangles is seen at a pixel, in `f64`.

use common::Vec3;

use crate::coverage::Triangle;

/// What is seen at a pixel's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// The number of the triangle.
    pub triangle: usize,
    /// Its depth there; larger is nearer.
    pub depth: f64,
    /// How far behind it the next one is; ∞ if there is none.
    pub gap: f64,
}

/// The nearest of the triangles at the pixel (x, y), the first of equals. Corners are x and y in px, which are
/// rounded to 1/256 px as lesson 3 specifies, and z the depth. What has a corner that is not finite is not seen.
#[must_use]
pub fn nearest(triangles: &[[Vec3; 3]], x: i32, y: i32) -> Option<Seen> {
    let depths = triangles.iter().enumerate().filter_map(|(n, corners)| Some((n, depth_at(corners, x, y)?)));
    let mut depths: Vec<(usize, f64)> = depths.collect();
    // A stable sort: equals stay in the order in which they came.
    depths.sort_by(|a, b| b.1.total_cmp(&a.1));
    let &(triangle, depth) = depths.first()?;
    let gap = depths.get(1).map_or(f64::INFINITY, |next| depth - next.1);
    Some(Seen { triangle, depth, gap })
}

/// The depth of a triangle's plane at a pixel's centre that it covers.
pub(crate) fn depth_at(corners: &[Vec3; 3], x: i32, y: i32) -> Option<f64> {
    if !corners.iter().all(|corner| corner.is_finite()) {
        return None;
    }
    let flat = Triangle::new(corners.map(Vec3::truncate));
    let weights = flat.covers(x, y).then(|| flat.weights(x, y))?;
    let [a, b, c] = corners.map(|corner| f64::from(corner.z));
    // Measured from one of the corners, a level triangle has its depth to the last bit.
    Some(a + weights[1] * (b - a) + weights[2] * (c - a))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(depth: f32) -> [Vec3; 3] {
        [(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)].map(|(x, y)| Vec3::new(x, y, depth))
    }

    #[test]
    fn the_nearest_is_seen_and_the_first_of_equals() {
        let seen = nearest(&[square(0.0), square(2.0), square(2.0), square(f32::INFINITY)], 1, 1);
        assert_eq!(seen, Some(Seen { triangle: 1, depth: 2.0, gap: 0.0 }));
        assert_eq!(nearest(&[square(0.5)], 1, 1).unwrap().gap, f64::INFINITY);
        assert_eq!(nearest(&[square(0.5)], 8, 8), None);
        assert_eq!(nearest(&[square(f32::NAN)], 1, 1), None);
    }
}
