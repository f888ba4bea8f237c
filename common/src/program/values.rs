//! The values of flags: numbers, points and colours from what was typed.
//!
//! Each function is a `value_parser` for clap, or the greater part of one. What is wrong is said in one line.

use std::str::FromStr;

use glam::{DVec3, Vec3};

use crate::direction::unit;
use crate::{Color, file};

/// Width and height of a picture that can be read again, as in `800x600`.
///
/// # Errors
/// Where these are not two numbers, or no such picture.
pub fn size(text: &str) -> Result<(u16, u16), String> {
    let size = text
        .split_once('x')
        .and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)))
        .filter(|&(width, height): &(u16, u16)| {
            width.min(height) > 0 && width.max(height) <= file::SIDE_LIMIT
        });
    match size {
        None => Err(format!("write two numbers from 1 to {}, as in 800x600", file::SIDE_LIMIT)),
        Some((width, height)) if !file::fits(width, height) => {
            Err(format!("a picture may have {} pixels in all, as 8192x8192 has", file::PIXEL_LIMIT))
        }
        Some(size) => Ok(size),
    }
}

/// `N` numbers with commas between them.
///
/// # Errors
/// Where there are more or fewer, or one is no number of this type.
pub fn numbers<T: FromStr, const N: usize>(text: &str) -> Result<[T; N], String> {
    numbers_of(&split(text))
}

/// `N` numbers with commas between them and, behind a further comma, perhaps a colour.
///
/// # Errors
/// As [`numbers`], or where what stands behind them is no colour.
pub fn numbers_and_color<T: FromStr, const N: usize>(text: &str) -> Result<([T; N], Option<Color>), String> {
    let parts = split(text);
    let Some((color, before)) = parts.split_last().filter(|_| parts.len() == N + 1) else {
        return Ok((numbers_of(&parts)?, None));
    };
    Ok((numbers_of(before)?, Some(color.parse()?)))
}

/// A point, or a vector of any length: numbers that are finite as `f32`, as exact as they were typed.
///
/// # Errors
/// Where these are not three finite numbers.
pub fn point(text: &str) -> Result<DVec3, String> {
    let point = DVec3::from_array(numbers(text)?);
    let refused = || "write 3 finite numbers with commas between them".into();
    point.as_vec3().is_finite().then_some(point).ok_or_else(refused)
}

/// A direction, made 1 long however long it was.
///
/// # Errors
/// Where these are not three finite numbers, or all of them are 0.
pub fn direction(text: &str) -> Result<Vec3, String> {
    unit(Vec3::from_array(numbers(text)?))
        .ok_or_else(|| "a direction needs three finite numbers, not all 0".into())
}

fn split(text: &str) -> Vec<&str> {
    text.split(',').map(str::trim).collect()
}

fn numbers_of<T: FromStr, const N: usize>(parts: &[&str]) -> Result<[T; N], String> {
    let number =
        |part: &&str| part.parse().map_err(|_| format!("`{part}` is not a number that can be used here"));
    let wrong = || format!("write {N} numbers with commas between them, not {}", parts.len());
    if parts.len() != N {
        return Err(wrong());
    }
    let numbers: Vec<T> = parts.iter().map(number).collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| wrong())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_one_that_can_be_read_again() {
        assert_eq!(size("8192x8192"), Ok((8192, 8192)));
        for (text, said) in [
            ("0x5", "write two numbers from 1 to 16384"),
            ("20000x5", "write two numbers from 1 to 16384"),
            ("5", "write two numbers from 1 to 16384"),
            ("5x-5", "write two numbers from 1 to 16384"),
            ("8192x8193", "a picture may have 67108864 pixels in all"),
        ] {
            assert!(size(text).unwrap_err().contains(said), "{text}");
        }
    }

    #[test]
    fn numbers_are_as_many_as_asked_for() {
        assert_eq!(numbers(" -1, 2,3 "), Ok([-1, 2, 3]));
        assert_eq!(numbers_and_color("1,2"), Ok(([1.0, 2.0], None)));
        assert_eq!(numbers_and_color("1,2,ff0000"), Ok(([1.0, 2.0], Some(Color::RED))));
        for (text, said) in [
            ("1,2", "write 3 numbers with commas between them, not 2"),
            ("1,2,3,4", "write 3 numbers with commas between them, not 4"),
            ("1,2,4.5", "`4.5` is not a number"),
            ("1,2,2147483648", "`2147483648` is not a number"),
            ("1,2,", "`` is not a number"),
        ] {
            assert!(numbers::<i32, 3>(text).unwrap_err().contains(said), "{text}");
        }
        for (text, said) in [
            ("1", "write 2 numbers with commas between them, not 1"),
            ("1,2,ff0000,3", "write 2 numbers with commas between them, not 4"),
            ("1,2,red", "`red` is not a colour"),
        ] {
            assert!(numbers_and_color::<i32, 2>(text).unwrap_err().contains(said), "{text}");
        }
    }

    #[test]
    fn a_point_is_finite() {
        assert_eq!(point("-1,2e3,0.5"), Ok(DVec3::new(-1.0, 2000.0, 0.5)));
        for text in ["1,inf,0", "nan,0,0", "0,0,1e39"] {
            assert!(point(text).unwrap_err().contains("write 3 finite numbers"), "{text}");
        }
    }

    #[test]
    fn a_direction_becomes_a_unit_vector_however_long_it_was() {
        for scale in ["1e-45", "1e-38", "1", "1e20", "1e38"] {
            let long = direction(&format!("{scale},0,{scale}")).unwrap();
            assert!((long - Vec3::new(0.5, 0.0, 0.5).normalize()).length() < 1e-6, "{scale}");
        }
        for text in ["0,0,0", "0,inf,0", "0,nan,1"] {
            assert!(direction(text).unwrap_err().contains("not all 0"), "{text}");
        }
    }
}
