//! Models made for a figure.

use assets::sphere::sphere;
use common::{Attributes, Model};

/// A model written as an OBJ file.
pub(crate) fn parsed(text: &str) -> anyhow::Result<Model> {
    Model::parse(text.as_bytes(), Attributes { normals: true, uvs: true }).map_err(anyhow::Error::msg)
}

/// A ball of radius 1 in bands and sectors, with normals.
pub(crate) fn ball(bands: usize, sectors: usize) -> anyhow::Result<Model> {
    parsed(&sphere(bands, sectors).to_obj())
}
