//! Where methods fail, and where they must not: tables of (input, method, what must happen).
//!
//! A failure is pinned to the letter, so that a test notices when a method stops failing as the lesson says
//! it does. Every method of a lesson has a row for every input.

mod camera;
mod gouraud;
mod lines;
mod shaders;
mod textures;
mod transforms;
mod triangles;
mod wireframe;
mod zbuffer;
