//! What the book shows of lesson 4, beside its chapter.

pub(crate) mod figures;
