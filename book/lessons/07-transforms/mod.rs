//! What the book shows of lesson 7, beside its chapter.

pub(crate) mod figures;
