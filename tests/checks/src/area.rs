//! How much of a pixel a triangle covers, in rational numbers.
//!
//! Nothing is cut. A triangle's area is the sum over its sides, walked clockwise, of what lies between the side and the
//! bottom of the pixel, counted as negative where the side runs to the left (Green's theorem); and of each side only as
//! much of it counts as lies in the pixel: the integral of max(y, 0) − max(y − 1, 0) over the pixel's width. Of a straight
//! side each of the two is a trapezoid or a triangle, and so a fraction of two whole numbers.

use common::Vec2;

use crate::coverage::Triangle;

/// A fraction is taken down to a whole number of these in a pixel.
const UNIT: i128 = 1 << 60;

/// Of 2⁻⁶⁰ in a pixel, how many are in a square of 1/256 px.
const SMALL: i128 = UNIT >> 16;

/// The share of the pixel (x, y) that a triangle covers, from 0 to 1. Corners are in px, rounded to 1/256 px as lesson 3
/// specifies. What each of the six terms is off is below 2⁻⁶⁰; the sum is rounded to `f64` last.
///
/// # Panics
/// Where a corner is not finite, or is more than 2²³ px from the pixel.
#[must_use]
pub fn area(corners: [Vec2; 3], x: i32, y: i32) -> f64 {
    let pixel = [x, y].map(|n| i128::from(n) * 256);
    let [a, b, c] = Triangle::new(corners).0.map(|corner| {
        let at = [corner[0] - pixel[0], corner[1] - pixel[1]];
        assert!(
            at.iter().all(|n| n.abs() <= 1 << 31),
            "a corner is too far from the pixel for exact numbers"
        );
        at
    });
    let sum: i128 = [[a, b], [b, c], [c, a]].map(below).iter().sum();
    sum.abs() as f64 / UNIT as f64
}

/// Of the pixel from (0, 0) to (256, 256), the area below a side, negative where it runs to the left.
fn below([from, to]: [[i128; 2]; 2]) -> i128 {
    let (sign, [low, high]) = if from[0] <= to[0] { (1, [from, to]) } else { (-1, [to, from]) };
    let [run, rise] = [high[0] - low[0], high[1] - low[1]];
    let [first, last] = [low[0].max(0), high[0].min(256)];
    if first >= last {
        return 0;
    }
    // Heights above `bottom`, times `run`, at both ends of what is over the pixel.
    let above = |bottom: i128| {
        let height = |x: i128| (low[1] - bottom) * run + (x - low[0]) * rise;
        let [left, right] = [height(first), height(last)];
        match (left > 0, right > 0) {
            (true, true) => (left + right) * (last - first) * SMALL / (2 * run),
            (false, false) => 0,
            // A triangle, whose width is its height over the slope.
            _ => left.max(right).pow(2) * SMALL / (2 * run * rise.abs()),
        }
    };
    sign * (above(0) - above(256))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(corners: [(f32, f32); 3], x: i32, y: i32) -> f64 {
        let corners = corners.map(Vec2::from);
        let area = area(corners, x, y);
        let [a, b, c] = corners;
        // Clockwise and counterclockwise are the same triangle.
        assert_eq!(super::area([c, b, a], x, y), area);
        assert_eq!(super::area([b, c, a], x, y), area);
        area
    }

    #[test]
    fn what_lies_in_the_pixel_has_its_own_area() {
        assert_eq!(of([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], 0, 0), 0.5);
        assert_eq!(of([(3.25, -1.5), (3.75, -1.5), (3.5, -1.25)], 3, -2), 0.0625);
        assert_eq!(of([(3.25, -1.5), (3.75, -1.5), (3.5, -1.25)], 3, -1), 0.0);
        // One square of 1/256 px, halved.
        assert_eq!(of([(0.5, 0.5), (0.503_906_25, 0.5), (0.5, 0.503_906_25)], 0, 0), 0.5 / 65536.0);
        assert_eq!(of([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], 0, 0), 0.0);
    }

    #[test]
    fn only_what_lies_in_the_pixel_counts() {
        let large = [(-10.0, -10.0), (30.0, -10.0), (-10.0, 30.0)];
        assert_eq!(of(large, 3, 3), 1.0);
        assert_eq!(
            [of(large, 9, 10), of(large, 10, 10), of(large, 10, 9), of(large, 9, 9)],
            [0.5, 0.0, 0.5, 1.0]
        );
        assert_eq!([of(large, -10, 5), of(large, -11, 5), of(large, 5, -11)], [1.0, 0.0, 0.0]);
        // A side of slope 1/2 through (0, 0): a quarter below, then three, and above it the rest.
        let gentle = [(0.0, 0.0), (64.0, 0.0), (64.0, 32.0)];
        assert_eq!(
            [of(gentle, 0, 0), of(gentle, 1, 0), of(gentle, 1, 1), of(gentle, 2, 1)],
            [0.25, 0.75, 0.0, 0.25]
        );
        // Through all four sides of a pixel: a band between y = x ± 1/2, of 3/4.
        let parts = [[(-2.0, -1.5), (4.0, 4.5), (4.0, 3.5)], [(-2.0, -1.5), (4.0, 3.5), (-2.0, -2.5)]];
        assert_eq!(parts.map(|part| of(part, 0, 0)).iter().sum::<f64>(), 0.75);
    }

    #[test]
    fn pixels_add_up_to_the_triangle() {
        let corners = [(0.3, 1.7), (17.9, 4.2), (6.1, 14.4)];
        let [a, b, c] = corners.map(|(x, y)| [x, y].map(|n: f32| (f64::from(n) * 256.0).round() / 256.0));
        let whole = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0;
        let sum: f64 =
            (0..16).flat_map(|y| (0..18).map(move |x| (x, y))).map(|(x, y)| of(corners, x, y)).sum();
        assert!((sum - whole).abs() < 1e-12, "{sum}, not {whole}");
    }

    #[test]
    fn corners_may_be_millions_of_pixels_away() {
        let far = 4_194_304.0;
        // Half-planes, from very far: y < x + 1/4 and its complement.
        let [below, above] =
            [[(-far, -far), (far, -far), (far, far)], [(-far, -far), (far, far), (-far, far)]];
        assert_eq!(
            [of(below, 0, 0), of(above, 0, 0), of(below, 7, 6), of(above, 6, 7)],
            [0.5, 0.5, 1.0, 1.0]
        );
        // A needle of 1/256 px at its foot, four million pixels long: it crosses the pixel almost as a strip.
        let needle = of([(0.5, -far), (0.503_906_25, -far), (0.5, far)], 0, 0);
        assert!((needle - 0.5 / 256.0).abs() < 1e-9);
    }

    #[test]
    #[should_panic(expected = "too far")]
    fn farther_out_numbers_would_not_do() {
        let _ = of([(1e7, 0.0), (0.0, 1e7), (0.0, 0.0)], 0, 0);
    }
}
