//! Lesson 6.

mod snapshots;
mod stability;
