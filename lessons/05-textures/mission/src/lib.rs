//! Mission 5: colour from a picture.
//!
//! Write the bodies of [`texel`], [`interpolate`] and [`draw_textured`], then see what is right:
//! `cargo run -p my-textures`.
//!
//! What you need:
//!
//! - `texture.get(x: i32, y: i32)`: the colour of a texel, `Some(color)`, or `None` outside;
//!   `option.unwrap_or(Color::BLACK)` is the colour or else black.
//! - `texture.size()`: width and height as a `Vec2`; `uv * texture.size()` multiplies coordinate by coordinate.
//!   `texture.width()`, `texture.height()`: `i32`. `texture.bounds()`: its first and last texel, both included.
//! - `v.floor()`, `v.as_ivec2()`, and `n.max(low).min(high)`, which, unlike `clamp`, does not panic where high < low.
//! - [`triangles::flat_intensity`]`(corners: [Vec3; 3], light: Vec3) -> f32`;
//!   [`zbuffer::to_screen`]`(point: Vec3, size: Vec2) -> Vec3`, pixels and depth.
//! - [`zbuffer::fill_nearest`]`(corners: [Vec3; 3], depths: &mut DepthBuffer<f32>, store, visit)`, with
//!   `|depth| depth` for `store` and `visit(x: i32, y: i32, weights: Vec3)`;
//!   `DepthBuffer::new(image, f32::NEG_INFINITY)` makes the buffer.

use common::{Color, Image, Model, Vec2, Vec3};
use zbuffer::DepthBuffer;

/// The texel that (u, v) is in, or the nearest one outside.
///
/// u goes from 0 at the left to 1 at the right, v from 0 at the bottom to 1 at the top. Texel (i, j) of a
/// texture of w×h covers u from i/w to (i+1)/w: so u = 1 is one too far, and belongs to the last texel. A
/// texture without texels is black.
#[must_use]
pub fn texel(texture: &Image, uv: Vec2) -> Color {
    let _ = (texture, uv);
    todo!("stretch (u, v) to the texture's size, cut off, and clamp to the first and the last texel");
}

/// The mean of three corners' values, each with its weight.
#[must_use]
pub fn interpolate([a, b, c]: [Vec2; 3], weights: Vec3) -> Vec2 {
    let _ = (a, b, c, weights);
    todo!("each corner's value times its weight, summed");
}

/// Draws a model whose colour at (u, v) is `color(uv)`, flat-shaded and with a depth test; what faces away from
/// the light, with an intensity below 0, is left out. Returns the depths.
///
/// `model.faces()` has the corners of each triangle, `model.face_uvs()` their (u, v): `zip` them.
/// `color.shaded(intensity)` is a colour under a light.
pub fn draw_textured(
    model: &Model,
    light: Vec3,
    image: &mut Image,
    color: impl Fn(Vec2) -> Color,
) -> DepthBuffer<f32> {
    let _ = (model, light, image, color);
    todo!("as in lesson 4, but at each pixel interpolate (u, v) by the weights and ask for the colour there");
}
