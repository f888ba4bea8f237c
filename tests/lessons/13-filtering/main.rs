//! Lesson 13: what its methods draw, where they fail, what its program is asked.

mod flight;
mod floor;
mod properties;
mod snapshots;
mod stability;
mod usage;
