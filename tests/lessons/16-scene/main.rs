//! Lesson 16: what its methods draw, where they fail, what its program is asked.

mod alpha;
mod cameras;
mod degenerate;
mod handedness;
mod lights;
mod order;
mod ownership;
mod pictures;
mod pixels;
mod planes;
mod snapshots;
mod stability;
mod truth;
mod usage;
mod versions;
