//! What the book shows of lesson 2, beside its chapter.

pub(crate) mod figures;
