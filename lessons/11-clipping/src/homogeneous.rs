//! A triangle's pixels without clipping it and without dividing by w.
//!
//! What a pixel sees through its centre (X, Y), from −1 to 1, are the points of clip space with (x, y, w) = w·(X, Y, 1). Such
//! a point of the triangle is Σμᵢ(xᵢ, yᵢ, wᵢ) with weights that sum to 1. With the corners as columns of a matrix M and
//! cᵢ = μᵢ/w this says **M c = (X, Y, 1)**, so *c* = adj M·(X, Y, 1)/det M: three linear functions of the pixel. The
//! triangle is seen there, in front of the eye, where none of them is negative; their sum is 1/w, and cᵢ/Σcⱼ are the weights
//! in perspective. A corner behind the eye changes nothing in this (M. Olano and T. Greer, *Triangle scan conversion using 2D
//! homogeneous coordinates*, Graphics Hardware 1997).
//!
//! The rows of adj M are the cross products of two corners. Two triangles at a side have the same one but for its sign, and
//! a difference of two exact products changes nothing but its sign with it: they agree on each pixel.

use common::{Bounds, DVec2, DVec3, Vec4, Vec4Swizzles};
use perspective::interpolation::Pixels;
use shaders::shader::Varying;

use crate::clip::ClipVertex;

/// A linear function of the pixels' centres, its coefficients for X, Y and 1; inside it is positive.
#[derive(Clone, Copy, Debug)]
struct Edge {
    coefficients: DVec3,
    /// Whether what lies right on it is inside.
    closed: bool,
}

/// Goes through the pixels in `bounds`, the whole picture, in which a triangle is seen between near and far, rows from the
/// bottom. The depth is that of window space, from 0 to 1. A triangle that is seen edge-on covers nothing.
// ANCHOR: fill
pub fn fill<V: Varying>(vertices: [ClipVertex<V>; 3], bounds: Bounds, mut pixels: impl Pixels<V>) {
    let (corners, varyings) = (vertices.map(|vertex| vertex.position), vertices.map(|vertex| vertex.varying));
    let [a, b, c] = corners.map(|corner| corner.xyw().as_dvec3());
    let determinant = a.dot(b.cross(c));
    if determinant == 0.0 || !determinant.is_finite() {
        return;
    }
    // All signs turned where the triangle faces away, all sizes without the determinant.
    let sides = [b.cross(c), c.cross(a), a.cross(b)].map(|side| side * determinant.signum());
    // The share of each corner in what is linear over the triangle, for X, Y and 1.
    let along = |axis: usize| DVec3::new(sides[0][axis], sides[1][axis], sides[2][axis]);
    let [along_x, along_y, constant] = [0, 1, 2].map(along);
    let (z, w) =
        (DVec3::from_array(corners.map(|p| p.z.into())), DVec3::from_array(corners.map(|p| p.w.into())));
    let plane = |values: DVec3| DVec3::new(along_x.dot(values), along_y.dot(values), constant.dot(values));
    let closed = |coefficients| Edge { coefficients, closed: true };
    // ANCHOR: near_and_far
    let edges = [
        top_left(sides[0]),
        top_left(sides[1]),
        top_left(sides[2]),
        closed(plane(w + z)),
        closed(plane(w - z)),
    ];
    // ANCHOR_END: near_and_far
    let size = (bounds.max + 1).as_dvec2();
    let center = |x: i32, y: i32| (DVec2::new(x.into(), y.into()) + 0.5) / size * 2.0 - 1.0;
    let (bottom, top) = rows(corners, bounds);
    for y in bottom..=top {
        let (mut first, mut last) = (bounds.min.x, bounds.max.x);
        let row = center(0, y).y;
        for edge in &edges {
            let Edge { coefficients, closed } = edge;
            let base = coefficients.y * row + coefficients.z;
            let covers = |x: i32| {
                let value = coefficients.x * center(x, y).x + base;
                value > 0.0 || value == 0.0 && *closed
            };
            narrow(coefficients.x, base, size.x, covers, &mut first, &mut last);
        }
        let base = along_y * row + constant;
        for x in first..=last {
            let shares = along_x * center(x, y).x + base;
            let depth = 0.5 + 0.5 * shares.dot(z) / determinant.abs();
            let weights = shares / shares.element_sum();
            pixels.pixel(x, y, depth.clamp(0.0, 1.0) as f32, || V::interpolate(varyings, weights.as_vec3()));
        }
    }
}
// ANCHOR_END: fill

/// A side: what lies right on it is inside if it is a left or a top one, so that it belongs to one of two neighbours.
fn top_left(side: DVec3) -> Edge {
    Edge { coefficients: side, closed: side.x > 0.0 || side.x == 0.0 && side.y < 0.0 }
}

/// The rows in which a triangle may be seen: all of them where a corner is behind the eye.
fn rows(corners: [Vec4; 3], bounds: Bounds) -> (i32, i32) {
    if corners.iter().any(|corner| corner.w <= 0.0) {
        return (bounds.min.y, bounds.max.y);
    }
    let height = f64::from(bounds.max.y + 1);
    let heights = corners.map(|corner| (f64::from(corner.y) / f64::from(corner.w) + 1.0) * height / 2.0);
    let [low, high] = [f64::min, f64::max].map(|pick| heights.into_iter().reduce(pick).unwrap_or_default());
    // A row more on either side, for the rounding; the edges decide.
    let row = |height: f64| (height as i32).clamp(-2, bounds.max.y + 2);
    (bounds.min.y.max(row(low.floor()) - 1), bounds.max.y.min(row(high.floor()) + 1))
}

/// Cuts a row's pixels down to those that an edge covers. A quotient tells where it passes the row, to far less than a pixel,
/// and the edge itself which of the pixels about that place it covers: rounded as it is, it grows from left to right, or
/// falls, or stays.
fn narrow(slope: f64, base: f64, width: f64, covers: impl Fn(i32) -> bool, first: &mut i32, last: &mut i32) {
    if first > last {
        return;
    }
    let passes = (((1.0 - base / slope) * width / 2.0 - 0.5) as i32).clamp(*first, *last);
    if slope > 0.0 {
        *first = (passes..=*last).find(|&x| covers(x)).unwrap_or(*last + 1);
    } else if slope < 0.0 {
        *last = (*first..=(passes + 1).min(*last)).rev().find(|&x| covers(x)).unwrap_or(*first - 1);
    } else if !covers(*first) {
        *last = *first - 1;
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use common::IVec2;

    use super::*;

    /// The rows of a picture so many high in which a triangle with corners at these heights, in pixels, is looked for.
    fn rows_of(height: i16, heights: [f32; 3], w: [f32; 3]) -> (i32, i32) {
        let middle = f32::from(height) / 2.0;
        let corner = |n: usize| Vec4::new(0.0, (heights[n] / middle - 1.0) * w[n], 0.0, w[n]);
        rows([0, 1, 2].map(corner), Bounds { min: IVec2::ZERO, max: IVec2::new(19, i32::from(height) - 1) })
    }

    /// No row is walked in vain but for one above and one below.
    #[test]
    fn rows_are_those_between_the_corners_and_two_more() {
        assert_eq!(rows_of(16, [9.25, 4.5, 6.0], [1.0, 2.0, 0.5]), (3, 10));
        assert_eq!(rows_of(16, [-1e6, 4.5, 1e6], [1.0, 2.0, 0.5]), (0, 15));
        for (height, low, high) in [(16, -1e6, -3.0), (16, 19.0, 1e6), (1, 4.0, 5.0), (1, -5.0, -4.0)] {
            let (bottom, top) = rows_of(height, [low, high, low], [1.0; 3]);
            assert!(bottom > top, "{height}: from {bottom} to {top}");
        }
        // What is behind the eye, or at its depth, may be seen anywhere.
        for w in [-1.0, 0.0] {
            assert_eq!(rows_of(16, [9.25, 4.5, 6.0], [1.0, 2.0, w]), (0, 15));
        }
    }

    /// Where the centre of a pixel is in a row of 1,000, from −1 to 1.
    fn center(x: i32) -> f64 {
        (f64::from(x) + 0.5) / 1000.0 * 2.0 - 1.0
    }

    /// The pixels of such a row that an edge leaves of those from `first` to `last`, and of how many it was asked.
    fn narrowed(slope: f64, base: f64, [first, last]: [i32; 2]) -> ([i32; 2], u32) {
        let (mut left, mut right, asked) = (first, last, Cell::new(0));
        let covers = |x: i32| {
            asked.set(asked.get() + 1);
            slope * center(x) + base >= 0.0
        };
        narrow(slope, base, 1000.0, covers, &mut left, &mut right);
        ([left, right], asked.get())
    }

    /// An edge is asked for no more than three pixels, those about where it passes the row; also where it passes right
    /// through a centre, and rounding brings the quotient to either side of that.
    #[test]
    fn an_edge_is_found_and_not_searched_for() {
        for slope in [0.5, 0.7, 3.0, -0.5, -0.7, -3.0] {
            let through_centers = (0..1000).map(|x| -(slope * center(x)));
            let elsewhere = (0..=1000).map(|x| slope * (1.0 - f64::from(x) / 500.0));
            for base in through_centers.chain(elsewhere) {
                let covered = |x: &i32| slope * center(*x) + base >= 0.0;
                let first = (0..1000).find(covered).unwrap_or(if slope > 0.0 { 1000 } else { 0 });
                let last = (0..1000).rev().find(covered).unwrap_or(if slope > 0.0 { 999 } else { -1 });
                let (left, asked) = narrowed(slope, base, [0, 999]);
                assert_eq!(left, [first, last], "{slope} {base}");
                assert!(asked <= 3, "{slope} {base}: {asked}");
            }
        }
        // Nothing is left of what another edge has left nothing of, and nobody is asked.
        assert_eq!(narrowed(1.0, 0.0, [7, 6]), ([7, 6], 0));
        // An edge along the row covers all of it or nothing.
        assert_eq!(narrowed(0.0, 1.0, [3, 6]), ([3, 6], 1));
        let ([first, last], _) = narrowed(0.0, -1.0, [3, 6]);
        assert!(first > last);
    }
}
