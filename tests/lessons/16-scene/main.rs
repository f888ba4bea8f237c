//! Lesson 16: what its methods draw, where they fail, what its program is asked.

mod alike;
mod alpha;
mod any_scene;
mod cameras;
mod colors;
mod cost;
mod degenerate;
mod handedness;
mod head;
mod lights;
mod motion;
mod order;
mod ownership;
mod pictures;
mod pixels;
mod planes;
mod projections;
mod samples;
mod snapshots;
mod stability;
mod truth;
mod usage;
mod versions;
