//! The course's own models.

use std::path::Path;

use assets::torus_knot::torus_knot;
use common::program::model::DEFAULT_MODEL;
use common::{Attributes, Model, Vec3};
use gouraud::corner_normals;
use perspective::view;

use crate::stage::{head_texture, light, object, projection, read};
use crate::{FULL, Scene};

const NEEDS: Attributes = Attributes { normals: true, uvs: true };

/// The head as lesson 13 shows it, without the floor.
///
/// # Panics
/// Where one of the head's files cannot be read.
#[must_use]
pub fn head(size: [u16; 2]) -> Scene {
    let model = Model::read(Path::new(DEFAULT_MODEL), NEEDS).unwrap_or_else(|error| panic!("{error}"));
    let view = view(Vec3::new(2.0, 0.2, 3.3), Vec3::new(0.3, -0.35, 0.0), Vec3::Y);
    let normals = corner_normals(&model);
    Scene {
        size,
        object: object(model, normals, head_texture()),
        to_clip: projection(size) * view.expect("the eye is not at the centre"),
        light: light(),
    }
}

/// A knotted tube, 40,000 triangles of wood.
///
/// # Panics
/// Where the wood's file cannot be read.
#[must_use]
pub fn knot() -> Scene {
    let mut mesh = torus_knot(1000, 20);
    // Boards that are about as long as wide.
    mesh.uvs.iter_mut().for_each(|uv| uv.x *= 8.0);
    let model = Model::parse(mesh.to_obj().as_bytes(), NEEDS).unwrap_or_else(|error| panic!("{error}"));
    let view = view(Vec3::new(0.8, 1.7, 1.7), Vec3::ZERO, Vec3::Y);
    let normals = corner_normals(&model);
    Scene {
        size: FULL,
        object: object(model, normals, read(WOOD)),
        to_clip: projection(FULL) * view.expect("the eye is not at the centre"),
        light: light(),
    }
}

const WOOD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/crate.png");
