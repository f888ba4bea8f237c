//! Lesson 9: what its methods draw, where they fail, what its program is asked.

mod loops;
mod properties;
mod snapshots;
mod stability;
mod usage;
