//! Lesson 9.

mod properties;
mod snapshots;
mod stability;
