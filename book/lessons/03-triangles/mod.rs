//! What the book shows of lesson 3, beside its chapter.

pub(crate) mod figures;
