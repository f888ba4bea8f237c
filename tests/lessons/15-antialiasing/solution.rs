//! All of mission 15.
use common::{Color, IVec2, Vec2};

pub use antialiasing_given::{Side, draw, pattern, sides};

/// A bit for each sample that is inside of all sides.
pub fn coverage(corners: [Vec2; 3], pixel: IVec2, pattern: &[[i32; 2]]) -> u32 {
    let Some(sides) = sides(corners) else { return 0 };
    let mut mask = 0;
    for (s, place) in pattern.iter().enumerate() {
        let point = [0, 1].map(|axis| i64::from(pixel[axis]) * 256 + i64::from(place[axis]) * 16);
        let inside = |side: &Side| {
            let edge = side.edge(point);
            edge > 0 || edge == 0 && side.top_left
        };
        if sides.iter().all(inside) {
            mask |= 1 << s;
        }
    }
    mask
}

/// Sums, and one division for each.
pub fn resolve(samples: &[Color]) -> Color {
    let count = samples.len() as u32;
    let mean = |channel: fn(&Color) -> u8| {
        let sum: u32 = samples.iter().map(|sample| u32::from(channel(sample))).sum();
        ((sum + count / 2) / count) as u8
    };
    Color { r: mean(|c| c.r), g: mean(|c| c.g), b: mean(|c| c.b), a: mean(|c| c.a) }
}
