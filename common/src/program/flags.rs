//! Flags that several lessons take and that are neither the model's nor of one lesson's making.

use std::path::PathBuf;

use glam::Vec3;

use super::values;
use crate::Image;

/// `--light`.
#[derive(Clone, Debug, clap::Args)]
pub struct LightFlag {
    /// Direction from the surface to the light, of any length but 0
    #[arg(id = "light", long = "light", value_name = "x,y,z", default_value = "0,0,1", value_parser = values::direction, allow_hyphen_values = true)]
    pub direction: Vec3,
}

/// `--depth`.
#[derive(Clone, Debug, clap::Args)]
pub struct DepthFlag {
    /// Also write the depth buffer as a grey picture: the nearest is white, where nothing is stays black
    #[arg(id = "depth", long = "depth", value_name = "FILE", conflicts_with = "compare")]
    pub file: Option<PathBuf>,
}

impl DepthFlag {
    /// The picture of the depths and its file, where it is asked for.
    pub fn picture(&self, draw: impl FnOnce() -> Image) -> Option<(PathBuf, Image)> {
        self.file.as_ref().map(|path| (path.clone(), draw()))
    }
}
