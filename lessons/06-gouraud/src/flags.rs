//! What the programs of smoothly shaded scenes, this lesson's and later ones, are told and load.

use common::program::Extras;
use common::program::flags::{DepthFlag, LightFlag};
use common::program::model::TexturedModelFlags;
use common::{Attributes, DVec3, Image, Model, Vec3};

use crate::{Drawn, Scene, Wrap, corner_normals};

/// `--model`, `--texture`, `--wrap`, `--light` and `--depth`.
#[derive(Clone, Debug, clap::Args)]
pub struct SceneFlags {
    /// The model and its texture.
    #[command(flatten)]
    pub model: TexturedModelFlags,

    /// Where (u, v) leave 0 to 1: show the texture's border, or the texture again
    #[arg(
        long,
        value_name = "clamp|repeat",
        value_enum,
        hide_possible_values = true,
        default_value = "clamp"
    )]
    pub wrap: Wrap,

    /// The light.
    #[command(flatten)]
    pub light: LightFlag,
    /// The picture of the depths.
    #[command(flatten)]
    pub depth: DepthFlag,
}

/// What the flags ask for, loaded once for any number of pictures.
pub struct LoadedScene {
    model: Model,
    /// The unit normals at the corners of each triangle.
    pub normals: Vec<[Vec3; 3]>,
    texture: Image,
    flags: SceneFlags,
}

impl LoadedScene {
    /// Reads model and texture, about an origin as [`TexturedModelFlags::read_about`] does.
    ///
    /// # Errors
    /// Where one cannot be read.
    pub fn read(flags: SceneFlags, origin: DVec3) -> anyhow::Result<Self> {
        let (model, texture) = flags.model.read_about(origin, Attributes { normals: true, uvs: true })?;
        Ok(Self { normals: corner_normals(&model), model, texture, flags })
    }

    /// The scene to draw.
    #[must_use]
    pub fn scene(&self) -> Scene<'_> {
        Scene {
            model: &self.model,
            normals: &self.normals,
            texture: &self.texture,
            wrap: self.flags.wrap,
            light: self.flags.light.direction,
        }
    }

    /// What there is of a drawing besides the picture.
    #[must_use]
    pub fn extras(&self, drawn: &Drawn) -> Extras {
        let depth = self.flags.depth.picture(|| drawn.depths.picture());
        Extras { depth, left_out: drawn.left_out }
    }
}
