//! Lesson 12: what its methods draw, where they fail, what its program is asked.

mod alike;
mod bought;
mod levels;
mod maps;
mod properties;
mod snapshots;
mod stability;
mod stage;
mod toon;
mod usage;
