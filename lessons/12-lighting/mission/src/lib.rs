//! Mission 12: a point light.
//!
//! Write the body of [`blinn_phong`], then see what is right: `cargo run -p my-lighting`.
//!
//! What you need:
//!
//! - [`PointLight`] has `position: Vec3`, and the numbers `ambient`, `diffuse`, `specular` and `shininess`.
//! - `Reflected { body, highlight }` makes the result of two numbers.
//! - `a - b`, `a + b`, `a.dot(b)` of two vectors; `v.normalize_or_zero()` is `v` made 1 long, and 0 where `v` is 0.
//! - `x.max(0.0)` is the larger of two numbers, `x.powf(e)` is x to the power of e, for x from 0 on.

use common::Vec3;

// Given: the light, the loop over triangles and pixels, and what makes a colour of the result.
pub use lighting_given::{PointLight, Reflected, draw};

/// What is reflected of a light towards an eye, at a point of a surface.
///
/// `body` is the share of the surface's own colour: the light's `ambient`, and of its `diffuse` as much as the cosine of the
/// angle between the normal and the direction to the light. `highlight` is of its `specular` as much as the cosine between
/// the normal and the half-way vector, the direction in the middle between those to the light and to the eye, to the
/// power of its `shininess`. No cosine counts as less than 0.
///
/// Where the light is behind the surface or just at its edge, the cosine to it not above 0, there is ambient light alone.
/// So it is where there is no direction to the light, since it is at the point itself, and where the normal is 0.
///
/// The normal comes from the interpolation between three corners: its direction counts, its length does not.
#[must_use]
pub fn blinn_phong(point: Vec3, normal: Vec3, eye: Vec3, light: &PointLight) -> Reflected {
    let _ = (point, normal, eye, light);
    todo!(
        "three directions from the point, each 1 long: the normal, to the light, to the eye; then the two cosines"
    )
}
