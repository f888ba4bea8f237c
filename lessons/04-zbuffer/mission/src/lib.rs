//! Mission 4: the nearest surface.
//!
//! Write the bodies of [`fill_nearest`] and [`z_f32`], then see what is right: `cargo run -p my-zbuffer`.
//!
//! What you need:
//!
//! - [`triangles::fill`]`(corners: [Vec2; 3], bounds: Bounds, visit)` calls `visit(x: i32, y: i32, weights: Vec3)` for
//!   each pixel of a triangle.
//! - A [`DepthBuffer`]`<D>` keeps a depth of type `D` for each pixel: `depths.get(x, y)` is one,
//!   `depths.set(x, y, depth)` keeps one, `depths.bounds()` are its pixels, and `DepthBuffer::new(image, nothing)` makes
//!   one for a picture. A larger depth is nearer; where nothing is drawn yet, it is −∞, `f32::NEG_INFINITY`.
//! - [`Surface`]: `corners: [Vec3; 3]`, x and y in pixels and z the depth, and `color: Color`.
//! - `corners.map(|corner| …)` makes an array of another; `corner.truncate()` is the `Vec2` of x and y;
//!   `Vec3::new(a, b, c).dot(weights)` the sum of three products.

use common::{Image, Vec3};

// Given: the buffer, a triangle with its colour, and from the model to pixels and depth.
pub use zbuffer_given::{DepthBuffer, Surface, to_screen};

/// Calls `visit(x, y, weights)` for each pixel of a triangle that is nearer than what was drawn there, and
/// keeps its depth in the buffer.
///
/// Corners are x and y in pixels and z the depth. `corner.truncate()` is x and y alone. A buffer may keep
/// depths as other numbers than f32: what it keeps of a depth is `store(depth)`. Of equal depths the first one
/// drawn stays.
pub fn fill_nearest<D: Copy + PartialOrd>(
    corners: [Vec3; 3],
    depths: &mut DepthBuffer<D>,
    store: impl Fn(f32) -> D,
    visit: impl FnMut(i32, i32, Vec3),
) {
    let _ = (corners, depths, store, visit);
    todo!(
        "fill the triangle; at each pixel the depth is the sum of the corners' z times their weights: \
         compare, keep, visit"
    );
}

/// Draws surfaces with a buffer of f32, which is returned.
pub fn z_f32(surfaces: &[Surface], image: &mut Image) -> DepthBuffer<f32> {
    let _ = (surfaces, image);
    todo!(
        "make a DepthBuffer::new(image, …) that holds what is farther than anything, and fill_nearest() \
         each surface in its colour"
    );
}
