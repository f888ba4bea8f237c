//! Small triangles anywhere: what a triangle costs, and what it costs to jump about in memory.

use common::{Vec2, Vec3};
use fastrand::Rng;

use crate::stage::{Corner, Stage};
use crate::{FULL, Scene};

/// So many triangles with equal sides and an area of so many pixels, each with corners of its own: turned in any
/// direction, anywhere in the picture, at any depth, in no order.
#[must_use]
pub fn soup(count: u32, area: f32) -> Scene {
    let size = Vec2::new(FULL[0].into(), FULL[1].into());
    let radius = (4.0 * area / 27f32.sqrt()).sqrt();
    let mut random = Rng::with_seed(17);
    let mut stage = Stage::default();
    for n in 0..count {
        let direction = direction(&mut random);
        let middle = Vec2::new(random.f32(), random.f32()) * (size - 2.0 * radius) + radius;
        let inverse_depth = 0.1 + 0.4 * random.f32();
        let corner = |turned: Vec2| Corner {
            at: middle + radius * turned,
            // One corner's depth differs from another's, by up to a hundredth.
            inverse_depth: inverse_depth * (1.0 + 0.005 * turned.y),
            uv: (middle + radius * turned) / size,
            normal: Vec3::new(turned.x, turned.y, 2.0),
        };
        stage.corners.extend([direction, turned(direction), turned(turned(direction))].map(corner));
        stage.triangles.push([3 * n, 3 * n + 1, 3 * n + 2]);
    }
    stage.scene()
}

/// A unit vector in any direction, all alike: of the points in a square one that lies in the circle, and not at its centre.
/// There are no sines in it, which platforms round differently.
fn direction(random: &mut Rng) -> Vec2 {
    loop {
        let point = 2.0 * Vec2::new(random.f32(), random.f32()) - 1.0;
        if (0.01..1.0).contains(&point.length_squared()) {
            return point.normalize();
        }
    }
}

/// A vector turned by 120° to the left.
fn turned(vector: Vec2) -> Vec2 {
    let (cos, sin) = (-0.5, 0.75f32.sqrt());
    Vec2::new(cos * vector.x - sin * vector.y, sin * vector.x + cos * vector.y)
}
