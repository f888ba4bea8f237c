//! What the book shows of lesson 5, beside its chapter.

pub(crate) mod figures;
