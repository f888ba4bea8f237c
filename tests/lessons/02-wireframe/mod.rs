//! Lesson 2.

mod properties;
mod snapshots;
mod stability;
