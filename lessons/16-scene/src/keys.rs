//! The keys, and what is written for `--keys`.

use std::str::FromStr;

use common::printable::printable;

use crate::orbit::{Axis, Way};

/// A key that does something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// Ends it.
    Escape,
    /// Wireframe, and back.
    F1,
    /// Antialiasing, and back.
    F2,
    /// The eye moves to its left around (0, 0, 0).
    Left,
    /// To its right.
    Right,
    /// The eye rises.
    Up,
    /// It sinks.
    Down,
    /// The eye comes nearer.
    W,
    /// It goes farther away.
    S,
}

impl Key {
    /// All of them, with the names that `--keys` knows.
    pub const NAMES: [(&'static str, Self); 9] = [
        ("Escape", Self::Escape),
        ("F1", Self::F1),
        ("F2", Self::F2),
        ("Left", Self::Left),
        ("Right", Self::Right),
        ("Up", Self::Up),
        ("Down", Self::Down),
        ("W", Self::W),
        ("S", Self::S),
    ];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize].0
    }

    // ANCHOR: moves
    /// Along which axis it moves the eye, and which way, if it does.
    #[must_use]
    pub fn moves(self) -> Option<(Axis, Way)> {
        match self {
            Self::Left => Some((Axis::Around, Way::Back)),
            Self::Right => Some((Axis::Around, Way::There)),
            Self::Down => Some((Axis::Up, Way::Back)),
            Self::Up => Some((Axis::Up, Way::There)),
            Self::S => Some((Axis::Nearer, Way::Back)),
            Self::W => Some((Axis::Nearer, Way::There)),
            Self::Escape | Self::F1 | Self::F2 => None,
        }
    }
    // ANCHOR_END: moves
}

/// The most presses that are replayed: a quarter of an hour of them.
const MOST: usize = 10_000;

/// Keys pressed one after the other, as `--keys` has them: names with blanks between them, each with `*N` for N presses or
/// without for one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Presses(pub Vec<Key>);

impl FromStr for Presses {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut presses = Vec::new();
        for word in text.split_whitespace() {
            let (name, count) = word.split_once('*').unwrap_or((word, "1"));
            let named = Key::NAMES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
            let (_, key) = named.ok_or_else(|| {
                format!(
                    "there is no key `{}`, only {}",
                    printable(name),
                    Key::NAMES.map(|row| row.0).join(", ")
                )
            })?;
            let count = count.parse().ok().filter(|&count| count >= 1 && count <= MOST - presses.len());
            let count = count.ok_or_else(|| {
                format!("`{}`: write a number of presses behind the *, up to {MOST} in all", printable(word))
            })?;
            presses.extend(std::iter::repeat_n(*key, count));
        }
        Ok(Self(presses))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_key_has_its_own_name() {
        assert!((0..9).all(|n| Key::NAMES[n].1 as usize == n));
        assert!(
            Key::NAMES
                .iter()
                .all(|&(name, key)| key.name() == name && name.parse() == Ok(Presses(vec![key])))
        );
    }

    #[test]
    fn presses_are_names_and_numbers() {
        let parsed = |text: &str| text.parse::<Presses>().map(|presses| presses.0);
        assert_eq!(parsed(""), Ok(vec![]));
        assert_eq!(parsed(" F1  left*2\tW "), Ok(vec![Key::F1, Key::Left, Key::Left, Key::W]));
        assert_eq!(parsed("S*9999 Escape").map(|keys| keys.len()), Ok(10_000));
        for (text, said) in [
            ("Left Foo", "there is no key `Foo`, only Escape, F1, F2, Left, Right, Up, Down, W, S"),
            ("Left,Right", "there is no key `Left,Right`"),
            ("*3", "there is no key ``"),
            ("Left*0", "`Left*0`: write a number of presses behind the *, up to 10000 in all"),
            ("Left*", "`Left*`: write a number"),
            ("Left*-1", "`Left*-1`: write a number"),
            ("Left*2*3", "`Left*2*3`: write a number"),
            ("W*10000 S", "`S`: write a number of presses behind the *, up to 10000 in all"),
            ("W*99999999999999999999999", "up to 10000 in all"),
        ] {
            let error = parsed(text).unwrap_err();
            assert!(error.contains(said) && !error.contains('\n'), "{text}: {error}");
        }
    }
}
