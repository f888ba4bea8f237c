//! How far apart two surfaces of triangles are, in `f64`.
//!
//! The distance of a surface from another is that of its farthest point (Hausdorff's). A distance changes by no more than the way
//! that one goes: from the distance of a triangle's middle no point of it is farther off than its corners are away. So triangles
//! are cut into four as long as that could be more than what was found, but for a tolerance. What is found is a lower bound, and
//! with the tolerance added an upper one.

use common::DVec3;

/// Triangles, sorted into the cells of a grid that their boxes meet.
pub struct Surface {
    triangles: Vec<[DVec3; 3]>,
    low: DVec3,
    side: f64,
    counts: [i32; 3],
    cells: Vec<Vec<u32>>,
}

impl Surface {
    /// Of triangles.
    ///
    /// # Panics
    /// Where there are none, or all are in one point.
    #[must_use]
    pub fn new(triangles: Vec<[DVec3; 3]>) -> Self {
        let corners = || triangles.as_flattened().iter().copied();
        let low = corners().reduce(DVec3::min).expect("a surface has triangles");
        let high = corners().reduce(DVec3::max).expect("a surface has triangles");
        // On a surface so many cells meet about one triangle each.
        let side = (high - low).max_element() / (triangles.len() as f64).sqrt();
        assert!(side > 0.0, "the surface is a point");
        let counts = ((high - low) / side).to_array().map(|count| count as i32 + 1);
        let cells = vec![Vec::new(); counts.iter().product::<i32>() as usize];
        let mut surface = Self { low, side, counts, cells, triangles };
        for n in 0..surface.triangles.len() {
            let [a, b, c] = surface.triangles[n];
            let [first, last] = [a.min(b).min(c), a.max(b).max(c)].map(|corner| surface.cell(corner));
            for cell in boxed(first, last) {
                let at = surface.index(cell);
                surface.cells[at].push(n as u32);
            }
        }
        surface
    }

    /// The cell of a point; the nearest of those that there are.
    fn cell(&self, p: DVec3) -> [i32; 3] {
        let place = ((p - self.low) / self.side).to_array();
        std::array::from_fn(|axis| (place[axis] as i32).clamp(0, self.counts[axis] - 1))
    }

    fn index(&self, [x, y, z]: [i32; 3]) -> usize {
        ((z * self.counts[1] + y) * self.counts[0] + x) as usize
    }

    /// The distance of a point from the nearest triangle.
    #[must_use]
    pub fn distance(&self, p: DVec3) -> f64 {
        self.distance_beyond(p, 0.0)
    }

    /// The same, or anything that is not more than `enough`, where the distance is not more than that.
    fn distance_beyond(&self, p: DVec3, enough: f64) -> f64 {
        let middle = self.cell(p);
        let mut nearest = f64::INFINITY;
        for ring in 0..=self.counts.into_iter().max().unwrap_or(0) {
            // What is in no cell of the rings before is at least so far away.
            if nearest <= f64::from(ring - 1) * self.side {
                break;
            }
            let first = middle.map(|place| (place - ring).max(0));
            let last = std::array::from_fn(|axis| (middle[axis] + ring).min(self.counts[axis] - 1));
            let in_ring = |cell: &[i32; 3]| (0..3).any(|axis| (cell[axis] - middle[axis]).abs() == ring);
            for cell in boxed(first, last).filter(in_ring) {
                for &n in &self.cells[self.index(cell)] {
                    nearest = nearest.min(from_triangle(p, self.triangles[n as usize]));
                    if nearest <= enough {
                        return nearest;
                    }
                }
            }
        }
        nearest
    }

    /// The distance of the farthest of another surface's points from this one: so much at least, and at most the tolerance more.
    #[must_use]
    pub fn farthest(&self, other: &Self, tolerance: f64) -> f64 {
        let farther = |farthest: f64, &corner: &DVec3| farthest.max(self.distance_beyond(corner, farthest));
        let farthest = other.triangles.as_flattened().iter().fold(0.0, farther);
        other
            .triangles
            .iter()
            .fold(farthest, |farthest, &triangle| self.within(triangle, farthest, tolerance))
    }

    /// The same of a triangle's points, where one as far as this has been found.
    fn within(&self, [a, b, c]: [DVec3; 3], farthest: f64, tolerance: f64) -> f64 {
        let middle = (a + b + c) / 3.0;
        let reach = middle.distance(a).max(middle.distance(b)).max(middle.distance(c));
        let distance = self.distance_beyond(middle, farthest + tolerance - reach);
        if distance + reach <= farthest + tolerance {
            return farthest;
        }
        let [ab, bc, ca] = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        let parts = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
        parts
            .into_iter()
            .fold(farthest.max(distance), |farthest, part| self.within(part, farthest, tolerance))
    }
}

/// The whole-numbered points of a box, its last ones included.
fn boxed(first: [i32; 3], last: [i32; 3]) -> impl Iterator<Item = [i32; 3]> {
    let rows = (first[2]..=last[2]).flat_map(move |z| (first[1]..=last[1]).map(move |y| [y, z]));
    rows.flat_map(move |[y, z]| (first[0]..=last[0]).map(move |x| [x, y, z]))
}

/// The distance of a point from a triangle: that from its plane where the foot is in the triangle, else from the nearest side.
#[must_use]
pub fn from_triangle(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let sides = [[a, b], [b, c], [c, a]];
    if normal.length_squared() > 0.0
        && sides.iter().all(|[from, to]| (to - from).cross(p - from).dot(normal) >= 0.0)
    {
        return ((p - a).dot(normal) / normal.length()).abs();
    }
    sides.map(|[from, to]| from_segment(p, from, to)).into_iter().fold(f64::INFINITY, f64::min)
}

fn from_segment(p: DVec3, from: DVec3, to: DVec3) -> f64 {
    let along = to - from;
    let share = (p - from).dot(along) / along.length_squared();
    // Of a segment without length it is NaN.
    p.distance(from + along * if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) })
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(0.0, 3.0, 0.0)];

    #[test]
    fn a_point_is_nearest_to_the_inside_a_side_or_a_corner() {
        for (p, expected) in [
            ([1.0, 1.0, -2.0], 2.0),
            ([2.0, -3.0, 4.0], 5.0),
            ([-3.0, -4.0, 0.0], 5.0),
            ([7.0, 0.0, 4.0], 5.0),
            ([2.0, 1.5, 1.0], 1.0),
            // The longest side is 12/5 from the right angle.
            ([4.0, 3.0, 0.0], 2.4),
        ] {
            let distance = from_triangle(p.into(), TRIANGLE);
            assert!((distance - expected).abs() < 1e-12, "{p:?}: {distance}");
        }
        assert_eq!(from_triangle(DVec3::Z, [DVec3::ZERO; 3]), 1.0);
    }

    /// The grid finds what a look at every triangle finds, from inside and from outside.
    #[test]
    fn the_grid_leaves_out_nothing() {
        let point = |n: u32| {
            let n = f64::from(n);
            DVec3::new((n * 0.618).fract(), (n * 0.414).fract(), (n * 0.732).fract())
        };
        let triangles: Vec<_> =
            (0..60).map(|n| [point(n), point(n) + point(n + 7) * 0.2, point(n + 1) * 0.9]).collect();
        let surface = Surface::new(triangles.clone());
        for n in 0..500 {
            let p = point(3 * n) * 4.0 - 1.5;
            let all =
                triangles.iter().map(|&triangle| from_triangle(p, triangle)).fold(f64::INFINITY, f64::min);
            assert_eq!(surface.distance(p), all, "{p}");
        }
    }

    /// Between two squares, one bent up by 1 in its middle: not the same either way.
    #[test]
    fn the_farthest_point_is_found_wherever_it_is() {
        let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        let [a, b, c, d] = [at(0.0, 0.0, 0.0), at(2.0, 0.0, 0.0), at(2.0, 2.0, 0.0), at(0.0, 2.0, 0.0)];
        let flat = Surface::new(vec![[a, b, c], [a, c, d]]);
        let top = at(1.0, 1.0, 1.0);
        let bent = Surface::new(vec![[a, b, top], [b, c, top], [c, d, top], [d, a, top]]);
        for tolerance in [0.5, 0.1, 1e-3] {
            assert_eq!(flat.farthest(&bent, tolerance), 1.0, "a corner");
            // The point under the top, which is no corner, is 1/√2 from the four planes.
            let found = bent.farthest(&flat, tolerance);
            assert!(
                found <= 0.5_f64.sqrt() + 1e-12 && found + tolerance >= 0.5_f64.sqrt(),
                "{tolerance}: {found}"
            );
        }
        assert_eq!(flat.farthest(&flat, 0.01), 0.0);
    }
}
