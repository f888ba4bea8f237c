//! Lesson 16: a scene, and a window to look at it.

pub mod entity;
pub mod frustum;
pub mod head;
pub mod held;
pub mod kept;
pub mod keys;
pub mod lamps;
pub mod levels;
pub mod mesh;
pub mod orbit;
pub mod pixels;
pub mod render;
pub mod scene;
pub mod shader;
pub mod shapes;
pub mod simulation;
pub mod target;
pub mod version_11;
pub mod versions;
#[cfg(feature = "window")]
pub mod window;
pub mod wireframe;

use common::{Lesson, Method, Table};

pub use entity::Entity;
pub use levels::{Levels, METHODS};
pub use mesh::{Mesh, Paint};
pub use orbit::{Orbit, orbit};
pub use render::{Counts, render_scene};
pub use scene::{Filtering, Scene, Shading, Style};
pub use shapes::{Shape, Vertex, cube, sphere};
pub use simulation::Simulation;
pub use target::Target;
pub use versions::{VERSIONS, Version};

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 16,
    name: "scene",
    title: "The scene",
    job: "a scene with a camera, in a window",
    tables: &[Table { name: "", job: "Choose a sphere's triangles", rows: || Method::rows(METHODS) }],
};
