//! Lesson 1.

mod properties;
mod snapshots;
mod stability;
