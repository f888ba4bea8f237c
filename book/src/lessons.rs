//! The lessons, each with its chapter, its figures and its charts in a folder of `book/lessons/`.

#[path = "../lessons/08-camera/mod.rs"]
pub(crate) mod camera;
#[path = "../lessons/06-gouraud/mod.rs"]
pub(crate) mod gouraud;
#[path = "../lessons/01-lines/mod.rs"]
pub(crate) mod lines;
#[path = "../lessons/09-shaders/mod.rs"]
pub(crate) mod shaders;
#[path = "../lessons/05-textures/mod.rs"]
pub(crate) mod textures;
#[path = "../lessons/07-transforms/mod.rs"]
pub(crate) mod transforms;
#[path = "../lessons/03-triangles/mod.rs"]
pub(crate) mod triangles;
#[path = "../lessons/02-wireframe/mod.rs"]
pub(crate) mod wireframe;
#[path = "../lessons/04-zbuffer/mod.rs"]
pub(crate) mod zbuffer;
