//! All of mission 3.
use common::{Bounds, Vec2, Vec3};

/// A point, in f64: what follows is exact for corners in 1/256 px.
type Point = [f64; 2];

/// Twice the area of a triangle, below 0 if it is clockwise.
fn doubled_area([a, b, c]: [Point; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether a point of that weight is inside a side: counterclockwise and y up, a left one goes down and a top one
/// to the left.
fn is_inside([from, to]: [Point; 2], weight: f64) -> bool {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    weight > 0.0 || weight == 0.0 && (dy < 0.0 || dy == 0.0 && dx < 0.0)
}

/// Edge functions.
pub fn fill(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    let [min, max] = [Vec2::min, Vec2::max].map(|of| corners.into_iter().reduce(of).unwrap_or_default());
    let (min, max) = (min.floor().as_ivec2().max(bounds.min), max.ceil().as_ivec2().min(bounds.max));
    let [a, mut b, mut c] =
        corners.map(|corner| corner.to_array().map(|n| (f64::from(n) * 256.0).round() / 256.0));
    let clockwise = doubled_area([a, b, c]) < 0.0;
    if clockwise {
        (b, c) = (c, b);
    }
    let area = doubled_area([a, b, c]);
    for y in min.y..=max.y {
        for x in min.x..=max.x {
            let p = [f64::from(x) + 0.5, f64::from(y) + 0.5];
            let sides = [[b, c], [c, a], [a, b]];
            let weights = sides.map(|[from, to]| doubled_area([from, to, p]));
            if area > 0.0 && sides.into_iter().zip(weights).all(|(side, weight)| is_inside(side, weight)) {
                let [u, v, w] = weights.map(|weight| (weight / area) as f32);
                visit(x, y, if clockwise { Vec3::new(u, w, v) } else { Vec3::new(u, v, w) });
            }
        }
    }
}

/// The cosine between normal and light.
pub fn flat_intensity([a, b, c]: [Vec3; 3], light: Vec3) -> f32 {
    (b - a).cross(c - a).normalize_or_zero().dot(light)
}
