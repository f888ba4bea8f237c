//! A frustum's matrix and what a depth becomes, in `f64`, by the formulas as they are written.

use common::Mat4;

/// Left, right, bottom and top on the near plane, and the depths of the near and the far plane.
pub type Frustum = [f64; 6];

/// The rows of the matrix from eye space to clip space. The far plane may be infinite.
#[must_use]
pub fn rows([l, r, b, t, n, f]: Frustum) -> [[f64; 4]; 4] {
    let (a, c) =
        if f.is_infinite() { (-1.0, -2.0 * n) } else { (-(f + n) / (f - n), -2.0 * f * n / (f - n)) };
    [
        [2.0 * n / (r - l), 0.0, (r + l) / (r - l), 0.0],
        [0.0, 2.0 * n / (t - b), (t + b) / (t - b), 0.0],
        [0.0, 0.0, a, c],
        [0.0, 0.0, -1.0, 0.0],
    ]
}

/// The largest error of an entry as a share of it; infinite where one is to be 0 and is not.
#[must_use]
pub fn error(got: &Mat4, frustum: Frustum) -> f64 {
    let mut worst: f64 = 0.0;
    for (row, exact) in rows(frustum).into_iter().enumerate() {
        for (column, exact) in exact.into_iter().enumerate() {
            let off = (f64::from(got.row(row)[column]) - exact).abs();
            let share = if off == 0.0 { 0.0 } else { off / exact.abs() };
            // Unlike `f64::max` this keeps a NaN.
            worst = if share <= worst { worst } else { share };
        }
    }
    worst
}

/// The distance from the eye at which the window's depth, from 0 at `n` to 1 at `f`, is `z`.
#[must_use]
pub fn distance_at(z: f64, n: f64, f: f64) -> f64 {
    // z·(1/n − 1/f) of the way from 1/n to 1/f.
    1.0 / (1.0 / n - z * (1.0 / n - 1.0 / f))
}

/// The numbers that are nearer to a positive `f32` than to any other, from the first to the last.
#[must_use]
pub fn rounded_to(number: f32) -> [f64; 2] {
    let bits = number.to_bits();
    let half = |other: u32| f64::from(number).midpoint(f64::from(f32::from_bits(other)));
    [half(bits - 1), half(bits + 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_planes_are_at_minus_one_and_one() {
        for frustum in [[-1.0, 3.0, -2.0, 1.0, 0.5, 8.0], [-1.0, 1.0, -1.0, 1.0, 0.5, f64::INFINITY]] {
            let [l, _, _, t, n, f] = frustum;
            let at = |x: f64, y: f64, z: f64| rows(frustum).map(|[a, b, c, d]| a * x + b * y + c * z + d);
            let [x, y, z, w] = at(l, t, -n);
            assert_eq!([x / w, y / w, z / w], [-1.0, 1.0, -1.0]);
            let far = f.min(1e12);
            let [_, _, z, w] = at(0.0, 0.0, -far);
            assert!((z / w - 1.0).abs() < 1e-11);
        }
    }

    #[test]
    fn half_of_the_depths_are_before_twice_the_near_plane() {
        assert_eq!(distance_at(0.5, 1.0, f64::INFINITY), 2.0);
        assert_eq!([distance_at(0.0, 0.25, 4.0), distance_at(1.0, 0.25, 4.0)], [0.25, 4.0]);
    }

    #[test]
    fn between_two_neighbours_is_the_middle() {
        let [low, high] = rounded_to(1.0);
        assert_eq!([1.0 - low, high - 1.0], [2f64.powi(-25), 2f64.powi(-24)]);
    }
}
