//! Exact coverage by integer edge functions.
//!
//! The edge function of a side from *A* to *B* is *E(P) = (B − A) × (P − A)*: twice the area of the triangle
//! *ABP*, positive on the left of the side, 0 on it, negative on the right (J. Pineda, *A parallel algorithm
//! for polygon rasterization*, SIGGRAPH 1988). With the corners counterclockwise, a point is inside when it
//! is on the left of all three sides. And *E/(2·area)* is the weight of the opposite corner.
//!
//! Corners are rounded to 1/256 px once. From there on everything is an integer, so nothing depends on the
//! order of the corners, and two triangles with a common side agree on it to the last bit.
//!
//! E is linear: a step to the right adds the same number to it every time. So in a row the three
//! conditions *E ≥ 0* are three bounds on x. The first and last pixel come from three divisions, no pixel
//! outside is ever looked at, and inside, three additions a pixel keep the weights up to date.
//!
//! **Which integer?** Corners of ±2²⁰ px are ±2²⁸ in 1/256 px, so their differences are at most 2²⁹. Those to
//! a centre in the triangle's bounding box are at most 2²⁹ + 2⁸: the box is made of whole pixels, the centre
//! lies ½ px inside, and the loops step one pixel past the end. So a product of two is below 2⁵⁸ + 2³⁸, and E,
//! a difference of two products, below 2⁶⁰; the step from one pixel to the next is at most 256·2²⁹ = 2³⁷. An
//! `i64` holds them all with 3 bits to spare. What lies farther out, up to ±2⁵² px, is computed in the same
//! way in `i128`, where E is below 2¹²⁴. Beyond that, and for NaN, nothing is drawn.

use std::ops::{Add, Div, Mul, Sub};

use common::{Bounds, Vec2, Vec3};

/// Steps of a coordinate in a pixel: 8 bits, as on common hardware.
const SUBPIXELS: i64 = 256;

/// Up to where `i64` is used, in pixels on either side of the origin.
const NARROW: f32 = (1 << 20) as f32;

/// Up to where `i128` is used.
const WIDE: f32 = (1_u64 << 52) as f32;

/// Calls `visit(x, y, weights)` for each pixel in `bounds` that the triangle covers, rows from the bottom.
///
/// Corners are in pixels, in any order. The weights are those of the corners at the pixel's centre: each
/// between 0 and 1, their sum 1 to within 1e-6. A triangle without area covers nothing.
// ANCHOR: fill
pub fn fill(corners: [Vec2; 3], bounds: Bounds, visit: impl FnMut(i32, i32, Vec3)) {
    let bounds = box_of(corners, bounds);
    // Far from the triangle no bound on the numbers holds.
    if bounds.max.cmplt(bounds.min).any() {
        return;
    }
    // NaN is within no limit.
    let within = |limit: f32| corners.iter().all(|corner| corner.abs().cmple(Vec2::splat(limit)).all());
    if within(NARROW) {
        scan(corners.map(snap), bounds, visit);
    } else if within(WIDE) {
        scan(corners.map(|corner| snap(corner).map(i128::from)), bounds, visit);
    }
}
// ANCHOR_END: fill

/// The nearest point of the grid of 1/256 px. Multiplying by a power of 2 rounds nothing.
fn snap(corner: Vec2) -> [i64; 2] {
    corner.to_array().map(|coordinate| (coordinate * SUBPIXELS as f32).round_ties_even() as i64)
}

/// The pixels of `bounds` whose centres the triangle can cover.
fn box_of([a, b, c]: [Vec2; 3], bounds: Bounds) -> Bounds {
    let low = a.min(b).min(c).floor().as_ivec2();
    let high = a.max(b).max(c).floor().as_ivec2();
    Bounds { min: low.max(bounds.min), max: high.min(bounds.max) }
}

/// What the scan needs of `i64` and of `i128`.
trait Integer:
    Copy + Ord + From<i64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn to_f64(self) -> f64;
    fn to_i64(self) -> i64;
}

impl Integer for i64 {
    fn to_f64(self) -> f64 {
        self as f64
    }
    fn to_i64(self) -> i64 {
        self
    }
}

impl Integer for i128 {
    fn to_f64(self) -> f64 {
        self as f64
    }
    fn to_i64(self) -> i64 {
        self as i64
    }
}

/// The edge function of one side, as the scan moves over the pixels.
struct Edge<I> {
    /// Its value at the first pixel of the row.
    row: I,
    /// What a step of one pixel to the right adds.
    right: I,
    /// What a step of one pixel up adds.
    up: I,
    /// The least value inside: 0 on a top or left side, else 1.
    inside: I,
}

impl<I: Integer> Edge<I> {
    /// The side `from`→`to` of a counterclockwise triangle, its row value that of the pixel at `first`.
    fn new(from: [I; 2], to: [I; 2], first: [I; 2]) -> Self {
        let [zero, one, pixel] = [0, 1, SUBPIXELS].map(I::from);
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        // The inside is on the left: a side that goes down is a left one, one that goes left a top one.
        let top_left = dy < zero || (dy == zero && dx < zero);
        Self {
            row: dx * (first[1] - from[1]) - dy * (first[0] - from[0]),
            right: zero - dy * pixel,
            up: dx * pixel,
            inside: if top_left { zero } else { one },
        }
    }

    /// Cuts the row's pixels `first..=last` down to those on the inner side.
    fn narrow(&self, first: &mut I, last: &mut I) {
        let [zero, one] = [0, 1].map(I::from);
        let margin = self.row - self.inside;
        if self.right > zero {
            if margin < zero {
                *first = (*first).max((self.right - one - margin) / self.right);
            }
        } else if margin < zero {
            *last = zero - one;
        } else if self.right < zero {
            *last = (*last).min(margin / (zero - self.right));
        }
    }
}

/// Walks the rows of `bounds`, which corners in 1/256 px belong to.
// ANCHOR: scan
fn scan<I: Integer>([a, b, c]: [[I; 2]; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    let zero = I::from(0);
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area == zero {
        return;
    }
    // A box of every pixel is too wide for an i32.
    let [left, right] = [bounds.min.x, bounds.max.x].map(i64::from);
    let corner = [left, bounds.min.y.into()].map(|n| I::from(n * SUBPIXELS + SUBPIXELS / 2));
    // Clockwise corners make the same sides, walked in the other direction.
    let side = |from, to| if area > zero { Edge::new(from, to, corner) } else { Edge::new(to, from, corner) };
    let mut edges = [side(b, c), side(c, a), side(a, b)];
    let per_area = 1.0 / area.to_f64().abs();

    for y in bounds.min.y..=bounds.max.y {
        let (mut first, mut last) = (zero, I::from(right - left));
        edges.iter().for_each(|edge| edge.narrow(&mut first, &mut last));
        if first <= last {
            let mut e = edges.each_ref().map(|edge| edge.row + first * edge.right);
            for x in left + first.to_i64()..=left + last.to_i64() {
                visit(x as i32, y, Vec3::from_array(e.map(|e| (e.to_f64() * per_area) as f32)));
                e = [e[0] + edges[0].right, e[1] + edges[1].right, e[2] + edges[2].right];
            }
        }
        for edge in &mut edges {
            edge.row = edge.row + edge.up;
        }
    }
}
// ANCHOR_END: scan
