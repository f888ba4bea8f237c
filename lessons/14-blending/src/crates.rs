//! The lesson's own scene, version 8 of the assignment: a large opaque crate, and a smaller one at half alpha before it.

use common::Vec3;
use filtering::scene::Filterable;
use transforms::affine::model;

use crate::scene::Entity;

/// The model of a crate, and its wood.
pub const CRATE: [&str; 2] = [
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/cube.obj"),
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/crate.png"),
];

/// Where the large one stands, how it is turned, in degrees, and how large it is.
const LARGE: [Vec3; 3] = [Vec3::new(-0.12, 0.02, -0.4), Vec3::new(0.0, -26.0, 0.0), Vec3::splat(1.74)];

/// The same of the small one.
const SMALL: [Vec3; 3] = [Vec3::new(0.36, 0.2, 1.15), Vec3::new(26.0, 42.0, 0.0), Vec3::splat(0.62)];

/// The two, as entities of one model.
#[must_use]
pub fn entities(crate_: &Filterable) -> [Entity<'_>; 2] {
    let place = |[at, degrees, size]: [Vec3; 3]| model(at, degrees, size);
    [(LARGE, 1.0), (SMALL, 0.5)].map(|(at, alpha)| Entity { model: crate_, to_world: place(at), alpha })
}
