//! Lesson 10: what its methods draw, where they fail, what its program is asked.

mod properties;
mod snapshots;
mod stability;
mod usage;
