//! The models and textures that charts draw.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;

use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE};
use common::{Attributes, Image, Model};

const ALL: Attributes = Attributes { normals: true, uvs: true };

/// Numbers of triangles from 10 to 10⁵ that a [`sphere`] can have: 2·n².
pub(crate) const TRIANGLES: &[usize] = &[18, 98, 968, 10_082, 100_352];

/// The number of triangles of `sphere.obj`.
pub(crate) const USUAL: usize = 5000;

/// A sphere of so many triangles, made once: 2·n² of them in n sectors and n + 1 bands.
pub(crate) fn sphere(triangles: usize) -> &'static Model {
    thread_local! {
        static MADE: RefCell<BTreeMap<usize, &'static Model>> = RefCell::default();
    }
    let make = || {
        let sectors = sectors(triangles);
        let text = assets::sphere::sphere(sectors + 1, sectors).to_obj();
        let model = Model::parse(text.as_bytes(), ALL).expect("the sphere is a model");
        // It is needed until the program ends.
        &*Box::leak(Box::new(model))
    };
    MADE.with_borrow_mut(|made| *made.entry(triangles).or_insert_with(make))
}

/// The sectors of a sphere of so many triangles.
pub(crate) fn sectors(triangles: usize) -> usize {
    ((triangles as f64 / 2.0).sqrt().round() as usize).max(3)
}

/// What the lessons draw unless told otherwise, with its name and its texture.
pub(crate) fn scene_model() -> anyhow::Result<(String, &'static Model, &'static Image)> {
    let path = Path::new(DEFAULT_MODEL);
    let model = Model::read(path, ALL)?;
    let texture = Image::read(Path::new(DEFAULT_TEXTURE))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok((format!("the {name}"), Box::leak(Box::new(model)), Box::leak(Box::new(texture))))
}

/// The crate's side, 256×256 texels.
pub(crate) fn texture() -> Image {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/crate.png");
    Image::read(Path::new(path)).expect("the course has a crate.png")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spheres_have_as_many_triangles_as_they_say() {
        for triangles in TRIANGLES.iter().copied().filter(|&triangles| triangles < 20_000).chain([USUAL]) {
            assert_eq!(sphere(triangles).faces().len(), triangles);
        }
    }
}
