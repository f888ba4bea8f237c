//! All of mission 13.
use common::{Vec2, Vec3};

pub use filtering_given::{Footprint, Level, Wrap, color, floor, levels};

/// Linear between four centres.
pub fn bilinear(texels: &Level, uv: Vec2, wrap: Wrap) -> Vec3 {
    let (width, height) = (texels.width(), texels.height());
    let place = uv * Vec2::new(width as f32, height as f32) - 0.5;
    let corner = place.floor();
    let share = place - corner;
    let (i, j) = (corner.x as i32, corner.y as i32);
    let light = |i: i32, j: i32| texels.light(wrap.texel(i, width), wrap.texel(j, height));
    let below = light(i, j) + (light(i + 1, j) - light(i, j)) * share.x;
    let above = light(i, j + 1) + (light(i + 1, j + 1) - light(i, j + 1)) * share.x;
    below + (above - below) * share.y
}

/// The logarithm of the longer side in texels.
pub fn level(footprint: Footprint, size: Vec2) -> f32 {
    let [x, y] = [footprint.x, footprint.y].map(|side| (side * size).length());
    x.max(y).log2()
}
