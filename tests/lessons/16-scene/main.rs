//! Lesson 16: what its methods draw, where they fail, what its program is asked.

mod cost;
mod head;
mod snapshots;
mod stability;
mod usage;
