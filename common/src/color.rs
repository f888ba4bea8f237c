//! A colour as a picture stores it.

use std::str::FromStr;

/// A colour in 8 bits a channel, in the order red, green, blue, alpha (255 is opaque).
///
/// The numbers are gamma-encoded, as they stand in a file. Lessons 1-9 compute with them as if they were
/// proportional to light; they are not, and chapter 6 of the book shows what that costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Color {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
    /// Opacity: 0 is transparent, 255 opaque.
    pub a: u8,
}

impl Color {
    /// Opaque black, the colour of a new picture.
    pub const BLACK: Self = Self::rgb(0, 0, 0);
    /// Opaque white.
    pub const WHITE: Self = Self::rgb(255, 255, 255);
    /// Opaque red.
    pub const RED: Self = Self::rgb(255, 0, 0);
    /// Opaque green.
    pub const GREEN: Self = Self::rgb(0, 255, 0);

    /// An opaque colour.
    #[must_use]
    pub const fn rgb(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b, a: 255 }
    }

    /// The opaque grey of an intensity: 0 is black, 1 white. What lies outside is clamped, NaN is black.
    #[must_use]
    pub fn gray(intensity: f32) -> Self {
        Self::WHITE.shaded(intensity)
    }

    /// The colour under a light: 1 leaves it as it is, 0 makes it black. Each channel is rounded to nearest,
    /// what lies outside is clamped, NaN is black; alpha stays.
    #[inline]
    #[must_use]
    pub fn shaded(self, intensity: f32) -> Self {
        // A float cast saturates, so this line does the clamping.
        let shade = |channel: u8| (f32::from(channel) * intensity + 0.5) as u8;
        Self { r: shade(self.r), g: shade(self.g), b: shade(self.b), a: self.a }
    }

    /// How bright the colour looks, by the weights of ITU-R BT.709, rounded: grey stays what it is.
    #[must_use]
    pub const fn luma(self) -> u8 {
        ((2126 * self.r as u32 + 7152 * self.g as u32 + 722 * self.b as u32 + 5000) / 10_000) as u8
    }

    /// The mixture of `self` and `over`: `over`'s share is `coverage` in 255ths, rounded to nearest.
    #[must_use]
    pub fn mixed(self, over: Self, coverage: u8) -> Self {
        let mix = |below: u8, above: u8| {
            let coverage = u32::from(coverage);
            ((u32::from(below) * (255 - coverage) + u32::from(above) * coverage + 127) / 255) as u8
        };
        Self {
            r: mix(self.r, over.r),
            g: mix(self.g, over.g),
            b: mix(self.b, over.b),
            a: mix(self.a, over.a),
        }
    }

    /// One of a fixed sequence of colours that looks random, the same in every run.
    ///
    /// The bits of `n` are mixed by the finaliser of `SplitMix64` (Steele, Lea and Flood, *Fast splittable
    /// pseudorandom number generators*, 2014).
    #[must_use]
    pub const fn random(n: u64) -> Self {
        let mut z = n.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let [r, g, b, ..] = (z ^ (z >> 31)).to_le_bytes();
        Self::rgb(r, g, b)
    }
}

impl FromStr for Color {
    type Err = String;

    /// Reads `rrggbb` in hexadecimal digits, as `ff0000` for red.
    fn from_str(text: &str) -> Result<Self, String> {
        let channel = |at: usize| text.get(at..at + 2).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        if text.len() == 6
            && text.bytes().all(|digit| digit.is_ascii_hexdigit())
            && let (Some(r), Some(g), Some(b)) = (channel(0), channel(2), channel(4))
        {
            Ok(Self::rgb(r, g, b))
        } else {
            Err(format!("`{text}` is not a colour: write six hexadecimal digits, as in ff8000"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gray_clamps_and_rounds() {
        let levels = [-1.0, 0.0, 0.5, 1.0, 7.0, f32::NAN].map(|i| Color::gray(i).r);
        assert_eq!(levels, [0, 0, 128, 255, 255, 0]);
    }

    #[test]
    fn luma_of_every_grey_is_that_grey() {
        assert!((0..=255).all(|v| Color::rgb(v, v, v).luma() == v));
    }

    #[test]
    fn mixing_is_exact_at_both_ends() {
        for n in 0..1000 {
            let (below, above) = (Color::random(n), Color::random(n + 1000));
            assert_eq!(below.mixed(above, 0), below);
            assert_eq!(below.mixed(above, 255), above);
        }
    }

    /// Every product of a level and a coverage, against the nearest 255th: none is half-way between two.
    #[test]
    fn mixing_rounds_to_nearest() {
        for (level, coverage) in (0..=255).flat_map(|level| (0..=255).map(move |coverage| (level, coverage)))
        {
            let product = u32::from(level) * u32::from(coverage);
            let nearest = (0..=255_u8).min_by_key(|&n| (255 * u32::from(n)).abs_diff(product)).unwrap();
            let grey = Color::rgb(level, level, level);
            assert_eq!(Color::BLACK.mixed(grey, coverage).r, nearest, "{level} {coverage}");
            assert_eq!(grey.mixed(Color::BLACK, 255 - coverage).r, nearest, "{level} {coverage}");
        }
    }

    /// The lowest bytes of the numbers that `SplitMix64` gives from the seed 0 on: e220a8397b1dcdaf,
    /// 6e789e6aa1b965f4, 06c45d188009454f.
    #[test]
    fn random_colours_are_bytes_of_a_known_generator() {
        let expected =
            [Color::rgb(0xaf, 0xcd, 0x1d), Color::rgb(0xf4, 0x65, 0xb9), Color::rgb(0x4f, 0x45, 0x09)];
        assert_eq!([0, 1, 2].map(Color::random), expected);
    }

    #[test]
    fn a_colour_is_six_digits() {
        assert_eq!("ff8000".parse(), Ok(Color::rgb(255, 128, 0)));
        for bad in ["", "fff", "ff80000", "+f8000", "gg0000", "ééé"] {
            assert!(bad.parse::<Color>().is_err(), "{bad}");
        }
    }
}
