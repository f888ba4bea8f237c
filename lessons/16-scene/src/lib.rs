//! Lesson 16: a scene, and a window to look at it.
//!
//! **You will see** a head among crates and spheres on a floor that reaches to the horizon, some of them moving, and walk around
//! them by the arrow keys. **New:** nothing is drawn that was not drawn before. What is new is what there is to be drawn, who
//! owns it, and how little of it must be looked at: meshes that entities share, a frame that allocates nothing, entities outside
//! of the picture that cost no vertex, and as many triangles as half a pixel asks for.
//!
//! The job: draw a scene, as often as a window asks. [`shapes`] makes a cube and a sphere, [`mesh`] what never changes of them,
//! [`levels`] keeps a mesh in several resolutions ([`METHODS`]), as [`head`] has them, [`entity`] places one in the world, and a
//! [`scene`](mod@scene) owns entities and lights. [`render`](mod@render) draws it to a [`target`] by the looks of
//! [`shader`](mod@shader) or as a [`wireframe`], after [`frustum`] has told what is in the picture; [`kept`] and [`lamps`] keep
//! what would else be made in every frame. [`orbit`](mod@orbit) moves the camera, [`keys`] and [`held`] tell by what, and a
//! [`simulation`] is all of it as time passes. [`versions`] has the assignment that led to this course, from its first version on,
//! and [`version_11`] what comes last. From lesson 1 come lines, from 7 the matrices, from 10 the camera, from 11 the triangles,
//! from 12 the light, from 13 textures, from 14 what is seen through, from 15 the samples.
//!
//! Conventions: as in lesson 15. The world is right-handed, y up, and the camera looks along −z; angles are in degrees. Where the
//! assignment counts z away from the eye, [`ours`] says what that is here.

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
pub use render::{Counts, Renderer, render_scene};
pub use scene::{Filtering, Scene, Shading, Style};
pub use shapes::{Shape, Vertex, cube, sphere};
pub use simulation::Simulation;
pub use target::Target;
pub use versions::{VERSIONS, Version, ours};

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 16,
    name: "scene",
    title: "The scene",
    job: "a scene with a camera, in a window",
    tables: &[Table { name: "", job: "Choose a sphere's triangles", rows: || Method::rows(METHODS) }],
};
