//! Mission 6: smooth shading.
//!
//! Write the bodies of [`intensities`] and [`gouraud()`], then see what is right: `cargo run -p my-gouraud`.
//!
//! From below come [`textures::texel`], [`textures::interpolate`], [`zbuffer::DepthBuffer`] and
//! [`zbuffer::fill_nearest`].

use common::{Image, Vec3};

// Given: what is drawn, what a drawing leaves behind, and the normals of a model.
pub use gouraud::{Drawn, Scene, corner_normals};

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
/// what faces away is black. `scene.normals[n]` are the normals of triangle n. `scene.wrap` is `Clamp` here, which
/// is what `texel` does.
pub fn gouraud(scene: &Scene, image: &mut Image, place: impl Fn(Vec3) -> Option<Vec3>) -> Drawn {
    let _ = (scene, image, place);
    todo!(
        "as in lesson 5, but with an intensity at each corner: interpolate it by the weights, and clamp it \
         at 0 only then"
    );
}
