//! Mission 6: smooth shading.
//!
//! Write the bodies of [`intensities`] and [`gouraud()`], then see what is right: `cargo run -p my-gouraud`.
//!
//! What you need:
//!
//! - [`Scene`]: `model`, `normals` (of triangle n, `scene.normals[n]: [Vec3; 3]`), `texture: &Image`, `light: Vec3`, which is
//!   1 long. [`Drawn`]: `depths: DepthBuffer<f32>`, `left_out: usize`.
//! - `model.faces()` and `model.face_uvs()`: iterators over `[Vec3; 3]` and `[Vec2; 3]`; `zip` makes pairs of two,
//!   `enumerate` numbers them.
//! - [`textures::texel`]`(texture: &Image, uv: Vec2) -> Color`,
//!   [`textures::interpolate`]`(uvs: [Vec2; 3], weights: Vec3) -> Vec2`, `color.shaded(intensity: f32)`.
//! - [`zbuffer::fill_nearest`]`(corners: [Vec3; 3], depths: &mut DepthBuffer<f32>, store, visit)` and
//!   [`DepthBuffer`], as in lesson 5.
//! - `Vec3::from_array([a, b, c])`, `a.dot(b)`; `let [Some(a), Some(b), Some(c)] = … else { … };` takes three values out, or
//!   does what stands behind `else` where one is missing.

use common::{Image, Vec3};
use zbuffer::DepthBuffer;

// Given: what is drawn, what a drawing leaves behind, and the normals of a model.
pub use gouraud_given::{Drawn, Scene, corner_normals};

/// The brightness at three corners: the cosine of the angle between normal and light, below 0 in the dark.
#[must_use]
pub fn intensities(normals: [Vec3; 3], light: Vec3) -> Vec3 {
    let _ = (normals, light);
    todo!("a dot product for each normal; do not clamp them here, since the dark corners count, too");
}

/// Draws a textured scene with the brightness interpolated between the corners.
///
/// `place` puts a point of the model into the picture (x and y in pixels, z the depth) or nowhere: a triangle
/// with a corner without a place is left out, and counted in [`Drawn::left_out`]. Nothing else is left out:
/// what faces away is black. `scene.normals[n]` are the normals of triangle n.
pub fn gouraud(
    scene: &Scene,
    image: &mut Image,
    place: impl Fn(Vec3) -> Option<Vec3>,
) -> Drawn<DepthBuffer<f32>> {
    let _ = (scene, image, place);
    todo!(
        "as in lesson 5, but with an intensity at each corner: interpolate it by the weights, and clamp it \
         at 0 only then"
    );
}
