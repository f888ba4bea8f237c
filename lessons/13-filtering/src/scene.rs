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
    opaque: bool,
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
        let mut models = Loaded::read_model(flags, Default::default(), origin, SLABS)?;
        models.iter_mut().skip(1).for_each(|floor| floor.texture = fine(&floor.texture));
        Ok(models.into_iter().map(|loaded| Self::new(loaded, mipmap, wrap)).collect())
    }

    /// A model with its texture to be filtered.
    #[must_use]
    pub fn new(loaded: Loaded, mipmap: Mipmap, wrap: Wrap) -> Self {
        let mesh = indexed(&loaded.model, &loaded.normals, Attributes { normals: true, uvs: true });
        let texture = mipmap.texture(&loaded.texture, wrap);
        let opaque = loaded.texture.pixels().all(|(_, _, color)| color.a == u8::MAX);
        Self { loaded, mesh, texture, opaque }
    }

    /// Its vertices and triangles.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Its texture, with all levels.
    #[must_use]
    pub fn texture(&self) -> &Texture {
        &self.texture
    }

    /// Whether every texel of its texture is opaque.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.opaque
    }

    /// What a shader reads of it, under a light and before a camera.
    #[must_use]
    pub fn surface(&self, light: Vec3, to_clip: Mat4) -> Surface<'_> {
        Surface { uniforms: self.loaded.uniforms(light, to_clip), mesh: &self.mesh, texture: &self.texture }
    }
}

/// The floor's checks in 256×256 texels instead of 2×2. Of one texel to a field, a filter that blends neighbours would leave
/// no field as it is.
#[must_use]
pub fn fine(checks: &Image) -> Image {
    checks.scale(SIDE, SIDE)
}
