//! Lesson 5.

mod properties;
mod snapshots;
mod stability;
