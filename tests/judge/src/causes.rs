//! Faults that turn up in many lessons, as transformations of a result.

use common::{Color, Format, Image};
use tasks::Raw;

use super::Cause;

/// What can befall any picture.
pub const PICTURE: [Cause; 8] = [
    Cause {
        name: "nothing is drawn",
        explains: |asked, got| asked.becomes(got, |raw| picture(raw, |_, _, _| None)),
    },
    Cause {
        name: "it is upside down: y points up, row 0 is the lowest",
        explains: |asked, got| asked.becomes(got, upside_down),
    },
    Cause {
        name: "it is mirrored: x points to the right, column 0 is the leftmost",
        explains: |asked, got| asked.becomes(got, mirrored),
    },
    Cause {
        name: "x and y are swapped",
        explains: |asked, got| asked.becomes(got, |raw| picture(raw, |from, x, y| from.get(y, x))),
    },
    Cause {
        name: "off by one: it is a pixel too far right",
        explains: |asked, got| asked.becomes(got, |raw| shifted(raw, 1, 0)),
    },
    Cause {
        name: "off by one: it is a pixel too far left",
        explains: |asked, got| asked.becomes(got, |raw| shifted(raw, -1, 0)),
    },
    Cause {
        name: "off by one: it is a pixel too high",
        explains: |asked, got| asked.becomes(got, |raw| shifted(raw, 0, 1)),
    },
    Cause {
        name: "off by one: it is a pixel too low",
        explains: |asked, got| asked.becomes(got, |raw| shifted(raw, 0, -1)),
    },
];

/// A list of causes, and after it those that any picture has.
#[must_use]
pub fn picture_and(more: &[Cause]) -> Vec<Cause> {
    [more, &PICTURE].concat()
}

/// A picture made of another, pixel by pixel; where it gives none, black.
pub fn picture(raw: &Raw, color: impl Fn(&Image, i32, i32) -> Option<Color>) -> Raw {
    let Raw::Picture(from) = raw else { return raw.clone() };
    let mut image = Image::new(from.width() as u16, from.height() as u16, Format::Rgb);
    for (x, y, _) in from.pixels() {
        image.set(x, y, color(from, x, y).unwrap_or(Color::BLACK));
    }
    Raw::Picture(image)
}

/// A table of numbers made of another, row by row.
pub fn rows(raw: &Raw, change: impl Fn(&mut [f32])) -> Raw {
    let mut raw = raw.clone();
    if let Raw::Numbers { columns, values } = &mut raw {
        values.chunks_exact_mut(*columns).for_each(change);
    }
    raw
}

/// Every number with its sign changed.
#[must_use]
pub fn negated(raw: &Raw) -> Raw {
    rows(raw, |row| row.iter_mut().for_each(|value| *value = -*value))
}

/// Rows and columns swapped, of a square table.
#[must_use]
pub fn transposed(raw: &Raw) -> Raw {
    let mut transposed = raw.clone();
    if let (Raw::Numbers { columns, values }, Raw::Numbers { values: from, .. }) = (&mut transposed, raw)
        && values.len() == *columns * *columns
    {
        (0..values.len()).for_each(|n| values[n] = from[n % *columns * *columns + n / *columns]);
    }
    transposed
}

/// Top and bottom swapped.
#[must_use]
pub fn upside_down(raw: &Raw) -> Raw {
    picture(raw, |from, x, y| from.get(x, from.height() - 1 - y))
}

/// Left and right swapped.
#[must_use]
pub fn mirrored(raw: &Raw) -> Raw {
    picture(raw, |from, x, y| from.get(from.width() - 1 - x, y))
}

/// Moved by whole pixels; what leaves the picture is lost.
fn shifted(raw: &Raw, dx: i32, dy: i32) -> Raw {
    picture(raw, |from, x, y| from.get(x - dx, y - dy))
}

/// A colour for another, wherever `here` says.
pub fn swapped(raw: &Raw, [a, b]: [Color; 2], here: impl Fn(i32) -> bool) -> Raw {
    picture(raw, |from, x, y| match from.get(x, y) {
        Some(color) if color == a && here(x) => Some(b),
        Some(color) if color == b && here(x) => Some(a),
        color => color,
    })
}
