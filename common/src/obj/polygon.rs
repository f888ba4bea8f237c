//! Cuts a face of any number of corners into triangles.

use earcut::Earcut;
use glam::{DVec2, DVec3};

/// The most corners of a face in which the fan of the first corner does not cover just the face. Cutting ears
/// looks up neighbours on a grid, which takes a time in proportion to the corners for most shapes, and for the
/// worst of them in proportion to their square.
pub(crate) const CORNER_LIMIT: usize = 1 << 12;

/// How far a triangle of the fan may turn the wrong way and count as flat, as a share of the face: about what
/// decimal places leave of corners on one line.
const FLAT: f64 = 1e-9;

/// What cutting needs, kept from face to face.
pub(crate) struct Cutter {
    ears: Earcut<f64>,
    outline: Vec<[f64; 2]>,
    indices: Vec<u32>,
}

/// A face that cannot be cut: it is not covered by the fan of its first corner, and has too many corners.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct TooManyCorners;

impl Cutter {
    /// With nothing in it.
    pub(crate) fn new() -> Self {
        Self { ears: Earcut::new(), outline: Vec::new(), indices: Vec::new() }
    }

    /// Calls `triangle` with the corners' numbers for each triangle of a face of at least three corners.
    ///
    /// The face is seen in its own plane: along the normal that M. E. Newell's sum gives (I. E. Sutherland,
    /// R. F. Sproull, R. A. Schumacker, *A characterization of ten hidden-surface algorithms*, Computing Surveys
    /// 6(1), 1974), or rather along the axis nearest to it, which changes no inside. Where the triangles between
    /// the first corner and each side all turn as the face does, they are taken: so for every convex face.
    /// Elsewhere ears are cut off. All triangles turn as the face does. A face that crosses itself has no inside;
    /// it gives some triangles between its corners. One without area gives the fan.
    pub(crate) fn cut(
        &mut self,
        corners: &[DVec3],
        mut triangle: impl FnMut([u32; 3]),
    ) -> Result<(), TooManyCorners> {
        let count = corners.len() as u32;
        let fan = (2..count).map(|n| [0, n - 1, n]);
        let normal = normal(corners);
        if is_fan(corners, normal) {
            fan.for_each(triangle);
            return Ok(());
        }
        if corners.len() > CORNER_LIMIT {
            return Err(TooManyCorners);
        }
        let flat = flatten(normal);
        self.outline.clear();
        self.outline.extend(corners.iter().map(|&corner| flat(corner - corners[0]).to_array()));
        self.ears.earcut(self.outline.iter().copied(), &[], &mut self.indices);
        if self.indices.is_empty() {
            fan.for_each(triangle);
            return Ok(());
        }
        for &[a, b, c] in self.indices.as_chunks().0 {
            let [p, q, r] = [a, b, c].map(|i| DVec2::from_array(self.outline[i as usize]));
            triangle(if (q - p).perp_dot(r - p) < 0.0 { [a, c, b] } else { [a, b, c] });
        }
        Ok(())
    }
}

/// The normal of a face, as long as twice its area; 0 where it has none.
fn normal(corners: &[DVec3]) -> DVec3 {
    // From the first corner on, so that a face far away loses no digits.
    let sides = corners[1..].windows(2).map(|pair| (pair[0] - corners[0]).cross(pair[1] - corners[0]));
    sides.fold(DVec3::ZERO, |sum, cross| sum + cross)
}

/// Whether no triangle of the fan of the first corner turns against the face.
fn is_fan(corners: &[DVec3], normal: DVec3) -> bool {
    let limit = -FLAT * normal.length_squared();
    let turns = corners[1..].windows(2).map(|pair| (pair[0] - corners[0]).cross(pair[1] - corners[0]));
    turns.map(|cross| cross.dot(normal)).all(|turn| turn >= limit)
}

/// The map that drops the coordinate in which a normal is largest: what turns counterclockwise around the normal
/// does so afterwards.
fn flatten(normal: DVec3) -> impl Fn(DVec3) -> DVec2 {
    let axis = normal.abs().max_position();
    let positive = normal[axis] > 0.0;
    move |point| {
        let flat = DVec2::new(point[(axis + 1) % 3], point[(axis + 2) % 3]);
        if positive { flat } else { DVec2::new(flat.y, flat.x) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(outline: &[[f64; 3]]) -> Vec<[u32; 3]> {
        let corners: Vec<DVec3> = outline.iter().copied().map(DVec3::from).collect();
        let mut triangles = Vec::new();
        Cutter::new().cut(&corners, |triangle| triangles.push(triangle)).unwrap();
        triangles
    }

    #[test]
    fn a_convex_face_is_a_fan() {
        assert_eq!(cut(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), [[0, 1, 2]]);
        // Also one whose corners are not quite in a plane, or on one line.
        let square = [[0.0; 3], [1.0, 0.0, 0.1], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(cut(&square), [[0, 1, 2], [0, 2, 3]]);
        let middle = [[0.0; 3], [0.1, 0.0, 0.3], [0.2, 0.0, 0.6], [0.0, 1.0, 0.0]];
        assert_eq!(cut(&middle), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(cut(&[[1.0; 3]; 5]), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    }

    /// The fan of a dart's first corner would cover what is outside. Along each axis, from both sides, small and large,
    /// near and so far away that the last bit of a coordinate counts.
    #[test]
    fn a_dart_is_cut_at_its_notch() {
        const DART: [[f64; 2]; 4] = [[-1.0, 0.0], [0.0, -1.0], [1.0, 1.0], [0.0, 0.0]];
        const NOTCH: u32 = 3;
        for (axis, size, far, turned, first) in cases() {
            let mut corners = DART.map(|[x, y]| {
                let mut corner = far;
                corner[(axis + 1) % 3] += size * x;
                corner[(axis + 2) % 3] += size * y;
                corner
            });
            let mut notch = NOTCH;
            if turned {
                corners.reverse();
                notch = 3 - notch;
            }
            corners.rotate_left(first);
            notch = (notch + 4 - first as u32) % 4;
            let triangles = cut(&corners.map(|corner| corner.to_array()));
            let case = format!("axis {axis}, {size} at {far}, turned: {turned}, from {first}: {triangles:?}");
            assert_eq!(triangles.len(), 2, "{case}");
            for triangle in triangles {
                assert!(triangle.contains(&notch), "{case}");
                let [a, b, c] = triangle.map(|n| corners[n as usize]);
                assert!((b - a).cross(c - a)[axis] * if turned { -1.0 } else { 1.0 } > 0.0, "{case}");
            }
        }
    }

    /// Axis, size, place, way round and first corner of a dart.
    fn cases() -> impl Iterator<Item = (usize, f64, DVec3, bool, usize)> {
        let far = 2f64.powi(52);
        let places = [
            (1.0, DVec3::ZERO),
            (1e-4, DVec3::new(-3.0, 7.0, -5.0)),
            (1e6, DVec3::new(3.0, -7.0, 5.0)),
            (1.0, DVec3::new(-far, far, -far)),
            (1.0, DVec3::new(far, -far, far)),
        ];
        (0..3).flat_map(move |axis| {
            places.into_iter().flat_map(move |(size, place)| {
                [false, true]
                    .into_iter()
                    .flat_map(move |turned| (0..4).map(move |first| (axis, size, place, turned, first)))
            })
        })
    }

    /// Of such a face, the ears may be cut off the wrong way round: here, between the corners 3, 4 and 6.
    #[test]
    fn triangles_of_a_face_that_crosses_itself_turn_as_it_does() {
        let outline: [[i8; 2]; 9] = [[3, 2], [7, 1], [7, 3], [3, 0], [3, 7], [1, 5], [4, 0], [6, 2], [0, 1]];
        let corners = outline.map(|[x, y]| DVec3::new(x.into(), y.into(), 0.0));
        let normal = normal(&corners);
        let triangles = cut(&corners.map(|corner| corner.to_array()));
        assert!(
            triangles.iter().any(|triangle| [3, 4, 6].iter().all(|n| triangle.contains(n))),
            "{triangles:?}"
        );
        for triangle in triangles {
            let [a, b, c] = triangle.map(|n| corners[n as usize]);
            assert!((b - a).cross(c - a).dot(normal) >= 0.0, "{triangle:?}");
        }
    }

    #[test]
    fn there_may_be_millions_of_corners_around_what_is_convex_and_not_elsewhere() {
        let circle = |n: usize, radius: &dyn Fn(usize) -> f64| {
            let at = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
            (0..n).map(|i| DVec3::new(at(i).cos(), at(i).sin(), 0.0) * radius(i)).collect::<Vec<_>>()
        };
        let mut count = 0;
        let round = circle(1_000_000, &|_| 1.0);
        assert_eq!(Cutter::new().cut(&round, |_| count += 1), Ok(()));
        assert_eq!(count, 999_998);
        let jagged = |n| circle(n, &|i| 1.0 + (i % 2) as f64);
        count = 0;
        assert_eq!(Cutter::new().cut(&jagged(CORNER_LIMIT), |_| count += 1), Ok(()));
        assert_eq!(count, CORNER_LIMIT - 2);
        assert_eq!(Cutter::new().cut(&jagged(CORNER_LIMIT + 2), |_| ()), Err(TooManyCorners));
    }
}
