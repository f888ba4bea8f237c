//! Lesson 17: that each of its methods draws lesson 13's pixels, and what its program is asked.

mod any_scene;
mod canvas;
mod cost;
mod looks;
mod many;
mod nearly;
mod snapshots;
mod soup;
mod stability;
mod usage;
