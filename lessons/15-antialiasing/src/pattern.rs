//! Where the samples of a pixel are.
//!
//! The places are those that Vulkan calls standard (Vulkan 1.3, *Multisampling*, *Standard sample locations*) and that
//! Direct3D prescribes (`D3D11_STANDARD_MULTISAMPLE_QUALITY_LEVELS`). From two samples on no two of a pattern have the same
//! x or the same y, so that an edge along an axis passes them one after the other, and not four at a time as in a grid.

/// A place in a pixel, counted from its lower left corner, in 1/16 px: to the right, then up.
pub type Place = [i32; 2];

/// So many places make up the side of a pixel.
pub const PLACES: i32 = 16;

// ANCHOR: patterns
/// The places as the specifications have them: in 1/16 px from the upper left corner, y pointing down.
const DOWN_1: [Place; 1] = [[8, 8]];
const DOWN_2: [Place; 2] = [[12, 12], [4, 4]];
const DOWN_4: [Place; 4] = [[6, 2], [14, 6], [2, 10], [10, 14]];
const DOWN_8: [Place; 8] = [[9, 5], [7, 11], [13, 9], [5, 3], [3, 13], [1, 7], [11, 15], [15, 1]];
#[rustfmt::skip]
const DOWN_16: [Place; 16] = [
    [9, 9], [7, 5], [5, 10], [12, 7], [3, 6], [10, 13], [13, 11], [11, 3],
    [6, 14], [8, 1], [4, 2], [2, 12], [0, 8], [15, 4], [14, 15], [1, 0],
];

/// The same from the lower left corner, y pointing up. What is on the upper side of a pixel there is on it here.
const fn turned<const N: usize>(mut places: [Place; N]) -> [Place; N] {
    let mut n = 0;
    while n < N {
        places[n][1] = PLACES - places[n][1];
        n += 1;
    }
    places
}

/// The patterns of 1, 2, 4, 8 and 16 samples.
pub const PATTERNS: [&[Place]; 5] =
    [&turned(DOWN_1), &turned(DOWN_2), &turned(DOWN_4), &turned(DOWN_8), &turned(DOWN_16)];
// ANCHOR_END: patterns

/// The pattern of so many samples.
///
/// # Panics
/// Where there is none: there are those of 1, 2, 4, 8 and 16.
#[must_use]
pub const fn pattern(samples: usize) -> &'static [Place] {
    assert!(samples.is_power_of_two() && samples <= 16, "there are patterns of 1, 2, 4, 8 and 16 samples");
    PATTERNS[samples.trailing_zeros() as usize]
}
