//! The versions of the assignment, one after the other, as data and small functions.

mod all;
mod crates;
mod first;

use common::{Mat4, Vec2, Vec3, Vec4};
use perspective::perspective;

use crate::keys::Key;
use crate::orbit::Orbit;
use crate::scene::Scene;
use crate::version_11;

/// A version: what is seen, from where, and which keys there are.
pub struct Version {
    /// Its number.
    pub number: u8,
    /// What it shows, in a line.
    pub what: &'static str,
    /// From eye space to clip space, for a picture of that size.
    pub projection: fn(Vec2) -> Mat4,
    /// The scene, its spheres of those sizes.
    pub scene: fn(&[[usize; 2]]) -> anyhow::Result<Scene>,
    /// Brings the scene to a time, in seconds from its beginning; none where nothing moves.
    pub animate: Option<fn(&mut Scene, f64)>,
    /// Where the camera is at first, if it can move; else it stays at the origin and looks along −z.
    pub camera: Option<Orbit>,
    /// Whether F1 switches to the sides of triangles, and back.
    pub wireframe: bool,
    /// Whether edges are smooth, and F2 switches to rough ones and back.
    pub antialiasing: bool,
}

impl Version {
    /// Whether there is such a key yet.
    #[must_use]
    pub fn has(&self, key: Key) -> bool {
        match key {
            Key::Escape => true,
            Key::F1 => self.wireframe,
            Key::F2 => self.antialiasing,
            Key::Left | Key::Right | Key::Up | Key::Down | Key::W | Key::S => self.camera.is_some(),
        }
    }
}

/// All of them, by their numbers. The last is the course's own.
pub const VERSIONS: &[Version] = &[
    first::WHITE,
    first::COLORS,
    first::DEPTH,
    first::PHONG,
    first::BLINN_PHONG,
    first::PERSPECTIVE,
    crates::TEXTURE,
    crates::WIREFRAME,
    crates::BLENDING,
    all::CAMERA,
    all::ANTIALIASING,
    version_11::VERSION,
];

// ANCHOR: ours
/// Where something stands, and how it is turned, of which the assignment says where and how.
///
/// Its z axis points away from the eye, ours towards it: each of its points (x, y, z) is our (x, y, −z). With the matrix
/// Z = diag(1, 1, −1) a point p is our Z·p, and what its matrix M does to points ours does if it is Z·M·Z: so z changes its
/// sign in a move, and turns about x and y, but not about z, change theirs. A mirror turns the order of corners round, so a
/// mesh is not mirrored but made anew, with the order that faces outwards here: a cube and a sphere are their own mirror
/// images.
#[must_use]
pub fn ours(position: Vec3, degrees: Vec3) -> (Vec3, Vec3) {
    (position * Vec3::new(1.0, 1.0, -1.0), degrees * Vec3::new(-1.0, -1.0, 1.0))
}
// ANCHOR_END: ours

/// How far the planes of [`orthographic`] are from the eye.
const ORTHOGRAPHIC_FAR: f32 = 4.0;

// ANCHOR: orthographic
/// The assignment's first projection: x/5 and y/5, which bring ±5 to the borders of the picture, whatever its size. Depths
/// from 0 to 4 are seen.
#[must_use]
pub fn orthographic(_size: Vec2) -> Mat4 {
    Mat4::from_cols(
        Vec4::new(1.0 / 5.0, 0.0, 0.0, 0.0),
        Vec4::new(0.0, 1.0 / 5.0, 0.0, 0.0),
        Vec4::new(0.0, 0.0, -2.0 / ORTHOGRAPHIC_FAR, 0.0),
        Vec4::new(0.0, 0.0, -1.0, 1.0),
    )
}
// ANCHOR_END: orthographic

/// What a camera sees that looks so many degrees from bottom to top, in a picture of that size: from 0.1 to 100 before it.
///
/// # Panics
/// Where the picture has no width or height, or as many degrees make none.
#[must_use]
pub fn in_perspective(fov: f32, size: Vec2) -> Mat4 {
    perspective(fov, size.x / size.y, 0.1, 100.0).expect("a picture has a width and a height")
}

/// The angle, in degrees, after so many seconds at that many degrees a second.
fn turned(degrees_a_second: f64, seconds: f64) -> f32 {
    (degrees_a_second * seconds % 360.0) as f32
}

#[cfg(test)]
mod tests {
    use common::{Color, IVec2};
    use perspective::window;
    use transforms::affine::model;
    use transforms::scale;

    use super::*;

    /// Z·M·Z, of any move, turn and scale.
    #[test]
    fn what_the_assignments_matrix_does_ours_does_seen_in_a_mirror() {
        let mirror = scale(Vec3::new(1.0, 1.0, -1.0));
        for n in 0..200 {
            let number = |k: u64| f32::from(Color::random(10 * n + k).r) / 16.0 - 8.0;
            let [position, degrees, size] =
                [0, 3, 6].map(|k| Vec3::new(number(k), number(k + 1), number(k + 2)));
            let theirs = model(position, 20.0 * degrees, size);
            let (position, degrees) = ours(position, 20.0 * degrees);
            let ours = model(position, degrees, size);
            assert!(ours.abs_diff_eq(mirror * theirs * mirror, 1e-5), "{n}");
        }
    }

    /// The pixel (x/5 + 1)·w/2, h − (y/5 + 1)·h/2, with rows from the top.
    #[test]
    fn the_first_projection_is_the_assignments_formula() {
        let size = Vec2::new(800.0, 600.0);
        let pixel = |x, y, z| {
            let (place, _) = ours(Vec3::new(x, y, z), Vec3::ZERO);
            let window = window(orthographic(size) * place.extend(1.0), size).unwrap();
            IVec2::new(window.x as i32, (size.y - window.y) as i32)
        };
        // The assignment's own two examples, which say z = 0, and its objects' depth.
        for z in [0.0, 2.0] {
            assert_eq!(pixel(-5.0, 5.0, z), IVec2::ZERO);
            assert_eq!(pixel(0.0, 0.0, z), IVec2::new(400, 300));
            assert_eq!(pixel(2.5, -2.5, z), IVec2::new(600, 450));
        }
    }

    #[test]
    fn versions_stand_in_order_and_keep_the_keys_that_they_have() {
        let mut before = 0;
        for (n, version) in (0..).zip(VERSIONS) {
            assert_eq!(version.number, n);
            let keys = [Key::F1, Key::W, Key::F2].map(|key| u32::from(version.has(key))).iter().sum();
            assert!(keys >= before && version.has(Key::Escape), "{n}");
            before = keys;
        }
        assert_eq!((VERSIONS.len(), before), (12, 3));
    }
}
