//! What is in the picture, and how large, told by spheres.
//!
//! A camera's matrix has all that is to be known. A point p of the world is inside of a plane of clip space where the product of
//! plane and M·p is not negative; that is the product of Mᵀ·plane and p, so the rows of M make the six planes of the frustum in
//! the world, whatever the projection (G. Gribb and K. Hartmann, *Fast extraction of viewing frustum planes from the
//! world-view-projection matrix*, 2001). Orthographic or in perspective, near and far, even a far plane at infinity, are no
//! special cases.

use clipping::plane::PLANES;
use common::{DVec3, DVec4, Mat4, Vec2, Vec3};

/// A sphere in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its middle.
    pub center: Vec3,
    /// Its radius, not negative.
    pub radius: f32,
}

/// What rounding may do to a vertex on its way to clip space, relative to the largest numbers on it: matrix times matrix times
/// vector is four products and three sums twice over, of which each is off by 2⁻²⁴ at most; twice that, to be safe.
pub(crate) const ROUNDING: f32 = 16.0 * f32::EPSILON / 2.0;

/// Whether some of a sphere may be in the picture: no vertex in it, however it is rounded, is drawn where this is false. The
/// reverse does not hold: beside an edge of the frustum a sphere may be outside of it and yet of none of its planes.
///
/// The distance of a point from a plane (n, d) is (n·p + d)/|n|, and |n| is not divided by, since it is 0 for a far plane at
/// infinity.
// ANCHOR: sees
#[must_use]
pub fn sees(to_clip: &Mat4, sphere: &Sphere) -> bool {
    let Sphere { center, radius } = sphere;
    let (center, radius) = (center.as_dvec3(), f64::from(*radius));
    let rows = to_clip.transpose().as_dmat4();
    // The largest numbers that may be added up for a vertex in it.
    let (sizes, largest) = (rows.abs(), (center.abs() + radius).extend(1.0));
    !PLANES.iter().map(|plane| plane.as_dvec4()).any(|plane| {
        let inwards = rows * plane;
        let rounding = f64::from(ROUNDING) * (sizes * plane.abs()).dot(largest);
        // Of numbers that are none this is false, and they are seen.
        inwards.dot(center.extend(1.0)) < -radius * inwards.truncate().length() - rounding
    })
}
// ANCHOR_END: sees

/// At most so many pixels is a unit of the world within that sphere, wherever in a picture of that size; infinite where the
/// sphere reaches the depth of the eye.
///
/// **Derivation.** Let x, y and w be the matrix's rows, so that a point p is at (u, v) = (x·p/w·p, y·p/w·p) from −1 to 1. By the
/// quotient rule a small step dp moves (u, v) by ((x − u·w)·dp, (y − v·w)·dp)/(w·p), and the window is size/2 as large: the step is
/// magnified by at most the spectral norm of that 2×3 matrix. Its numerator is linear in u and v, and the norm of what is linear
/// is convex: it is largest in a corner of the picture, where u and v are ±1. The denominator is least where the sphere is nearest. So
/// the bound holds for each step in the sphere and in the picture, and for each way between two points there, since both are
/// convex.
///
/// The norm of a matrix with the rows a and b is the root of the larger eigenvalue of ((a·a, a·b), (a·b, b·b)), and that is
/// (a·a + b·b)/2 + √(((a·a − b·b)/2)² + (a·b)²).
// ANCHOR: pixels_per_unit
#[must_use]
pub fn pixels_per_unit(to_clip: &Mat4, sphere: &Sphere, size: Vec2) -> f32 {
    let [x, y, w] = [0, 1, 3].map(|row| to_clip.row(row).as_dvec4());
    let nearest =
        w.dot(sphere.center.as_dvec3().extend(1.0)) - f64::from(sphere.radius) * w.truncate().length();
    if nearest <= 0.0 || nearest.is_nan() {
        return f32::INFINITY;
    }
    let [x, y, w] = [x, y, w].map(DVec4::truncate);
    let half = size.as_dvec2() / 2.0;
    let corners = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
    let norms = corners.map(|[u, v]| spectral_norm([(x - w * u) * half.x, (y - w * v) * half.y]));
    ((norms.into_iter().fold(0.0, f64::max) / nearest) as f32).next_up()
}

/// The largest length of what a matrix with these two rows makes of a vector of length 1.
fn spectral_norm([a, b]: [DVec3; 2]) -> f64 {
    let [aa, ab, bb] = [a.dot(a), a.dot(b), b.dot(b)];
    ((aa + bb) / 2.0 + ((aa - bb) / 2.0).hypot(ab)).sqrt()
}
// ANCHOR_END: pixels_per_unit

#[cfg(test)]
mod tests {
    use super::*;
    use perspective::perspective;

    fn ball(x: f32, y: f32, z: f32, radius: f32) -> Sphere {
        Sphere { center: Vec3::new(x, y, z), radius }
    }

    /// In a view of 90 degrees the left plane is x = z: (−3, 0, −1) is √2 outside of it, (−2, 0, −1) half of that.
    #[test]
    fn a_ball_beside_the_left_plane() {
        let to_clip = perspective(90.0, 1.0, 0.1, 100.0).unwrap();
        assert!(!sees(&to_clip, &ball(-3.0, 0.0, -1.0, 1.0)));
        assert!(sees(&to_clip, &ball(-3.0, 0.0, -1.0, 1.42)));
        assert!(sees(&to_clip, &ball(-2.0, 0.0, -1.0, 1.0)));
    }

    /// 45 degrees, 1024 × 768: 384 · cot 22.5° = 927 px to the side a unit away, and √(927² + 512² + 384²) in the corner.
    #[test]
    fn a_unit_in_pixels() {
        let to_clip = perspective(45.0, 4.0 / 3.0, 0.1, 100.0).unwrap();
        let size = Vec2::new(1024.0, 768.0);
        let bound = pixels_per_unit(&to_clip, &ball(0.0, 0.0, -11.0, 1.0), size);
        assert!((bound - 112.652).abs() < 0.001, "{bound}");
        assert_eq!(pixels_per_unit(&to_clip, &ball(0.0, 0.0, -1.0, 1.0), size), f32::INFINITY);
    }
}
