//! What a lesson's result is measured against: exact references, and typed comparisons.
//!
//! | module | reference |
//! |---|---|
//! | [`segment`] | the ideal line, in rational numbers |
//! | [`coverage`] | the pixels of a triangle and their weights, in `i128` |
//! | [`picture`] | two pictures, fault by fault |
//!
//! Nothing here calls a lesson, and nothing is computed the way the lessons compute it.

pub mod coverage;
pub mod picture;
pub mod segment;
