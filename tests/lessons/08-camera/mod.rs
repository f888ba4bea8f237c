//! Lesson 8.

mod properties;
mod snapshots;
mod stability;
