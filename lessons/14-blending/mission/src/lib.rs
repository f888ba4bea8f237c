//! Mission 14: what happens to a fragment.
//!
//! Write the bodies of [`over`] and [`test`](fn@test), then see what is right: `cargo run -p my-blending`.
//!
//! What you need:
//!
//! - A colour's channels are `color.r`, `color.g`, `color.b` and `color.a`, from 0 to 255; `u32::from(color.r)` is a number
//!   with room for products, and `n as u8` goes back where n is at most 255. `/` between whole numbers drops the rest.
//! - `function.holds(a, b)`: whether "a less b", "a equal b" and so on holds, for a [`Compare`].
//! - `operation.apply(stored, reference)`: what a [`StencilOp`] makes of a stored stencil value.
//! - `a & b` has the bits that both have, `a | b` those that one of them has, `!a` those that a has not.
//! - `Kept { stencil, depth }` makes a new pair, `Kept { depth, ..kept }` one with another depth.

use common::Color;

// Given: comparisons, stencil operations, and a loop over fragments that calls your two functions.
pub use blending_given::{Compare, DepthTest, Kept, Layer, StencilOp, StencilTest, draw};

/// A translucent colour over another one.
///
/// `source.a` is the share of the source in 255ths, and the rest is the destination's: for red, green and blue. The result's
/// alpha is what the two cover together: all of the source's, and as large a share of the destination's as the source leaves
/// free. Each channel is the exact number rounded to the nearest whole one.
#[must_use]
pub fn over(source: Color, destination: Color) -> Color {
    let _ = (source, destination);
    todo!(
        "a weighted sum of two channels, divided by 255 and rounded; alpha with other weights than the colours"
    )
}

/// The stencil test and then the depth test of one fragment: whether it passes both, and what is kept at its pixel afterwards.
///
/// The stencil test compares the reference with what is kept, of both only the bits in `read_mask`: "reference less kept" for
/// [`Compare::Less`]. Whatever comes of the tests, one of three operations is applied to the kept stencil value: `fail` where the
/// stencil test fails, `depth_fail` where the depth test does, `pass` where both pass; only the bits in `write_mask` change.
///
/// The depth test compares the fragment's depth with the kept one: "fragment less kept". The fragment's depth is kept where
/// both tests pass, if `write` says so.
#[must_use]
pub fn test(stencil: &StencilTest, depth: &DepthTest, fragment: f32, kept: Kept) -> (bool, Kept) {
    let _ = (stencil, depth, fragment, kept);
    todo!("which of the three operations it is, what it makes of the stencil value, and whose depth is kept")
}
