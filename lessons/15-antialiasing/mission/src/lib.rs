//! Mission 15: the share of a pixel that a triangle covers.
//!
//! Write the bodies of [`coverage`] and [`resolve`], then see what is right: `cargo run -p my-antialiasing`.
//!
//! What you need:
//!
//! - `sides(corners)`: the three sides of a triangle, counterclockwise whatever the order of its corners; `None` where it has no
//!   area. Corners are rounded to 1/256 px, as in lesson 3.
//! - `side.edge([x, y])`: the edge function of a side at a point in 1/256 px, positive inside, 0 on the side.
//! - `side.top_left`: whether a point on that side belongs to the triangle.
//! - `1 << s` is the number whose only bit is bit s; `a | b` has the bits of both.
//! - `i64::from(n)` and `u32::from(n)` give a small number more room. `/` between whole numbers drops the rest.

use common::{Color, IVec2, Vec2};

// Given: sides and their edge functions, places of samples, and a picture that is drawn with your two functions.
pub use antialiasing_given::{Side, draw, pattern, sides};

/// Which samples of a pixel a triangle covers: bit s is set where sample s is inside.
///
/// Corners are in pixels. `pattern` has the places of the samples, x and y in 1/16 px from the pixel's lower left corner, which
/// is at (x, y) of the pixel itself. A sample on a side is inside if that is a top or left side.
#[must_use]
pub fn coverage(corners: [Vec2; 3], pixel: IVec2, pattern: &[[i32; 2]]) -> u32 {
    let _ = (corners, pixel, pattern);
    todo!("for each sample its place in 1/256 px, and whether that is inside of all three sides")
}

/// The colour of a pixel from those of its samples, of which there is at least one: of each channel, alpha among them, the mean,
/// rounded to the nearest whole number, and up from a half.
#[must_use]
pub fn resolve(samples: &[Color]) -> Color {
    let _ = samples;
    todo!("the sum of each channel, then one division that rounds")
}
