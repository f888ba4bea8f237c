//! Lesson 16: what its methods draw, where they fail, what its program is asked.

mod cost;
mod frustum;
mod head;
mod levels;
mod snapshots;
mod spheres;
mod stability;
mod stage;
mod usage;
