//! A triangle of clip space: which side of it is seen, in whole numbers, and what a ray through a pixel meets, in `f64`.
//!
//! Without their z, the points of clip space are a space of three dimensions with the eye at its origin: what lies on one
//! ray from there is seen at one place (X, Y), and the ray has the direction (X, Y, 1). Sheared by x − Xw and y − Yw, the
//! ray becomes the axis of w, so a triangle seen along it is a triangle of the plane, and the ray meets it where the origin is
//! inside. Nothing is divided by w, and nothing is cut; and since each corner is sheared by itself, one may be 10³⁰ times as
//! far away as another.

use common::{DVec2, DVec3, Vec4};

/// What a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The weights of the corners at that point of the triangle.
    pub weights: DVec3,
    /// z/w there, brought from −1 … 1 to 0 … 1.
    pub depth: f64,
}

/// What the ray through (X, Y) meets of a triangle between near and far; the picture is −1 ≤ X, Y ≤ 1. Nothing where the
/// ray lies in the triangle's plane.
#[must_use]
pub fn hit(corners: [Vec4; 3], [x, y]: [f64; 2]) -> Option<Hit> {
    let [a, b, c] = corners.map(|corner| {
        let [cx, cy, _, cw] = corner.to_array().map(f64::from);
        DVec2::new(cx - x * cw, cy - y * cw)
    });
    // Twice the areas of the three parts into which the origin divides the triangle.
    let parts = DVec3::new(b.perp_dot(c), c.perp_dot(a), a.perp_dot(b));
    let weights = parts / parts.element_sum();
    let mean = |axis: usize| weights.dot(DVec3::from_array(corners.map(|corner| corner[axis].into())));
    let (z, w) = (mean(2), mean(3));
    let seen = w > 0.0 && weights.cmpge(DVec3::ZERO).all() && z.abs() <= w;
    seen.then(|| Hit { weights, depth: 0.5 + 0.5 * z / w })
}

/// The nearest of several triangles on the ray through (X, Y), by its number, and the first of equals.
#[must_use]
pub fn nearest(triangles: &[[Vec4; 3]], at: [f64; 2]) -> Option<(usize, Hit)> {
    let hits = triangles.iter().enumerate().filter_map(|(n, &corners)| Some((n, hit(corners, at)?)));
    hits.min_by(|a, b| a.1.depth.total_cmp(&b.1.depth))
}

/// Which side of a triangle is seen from the origin: 1 where its corners, given in whole numbers, run counterclockwise for
/// someone there who looks along −z, −1 where they run clockwise, 0 where it is seen edge-on. Numbers up to 2³⁹ are safe.
#[must_use]
pub fn side(corners: [[i64; 3]; 3]) -> i32 {
    let [a, b, c] = corners.map(|corner| corner.map(i128::from));
    // The volume between the triangle and the origin, as a sum over all orders of the axes.
    let volume: i128 = [[0, 1, 2], [1, 2, 0], [2, 0, 1]]
        .into_iter()
        .map(|[i, j, k]| a[i] * b[j] * c[k] - a[k] * b[j] * c[i])
        .sum();
    // Seen from inside of the tetrahedron's corner, a positive volume runs clockwise.
    -volume.signum() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wall at depth 2 before the eye, its right half missing.
    const WALL: [Vec4; 3] =
        [Vec4::new(-2.0, -2.0, 1.0, 2.0), Vec4::new(2.0, -2.0, 1.0, 2.0), Vec4::new(-2.0, 2.0, 1.0, 2.0)];

    #[test]
    fn a_ray_meets_a_wall_where_it_is() {
        let met = hit(WALL, [-0.5, -0.25]).unwrap();
        assert!((met.weights - DVec3::new(0.375, 0.25, 0.375)).length() < 1e-12);
        assert_eq!(met.depth, 0.75);
        assert_eq!(hit(WALL, [0.5, 0.25]), None);
        // Behind the eye, before near, and beyond far.
        for [z, w] in [[-1.0, -1.0], [-5.0, 1.0], [5.0, 1.0]] {
            let moved = WALL.map(|corner| corner * Vec4::new(w, w, z, w));
            assert_eq!(hit(moved, [-0.5 * w as f64, -0.25]), None, "{z} {w}");
        }
        let nearer = WALL.map(|corner| corner * Vec4::new(1.0, 1.0, -1.0, 1.0));
        assert_eq!(nearest(&[WALL, nearer, nearer], [-0.5, -0.25]).unwrap().0, 1);
    }

    #[test]
    fn counterclockwise_is_in_front() {
        let wall = [[-1, -1, -2], [1, -1, -2], [-1, 1, -2]];
        assert_eq!(side(wall), 1);
        assert_eq!(side([wall[0], wall[2], wall[1]]), -1);
        assert_eq!(side([wall[0], wall[1], [0, 0, 0]]), 0);
        // Behind the one who looks, the other side is turned to them.
        assert_eq!(side(wall.map(|[x, y, z]| [x, y, -z])), -1);
    }
}
