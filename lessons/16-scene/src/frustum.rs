//! What is in the picture, and how large, told by spheres.

use common::{Mat4, Vec2, Vec3};

/// A sphere in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its middle.
    pub center: Vec3,
    /// Its radius, not negative.
    pub radius: f32,
}

/// Whether some of a sphere may be in the picture.
#[must_use]
pub fn sees(_to_clip: &Mat4, _sphere: &Sphere) -> bool {
    true
}

/// At most so many pixels is a unit of the world within that sphere, in a picture of that size.
#[must_use]
pub fn pixels_per_unit(_to_clip: &Mat4, _sphere: &Sphere, _size: Vec2) -> f32 {
    f32::INFINITY
}
