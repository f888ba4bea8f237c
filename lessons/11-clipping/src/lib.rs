//! Lesson 11: every triangle, wherever the eye is.
//!
//! **You will see** lesson 10's head from so low and near that the floor passes behind the eye: there lesson 10 leaves
//! a triangle out, and half of the floor with it. **New:** triangles are cut in clip space, before the division by w, by
//! the planes that bound what can be drawn; those that show their back are not drawn at all; and each vertex is computed
//! once, whatever number of triangles share it.
//!
//! The job: bring a mesh from its vertices to triangles that can be filled. [`mesh`] unifies an OBJ's three kinds of
//! numbers into vertices ([`ASSEMBLIES`]), [`assembly`] makes triangles of an index buffer: a list, a strip, a fan;
//! [`facing`](mod@facing) tells which side is seen ([`FACINGS`]); [`plane`] has the planes, [`clip`](mod@clip) cuts by one of
//! them, [`homogeneous`] does without cutting, and [`render`](mod@render) is the loop. From lesson 9 come the shaders, from
//! lesson 10 the camera, the window and the filling of one triangle.
//!
//! [`METHODS`] holds what can be done with a triangle that is not wholly in the picture, from leaving it out to not
//! cutting it at all.
//!
//! Conventions: as in lesson 10. A triangle faces the eye where its corners run counterclockwise in the picture. Planes
//! are vectors of clip space with their inner side where the product with a point is not negative.

pub mod assembly;
pub mod clip;
pub mod facing;
pub mod flags;
pub mod homogeneous;
pub mod mesh;
pub mod plane;
pub mod render;

use common::{Image, Lesson, Method, Table};
use perspective::Framebuffer;
use perspective::depth::ZF32;
use perspective::lighting::Clamped;
use shaders::source::Texture;
use shaders::{Lit, Uniforms};
use zbuffer::DepthBuffer;

pub use clip::{ClipVertex, Polygon, clip};
pub use facing::{Cull, FACINGS, facing};
pub use mesh::{ASSEMBLIES, Mesh};
pub use render::{Clipping, Counts, render};

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 11,
    name: "clipping",
    title: "Clipping",
    job: "every triangle, wherever the eye is",
    tables: &[
        Table { name: "", job: "Draw what is not wholly in the picture", rows: || Method::rows(METHODS) },
        Table { name: "facings", job: "Tell which side is seen", rows: || Method::rows(FACINGS) },
        Table { name: "assemblies", job: "Assemble triangles", rows: || Method::rows(ASSEMBLIES) },
    ],
};

/// The model of the floor, in few large triangles, and its texture, which is to be repeated.
pub const SLABS: [&str; 2] = [
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/slabs.obj"),
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/checks.png"),
];

/// What can be done with a triangle that is not wholly in the picture, from the first idea to the last.
pub const METHODS: &[Method<Clipping>] = &[
    Method {
        name: "leave-out",
        run: Clipping::LeaveOut,
        promise: "right where all corners are in front of the eye and between near and far",
        failure: "a triangle with a corner at w ≤ 10⁻⁶ is missing, and what is nearer than the near plane is drawn",
    },
    Method {
        name: "near",
        run: Clipping::Near,
        promise: "cuts by one plane, and nothing is behind the eye any more; the fill's bounds do the rest",
        failure: "corners beyond 2¹⁶ px of the picture are filled slowly, those beyond 2⁵² px not at all",
    },
    Method {
        name: "six-planes",
        run: Clipping::SixPlanes,
        promise: "nothing outside of the picture is left: each corner that is filled lies in it",
        failure: "cuts each triangle at the picture's border, most of them for nothing; cuts move sides by up to 1/256 px",
    },
    Method {
        name: "guard-band",
        run: Clipping::GuardBand,
        promise: "cuts by near and far, and else only what reaches 2¹⁵ px from the picture's middle",
        failure: "nothing known; triangles that touch the eye itself, at w ≤ 10⁻⁶, are left out and counted",
    },
    Method {
        name: "homogeneous",
        run: Clipping::Homogeneous,
        promise: "cuts nothing: any triangle, even through the eye; sides are not rounded to 1/256 px",
        failure: "three more linear functions and a division for each pixel, in f64; a row costs five divisions",
    },
];

/// What a drawing leaves behind besides the picture.
pub struct Drawn {
    /// The nearest depth in each pixel; 1 where nothing is.
    pub depths: DepthBuffer<f32>,
    /// What became of vertices and triangles.
    pub counts: Counts,
}

// ANCHOR: draw
/// Draws models, each as its mesh, with its texture and smoothly lit.
pub fn draw(models: &[(Uniforms, &Mesh)], cull: Cull, clipping: Clipping, image: &mut Image) -> Drawn {
    let mut target = Framebuffer::new(image, ZF32);
    let mut counts = Counts::default();
    for (uniforms, mesh) in models {
        let shader = Lit::new(*uniforms, Texture, Clamped);
        counts += render(&shader, mesh, cull, clipping, &mut target);
    }
    Drawn { depths: target.depths, counts }
}
// ANCHOR_END: draw
