//! Lesson 7.

mod properties;
pub(crate) mod snapshots;
mod stability;
