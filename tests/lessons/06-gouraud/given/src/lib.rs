//! What mission 6 gives: what is drawn, and what a drawing leaves behind. Nothing of lesson 6 is in it, so that the program in
//! which a submission runs has nothing of it either.

use common::{Image, Model, Vec3};

/// What is drawn, and under which light.
pub struct Scene<'a> {
    /// Positions and texture coordinates.
    pub model: &'a Model,
    /// The unit normals at the corners of each triangle.
    pub normals: &'a [[Vec3; 3]],
    /// The texture. Outside, it is what its nearest texel is.
    pub texture: &'a Image,
    /// Unit vector from the surface to the light.
    pub light: Vec3,
}

/// What a drawing leaves behind besides the picture.
pub struct Drawn<Depths> {
    /// The nearest depth in each pixel.
    pub depths: Depths,
    /// How many triangles were left out since a corner of theirs has no place in the picture.
    pub left_out: usize,
}

/// The normals of a model's corners, made 1 long; none of a model without normals.
#[must_use]
pub fn corner_normals(model: &Model) -> Vec<[Vec3; 3]> {
    model.face_normals().map(|normals| normals.map(Vec3::normalize_or_zero)).collect()
}
