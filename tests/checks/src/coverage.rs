//! The pixels that a triangle covers, decided in `i128`.
//!
//! Corners are first rounded to 1/256 px, as lesson 3 specifies. A pixel's centre, or any other point of that
//! grid, is inside when a ray from it to the right crosses the sides an odd number of times. The ray starts an
//! infinitely small distance to the right of the point and a yet smaller one below it: this is what the top-left
//! rule means, and no side can pass through such a start.

use common::{Bounds, Vec2};

/// A point in 1/256 px.
type Point = [i128; 2];

/// A triangle with corners rounded to 1/256 px.
#[derive(Clone, Copy, Debug)]
pub struct Triangle(pub(crate) [Point; 3]);

impl Triangle {
    /// Rounds the corners, given in px, to the nearest 1/256 px, a tie to the even one.
    ///
    /// # Panics
    /// Where a corner is not finite.
    #[must_use]
    pub fn new(corners: [Vec2; 3]) -> Self {
        let snap = |coordinate: f32| {
            assert!(coordinate.is_finite());
            (f64::from(coordinate) * 256.0).round_ties_even() as i128
        };
        Self(corners.map(|corner| [snap(corner.x), snap(corner.y)]))
    }

    /// Whether the pixel (x, y) is covered: its centre is inside.
    #[must_use]
    pub fn covers(&self, x: i32, y: i32) -> bool {
        self.contains(center(x, y))
    }

    /// The samples of a pixel that are inside, bit s for sample s. Their places are counted from the pixel's lower
    /// left corner, in 1/16 px.
    #[must_use]
    pub fn samples(&self, x: i32, y: i32, places: &[[i32; 2]]) -> u32 {
        let inside = |&[right, up]: &[i32; 2]| {
            let along = |pixel: i32, part: i32| i128::from(pixel) * 256 + i128::from(part) * 16;
            self.contains([along(x, right), along(y, up)])
        };
        (0..).zip(places).fold(0, |mask, (s, place)| mask | u32::from(inside(place)) << s)
    }

    /// Whether a point, in 1/256 px, is inside.
    #[must_use]
    pub fn contains(&self, [px, py]: [i128; 2]) -> bool {
        let [a, b, c] = self.0;
        let crossings = [[a, b], [b, c], [c, a]].into_iter().filter(|[a, b]| {
            let [low, high] = if a[1] <= b[1] { [a, b] } else { [b, a] };
            // The ray runs just below py: a corner at py is above it.
            let crosses = low[1] < py && high[1] >= py;
            // Where it crosses, x·(high − low) = low.x·(high − low) + (py − low)·(high.x − low.x).
            let rise = high[1] - low[1];
            crosses && low[0] * rise + (py - low[1]) * (high[0] - low[0]) > px * rise
        });
        crossings.count() % 2 == 1
    }

    /// The pixels covered in the bounds, rows from the bottom.
    #[must_use]
    pub fn pixels(&self, bounds: Bounds) -> Vec<(i32, i32)> {
        let all =
            (bounds.min.y..=bounds.max.y).flat_map(|y| (bounds.min.x..=bounds.max.x).map(move |x| (x, y)));
        all.filter(|&(x, y)| self.covers(x, y)).collect()
    }

    /// The weights of the three corners at a pixel's centre: exact, then rounded. NaN without area.
    #[must_use]
    pub fn weights(&self, x: i32, y: i32) -> [f64; 3] {
        self.weights_at(center(x, y))
    }

    /// The weights of the three corners at a point, in 1/256 px: exact, then rounded. NaN without area.
    #[must_use]
    pub fn weights_at(&self, p: [i128; 2]) -> [f64; 3] {
        let [a, b, c] = self.0;
        let whole = doubled_area(a, b, c) as f64;
        [doubled_area(p, b, c), doubled_area(a, p, c), doubled_area(a, b, p)].map(|part| part as f64 / whole)
    }
}

fn center(x: i32, y: i32) -> Point {
    [x, y].map(|n| i128::from(n) * 256 + 128)
}

/// Twice the signed area of a triangle, by the shoelace formula.
fn doubled_area(a: Point, b: Point, c: Point) -> i128 {
    a[0] * b[1] - b[0] * a[1] + b[0] * c[1] - c[0] * b[1] + c[0] * a[1] - a[0] * c[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::IVec2;

    const WINDOW: Bounds = Bounds { min: IVec2::new(-2, -2), max: IVec2::new(6, 6) };

    #[test]
    fn a_centre_on_a_side_belongs_to_the_top_and_to_the_left() {
        // Centres lie on all sides of this square, cut along its diagonal.
        let [a, b, c, d] = [(0.5, 0.5), (3.5, 0.5), (3.5, 3.5), (0.5, 3.5)].map(Vec2::from);
        let mut pixels = Triangle::new([a, b, c]).pixels(WINDOW);
        pixels.extend(Triangle::new([a, c, d]).pixels(WINDOW));
        pixels.sort_unstable();
        let expected: Vec<_> = (0..3).flat_map(|x| (1..4).map(move |y| (x, y))).collect();
        assert_eq!(pixels, expected);
    }

    #[test]
    fn a_sample_on_a_side_belongs_to_the_top_and_to_the_left() {
        // A square of half a pixel, with a sample on each corner, on the middle of each side, and in the middle.
        let places = [[4, 4], [12, 4], [12, 12], [4, 12], [8, 4], [12, 8], [8, 12], [4, 8], [8, 8]];
        let [a, b, c, d] = [(2.25, -0.75), (2.75, -0.75), (2.75, -0.25), (2.25, -0.25)].map(Vec2::from);
        let halves = [[a, b, c], [a, c, d]].map(|corners| Triangle::new(corners).samples(2, -1, &places));
        // The diagonal is a left side of the lower half: the middle is its.
        assert_eq!(halves, [0b1_0000_0000, 0b0_1100_1000]);
        assert_eq!(Triangle::new([a, b, c]).samples(1, -1, &places), 0);
        // One sample, at the centre, is the pixel.
        assert_eq!(
            Triangle::new([a, b, c]).samples(2, -1, &[[8, 8]]) == 1,
            Triangle::new([a, b, c]).covers(2, -1)
        );
    }

    #[test]
    fn weights_are_shares_of_the_area() {
        let triangle = Triangle::new([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(Vec2::from));
        assert_eq!(triangle.weights(0, 0), [0.75, 0.125, 0.125]);
        assert_eq!(triangle.pixels(WINDOW).len(), 6);
    }
}
