//! What the book shows of lesson 3, beside its chapter.

pub(crate) mod charts;
pub(crate) mod figures;

#[cfg(test)]
mod answers;
