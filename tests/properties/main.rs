//! What must hold for any input, tried on random ones. `proptest` makes a failing one small and shows it.

mod lines;
mod triangles;
mod wireframe;
