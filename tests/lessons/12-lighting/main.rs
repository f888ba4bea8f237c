//! Lesson 12: what its methods draw, where they fail, what its program is asked.

mod alike;
mod levels;
mod properties;
mod snapshots;
mod stability;
mod stage;
mod usage;
