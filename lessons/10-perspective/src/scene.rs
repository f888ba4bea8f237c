//! What the programs of this lesson and later ones draw: a head on a floor, or a model alone.

use std::path::Path;

use common::placement::Placement;
use common::program::model::TexturedModelFlags;
use common::{Attributes, DVec3, Image, Mat4, Model, Vec3};
use gouraud::corner_normals;
use gouraud::flags::SceneFlags;
use shaders::Uniforms;
use textures::Wrap;

/// A model with what is drawn of it.
pub struct Loaded {
    /// The triangles, with texture coordinates.
    pub model: Model,
    /// The unit normals at the corners of each triangle.
    pub normals: Vec<[Vec3; 3]>,
    /// Its texture.
    pub texture: Image,
    /// What the texture is outside.
    pub wrap: Wrap,
}

impl Loaded {
    /// Reads what the flags ask for, about an origin: the model that they name, or the head on a floor, of which these are
    /// the model and the texture, which is repeated.
    ///
    /// # Errors
    /// Where a file cannot be read.
    pub fn read(flags: &SceneFlags, origin: DVec3, floor: [&str; 2]) -> anyhow::Result<Vec<Self>> {
        Self::read_model(&flags.model, flags.wrap, origin, floor)
    }

    /// The same where nothing but the model and what its texture is outside is asked for.
    ///
    /// # Errors
    /// Where a file cannot be read.
    pub fn read_model(
        flags: &TexturedModelFlags,
        wrap: Wrap,
        origin: DVec3,
        floor: [&str; 2],
    ) -> anyhow::Result<Vec<Self>> {
        let needs = Attributes { normals: true, uvs: true };
        let (model, texture) = flags.read_about(origin, needs)?;
        let mut models = vec![Self::new(model, texture, wrap)];
        if !flags.is_given() {
            let [model, texture] = floor.map(Path::new);
            let floor = Model::read_placed(model, needs, &Placement { origin, ..Placement::default() })?;
            models.push(Self::new(floor, Image::read(texture)?, Wrap::Repeat));
        }
        Ok(models)
    }

    /// A model, lit smoothly, with its texture and what that is outside.
    #[must_use]
    pub fn new(model: Model, texture: Image, wrap: Wrap) -> Self {
        Self { normals: corner_normals(&model), model, texture, wrap }
    }

    /// What a shader reads of it, under a light and before a camera.
    #[must_use]
    pub fn uniforms(&self, light: Vec3, to_clip: Mat4) -> Uniforms<'_> {
        let Self { model, normals, texture, wrap } = self;
        Uniforms { normals, texture: Some(texture), wrap: *wrap, light, to_clip, ..Uniforms::new(model) }
    }
}
