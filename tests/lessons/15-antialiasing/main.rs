//! Lesson 15: what its methods draw, where they fail, what its program is asked.

mod any_state;
mod area;
mod centroid;
mod cost;
mod edges;
mod properties;
mod resolves;
mod scenes;
mod snapshots;
mod stability;
mod states;
mod translucent;
mod usage;
