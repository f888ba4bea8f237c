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
//! **Which integer?** An `f64` holds every whole number up to 2⁵³, and divides faster than an `i64`. Corners of
//! ±2¹⁶ px are ±2²⁴ in 1/256 px, so their differences are at most 2²⁵. Those to a centre in the triangle's
//! bounding box are at most 2²⁵ + 2⁸, as the loops step one pixel past the end. So a product of two is below
//! 2⁵⁰ + 2³⁴, and E, a difference of two products, below 2⁵²; the step from one pixel to the next is at most
//! 256·2²⁵ = 2³³. So nothing is ever rounded. What lies farther out, up to ±2⁵² px, is computed in the same way
//! in `i128`, where E is below 2¹²⁴. Beyond that, and for NaN, nothing is drawn.

use std::ops::{Add, Mul, Range, Sub};

use common::{Bounds, DVec3, IVec2, Vec2, Vec3};

/// Steps of a coordinate in a pixel: 8 bits, as on common hardware.
const SUBPIXELS: i64 = 256;

/// Up to where `f64` is used, in pixels on either side of the origin.
const NARROW: f32 = (1 << 16) as f32;

/// Up to where `i128` is used.
const WIDE: f32 = (1_u64 << 52) as f32;

/// Calls `visit(x, y, weights)` for each pixel in `bounds` that the triangle covers, rows from the bottom.
///
/// Corners are in pixels, in any order. The weights are those of the corners at the pixel's centre: each
/// between 0 and 1, their sum 1 to within 1e-6. A triangle without area covers nothing.
// ANCHOR: fill
pub fn fill(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    // NaN is within no limit.
    let within = |limit: f32| corners.iter().all(|corner| corner.abs().cmple(Vec2::splat(limit)).all());
    if !within(WIDE) {
        return;
    }
    let snapped = corners.map(snap);
    let bounds = box_of(snapped, bounds);
    // Far from the triangle no bound on the numbers holds.
    if bounds.max.cmplt(bounds.min).any() {
        return;
    }
    let row = move |Row { y, pixels, mut edges, right, per_area }: Row| {
        for x in pixels {
            // What `i128` held exactly, sums of f64 may put just below 0.
            visit(x as i32, y, (edges * per_area).as_vec3().max(Vec3::ZERO));
            edges += right;
        }
    };
    if within(NARROW) {
        scan(snapped.map(|corner| corner.map(f64::of)), bounds, row);
    } else {
        scan(snapped.map(|corner| corner.map(i128::of)), bounds, row);
    }
}
// ANCHOR_END: fill

/// The nearest point of the grid of 1/256 px. Multiplying by a power of 2 rounds nothing.
// ANCHOR: snap
fn snap(corner: Vec2) -> [i64; 2] {
    corner.to_array().map(|coordinate| (coordinate * SUBPIXELS as f32).round_ties_even() as i64)
}
// ANCHOR_END: snap

/// The pixels of `bounds` whose centres lie in the box about the corners.
fn box_of([a, b, c]: [[i64; 2]; 3], bounds: Bounds) -> Bounds {
    let half = SUBPIXELS / 2;
    let inside = |axis: usize, min: i32, max: i32| {
        let [low, high] = [a[axis].min(b[axis]).min(c[axis]), a[axis].max(b[axis]).max(c[axis])];
        let first = (low - half + SUBPIXELS - 1).div_euclid(SUBPIXELS).max(min.into());
        let last = (high - half).div_euclid(SUBPIXELS).min(max.into());
        // Empty where they have passed each other; else both are within the bounds.
        if first <= last { (first as i32, last as i32) } else { (0, -1) }
    };
    let (x, y) = (inside(0, bounds.min.x, bounds.max.x), inside(1, bounds.min.y, bounds.max.y));
    Bounds { min: IVec2::new(x.0, y.0), max: IVec2::new(x.1, y.1) }
}

/// Numbers in which whole ones are exact, as far as the scan needs them.
trait Whole: Copy + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn of(n: i64) -> Self;
    /// The quotient of two numbers that are not below 0, rounded down.
    fn over(self, by: Self) -> i64;
    fn to_f64(self) -> f64;
}

impl Whole for f64 {
    fn of(n: i64) -> Self {
        n as f64
    }
    fn over(self, by: Self) -> i64 {
        // Below 2⁵³ no quotient is rounded up to a whole number: it is at least 1/by away from the next one.
        (self / by) as i64
    }
    fn to_f64(self) -> f64 {
        self
    }
}

impl Whole for i128 {
    fn of(n: i64) -> Self {
        n.into()
    }
    fn over(self, by: Self) -> i64 {
        (self / by).try_into().unwrap_or(i64::MAX)
    }
    fn to_f64(self) -> f64 {
        self as f64
    }
}

/// The edge function of one side, as the scan moves over the pixels.
// ANCHOR: edge
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

impl<I: Whole> Edge<I> {
    /// The side `from`→`to` of a counterclockwise triangle, its row value that of the pixel at `first`.
    fn new(from: [I; 2], to: [I; 2], first: [I; 2]) -> Self {
        let [zero, one, pixel] = [0, 1, SUBPIXELS].map(I::of);
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
    // ANCHOR_END: edge

    /// Cuts the row's pixels `first..=last` down to those on the inner side.
    // ANCHOR: narrow
    fn narrow(&self, first: &mut i64, last: &mut i64) {
        let [zero, one] = [0, 1].map(I::of);
        let margin = self.row - self.inside;
        if self.right > zero {
            if margin < zero {
                *first = (*first).max((self.right - one - margin).over(self.right));
            }
        } else if margin < zero {
            *last = -1;
        } else if self.right < zero {
            *last = (*last).min(margin.over(zero - self.right));
        }
    }
    // ANCHOR_END: narrow
}

/// The pixels of a row that a triangle covers.
struct Row {
    y: i32,
    /// Their x.
    pixels: Range<i64>,
    /// The three edge functions at the first one, and what a step to the right adds.
    edges: DVec3,
    right: DVec3,
    /// What makes weights of them.
    per_area: f64,
}

/// Walks the rows of `bounds`, which corners in 1/256 px belong to.
// ANCHOR: scan
fn scan<I: Whole>([a, b, c]: [[I; 2]; 3], bounds: Bounds, mut visit: impl FnMut(Row)) {
    let zero = I::of(0);
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area == zero {
        return;
    }
    // A box of every pixel is too wide for an i32.
    let [left, right] = [bounds.min.x, bounds.max.x].map(i64::from);
    let corner = [left, bounds.min.y.into()].map(|n| I::of(n * SUBPIXELS + SUBPIXELS / 2));
    // Clockwise corners make the same sides, walked in the other direction.
    let side = |from, to| if area > zero { Edge::new(from, to, corner) } else { Edge::new(to, from, corner) };
    let mut edges = [side(b, c), side(c, a), side(a, b)];
    let per_area = 1.0 / area.to_f64().abs();
    let steps = DVec3::from_array(edges.each_ref().map(|edge| edge.right.to_f64()));

    for y in bounds.min.y..=bounds.max.y {
        let (mut first, mut last) = (0, right - left);
        edges.iter().for_each(|edge| edge.narrow(&mut first, &mut last));
        if first <= last {
            let start = edges.each_ref().map(|edge| (edge.row + I::of(first) * edge.right).to_f64());
            let pixels = left + first..left + last + 1;
            visit(Row { y, pixels, edges: DVec3::from_array(start), right: steps, per_area });
        }
        for edge in &mut edges {
            edge.row = edge.row + edge.up;
        }
    }
}
// ANCHOR_END: scan
