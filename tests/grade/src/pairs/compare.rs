//! What two texts have in common.

use std::ops::Range;

use super::fingerprints::{GRAM, Work};
use super::tokens::GIVEN;

/// In how many places a passage is looked for, of those that begin alike.
const PLACES: usize = 16;

/// A passage that stands in two texts, in tokens of each.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Passage {
    pub(super) here: Range<usize>,
    pub(super) there: Range<usize>,
}

/// How much of each of two texts stands in the other, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shares {
    pub(super) of_first: f64,
    pub(super) of_second: f64,
}

impl Shares {
    /// The larger one: code that was added to a copy makes the other smaller.
    pub(super) fn larger(self) -> f64 {
        self.of_first.max(self.of_second)
    }
}

/// Compares two texts, each of which has something of its own.
pub(super) fn shares(first: &Work, second: &Work) -> Shares {
    if first.kinds == second.kinds {
        return Shares { of_first: 1.0, of_second: 1.0 };
    }
    let share = |one: &Work, other: &Work| {
        let shared: usize = passages(one, other).iter().map(|passage| passage.here.len()).sum();
        shared as f64 / one.own.max(1) as f64
    };
    Shares { of_first: share(first, second), of_second: share(second, first) }
}

/// The passages of one text that stand in another, in the order of the first, in which none overlaps the next.
///
/// Each token is passed once, so that this takes time in proportion to the text's length.
pub(super) fn passages(one: &Work, other: &Work) -> Vec<Passage> {
    let mut all: Vec<Passage> = Vec::new();
    for &(hash, at) in &one.chosen {
        let from = all.last().map_or(0, |passage| passage.here.end);
        if at + GRAM <= from {
            continue;
        }
        // A hash may, very rarely, be that of another passage.
        let same = |there: &usize| one.kinds[at..at + GRAM] == other.kinds[*there..*there + GRAM];
        let found = other.places(hash).take(PLACES).filter(same);
        let grown = found.map(|there| grow(&one.kinds, &other.kinds, at, there, from));
        // The first of the longest.
        if let Some(longest) = grown.reduce(|a, b| if b.here.len() > a.here.len() { b } else { a }) {
            all.push(longest);
        }
    }
    all
}

/// A passage as long as it can be, from the `GRAM` tokens that are known to be the same; not before `from`.
fn grow(one: &[u8], other: &[u8], here: usize, there: usize, from: usize) -> Passage {
    let same = |(a, b): &(&u8, &u8)| a == b && **a != GIVEN;
    let (before, after) = (here.max(from), here + GRAM);
    let skipped = before - here;
    let left =
        one[from..before].iter().rev().zip(other[..there + skipped].iter().rev()).take_while(same).count();
    let right = one[after..].iter().zip(&other[there + GRAM..]).take_while(same).count();
    Passage { here: before - left..after + right, there: there + skipped - left..there + GRAM + right }
}
