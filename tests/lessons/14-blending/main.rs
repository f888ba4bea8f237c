//! Lesson 14: what its methods draw, where they fail, what its program is asked.

mod alike;
mod early;
mod glass;
mod layers;
mod order;
mod properties;
mod scenes;
mod snapshots;
mod spaces;
mod stability;
mod state;
mod through;
mod usage;
