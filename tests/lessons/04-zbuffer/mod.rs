//! Lesson 4.

mod properties;
mod snapshots;
mod stability;
