//! Lesson 11: what its methods draw, where they fail, what its program is asked.

mod properties;
mod snapshots;
mod soup;
mod stability;
mod usage;
