//! Layers that fill the picture, one behind the other: how often a pixel is drawn, and how often it is for nothing.
//!
//! Parallel to the picture, they are kind to whoever keeps the nearest and the farthest depth of a piece of it: each layer
//! has one depth. Tilted, each towards another side, neighbours pass through each other, and their depths overlap.

use common::{Vec2, Vec3};
use fastrand::Rng;

use crate::stage::{Corner, Stage};
use crate::{FULL, Scene};

/// How far tilted layers reach at the picture's borders towards each side, in steps from one layer to the next.
pub const TILT: f32 = 1.5;

/// One over the depths of the nearest layer and the farthest.
const REACH: [f32; 2] = [0.5, 0.1];

/// So many layers, the nearest drawn first.
#[must_use]
pub fn front(count: u16, tilt: f32) -> Scene {
    stage(count, tilt, (0..count).collect())
}

/// So many layers, the farthest drawn first.
#[must_use]
pub fn back(count: u16, tilt: f32) -> Scene {
    stage(count, tilt, (0..count).rev().collect())
}

fn stage(count: u16, tilt: f32, order: Vec<u16>) -> Scene {
    let mut random = Rng::with_seed(17);
    let step = (REACH[1] - REACH[0]) / f32::from(count - 1);
    let tilts: Vec<Vec2> = (0..count)
        .map(|_| Vec2::new(random.f32(), random.f32()) * 2.0 - 1.0)
        .map(|direction| direction * tilt * step)
        .collect();
    let mut stage = Stage::default();
    for n in order {
        let layer =
            |side: Vec2| corner(n, REACH[0] + step * f32::from(n) + side.dot(tilts[usize::from(n)]), side);
        let sides = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        stage.add_square(sides.map(Vec2::from).map(layer));
    }
    stage.scene()
}

/// The corner of layer `n` on that side of the picture, a pixel beyond its border. Of neighbours each shows the whole
/// texture another way round.
fn corner(n: u16, inverse_depth: f32, side: Vec2) -> Corner {
    let size = Vec2::new(FULL[0].into(), FULL[1].into());
    let around = [Vec2::new(1.0, 1.0), Vec2::new(-1.0, 1.0), Vec2::new(1.0, -1.0), Vec2::new(-1.0, -1.0)];
    Corner {
        at: (side + 1.0) / 2.0 * size + side,
        inverse_depth,
        uv: (side * around[usize::from(n % 4)] + 1.0) / 2.0,
        normal: Vec3::new(0.5 * side.x, 0.5 * side.y, 1.0),
    }
}
