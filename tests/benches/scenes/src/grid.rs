//! The picture in triangles of one size, each pixel in just one of them: what a triangle costs when the number of pixels
//! is always the same.

use common::{Vec2, Vec3};

use crate::stage::{Corner, Stage};
use crate::{FULL, Scene};

/// A surface that fills the picture, in a grid whose fields are about square, each two triangles of about that many
/// pixels. Corners are shared.
#[must_use]
pub fn grid(area: f32) -> Scene {
    let size = Vec2::new(FULL[0].into(), FULL[1].into());
    let [columns, rows] = (size / (2.0 * area).sqrt()).round().max(Vec2::ONE).to_array().map(|n| n as u32);
    let mut stage = Stage::default();
    for row in 0..=rows {
        for column in 0..=columns {
            let share = Vec2::new(column as f32 / columns as f32, row as f32 / rows as f32);
            stage.corners.push(corner(share, size));
        }
    }
    let number = |column: u32, row: u32| row * (columns + 1) + column;
    for row in 0..rows {
        for column in 0..columns {
            let [a, b] = [number(column, row), number(column + 1, row)];
            let [d, c] = [number(column, row + 1), number(column + 1, row + 1)];
            stage.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    stage.scene()
}

/// The corner at that share of the picture's sides: of a plane that is nearer at the bottom, and shaded as if it were
/// bent.
fn corner(share: Vec2, size: Vec2) -> Corner {
    Corner {
        at: share * size,
        inverse_depth: 0.4 - 0.2 * share.y,
        uv: share,
        normal: Vec3::new(share.x - 0.5, share.y - 0.5, 1.0),
    }
}
