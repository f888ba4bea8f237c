//! The figures of the pages that are no lesson's.

#[cfg(test)]
mod answers;
pub(crate) mod front;
pub(crate) mod wrong;
