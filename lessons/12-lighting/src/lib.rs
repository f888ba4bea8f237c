//! Lesson 12: a point light.
//!
//! **You will see** the head under a lamp: a highlight on forehead and cheek, the far side in the dark. **New:** light comes
//! from a point in the world; a surface reflects it in three ways, ambient, diffuse and specular, which hangs on where the
//! eye is; and all of it is computed at each pixel, with position and normal interpolated in perspective.
//!
//! The job: what light a surface sends to the eye. [`light`] has the point light, [`reflection`] the models of B. T. Phong
//! and J. F. Blinn, [`scene`] a model at its place in the world, [`surface`] where normals come from, and [`shader`] the
//! shaders: once a triangle, at the corners, at each pixel. [`normalisation`] has ways to make vectors 1 long
//! ([`NORMALISATIONS`]), [`power`] ways to compute powers ([`POWERS`]), each with its error. From lesson 7 comes what turns
//! normals, from lesson 9 what a shader is, from lesson 11 the loop.
//!
//! What a surface brings besides its colour is in [`looks`] ([`LOOKS`]): normals from a map, in the model's space
//! ([`normal_map`]) or in the surface's own ([`tangent`]), a [`specular_map`], and a cartoon's outline ([`toon`]).
//!
//! [`METHODS`] holds four looks, from one brightness for each triangle to one for each pixel.
//!
//! Conventions: as in lesson 11. Light is computed **in the world**: positions by the model's matrix M, normals by (M⁻¹)ᵀ.
//! Normals point out of the surface, whichever side of it is seen.

pub mod flags;
pub mod light;
pub mod looks;
pub mod normal_map;
pub mod normalisation;
pub mod power;
pub mod reflection;
pub mod scene;
pub mod shader;
pub mod specular_map;
pub mod surface;
pub mod tangent;
pub mod toon;

use clipping::{Cull, Drawn, Mesh};
use common::{Image, Lesson, Method, Table};

use normalisation::Exact;
use power::Powf;
use reflection::{Halfway, Mirrored, PointLit};
use shader::{PerCorner, PerTriangle, draw, per_pixel};

pub use light::{Falloff, PointLight, Reflected};
pub use looks::{LOOKS, Look, Maps};
pub use normalisation::NORMALISATIONS;
pub use power::POWERS;
pub use reflection::{blinn_phong, phong};
pub use scene::Scene;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 12,
    name: "lighting",
    title: "Lighting",
    job: "a point light: ambient, diffuse, specular",
    tables: &[
        Table { name: "", job: "Light a surface", rows: || Method::rows(METHODS) },
        Table { name: "normalisations", job: "Make a normal 1 long", rows: || Method::rows(NORMALISATIONS) },
        Table { name: "powers", job: "Raise a cosine to a power", rows: || Method::rows(POWERS) },
        Table { name: "looks", job: "Choose what the surface brings", rows: || Method::rows(LOOKS) },
    ],
};

/// Draws a scene, its model handed over as a mesh, into a black picture.
pub type Draw = fn(&Scene, &Mesh, Cull, &mut Image) -> Drawn;

/// The ways to light a surface, from the first idea to the last.
pub const METHODS: &[Method<Draw>] = &[
    Method {
        name: "flat",
        run: |scene, mesh, cull, image| {
            draw(&PerTriangle::<PointLit<Mirrored>>::new(scene), mesh, cull, image)
        },
        promise: "Phong's model once a triangle, at its middle, with its own normal",
        failure: "facets; a highlight is a whole triangle or none",
    },
    Method {
        name: "phong-vertex",
        run: |scene, mesh, cull, image| draw(&PerCorner::<PointLit<Mirrored>>::new(scene), mesh, cull, image),
        promise: "Phong's model once a vertex; between corners two sums are interpolated",
        failure: "a highlight smaller than a triangle is missed or has its shape, and swims as the model turns",
    },
    Method {
        name: "phong",
        run: per_pixel::<Mirrored, Exact, Powf>,
        promise: "Phong's model at each pixel: highlights of any size, anywhere in a triangle",
        failure: "highlights stay as wide as long where light and eye are low, where those of real surfaces grow long",
    },
    Method {
        name: "blinn-phong",
        run: per_pixel::<Halfway, Exact, Powf>,
        promise: "Blinn's half-way vector at each pixel: highlights grow long where light and eye are low",
        failure: "one vector more to make 1 long; a highlight of a small exponent ends in an edge where the light just grazes",
    },
];
