//! What must hold for any input, tried on random ones. `proptest` makes a failing one small and shows it.

mod camera;
mod lines;
mod shaders;
mod textures;
mod transforms;
mod triangles;
mod wireframe;
mod zbuffer;
