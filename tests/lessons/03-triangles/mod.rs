//! Lesson 3.

mod properties;
mod snapshots;
mod stability;
