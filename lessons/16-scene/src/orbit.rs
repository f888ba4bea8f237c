//! A camera that circles the origin.

use common::{Mat4, Vec3};
use transforms::affine::{rotate_x, rotate_y, translate};

/// Where a camera is that looks at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// How far it has gone to the right around the y axis, in degrees; at 0 it is on the z axis.
    pub azimuth: f32,
    /// How far it has risen above the plane of x and z, in degrees.
    pub elevation: f32,
    /// How far it is from the origin.
    pub distance: f32,
}

impl Orbit {
    /// The camera's own matrix; see [`orbit`].
    #[must_use]
    pub fn camera(&self) -> Mat4 {
        orbit(self.azimuth, self.elevation, self.distance)
    }
}

/// The matrix of a camera, from eye space to the world, that looks at the origin from so far, after so many degrees to the
/// right and up.
#[must_use]
pub fn orbit(azimuth: f32, elevation: f32, distance: f32) -> Mat4 {
    let turn = rotate_y(azimuth) * rotate_x(-elevation);
    Mat4::from_mat3(turn) * translate(Vec3::Z * distance)
}
