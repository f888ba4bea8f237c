//! What the book shows of lesson 6, beside its chapter.

pub(crate) mod figures;
