//! What the programs of this lesson and later ones draw: the head on a floor, or a model alone, with textures to be
//! filtered.

use clipping::mesh::indexed;
use clipping::{Mesh, SLABS};
use common::program::model::TexturedModelFlags;
use common::{Attributes, DVec3, Image, Mat4, Vec3};
use perspective::scene::Loaded;

use crate::Surface;
use crate::mipmap::Mipmap;
use crate::texture::Texture;
use crate::wrap::Wrap;

/// A side of the floor's texture, in texels.
const SIDE: u16 = 256;

/// A model with its mesh, and its texture with all levels.
pub struct Filterable {
    loaded: Loaded,
    mesh: Mesh,
    texture: Texture,
}

impl Filterable {
    /// Reads what the flags ask for, about an origin: the model that they name, or the head on lesson 11's floor.
    ///
    /// # Errors
    /// Where a file cannot be read.
    pub fn read(
        flags: &TexturedModelFlags,
        origin: DVec3,
        mipmap: Mipmap,
        wrap: Wrap,
    ) -> anyhow::Result<Vec<Self>> {
        let models = Loaded::read_model(flags, Default::default(), origin, SLABS)?;
        Ok(models
            .into_iter()
            .enumerate()
            .map(|(n, loaded)| {
                let texture = if n == 0 {
                    mipmap.texture(&loaded.texture, wrap)
                } else {
                    mipmap.texture(&fine(&loaded.texture), wrap)
                };
                let mesh = indexed(&loaded.model, &loaded.normals, Attributes { normals: true, uvs: true });
                Self { loaded, mesh, texture }
            })
            .collect())
    }

    /// What a shader reads of it, under a light and before a camera.
    #[must_use]
    pub fn surface(&self, light: Vec3, to_clip: Mat4) -> Surface<'_> {
        Surface { uniforms: self.loaded.uniforms(light, to_clip), mesh: &self.mesh, texture: &self.texture }
    }
}

/// The floor's checks in more texels: of one to a field, a filter that blends neighbours would leave no field as it is.
#[must_use]
pub fn fine(checks: &Image) -> Image {
    checks.scale(SIDE, SIDE)
}
