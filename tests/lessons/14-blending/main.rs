//! Lesson 14: what its methods draw, where they fail, what its program is asked.

mod glass;
mod layers;
mod order;
mod products;
mod spaces;
