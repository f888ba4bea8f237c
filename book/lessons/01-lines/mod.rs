//! What the book shows of lesson 1, beside its chapter.

pub(crate) mod figures;
