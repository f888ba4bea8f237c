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
//! 256·2²⁵ = 2³³. So nothing is ever rounded.
//!
//! **Farther out**, up to ±2⁵² px, differences are at most 2⁶¹ and E at most 2¹²³. There each E is computed by
//! itself in `i128` and rounded to `f64` last, which keeps its sign and changes it by at most a 2⁵³rd. A row's
//! ends come from quotients of such numbers, so of its up to 2³² pixels they miss at most one, and the pixels
//! there are asked one by one. Beyond ±2⁵² px, and for NaN, nothing is drawn.

use std::ops::Range;

use common::{Bounds, DVec3, IVec2, Vec2, Vec3};

/// Steps of a coordinate in a pixel: 8 bits, as on common hardware.
pub const SUBPIXELS: i64 = 256;

/// Up to where `f64` is exact, in pixels on either side of the origin.
const NARROW: f32 = (1 << 16) as f32;

/// Up to where `i128` is: triangles with a corner farther out are left out.
pub const WIDE: f32 = (1_u64 << 52) as f32;

/// A point in 1/256 px.
type Fixed = [i64; 2];

/// Calls `visit(x, y, weights)` for each pixel in `bounds` that the triangle covers, rows from the bottom.
///
/// Corners are in pixels, in any order. The weights are those of the corners at the pixel's centre: each
/// between 0 and 1, their sum 1 to within 1e-6. A triangle without area covers nothing.
// ANCHOR: fill
pub fn fill(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    let Some(setup) = Setup::new(corners, bounds) else { return };
    let Bounds { min, max } = setup.bounds;
    let mut start = setup.edges;
    for y in min.y..=max.y {
        let Row { pixels, mut edges } = setup.span(y, start);
        for x in pixels {
            visit(x as i32, y, (edges * setup.per_area).as_vec3());
            edges += setup.right;
        }
        start += setup.up;
    }
}
// ANCHOR_END: fill

/// A triangle made ready to be drawn: its three edge functions, and what follows from them for rows and points.
///
/// What belongs to a side stands at the place of the corner opposite to it, as weights do. Up to ±2¹⁶ px all
/// these are whole numbers, exact; farther out, the nearest `f64`.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// The pixels that may be covered: those with their centre in the box about the corners. Never empty.
    pub bounds: Bounds,
    /// The edge functions at the centre of the first of those, `bounds.min`.
    pub edges: DVec3,
    /// What a step of one pixel to the right adds to them: times `per_area`, the weights' gradient along x.
    pub right: DVec3,
    /// What a step of one pixel up adds to them: times `per_area`, the weights' gradient along y.
    pub up: DVec3,
    /// The least value inside: 0 on a top or left side, else 1.
    pub inside: DVec3,
    /// One over twice the area: it makes weights of edge functions.
    pub per_area: f64,
    corners: [Fixed; 3],
    /// 1 for counterclockwise corners, −1 for clockwise ones.
    turn: f64,
    /// Whether the sides are too long for f64.
    wide: bool,
}

/// The pixels of a row that a triangle covers.
#[derive(Clone, Debug)]
pub struct Row {
    /// Their x, which fit in an `i32`; the end may not.
    pub pixels: Range<i64>,
    /// The edge functions at the first one; a step to the right adds [`Setup::right`].
    pub edges: DVec3,
}

impl Setup {
    /// The triangle with these corners, in pixels and in any order, in the picture that `bounds` are of. `None`
    /// where it covers no pixel: it has no area, its box holds no pixel's centre, or a corner is NaN or beyond
    /// ±2⁵² px.
    #[must_use]
    pub fn new(corners: [Vec2; 3], bounds: Bounds) -> Option<Self> {
        Self::asked_at(corners, bounds, [[0; 2]; 2])
    }

    /// The same where a pixel is asked at other places than its centre: at any from the lower left to the upper
    /// right one of these two, in 1/256 px from the centre, at most half a pixel away.
    // ANCHOR: new
    #[must_use]
    pub fn asked_at(corners: [Vec2; 3], bounds: Bounds, places: [[i64; 2]; 2]) -> Option<Self> {
        // NaN is within no limit.
        let within = |limit: f32| corners.iter().all(|corner| corner.abs().cmple(Vec2::splat(limit)).all());
        if !within(WIDE) {
            return None;
        }
        let wide = !within(NARROW);
        let [a, b, c] = corners.map(snap);
        let bounds = box_of([a, b, c], places, bounds);
        // Far from the triangle no bound on the numbers holds.
        if bounds.max.cmplt(bounds.min).any() {
            return None;
        }
        let area = cross(a, b, c, wide);
        if area == 0.0 {
            return None;
        }
        // ANCHOR: sides
        // Clockwise corners make the same sides, walked in the other direction.
        let turn = area.signum();
        let along = |axis: usize| {
            let [a, b, c] = [a[axis], b[axis], c[axis]];
            DVec3::new((c - b) as f64, (a - c) as f64, (b - a) as f64) * turn
        };
        let (along_x, along_y) = (along(0), along(1));
        // A side that goes down is a left one, one that goes left a top one.
        let top_left = along_y.cmplt(DVec3::ZERO) | (along_y.cmpeq(DVec3::ZERO) & along_x.cmplt(DVec3::ZERO));
        let inside = DVec3::select(top_left, DVec3::ZERO, DVec3::ONE);
        // ANCHOR_END: sides
        Some(Self {
            bounds,
            edges: edges([a, b, c], center(bounds.min.x.into(), bounds.min.y), wide) * turn,
            right: along_y * -SUBPIXELS as f64,
            up: along_x * SUBPIXELS as f64,
            inside,
            per_area: 1.0 / area.abs(),
            corners: [a, b, c],
            turn,
            wide,
        })
    }
    // ANCHOR_END: new

    /// Whether some side is too long for `f64`, so that an edge function is to be asked for by itself at each point.
    #[inline]
    #[must_use]
    pub fn is_wide(&self) -> bool {
        self.wide
    }

    /// The covered pixels of a row.
    #[inline]
    #[must_use]
    pub fn row(&self, y: i32) -> Row {
        let rows = i64::from(y) - i64::from(self.bounds.min.y);
        self.span(y, self.edges + self.up * rows as f64)
    }

    /// The pixels of a row that are covered at a place, in 1/256 px from their centres: one of those that the
    /// triangle was made ready for.
    #[inline(always)]
    #[must_use]
    pub fn row_at(&self, y: i32, place: [i64; 2]) -> Range<i64> {
        if self.wide {
            return self.wide_row(y, place).pixels;
        }
        let rows = i64::from(y) - i64::from(self.bounds.min.y);
        let (first, last) = self.ends(self.edges + self.offset(place) + self.up * rows as f64);
        let left = i64::from(self.bounds.min.x);
        left + first..left + last + 1
    }

    /// What a place in a pixel, in 1/256 px from its centre, adds to the edge functions there.
    #[inline]
    #[must_use]
    pub fn offset(&self, [x, y]: [i64; 2]) -> DVec3 {
        (self.right * x as f64 + self.up * y as f64) / SUBPIXELS as f64
    }

    /// The covered pixels of a row, from the edge functions at its first pixel in the bounds.
    // ANCHOR: row
    #[inline(always)]
    fn span(&self, y: i32, start: DVec3) -> Row {
        if self.wide {
            return self.wide_row(y, [0; 2]);
        }
        let (first, last) = self.ends(start);
        let left = i64::from(self.bounds.min.x);
        Row { pixels: left + first..left + last + 1, edges: start + self.right * first as f64 }
    }

    /// The first and the last covered pixel of such a row, counted from its first one.
    #[inline(always)]
    fn ends(&self, start: DVec3) -> (i64, i64) {
        let margins = start - self.inside;
        let (mut first, mut last) = (0.0, f64::from(self.bounds.max.x) - f64::from(self.bounds.min.x));
        for side in 0..3 {
            narrow(margins[side], self.right[side], &mut first, &mut last);
        }
        // Nothing below 2⁵³ is rounded up to a whole number when it is divided by `right`: it is at least 1/right
        // away from the next one. And where all is above 0, to drop the fraction is to round down.
        (first as i64, last as i64)
    }
    // ANCHOR_END: row

    /// Whether a point, in 1/256 px, is inside; on a side, if it is a top or left one. Exact for points within
    /// ±2¹⁶ px, and for all points if some corner is farther out.
    #[must_use]
    pub fn covers(&self, point: [i64; 2]) -> bool {
        self.at(point).cmpge(self.inside).all()
    }

    /// The edge functions at a point.
    fn at(&self, point: Fixed) -> DVec3 {
        edges(self.corners, point, self.wide) * self.turn
    }

    /// As [`row`](Self::row), for a wide triangle and a place in a pixel: of the pixels next to the ends, as f64 knows
    /// them, each is asked.
    #[cold]
    #[inline(never)]
    fn wide_row(&self, y: i32, place: Fixed) -> Row {
        let [min, max] = [self.bounds.min.x, self.bounds.max.x].map(i64::from);
        let at = |x: i64| {
            let center = center(x, y);
            [center[0] + place[0], center[1] + place[1]]
        };
        let (first, last) = self.ends(self.at(at(min)));
        let mut first = min + first.clamp(1, max - min + 1) - 1;
        let mut last = max.min(min + last + 1);
        let covered = |x| self.covers(at(x));
        while first <= last && !covered(first) {
            first += 1;
        }
        while first <= last && !covered(last) {
            last -= 1;
        }
        // Each addition along the row rounds by at most half an epsilon of the whole area: with so much more at its
        // start no weight ends below 0.
        let rounding = (last - first + 2) as f64 * f64::EPSILON / self.per_area;
        Row { pixels: first..last + 1, edges: self.at(at(first)) + rounding }
    }
}

/// The nearest point of the grid of 1/256 px, in these; a tie goes to the even one, what is beyond ±2⁵⁵ px there. Multiplying by a
/// power of 2 rounds nothing.
// ANCHOR: snap
#[inline]
#[must_use]
pub fn snap(corner: Vec2) -> [i64; 2] {
    corner.to_array().map(|coordinate| (coordinate * SUBPIXELS as f32).round_ties_even() as i64)
}
// ANCHOR_END: snap

/// The pixels of `bounds` one of whose places, counted from their centres, may lie in the box about the corners.
fn box_of([a, b, c]: [Fixed; 3], places: [Fixed; 2], bounds: Bounds) -> Bounds {
    let half = SUBPIXELS / 2;
    let inside = |axis: usize, min: i32, max: i32| {
        let [low, high] = [a[axis].min(b[axis]).min(c[axis]), a[axis].max(b[axis]).max(c[axis])];
        let [left, right] = places.map(|place| half + place[axis]);
        let first = (low - right + SUBPIXELS - 1).div_euclid(SUBPIXELS).max(min.into());
        let last = (high - left).div_euclid(SUBPIXELS).min(max.into());
        // Empty where they have passed each other; else both are within the bounds.
        if first <= last { (first as i32, last as i32) } else { (0, -1) }
    };
    let (x, y) = (inside(0, bounds.min.x, bounds.max.x), inside(1, bounds.min.y, bounds.max.y));
    Bounds { min: IVec2::new(x.0, y.0), max: IVec2::new(x.1, y.1) }
}

/// The centre of a pixel.
fn center(x: i64, y: i32) -> Fixed {
    [x, y.into()].map(|n| n * SUBPIXELS + SUBPIXELS / 2)
}

/// The cross product of the ways from a point to two others.
#[inline]
fn cross(from: Fixed, to: Fixed, point: Fixed, wide: bool) -> f64 {
    let [ax, ay] = [to[0] - from[0], to[1] - from[1]];
    let [bx, by] = [point[0] - from[0], point[1] - from[1]];
    if wide { wide_cross([ax, ay], [bx, by]) } else { ax as f64 * by as f64 - ay as f64 * bx as f64 }
}

#[cold]
#[inline(never)]
fn wide_cross(a: Fixed, b: Fixed) -> f64 {
    let [ax, ay, bx, by] = [a[0], a[1], b[0], b[1]].map(i128::from);
    (ax * by - ay * bx) as f64
}

/// The edge functions at a point, each at the place of the corner opposite to its side.
#[inline]
fn edges([a, b, c]: [Fixed; 3], point: Fixed, wide: bool) -> DVec3 {
    DVec3::new(cross(b, c, point, wide), cross(c, a, point, wide), cross(a, b, point, wide))
}

/// Cuts a row's pixels from `first` to `last` down to those on the inner side, where `margin` is what the edge
/// function at pixel 0 has more than it needs, and `right` what a step adds.
// ANCHOR: narrow
#[inline]
fn narrow(margin: f64, right: f64, first: &mut f64, last: &mut f64) {
    if right > 0.0 {
        let bound = (right - 1.0 - margin) / right;
        if bound > *first {
            *first = bound;
        }
    } else if margin < 0.0 {
        *last = -1.0;
    } else if right < 0.0 {
        let bound = margin / -right;
        if bound < *last {
            *last = bound;
        }
    }
}
// ANCHOR_END: narrow

#[cfg(test)]
mod tests {
    use super::*;

    /// A corner half-way between two points of the grid goes to the even one, in either direction.
    #[test]
    fn ties_go_to_the_even_point() {
        let halves = |n: f32| n / 512.0;
        let snapped = |x, y| snap(Vec2::new(halves(x), halves(y)));
        assert_eq!([snapped(1.0, 3.0), snapped(-1.0, -3.0), snapped(5.0, 7.0)], [[0, 2], [0, -2], [2, 4]]);
    }
}
