//! How well samples show a straight edge, in `f64`.
//!
//! Along an edge of irrational slope pixels meet it at every offset, each as often as any other (Weyl's equidistribution
//! theorem), so a mean along the edge is an integral over offsets. The offset of a point is how far it lies along the edge's
//! normal. A pixel shows how many of its samples have passed: a flight of steps, each at a sample's offset. What it should
//! show is the share of its square on that side of the edge: the integral of the square's width across the normal.

use common::DVec2;

/// Steps closer than this, in px, are one: no corner is placed finer.
const APART: f64 = 1.0 / 256.0;

/// How samples show an edge of one direction. Grey levels are 255ths, of black and white on its two sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// The grey levels told apart, black and white among them.
    pub levels: usize,
    /// The mean, along the edge and over the pixels that it crosses, of how many grey levels a pixel is off.
    pub mean: f64,
    /// The root of the mean square of the same.
    pub rms: f64,
    /// The largest of the same.
    pub largest: f64,
}

/// The direction of the normal of an edge that runs upwards at so many degrees to the x axis: to its right side.
#[must_use]
pub fn normal(degrees: f64) -> DVec2 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    // At 0, 90, 180 and 270 degrees one of them is 0, and its rounding error is no slope.
    let exact = |n: f64| if n.abs() < 1e-15 { 0.0 } else { n };
    DVec2::new(exact(sin), -exact(cos))
}

/// The share of the pixel from (0, 0) to (1, 1) where p·normal < offset. The normal has length 1.
///
/// Across the square, along the normal, the width of what the edge has yet to pass grows up to the second corner, stays up
/// to the third and shrinks: half of the square is a triangle and a part of a band, the other half is its mirror image.
#[must_use]
pub fn share(normal: DVec2, offset: f64) -> f64 {
    let [short, long] = [normal.abs().min_element(), normal.abs().max_element()];
    let passed = offset - normal.min(DVec2::ZERO).element_sum();
    let part = |t: f64| match t {
        t if t <= 0.0 => 0.0,
        t if t < short => t * t / (2.0 * short * long),
        t => (t - short / 2.0) / long,
    };
    let across = short + long;
    if 2.0 * passed <= across { part(passed) } else { 1.0 - part(across - passed) }
}

/// How a pixel's samples show an edge that runs at so many degrees to the x axis. Places are counted from the pixel's
/// lower left corner, in 1/16 px.
///
/// # Panics
/// Where there is no sample.
#[must_use]
pub fn quality(places: &[[i32; 2]], degrees: f64) -> Quality {
    let normal = normal(degrees);
    let n = places.len() as f64;
    let mut steps: Vec<f64> = places
        .iter()
        .map(|place| DVec2::from_array(place.map(|p| f64::from(p) / 16.0)).dot(normal))
        .collect();
    steps.sort_by(f64::total_cmp);
    let levels = 2 + steps.windows(2).filter(|pair| pair[1] - pair[0] > APART).count();

    // Between two steps, and between two of the square's corners, the error is a number less a quadratic that only grows.
    let [low, high] = [normal.min(DVec2::ZERO).element_sum(), normal.max(DVec2::ZERO).element_sum()];
    let short = normal.abs().min_element();
    let mut ends = [vec![low, low + short, high - short, high], steps.clone()].concat();
    ends.sort_by(f64::total_cmp);
    let (mut sum, mut squares, mut largest) = (0.0, 0.0, 0.0_f64);
    for pair in ends.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let shown = steps.iter().filter(|&&step| step < (from + to) / 2.0).count() as f64 / n;
        let error = |offset: f64| 255.0 * (shown - share(normal, offset));
        largest = largest.max(error(from).abs()).max(error(to).abs());
        let zero = root(from, to, error);
        for [from, to] in [[from, zero], [zero, to]] {
            sum += integral(from, to, error).abs();
            squares += integral(from, to, |offset| error(offset).powi(2));
        }
    }
    let across = high - low;
    Quality { levels, mean: sum / across, rms: (squares / across).sqrt(), largest }
}

/// Where a function that does not grow passes 0; one of the ends if it does not.
fn root(mut from: f64, mut to: f64, value: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = from.midpoint(to);
        *(if value(middle) > 0.0 { &mut from } else { &mut to }) = middle;
    }
    from.midpoint(to)
}

/// The integral of a polynomial of degree 5 at most, by Gauss's three points.
fn integral(from: f64, to: f64, value: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (from.midpoint(to), (to - from) / 2.0);
    let off = half * 0.6_f64.sqrt();
    half * (5.0 * value(middle - off) + 8.0 * value(middle) + 5.0 * value(middle + off)) / 9.0
}

#[cfg(test)]
mod tests {
    use std::f64::consts::SQRT_2;

    use super::*;

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    #[test]
    fn shares_are_triangles_and_trapezoids() {
        // Upright, flat, and either way round.
        for degrees in [0.0, 90.0, 180.0, 270.0] {
            let normal = normal(degrees);
            let low = normal.min(DVec2::ZERO).element_sum();
            assert_eq!(
                [-0.5, 0.0, 0.25, 1.0, 1.5].map(|t| share(normal, low + t)),
                [0.0, 0.0, 0.25, 1.0, 1.0],
                "{degrees}"
            );
        }
        // Along the diagonal: a triangle of height t has area t².
        let diagonal = normal(135.0);
        assert!([0.1, 0.5, SQRT_2 / 2.0].iter().all(|&t| near(share(diagonal, t), t * t)));
        assert!(near(share(diagonal, SQRT_2 - 0.2), 1.0 - 0.04));
        // Slope 1/2 through the lower left corner: a quarter lies below; 3/4 above.
        let gentle = normal(0.5_f64.atan().to_degrees());
        assert!(near(share(gentle, 0.0), 0.75) && near(share(-gentle, 0.0), 0.25));
    }

    #[test]
    fn both_sides_of_an_edge_are_the_whole_pixel() {
        for degrees in (0..3600).map(|n| f64::from(n) / 10.0) {
            let normal = normal(degrees);
            for offset in (-20..=20).map(|n| f64::from(n) / 13.0) {
                let [one, other] = [share(normal, offset), share(-normal, -offset)];
                assert!(
                    near(one + other, 1.0) && (0.0..=1.0).contains(&one),
                    "{degrees}, {offset}: {one} and {other}"
                );
            }
        }
        // Nothing jumps next to an axis.
        for tilt in [1e-300, 1e-17, 1e-12, 1e-10, 1e-8] {
            let normal = DVec2::new(1.0, tilt).normalize();
            assert!([0.0, 0.25, 0.5, 1.0].iter().all(|&t| (share(normal, t) - t).abs() < 1e-8), "{tilt}");
        }
    }

    /// Of one sample at the centre: the error is that of rounding to black or white.
    #[test]
    fn one_sample_is_off_by_half_a_grey_scale_at_most() {
        let upright = quality(&[[8, 8]], 90.0);
        assert_eq!(upright.levels, 2);
        // |t − [t ≥ 1/2]| over 0..1: largest 1/2, mean 1/4, root of the mean square √(1/12).
        assert!(
            near(upright.largest, 127.5)
                && near(upright.mean, 63.75)
                && near(upright.rms, 255.0 / 12_f64.sqrt())
        );
        // Along the diagonal t² over 0..√½ and back: the mean is (√½)³/3 over √½ = 1/6.
        let diagonal = quality(&[[8, 8]], 45.0);
        assert!(near(diagonal.mean, 255.0 / 6.0) && near(diagonal.rms, 255.0 * (1.0_f64 / 20.0).sqrt()));
    }

    /// Evenly spread columns show an upright edge in equal steps, whatever their heights, and a flat one by its rows.
    #[test]
    fn levels_are_counted_by_direction() {
        let columns = [[2, 8], [6, 8], [10, 8], [14, 8]];
        let (upright, flat) = (quality(&columns, 90.0), quality(&columns, 0.0));
        assert_eq!([upright.levels, flat.levels], [5, 2]);
        // A saw of 1/8: a mean of 1/16; flat it is one sample again.
        assert!(
            near(upright.mean, 255.0 / 16.0) && near(upright.largest, 255.0 / 8.0) && near(flat.mean, 63.75)
        );
        // The other way along the same edge, and the mirror image of all.
        for degrees in [0.0, 17.0, 45.0, 90.0, 133.0] {
            let [one, other] = [degrees, degrees + 180.0].map(|degrees| quality(&columns, degrees));
            let mirrored = quality(&columns.map(|[x, y]| [16 - x, y]), 180.0 - degrees);
            for q in [other, mirrored] {
                assert_eq!(q.levels, one.levels);
                assert!(near(q.mean, one.mean) && near(q.rms, one.rms) && near(q.largest, one.largest));
            }
        }
    }

    /// Against pixels counted one by one along an edge of irrational slope.
    #[test]
    fn an_integral_over_offsets_is_a_mean_along_the_edge() {
        let places = [[6, 2], [14, 6], [2, 10], [10, 14]];
        for slope in [0.618_033_988_75_f64, 0.070_710_678_118_654_76, 2.236_067_977_499_79] {
            let degrees = slope.atan().to_degrees();
            let normal = normal(degrees);
            let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
            for x in 0..20_000 {
                let [low, high] = [f64::from(x) * slope, f64::from(x + 1) * slope];
                for y in low.floor() as i64..=high.floor() as i64 {
                    // The edge runs through (0, 0): its offset from the pixel's own corner.
                    let offset = -DVec2::new(x.into(), y as f64).dot(normal);
                    let passed = |place: &&[i32; 2]| {
                        DVec2::from_array(place.map(|p| f64::from(p) / 16.0)).dot(normal) < offset
                    };
                    let shown = places.iter().filter(passed).count() as f64 / 4.0;
                    let error = 255.0 * (shown - share(normal, offset)).abs();
                    sum += error;
                    squares += error * error;
                    count += 1.0;
                }
            }
            let expected = quality(&places, degrees);
            assert!((sum / count - expected.mean).abs() < 0.02, "{slope}: {} {expected:?}", sum / count);
            assert!(((squares / count).sqrt() - expected.rms).abs() < 0.02, "{slope}");
        }
    }
}
