//! The slides' first two attempts (sections *Dessiner un triangle* and *line sweeping*). Their corners are
//! whole pixels, so real ones are rounded first.

use common::{Bounds, IVec2, Vec2, Vec3};

use crate::barycentric::weights;

/// Visits the pixels of the three sides. Their weights are those of the pixels' centres, of which some lie
/// outside the triangle: there a weight is below 0. A triangle without area has no weights and no outline.
// ANCHOR: outline
pub fn outline(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    let [a, b, c] = corners.map(to_pixel);
    for (from, to) in [(a, b), (b, c), (c, a)] {
        lines::bresenham(from, to, bounds, |x, y, _| {
            if let Some(weights) = weights(corners, center(x, y)) {
                visit(x, y, weights);
            }
        });
    }
}
// ANCHOR_END: outline

/// Cuts the triangle in two at the height of its middle corner and fills each half with horizontal lines.
///
/// The row of the middle corner belongs to both halves and is visited twice.
// ANCHOR: sweep
pub fn sweep(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, Vec3)) {
    let mut sorted = corners.map(to_pixel);
    sorted.sort_by_key(|corner| corner.y);
    let [low, middle, high] = sorted;
    for half in [[low, middle], [middle, high]] {
        between_sides(half, [low, high], bounds, |x, y| {
            if let Some(weights) = weights(corners, center(x, y)) {
                visit(x, y, weights);
            }
        });
    }
}

/// Visits the pixels between two sides, in the rows of the first one. A horizontal one bounds nothing.
fn between_sides(short: [IVec2; 2], long: [IVec2; 2], bounds: Bounds, mut visit: impl FnMut(i32, i32)) {
    if short[0].y == short[1].y {
        return;
    }
    for y in short[0].y.max(bounds.min.y)..=short[1].y.min(bounds.max.y) {
        let [from, to] = [short, long].map(|[low, high]| {
            let t = (y as f32 - low.y as f32) / (high.y as f32 - low.y as f32);
            (low.x as f32 + t * (high.x as f32 - low.x as f32)) as i32
        });
        for x in from.min(to).max(bounds.min.x)..=from.max(to).min(bounds.max.x) {
            visit(x, y);
        }
    }
}
// ANCHOR_END: sweep

/// The pixel whose bottom-left corner is nearest: the slides' whole numbers stay what they are.
fn to_pixel(corner: Vec2) -> IVec2 {
    corner.round().as_ivec2()
}

fn center(x: i32, y: i32) -> Vec2 {
    Vec2::new(x as f32 + 0.5, y as f32 + 0.5)
}
