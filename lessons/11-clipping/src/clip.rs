//! Cutting a polygon by planes, as I. Sutherland and G. Hodgman do (*Reentrant polygon clipping*, Communications of the
//! ACM 17, 1974), in homogeneous coordinates.

use common::Vec4;
use shaders::shader::Varying;

use crate::plane::distance;

/// A corner in clip space, and what is interpolated from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipVertex<V> {
    /// Where it is, before division by w.
    pub position: Vec4,
    /// What is interpolated.
    pub varying: V,
}

/// How many corners a triangle can have when six planes have cut it.
pub const MOST_CORNERS: usize = 9;

/// A convex polygon in clip space, its corners in order.
///
/// **Nine corners are enough.** A triangle has three, and each of the six planes adds at most one: where it cuts, at least
/// one corner is outside and goes, and the border passes the plane twice, which makes two new ones.
#[derive(Clone, Copy, Debug)]
pub struct Polygon<V> {
    corners: [ClipVertex<V>; MOST_CORNERS],
    count: usize,
}

impl<V: Varying> Polygon<V> {
    /// A polygon of these corners.
    ///
    /// # Panics
    /// Where there is none, or there are more than [`MOST_CORNERS`].
    #[inline]
    #[must_use]
    pub fn new(corners: &[ClipVertex<V>]) -> Self {
        let mut all = [corners[0]; MOST_CORNERS];
        all[..corners.len()].copy_from_slice(corners);
        Self { corners: all, count: corners.len() }
    }

    /// Its corners; none where nothing is left.
    #[inline]
    #[must_use]
    pub fn corners(&self) -> &[ClipVertex<V>] {
        &self.corners[..self.count]
    }

    #[inline]
    fn push(&mut self, corner: ClipVertex<V>) {
        self.corners[self.count] = corner;
        self.count += 1;
    }
}

/// What of a polygon is inside of a plane.
///
/// Each side is responsible for its first corner, and for the cut where it passes the plane; its second corner is the next
/// side's affair, so that none comes twice (notes, *Clipping*, the four cases).
// ANCHOR: clip
#[must_use]
pub fn clip<V: Varying>(polygon: &Polygon<V>, plane: Vec4) -> Polygon<V> {
    let corners = polygon.corners();
    let distances = polygon.corners.map(|corner| distance(plane, corner.position));
    let inside = |i: usize| distances[i] >= 0.0;
    let next = |i: usize| if i + 1 < corners.len() { i + 1 } else { 0 };
    // A convex polygon passes a plane twice or never. One that lies in the plane to within the rounding of its corners may
    // seem to pass it more often: there is nothing to cut.
    if (0..corners.len()).filter(|&i| inside(i) != inside(next(i))).count() > 2 {
        return *polygon;
    }
    let mut result = Polygon { count: 0, ..*polygon };
    for i in 0..corners.len() {
        let j = next(i);
        let cut = || cut([corners[i], corners[j]], [distances[i], distances[j]]);
        match (inside(i), inside(j)) {
            (true, true) => result.push(corners[i]),
            (true, false) => {
                result.push(corners[i]);
                result.push(cut());
            }
            (false, true) => result.push(cut()),
            (false, false) => {}
        }
    }
    result
}
// ANCHOR_END: clip

/// Where a side passes a plane, from the distances of its ends, one of them below 0 and the other not: at the share
/// t = d₀/(d₀ − d₁) of the way, for the position and for all that is interpolated.
///
/// Two triangles at a side walk along it in opposite directions, and must find the same point to the last bit, or a gap
/// would open between them. The two ends' weights, 1 − t = −d₁/(d₀ − d₁) and t, are therefore both computed as a quotient:
/// exchange the ends, and each weight stays with its end; and a sum does not depend on the order of its two terms.
// ANCHOR: cut
#[must_use]
pub fn cut<V: Varying>([a, b]: [ClipVertex<V>; 2], [from, to]: [f64; 2]) -> ClipVertex<V> {
    let (weight_a, weight_b) = (-to / (from - to), from / (from - to));
    let position = a.position.as_dvec4() * weight_a + b.position.as_dvec4() * weight_b;
    let varying = a.varying.times(weight_a as f32).plus(b.varying.times(weight_b as f32));
    ClipVertex { position: position.as_vec4(), varying }
}
// ANCHOR_END: cut

#[cfg(test)]
mod tests {
    use super::*;

    /// x ≥ 0.
    const PLANE: Vec4 = Vec4::X;

    /// A polygon with corners at these x; what is interpolated is x, too.
    fn at<const N: usize>(x: [f32; N]) -> Polygon<f32> {
        let corner = |n: usize| ClipVertex { position: Vec4::new(x[n], n as f32, 0.0, 1.0), varying: x[n] };
        let mut polygon = Polygon { corners: [corner(0); MOST_CORNERS], count: 0 };
        (0..N).for_each(|n| polygon.push(corner(n)));
        polygon
    }

    /// x and y of the corners of what is inside.
    fn left(polygon: &Polygon<f32>) -> Vec<(f32, f32)> {
        let inside = clip(polygon, PLANE);
        assert!(
            inside.corners().iter().all(|corner| corner.varying == corner.position.x),
            "cut with the same t"
        );
        inside.corners().iter().map(|corner| (corner.position.x, corner.position.y)).collect()
    }

    /// The notes' four cases: a side inside, leaving, outside, entering.
    #[test]
    fn each_side_is_responsible_for_its_first_corner_and_its_cut() {
        assert_eq!(left(&at([1.0, 2.0, 3.0])), [(1.0, 0.0), (2.0, 1.0), (3.0, 2.0)]);
        assert_eq!(left(&at([1.0, 3.0, -1.0])), [(1.0, 0.0), (3.0, 1.0), (0.0, 1.75), (0.0, 1.0)]);
        assert_eq!(left(&at([-1.0, 3.0, -1.0])), [(0.0, 0.25), (3.0, 1.0), (0.0, 1.75)]);
        assert_eq!(left(&at([-1.0, -2.0, -3.0])), []);
    }

    /// A corner in the plane is inside: it is not cut off and put back, as two.
    #[test]
    fn a_corner_in_the_plane_is_inside() {
        assert_eq!(left(&at([0.0, 2.0, 3.0])), [(0.0, 0.0), (2.0, 1.0), (3.0, 2.0)]);
        assert_eq!(left(&at([0.0, 0.0, 3.0])), [(0.0, 0.0), (0.0, 1.0), (3.0, 2.0)]);
        assert_eq!(left(&at([0.0, 0.0, 0.0])), [(0.0, 0.0), (0.0, 1.0), (0.0, 2.0)]);
    }

    /// What lies in the plane but for rounding passes it as often as it likes, and is left as it is.
    #[test]
    fn what_seems_to_pass_the_plane_four_times_lies_in_it() {
        let flat = at([1e-7, -1e-7, 1e-7, -1e-7]);
        assert_eq!(left(&flat).len(), 4);
        assert_eq!(left(&flat), [(1e-7, 0.0), (-1e-7, 1.0), (1e-7, 2.0), (-1e-7, 3.0)]);
    }
}
