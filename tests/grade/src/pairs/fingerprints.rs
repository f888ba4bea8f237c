//! Winnowing: a few hashes of each text, chosen so that two texts with a long enough passage in common have one in common
//! (Schleimer, Wilkerson, Aiken: Winnowing: Local Algorithms for Document Fingerprinting, SIGMOD 2003).

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use super::tokens::{GIVEN, Tokens};

/// How many tokens a hash is of. What is shorter is never found: such passages are alike by chance.
pub(super) const GRAM: usize = 20;
/// Of so many hashes in a row at least one is chosen.
const WINDOW: usize = 8;
/// So many tokens in common are always found.
#[cfg(test)]
pub(super) const FOUND: usize = GRAM + WINDOW - 1;

/// What is compared of a text, and the hashes by which its passages are found.
#[derive(Clone, Debug)]
pub(super) struct Work {
    /// What each token is; [`GIVEN`] is equal to none.
    pub(super) kinds: Vec<u8>,
    /// How many tokens are the text's own.
    pub(super) own: usize,
    /// The chosen hashes, and where each begins, in the order of the text.
    pub(super) chosen: Vec<(u64, usize)>,
    /// The same, in the order of the hashes.
    sorted: Vec<(u64, usize)>,
}

impl Work {
    /// A text without what is given.
    pub(super) fn new(tokens: &Tokens, given: &HashSet<u64>) -> Self {
        let mut kinds = tokens.kinds.clone();
        for (hash, at) in grams(&tokens.kinds) {
            if given.contains(&hash) {
                kinds[at..at + GRAM].fill(GIVEN);
            }
        }
        // Between given code nothing is found that is shorter, so that it would count as unlike.
        let mut chosen = Vec::new();
        let mut at = 0;
        for run in kinds.chunk_by_mut(|a, b| (*a == GIVEN) == (*b == GIVEN)) {
            if run.len() < GRAM {
                run.fill(GIVEN);
            }
            winnow(run, at, &mut chosen);
            at += run.len();
        }
        let own = kinds.iter().filter(|kind| **kind != GIVEN).count();
        let mut sorted = chosen.clone();
        sorted.sort_unstable();
        Self { kinds, own, chosen, sorted }
    }

    /// Where this hash was chosen.
    pub(super) fn places(&self, hash: u64) -> impl Iterator<Item = usize> {
        let first = self.sorted.partition_point(|(other, _)| *other < hash);
        self.sorted[first..].iter().take_while(move |(other, _)| *other == hash).map(|(_, at)| *at)
    }
}

/// The hash of each `GRAM` tokens in a row that are nobody's but the text's, and where they begin.
pub(super) fn grams(kinds: &[u8]) -> impl Iterator<Item = (u64, usize)> {
    let own = |(_, gram): &(usize, &[u8])| !gram.contains(&GIVEN);
    kinds.windows(GRAM).enumerate().filter(own).map(|(at, gram)| {
        // The same in each run of the program, unlike a hash table's.
        let mut hasher = DefaultHasher::new();
        gram.hash(&mut hasher);
        (hasher.finish(), at)
    })
}

/// Chooses of each window the least hash, the last one if several are.
fn winnow(run: &[u8], at: usize, chosen: &mut Vec<(u64, usize)>) {
    let hashes: Vec<(u64, usize)> = grams(run).map(|(hash, begin)| (hash, at + begin)).collect();
    for window in hashes.windows(WINDOW.min(hashes.len()).max(1)) {
        let least = window.iter().rev().min_by_key(|(hash, _)| *hash);
        if let Some(least) = least.filter(|least| chosen.last() != Some(least)) {
            chosen.push(*least);
        }
    }
}
