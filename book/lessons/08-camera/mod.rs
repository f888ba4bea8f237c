//! What the book shows of lesson 8, beside its chapter.

pub(crate) mod figures;
