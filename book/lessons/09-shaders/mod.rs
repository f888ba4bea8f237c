//! What the book shows of lesson 9, beside its chapter.

pub(crate) mod figures;
