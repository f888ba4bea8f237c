//! Mission 13: a texture without flicker.
//!
//! Write the bodies of [`bilinear`] and [`level`], then see what is right: `cargo run -p my-filtering`.
//!
//! What you need:
//!
//! - `texels.width()`, `texels.height()`, and `texels.light(i, j)` for the light, a `Vec3`, of the texel in column i and row j.
//! - `wrap.texel(i, n)`: which of n texels in a row stands for texel i, where i is below 0, or n or more.
//! - `x.floor()` is the whole number not above x; `x as i32` cuts off what is behind the point, and so is above x where x
//!   is below 0. `i as f32` goes the other way.
//! - `a + (b - a) * t` of two vectors; `a * b` of two vectors, number by number; `v.length()`.
//! - `x.max(y)`, `x.log2()`. `0.0_f32.log2()` is minus infinity.

use common::{Vec2, Vec3};

// Given: the texels, what stands for those outside, and a floor that is drawn with your two functions.
pub use filtering_given::{Footprint, Level, Wrap, color, floor, levels};

/// The light of a texture at (u, v), linear between the centres of its texels, in u and in v.
///
/// The texture reaches from 0 to 1, whatever its width and height. At the centre of a texel there is the light of that one
/// alone, in the middle of four centres the mean of the four. Texels beyond the border are those that `wrap` says.
#[must_use]
pub fn bilinear(texels: &Level, uv: Vec2, wrap: Wrap) -> Vec3 {
    let _ = (texels, uv, wrap);
    todo!(
        "the four texels between whose centres (u, v) lies, and how far it is from the first to the last, in u and in v"
    )
}

/// The level of a texture of that size, in texels, in which a footprint is one texel long: 0 for the texture itself, 1 where
/// texels are twice as large, 2 where they are four times as large, and any number between and beyond.
///
/// A footprint is as long as the longer of its two sides.
#[must_use]
pub fn level(footprint: Footprint, size: Vec2) -> f32 {
    let _ = (footprint, size);
    todo!("both sides in texels, the longer one, and how often 1 must be doubled for that")
}
