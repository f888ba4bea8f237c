//! A walk around the model: the eye on a circle.

use std::f32::consts::TAU;

use common::Vec3;
use common::direction::unit;
use transforms::rotation::rodrigues;

// ANCHOR: turned
/// Where the eye is after a share of a full turn, to the right, about the centre.
#[must_use]
pub fn turned(eye: Vec3, center: Vec3, up: Vec3, share: f32) -> Vec3 {
    let axis = unit(up).unwrap_or(Vec3::Y);
    center + rodrigues(axis, share * TAU) * (eye - center)
}
// ANCHOR_END: turned
