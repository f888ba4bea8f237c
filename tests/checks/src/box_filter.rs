//! What a pixel would show if it took the mean of all that is seen in its square, in `f64`: no samples, no order of drawing.
//!
//! This is the hidden-surface problem inside of a pixel, solved as E. Catmull put it (*A hidden-surface algorithm with
//! anti-aliasing*, SIGGRAPH 1978): what of the square each triangle shows is its part of the square less all that is nearer.
//! Where two depths are equal is a straight line, so each nearer part is convex: where the points are on the inner side of a
//! few lines. Taking such a part out of a convex polygon leaves convex ones, at most one for each line.

use common::{DVec2, DVec3, Vec2, Vec3};

use crate::coverage::Triangle;

/// A triangle of the window, of one colour.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// Its corners: x and y in px, rounded to 1/256 px as lesson 3 specifies, and the depth z, smaller is nearer.
    pub corners: [Vec3; 3],
    /// Its colour, in whatever is to be averaged.
    pub color: [f64; 3],
}

/// The points where a·x + b·y + c ≥ 0.
type Line = DVec3;

/// Corners of a convex polygon, in order.
type Polygon = Vec<DVec2>;

/// The corners of a pixel's square, which everything is counted from.
const SQUARE: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];

/// A surface prepared: the lines that bound it, and its depth as a function a·x + b·y + c.
struct Prepared {
    sides: [Line; 3],
    depth: DVec3,
}

impl Prepared {
    /// `None` without area. Everything is counted from the pixel (x, y), so that numbers near it are small.
    fn new(surface: &Surface, x: i32, y: i32) -> Option<Self> {
        let origin = [x, y].map(|n| i128::from(n) * 256);
        let corners = Triangle::new(surface.corners.map(|corner| Vec2::new(corner.x, corner.y))).0;
        let [a, b, c] = corners.map(|corner| [corner[0] - origin[0], corner[1] - origin[1]]);
        // Exact before it is rounded, however far the corners.
        let cross = |p: [i128; 2], q: [i128; 2]| p[0] * q[1] - p[1] * q[0];
        let doubled = cross(a, b) + cross(b, c) + cross(c, a);
        let (turn, area) = (doubled.signum() as f64, doubled.abs() as f64 / 65536.0);
        let side = |from: [i128; 2], to: [i128; 2]| {
            let along = |axis: usize| (to[axis] - from[axis]) as f64 / 256.0;
            DVec3::new(-along(1), along(0), cross(from, to) as f64 / 65536.0) * turn
        };
        let sides = [side(b, c), side(c, a), side(a, b)];
        // A side's function is twice the area at the corner opposite to it, and so a corner's weight but for that factor.
        let depths = surface.corners.map(|corner| f64::from(corner.z));
        let rest = [1, 2].map(|n: usize| sides[n] * ((depths[n] - depths[0]) / area));
        let depth = rest[0] + rest[1] + DVec3::new(0.0, 0.0, depths[0]);
        (doubled != 0).then_some(Self { sides, depth })
    }
}

/// The share of the pixel (x, y) in which each surface is seen, from 0 to 1. Of equal depths the first is seen. Off by some
/// 10⁻¹², rounding; of two surfaces in one plane, whose depths differ by rounding, either may be seen
/// unless the depths are all one number.
#[must_use]
pub fn shares(surfaces: &[Surface], x: i32, y: i32) -> Vec<f64> {
    let prepared: Vec<Option<Prepared>> =
        surfaces.iter().map(|surface| Prepared::new(surface, x, y)).collect();
    let others = |n: usize| prepared.iter().enumerate().filter(move |other| other.0 != n);
    let seen = |(n, surface): (usize, &Option<Prepared>)| {
        let Some(surface) = surface else { return 0.0 };
        // The square is cut by the triangle, and not the other way round: its corners are near.
        let mut parts = vec![surface.sides.iter().fold(SQUARE.to_vec(), |part, &line| inner(&part, line))];
        for (m, nearer) in others(n) {
            let Some(Prepared { sides: [p, q, r], depth, .. }) = nearer else { continue };
            let before = surface.depth - depth;
            let lines = [*p, *q, *r, before];
            // Where depths are nowhere different the first is seen, and there is no line between them.
            let lines = match before {
                DVec3::ZERO if m > n => continue,
                DVec3::ZERO => &lines[..3],
                _ => &lines,
            };
            parts = parts.into_iter().flat_map(|part| without(part, lines)).collect();
        }
        parts.iter().map(|part| area(part)).sum()
    };
    prepared.iter().enumerate().map(seen).collect()
}

/// The picture, rows from the bottom: of each pixel the mean of what is seen in it.
#[must_use]
pub fn picture(surfaces: &[Surface], background: [f64; 3], width: i32, height: i32) -> Vec<[f64; 3]> {
    let span = |surface: &Surface, axis: usize| {
        let all = surface.corners.map(|corner| f64::from(corner[axis]));
        // Rounded to 1/256 px a corner may lie farther out by half of that.
        let (low, high) = (all[0].min(all[1]).min(all[2]), all[0].max(all[1]).max(all[2]));
        low - 0.01..=high + 0.01
    };
    let meets = |surface: &Surface, axis: usize, n: i32| {
        let span = span(surface, axis);
        *span.start() < f64::from(n + 1) && *span.end() > f64::from(n)
    };
    let mut picture = Vec::new();
    for y in 0..height {
        let row: Vec<Surface> = surfaces.iter().copied().filter(|surface| meets(surface, 1, y)).collect();
        for x in 0..width {
            let here: Vec<Surface> = row.iter().copied().filter(|surface| meets(surface, 0, x)).collect();
            let shares = shares(&here, x, y);
            let rest = 1.0 - shares.iter().sum::<f64>();
            let color = |channel: usize| {
                let seen = here.iter().zip(&shares).map(|(surface, share)| surface.color[channel] * share);
                seen.sum::<f64>() + background[channel] * rest
            };
            picture.push([0, 1, 2].map(color));
        }
    }
    picture
}

fn value(line: Line, point: DVec2) -> f64 {
    line.dot(point.extend(1.0))
}

/// What of a polygon is on the inner side of a line.
fn inner(polygon: &[DVec2], line: Line) -> Polygon {
    let mut result = Vec::new();
    for (n, &to) in polygon.iter().enumerate() {
        let from = polygon[(n + polygon.len() - 1) % polygon.len()];
        let [before, after] = [from, to].map(|point| value(line, point));
        if (before < 0.0) != (after < 0.0) {
            result.push(from + (to - from) * (before / (before - after)));
        }
        if after >= 0.0 {
            result.push(to);
        }
    }
    result
}

/// What of a polygon is left without the points that are on the inner side of all of some lines.
fn without(mut polygon: Polygon, lines: &[Line]) -> Vec<Polygon> {
    let mut left = Vec::new();
    for &line in lines {
        left.push(inner(&polygon, -line));
        polygon = inner(&polygon, line);
    }
    left.retain(|part| area(part) > 0.0);
    left
}

/// The area of a polygon, from its first corner, near which numbers are small.
fn area(polygon: &[DVec2]) -> f64 {
    let Some(&first) = polygon.first() else { return 0.0 };
    let fan = polygon.windows(2).map(|pair| (pair[0] - first).perp_dot(pair[1] - first));
    fan.sum::<f64>().abs() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::area;

    fn surface(corners: [[f32; 3]; 3]) -> Surface {
        Surface { corners: corners.map(Vec3::from), color: [1.0, 0.5, 0.0] }
    }

    fn are(got: &[f64], expected: &[f64]) {
        let near =
            got.len() == expected.len() && got.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(near, "{got:?}, not {expected:?}");
    }

    /// A triangle that is alone, against the area in rational numbers.
    #[test]
    fn alone_a_surface_shows_its_area() {
        let corners = [(0.3, -1.7), (7.9, 2.2), (2.1, 6.4)];
        for order in [[0, 1, 2], [2, 1, 0]] {
            let corners = order.map(|n: usize| Vec2::from(corners[n]));
            let alone = Surface { corners: corners.map(|corner| corner.extend(0.5)), color: [1.0; 3] };
            let picture = picture(&[alone], [0.0; 3], 9, 7);
            for (n, pixel) in picture.iter().enumerate() {
                let (x, y) = (n as i32 % 9, n as i32 / 9);
                are(pixel, &[area::area(corners, x, y); 3]);
            }
        }
    }

    /// However far the corners, and whatever is near: half of the pixels on a diagonal.
    #[test]
    fn corners_may_be_as_far_as_can_be_counted() {
        let far = 4_503_599_627_370_496.0;
        let half = surface([[-far, -far, 0.5], [far, -far, 0.5], [far, far, 0.5]]);
        are(&shares(&[half], 3, 3), &[0.5]);
        are(&shares(&[half], 3, 2), &[1.0]);
        are(&shares(&[half], 2, 3), &[0.0]);
    }

    #[test]
    fn the_nearer_hides_the_farther_whatever_is_drawn_first() {
        let far = surface([[0.0, 0.0, 0.75], [2.0, 0.0, 0.75], [0.0, 2.0, 0.75]]);
        let near = surface([[0.0, 0.0, 0.5], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]]);
        are(&shares(&[far, near], 0, 0), &[0.875, 0.125]);
        are(&shares(&[near, far], 0, 0), &[0.125, 0.875]);
        // What is behind all the pixel is not seen at all.
        are(
            &shares(&[surface(near.corners.map(|corner| [corner.x, corner.y, 0.9])), far], 0, 0),
            &[0.0, 1.0],
        );
        // Equal depths: the first.
        let level = surface(near.corners.map(|corner| [corner.x, corner.y, 0.75]));
        are(&shares(&[far, level], 0, 0), &[1.0, 0.0]);
        are(&shares(&[level, far], 0, 0), &[0.125, 0.875]);
    }

    #[test]
    fn two_that_meet_share_the_pixel_along_the_line_where_they_do() {
        // Depths x/4 and 1/2 − x/4 + y/8 from the pixel (4, 3) on: equal where x = 1 + y/4; the first is nearer left of it.
        let by = |depth: fn(f32, f32) -> f32| {
            surface(
                [(-16.0, -16.0), (48.0, -16.0), (-16.0, 48.0)].map(|(x, y)| [x, y, depth(x - 4.0, y - 3.0)]),
            )
        };
        let pair = [by(|x, _| x / 4.0), by(|x, y| 0.25 - x / 4.0 + y / 8.0)];
        // In the pixel: x < 1/2 + y/4, whose mean over y is 5/8.
        are(&shares(&pair, 4, 3), &[0.625, 0.375]);
        are(&shares(&[pair[1], pair[0]], 4, 3), &[0.375, 0.625]);
        are(&shares(&pair, 3, 3), &[1.0, 0.0]);
        are(&shares(&pair, 5, 3), &[0.0, 1.0]);
    }

    /// Three that hide each other in a circle: there is no order in which to draw them.
    #[test]
    fn a_cycle_needs_no_order() {
        // Thin bars about the middle of a pixel, each higher at its end than at its beginning.
        let bar = |turn: f64| {
            let (sin, cos) = turn.to_radians().sin_cos();
            let at = |along: f64, across: f64, depth: f32| {
                let [x, y] = [0.5 + along * cos - across * sin, 0.5 + along * sin + across * cos];
                [x as f32, y as f32, depth]
            };
            surface([at(-0.4, -0.2, 0.8), at(0.4, -0.2, 0.2), at(0.0, 0.0, 0.5)])
        };
        let bars = [bar(0.0), bar(120.0), bar(240.0)];
        let mut orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1]].map(|order| {
            let seen = shares(&order.map(|n: usize| bars[n]), 0, 0);
            let mut by_bar = [0.0; 3];
            order.into_iter().zip(seen).for_each(|(n, share)| by_bar[n] = share);
            by_bar
        });
        orders.iter().for_each(|order| are(order, &orders[0]));
        let each = area::area(bars[0].corners.map(Vec3::truncate), 0, 0);
        // Each is hidden in part by the next, and hides in part the one before.
        assert!(
            orders[0].iter_mut().all(|share| *share < each - 1e-3 && *share > each / 2.0),
            "{orders:?} of {each}"
        );
    }

    /// Against 400×400 points a pixel, each seen by itself.
    #[test]
    fn points_close_together_see_the_same() {
        let mut rng = 1_u64;
        let mut number = move || {
            rng = rng.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (rng >> 40) as f32 / (1 << 24) as f32
        };
        for _ in 0..20 {
            let surfaces: Vec<Surface> = (0..6)
                .map(|_| surface([(); 3].map(|()| [3.0 * number() - 1.0, 3.0 * number() - 1.0, number()])))
                .collect();
            let seen = shares(&surfaces, 0, 0);
            let prepared: Vec<_> = surfaces.iter().map(|s| Prepared::new(s, 0, 0).unwrap()).collect();
            let mut counts = [0.0; 6];
            const SIDE: i32 = 400;
            for (i, j) in (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j))) {
                let point = (DVec2::new(i.into(), j.into()) + 0.5) / f64::from(SIDE);
                let inside =
                    |s: &&(usize, &Prepared)| s.1.sides.iter().all(|&side| value(side, point) >= 0.0);
                let all: Vec<_> = prepared.iter().enumerate().collect();
                let nearest = all
                    .iter()
                    .filter(inside)
                    .min_by(|a, b| value(a.1.depth, point).total_cmp(&value(b.1.depth, point)));
                if let Some(&(n, _)) = nearest {
                    counts[n] += 1.0 / f64::from(SIDE * SIDE);
                }
            }
            // An edge passes 400 of the squares about the points, and is off by half of each at most, to either side.
            assert!(seen.iter().zip(counts).all(|(a, b)| (a - b).abs() < 2e-3), "{seen:?} {counts:?}");
        }
    }
}
