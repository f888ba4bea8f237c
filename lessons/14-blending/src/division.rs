//! Ways to divide by 255.
//!
//! A channel of 8 bits is a share of 255, and a share of a share is a product divided by 255. What is blended is
//! (s·f + d·g)/255 or (s·f − d·g)/255, with the channels s and d of source and destination and their factors f and g, all of
//! them from 0 to 255. As 255 is odd, such a quotient is never half-way between two whole numbers.

use std::ops::{Add, Sub};

// ANCHOR: division
/// A way to divide by 255.
pub trait Division: Copy + Default {
    /// What products are added in.
    type Sum: Copy + Add<Output = Self::Sum> + Sub<Output = Self::Sum>;

    /// A channel times a factor, a share in 255ths.
    fn product(channel: u8, factor: u8) -> Self::Sum;

    /// A sum or difference of two products as a channel: divided, rounded, and clamped to 0 and 255.
    fn channel(sum: Self::Sum) -> u8;

    /// What lies between two channels: so many 255ths of the source, and the rest of the destination.
    #[inline]
    #[must_use]
    fn mix(source: u8, destination: u8, alpha: u8) -> u8 {
        Self::channel(Self::product(source, alpha) + Self::product(destination, 255 - alpha))
    }
}
// ANCHOR_END: division

/// Each channel and each factor becomes a number from 0 to 1, and the result a channel again.
#[derive(Clone, Copy, Debug, Default)]
pub struct Float;

// ANCHOR: float
impl Division for Float {
    type Sum = f32;

    #[inline]
    fn product(channel: u8, factor: u8) -> f32 {
        (f32::from(channel) / 255.0) * (f32::from(factor) / 255.0)
    }

    /// A cast clamps.
    #[inline]
    fn channel(sum: f32) -> u8 {
        (sum * 255.0 + 0.5) as u8
    }
}
// ANCHOR_END: float

/// Whole numbers and a division, which compilers make a product and a shift of.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

// ANCHOR: exact
impl Division for Exact {
    type Sum = i32;

    #[inline]
    fn product(channel: u8, factor: u8) -> i32 {
        i32::from(channel) * i32::from(factor)
    }

    #[inline]
    fn channel(sum: i32) -> u8 {
        ((sum.clamp(0, 255 * 255) + 127) / 255) as u8
    }
}
// ANCHOR_END: exact

/// Two shifts: with n = sum + 128, it is (n + n/256)/256, both rounded down (J. F. Blinn, *Three wrongs make a right*, IEEE
/// Computer Graphics and Applications 15, 1995). 1/255 is 1/256 + 1/256² + …, and of all sums up to 255² none needs more
/// terms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TwoShift;

// ANCHOR: two_shift
impl Division for TwoShift {
    type Sum = i32;

    #[inline]
    fn product(channel: u8, factor: u8) -> i32 {
        i32::from(channel) * i32::from(factor)
    }

    #[inline]
    fn channel(sum: i32) -> u8 {
        let n = sum.clamp(0, 255 * 255) + 128;
        ((n + (n >> 8)) >> 8) as u8
    }
}
// ANCHOR_END: two_shift

/// One shift, as if 255 were 256.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shift8;

// ANCHOR: shift_8
impl Division for Shift8 {
    type Sum = i32;

    #[inline]
    fn product(channel: u8, factor: u8) -> i32 {
        i32::from(channel) * i32::from(factor)
    }

    #[inline]
    fn channel(sum: i32) -> u8 {
        (sum >> 8).clamp(0, 255) as u8
    }
}
// ANCHOR_END: shift_8

/// Factors are stretched to 0 to 256 first, which makes the division a shift that is right at both ends.
#[derive(Clone, Copy, Debug, Default)]
pub struct Div256;

// ANCHOR: div_256
impl Division for Div256 {
    type Sum = i32;

    /// Of α and 255 − α just one is above 127, so that together they are 256.
    #[inline]
    fn product(channel: u8, factor: u8) -> i32 {
        i32::from(channel) * (i32::from(factor) + i32::from(factor >> 7))
    }

    #[inline]
    fn channel(sum: i32) -> u8 {
        ((sum + 128) >> 8).clamp(0, 255) as u8
    }
}
// ANCHOR_END: div_256
