//! The elements of an OBJ file, one a line: the numbers of a `v`, `vt` or `vn`, the corners of an `f` or `l`.

use super::words::{Words, shown};
use crate::model::Attributes;

/// The three lists of an OBJ file, in the order in which a face's corner names them: `position/uv/normal`.
pub(super) const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// The numbers of an element of each list: how many there may be, and how many there must.
pub(super) const NUMBERS: [(&str, usize, usize); 3] = [("v", 3, 3), ("vt", 2, 1), ("vn", 3, 3)];

/// A corner's places in the three lists, counted from 1.
pub(super) type Corner = [u32; 3];

/// The place of what is not named.
pub(super) const NONE: u32 = 0;

/// The place of what cannot be there: before the first.
pub(super) const NOWHERE: u32 = u32::MAX;

/// Which of the three lists are used.
pub(super) fn used(wanted: Attributes) -> [bool; 3] {
    [true, wanted.uvs, wanted.normals]
}

/// The numbers of an element of a list, the last ones 0 if they may be left out; `None` unless all are finite,
/// as `f32` too.
pub(super) fn numbers(words: &mut Words, kind: usize) -> Option<[f64; 3]> {
    let (_, most, least) = NUMBERS[kind];
    let mut numbers = [0.0; 3];
    for (n, number) in numbers[..most].iter_mut().enumerate() {
        *number = match words.word() {
            Some(word) => text(word)?.parse().ok()?,
            None if n >= least => 0.0,
            None => return None,
        };
        if !(*number as f32).is_finite() {
            return None;
        }
    }
    Some(numbers)
}

/// What is wrong with the numbers of an element of a list.
pub(super) fn no_numbers(words: &mut Words, kind: usize) -> String {
    let (_, most, least) = NUMBERS[kind];
    for n in 0..most {
        let Some(word) = words.word() else {
            return format!("it needs {least} numbers and has {n}");
        };
        let number = text(word).and_then(|word| word.parse::<f64>().ok());
        let shown = shown(word);
        match number {
            Some(number) if (number as f32).is_finite() => {}
            Some(number) if number.is_finite() => return format!("`{shown}` is too large"),
            Some(_) => return format!("`{shown}` is not finite"),
            None if word.contains(&b',') => {
                return format!(
                    "`{shown}` has a comma: write a point in a number, and a blank between numbers"
                );
            }
            None if has_exponent_with_d(word) => {
                return format!("`{shown}` is not a number: an exponent is written with an E");
            }
            None => return format!("`{shown}` is not a number"),
        }
    }
    "it is not made of finite numbers".into()
}

/// Whether a word is a number as Fortran writes it, `1.0D-01`.
fn has_exponent_with_d(word: &[u8]) -> bool {
    text(word).is_some_and(|word| word.replace(['D', 'd'], "e").parse::<f64>().is_ok())
}

/// A word that is text, as all numbers are.
fn text(word: &[u8]) -> Option<&str> {
    std::str::from_utf8(word).ok()
}

/// The indices that a corner such as `3`, `3/1`, `3//2` or `-1/-1/-1` names in the lists that are used. Of the
/// others, nothing is looked at.
pub(super) fn corner(word: &[u8], used: [bool; 3]) -> Result<[Option<i64>; 3], String> {
    let mut indices = [None; 3];
    let mut parts = word.split(|&byte| byte == b'/');
    if word.starts_with(b"/") || parts.clone().count() > 3 {
        return Err(format!("`{}` is not a corner", shown(word)));
    }
    for (index, used) in indices.iter_mut().zip(used) {
        let Some(part) = parts.next() else { break };
        if used && !part.is_empty() {
            let number = text(part).and_then(|part| part.parse().ok());
            let cure = if part.contains(&b',') { ": write blanks between corners, and no comma" } else { "" };
            let no_index = || format!("corner `{}`: `{}` is not an index{cure}", shown(word), shown(part));
            *index = Some(number.ok_or_else(no_index)?);
        }
    }
    Ok(indices)
}

/// The place in a list of that length so far that an index names: a negative one counts back from its end.
pub(super) fn place(index: Option<i64>, length: usize) -> u32 {
    let place = match index {
        None => return NONE,
        Some(index) if index < 0 => index.saturating_add(length as i64 + 1),
        Some(index) => index,
    };
    u32::try_from(place).ok().filter(|&place| place != NONE).unwrap_or(NOWHERE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_counts_from_1_or_back_from_the_end() {
        for (index, expected) in [
            (None, NONE),
            (Some(1), 1),
            (Some(4), 4),
            // It may be there by the end of the file.
            (Some(5), 5),
            (Some(0), NOWHERE),
            (Some(-1), 4),
            (Some(-4), 1),
            (Some(-5), NOWHERE),
            (Some(i64::MIN), NOWHERE),
            (Some(i64::MAX), NOWHERE),
        ] {
            assert_eq!(place(index, 4), expected, "{index:?}");
        }
    }
}
