//! Mission 17: 64 pixels at once.
//!
//! Write the body of [`cover`], then see what is right: `cargo run -p my-speed`.
//!
//! What you need:
//!
//! - A block is 8×8 pixels: [`SIDE`] is 8. `f64::from(SIDE)` is the same as an `f64`.
//! - What belongs to a side of the triangle stands in the same place of each `DVec3`: `v[0]`, `v[1]` and `v[2]`, or `v.x`, `v.y`
//!   and `v.z`.
//! - `v + w` and `v * 2.0` of vectors; `a.min(b)` and `a.max(b)`, of numbers, and of vectors number by number.
//! - `a.cmplt(b)`, `a.cmple(b)`, `a.cmpgt(b)` and `a.cmpge(b)` compare vectors number by number: `.any()` and `.all()` of what
//!   they give tell whether some or all comparisons hold.

use common::DVec3;

// Given: edge functions, the three answers, and a loop over blocks that asks for them.
pub use speed_given::{Cover, Edges, SIDE, draw};

/// How much of a block a triangle covers.
///
/// `edges` are the edge functions of the three sides at the centre of the block's lower left pixel; a pixel to the right adds
/// `right` to them, one up adds `up`. A pixel is covered where each of its three edge functions is at least the number in the same
/// place of `inside`. All are whole numbers.
///
/// - [`Cover::Nothing`] where all 64 pixels are outside of one and the same side; never where a pixel is covered.
/// - [`Cover::Whole`] where all 64 are covered; never where one is not.
/// - [`Cover::Part`] elsewhere: then whoever draws asks pixel by pixel.
#[must_use]
pub fn cover(edges: DVec3, right: DVec3, up: DVec3, inside: DVec3) -> Cover {
    let _ = (edges, right, up, inside);
    todo!(
        "what each edge function is at the pixels in the block's four corners, and what that says of all 64"
    )
}
