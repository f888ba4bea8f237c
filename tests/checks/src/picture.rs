//! Two pictures, compared fault by fault.

use std::fmt;

use common::compare::Difference;
use common::{Color, IVec2, Image};

/// One thing that is wrong with a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The picture has another size than expected.
    Size {
        /// Width and height that it should have.
        expected: IVec2,
        /// Width and height that it has.
        got: IVec2,
    },
    /// Nothing is drawn where something should be.
    Missing(IVec2),
    /// Something is drawn where nothing should be.
    Extra(IVec2),
    /// A pixel has another colour than expected, by more than the tolerance.
    WrongColor {
        /// The pixel.
        at: IVec2,
        /// The colour that it should have.
        expected: Color,
        /// The colour that it has.
        got: Color,
    },
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { expected, got } => {
                write!(f, "the picture is {}x{}, not {}x{}", got.x, got.y, expected.x, expected.y)
            }
            Self::Missing(at) => write!(f, "pixel ({}, {}) is missing", at.x, at.y),
            Self::Extra(at) => write!(f, "pixel ({}, {}) should be black", at.x, at.y),
            Self::WrongColor { at, expected, got } => {
                let hex = |c: &Color| format!("{:02x}{:02x}{:02x}", c.r, c.g, c.b);
                write!(f, "pixel ({}, {}) is {}, not {}", at.x, at.y, hex(got), hex(expected))
            }
        }
    }
}

/// Everything that is wrong with a picture; nothing if each channel of each pixel is within `tolerance` of
/// what was expected.
#[must_use]
pub fn faults(expected: &Image, got: &Image, tolerance: u8) -> Vec<Fault> {
    let size = |image: &Image| IVec2::new(image.width(), image.height());
    if size(expected) != size(got) {
        return vec![Fault::Size { expected: size(expected), got: size(got) }];
    }
    let Difference { missing, extra, recolored } = Difference::between(expected, got);
    let colors = |at: IVec2| (expected.get(at.x, at.y), got.get(at.x, at.y));
    let off = |at: &IVec2| match colors(*at) {
        (Some(a), Some(b)) => distance(a, b) > tolerance,
        _ => true,
    };
    let wrong = recolored.into_iter().filter(off).filter_map(|at| match colors(at) {
        (Some(expected), Some(got)) => Some(Fault::WrongColor { at, expected, got }),
        _ => None,
    });
    let missing = missing.into_iter().filter(off).map(Fault::Missing);
    let extra = extra.into_iter().filter(off).map(Fault::Extra);
    missing.chain(extra).chain(wrong).collect()
}

/// The largest difference of a channel.
#[must_use]
pub fn distance(a: Color, b: Color) -> u8 {
    a.r.abs_diff(b.r).max(a.g.abs_diff(b.g)).max(a.b.abs_diff(b.b)).max(a.a.abs_diff(b.a))
}

/// By how many grey levels two pictures of one size differ on average at the pixels that count, all three channels taken
/// alike. NaN where none counts.
#[must_use]
pub fn mean_difference(a: &Image, b: &Image, counts: impl Fn(i32, i32) -> bool) -> f64 {
    let both = a.pixels().zip(b.pixels()).filter(|((x, y, _), _)| counts(*x, *y));
    let (sum, count) = both.fold((0.0, 0.0), |(sum, count), ((.., a), (.., b))| {
        let off = [a.r.abs_diff(b.r), a.g.abs_diff(b.g), a.b.abs_diff(b.b)];
        (sum + off.map(f64::from).iter().sum::<f64>() / 3.0, count + 1.0)
    });
    sum / count
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Format;

    #[test]
    fn a_mean_is_over_what_counts() {
        let black = Image::new(4, 1, Format::Rgb);
        let mut other = black.clone();
        other.set(1, 0, Color::rgb(30, 0, 0));
        other.set(2, 0, Color::rgb(1, 1, 1));
        assert_eq!(mean_difference(&black, &other, |_, _| true), 11.0 / 4.0);
        assert_eq!(mean_difference(&other, &black, |x, _| x == 1), 10.0);
        assert!(mean_difference(&black, &other, |_, _| false).is_nan());
    }

    #[test]
    fn each_fault_is_told_and_the_tolerance_kept() {
        let mut expected = Image::new(3, 1, Format::Rgb);
        let mut got = expected.clone();
        expected.set(0, 0, Color::rgb(9, 9, 9));
        got.set(1, 0, Color::rgb(4, 4, 4));
        expected.set(2, 0, Color::rgb(100, 0, 0));
        got.set(2, 0, Color::rgb(100, 5, 0));
        let told: Vec<String> = faults(&expected, &got, 0).iter().map(Fault::to_string).collect();
        let all =
            ["pixel (0, 0) is missing", "pixel (1, 0) should be black", "pixel (2, 0) is 640500, not 640000"];
        assert_eq!(told, all);
        assert_eq!(faults(&expected, &got, 4), [Fault::Missing(IVec2::ZERO), faults(&expected, &got, 0)[2]]);
        assert_eq!(faults(&expected, &got, 9), []);
    }

    #[test]
    fn another_size_is_one_fault() {
        let [a, b] = [(3, 1), (1, 3)].map(|(w, h)| Image::new(w, h, Format::Rgb));
        assert_eq!(faults(&a, &b, 0)[0].to_string(), "the picture is 1x3, not 3x1");
    }
}
