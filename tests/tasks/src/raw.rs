//! What a student's functions return for a task, as plain data, and as a line of text that can cross from one
//! process to another.

use std::fmt;
use std::str::FromStr;

use common::{Bounds, Format, IVec2, Image, Mat4};

/// The result of a task, not yet judged.
#[derive(Clone, Debug, PartialEq)]
pub enum Raw {
    /// A picture in RGB.
    Picture(Image),
    /// A depth for each pixel, rows from the bottom; −∞ where nothing is.
    Depths {
        /// Pixels in a row.
        width: usize,
        /// Larger is nearer.
        values: Vec<f32>,
    },
    /// A table of numbers, row by row: a matrix; or a single row, the coordinates of a value. `None` has no row.
    Numbers {
        /// Numbers in a row.
        columns: usize,
        /// The rows, one after the other.
        values: Vec<f32>,
    },
    /// A list of points, as many as there happen to be.
    List {
        /// Numbers of a point.
        columns: usize,
        /// The points, one after the other.
        values: Vec<f32>,
    },
}

impl Raw {
    /// A value's coordinates.
    #[must_use]
    pub fn value<const N: usize>(value: [f32; N]) -> Self {
        Self::rows([value])
    }

    /// A table of numbers from its rows.
    #[must_use]
    pub fn rows<const N: usize>(rows: impl IntoIterator<Item = [f32; N]>) -> Self {
        Self::Numbers { columns: N, values: rows.into_iter().flatten().collect() }
    }

    /// A list of points.
    #[must_use]
    pub fn list<const N: usize>(points: impl IntoIterator<Item = [f32; N]>) -> Self {
        Self::List { columns: N, values: points.into_iter().flatten().collect() }
    }

    /// The depths that a drawing has left behind, from (0, 0) to the upper right corner of `bounds`.
    #[must_use]
    pub fn depths(bounds: Bounds, depth: impl Fn(i32, i32) -> f32) -> Self {
        let IVec2 { x: right, y: top } = bounds.max;
        let values = (0..=top).flat_map(|y| (0..=right).map(move |x| (x, y))).map(|(x, y)| depth(x, y));
        Self::Depths { width: right as usize + 1, values: values.collect() }
    }

    /// A matrix as it is written: its rows from above.
    #[must_use]
    pub fn matrix(m: Mat4) -> Self {
        Self::rows([0, 1, 2, 3].map(|row| m.row(row).to_array()))
    }
}

/// What came of a task.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A result.
    Raw(Raw),
    /// A `todo!` was reached: where it stands, and what it says.
    Unwritten(String),
    /// A panic, or the end of the process: what was said.
    Crashed(String),
    /// No result within the time limit.
    OutOfTime,
}

impl fmt::Display for Answer {
    /// One line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let list = |f: &mut fmt::Formatter<'_>, values: &[f32]| {
            values.iter().try_for_each(|value| write!(f, " {value}"))
        };
        match self {
            Self::Raw(Raw::Picture(image)) => {
                write!(f, "picture {} {} ", image.width(), image.height())?;
                image.pixels().try_for_each(|(.., c)| write!(f, "{:02x}{:02x}{:02x}", c.r, c.g, c.b))
            }
            Self::Raw(Raw::Depths { width, values }) => {
                write!(f, "depths {width}")?;
                list(f, values)
            }
            Self::Raw(Raw::Numbers { columns, values }) => {
                write!(f, "numbers {columns}")?;
                list(f, values)
            }
            Self::Raw(Raw::List { columns, values }) => {
                write!(f, "list {columns}")?;
                list(f, values)
            }
            Self::Unwritten(said) => write!(f, "unwritten {}", line(said)),
            Self::Crashed(said) => write!(f, "crashed {}", line(said)),
            Self::OutOfTime => write!(f, "late"),
        }
    }
}

impl FromStr for Answer {
    type Err = ();

    /// Reads what [`Display`](fmt::Display) wrote; whatever else it is given, it does not panic.
    fn from_str(line: &str) -> Result<Self, ()> {
        let (kind, rest) = line.split_once(' ').unwrap_or((line, ""));
        let mut words = rest.split_ascii_whitespace();
        let mut table = || -> Option<(usize, Vec<f32>)> {
            let columns = words.next()?.parse().ok().filter(|&columns| columns > 0)?;
            let values: Vec<f32> = words.by_ref().map(|word| word.parse().ok()).collect::<Option<_>>()?;
            values.len().is_multiple_of(columns).then_some((columns, values))
        };
        match kind {
            "picture" => picture(rest).map(Raw::Picture).map(Self::Raw),
            "depths" => table().map(|(width, values)| Self::Raw(Raw::Depths { width, values })),
            "numbers" => table().map(|(columns, values)| Self::Raw(Raw::Numbers { columns, values })),
            "list" => table().map(|(columns, values)| Self::Raw(Raw::List { columns, values })),
            "unwritten" => Some(Self::Unwritten(rest.into())),
            "crashed" => Some(Self::Crashed(rest.into())),
            "late" => Some(Self::OutOfTime),
            _ => None,
        }
        .ok_or(())
    }
}

/// Reads width, height and the hexadecimal bytes of a picture.
fn picture(text: &str) -> Option<Image> {
    let mut words = text.split_ascii_whitespace();
    let [width, height] = [words.next()?, words.next()?].map(|side| side.parse::<u16>().ok());
    let (width, height) = (width?, height?);
    let digits = words.next().unwrap_or("").as_bytes();
    if digits.len() != usize::from(width) * usize::from(height) * 6 {
        return None;
    }
    let mut image = Image::new(width, height, Format::Rgb);
    for (byte, digits) in image.buffer_mut().iter_mut().zip(digits.chunks_exact(2)) {
        *byte = u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()?;
    }
    Some(image)
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Color;

    #[test]
    fn an_answer_is_the_same_after_the_crossing() {
        let mut image = Image::new(3, 2, Format::Rgb);
        image.set(2, 1, Color::rgb(1, 2, 255));
        let odd = vec![f32::NEG_INFINITY, -0.0, 1.0 / 3.0, f32::MIN_POSITIVE / 2.0, f32::MAX, 1e-7];
        for answer in [
            Answer::Raw(Raw::Picture(image)),
            Answer::Raw(Raw::Picture(Image::new(0, 0, Format::Rgb))),
            Answer::Raw(Raw::Depths { width: 3, values: odd.clone() }),
            Answer::Raw(Raw::Numbers { columns: 2, values: odd.clone() }),
            Answer::Raw(Raw::List { columns: 3, values: odd }),
            Answer::Raw(Raw::list::<4>([])),
            Answer::Unwritten("lib.rs:3: plot".into()),
            Answer::Crashed("index out of bounds".into()),
            Answer::OutOfTime,
        ] {
            let line = answer.to_string();
            assert!(!line.contains('\n'));
            assert_eq!(line.parse(), Ok(answer));
        }
        assert_eq!(Answer::Crashed("two\nlines".into()).to_string(), "crashed two lines");
    }

    #[test]
    fn nonsense_is_no_answer() {
        for line in [
            "",
            "right",
            "picture",
            "picture 1 1",
            "picture 1 1 ff00",
            "picture 1 1 ff00zz",
            "picture 1 1 ééé",
            "picture 65535 65535 00",
            "numbers",
            "numbers 0",
            "numbers 0 1",
            "numbers 2 1",
            "numbers 1 one",
            "depths -1 2",
        ] {
            assert_eq!(line.parse::<Answer>(), Err(()), "{line}");
        }
    }
}
