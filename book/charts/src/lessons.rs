//! What each lesson measures: beside its chapter.

#[path = "../../lessons/08-camera/charts.rs"]
pub(crate) mod camera;
#[path = "../../lessons/06-gouraud/charts.rs"]
pub(crate) mod gouraud;
#[path = "../../lessons/01-lines/charts.rs"]
pub(crate) mod lines;
#[path = "../../lessons/09-shaders/charts.rs"]
pub(crate) mod shaders;
#[path = "../../lessons/05-textures/charts.rs"]
pub(crate) mod textures;
#[path = "../../lessons/07-transforms/charts.rs"]
pub(crate) mod transforms;
#[path = "../../lessons/03-triangles/charts.rs"]
pub(crate) mod triangles;
#[path = "../../lessons/02-wireframe/charts.rs"]
pub(crate) mod wireframe;
#[path = "../../lessons/04-zbuffer/charts.rs"]
pub(crate) mod zbuffer;
