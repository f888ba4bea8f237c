//! Flags of the programs that look through a true camera, this lesson's and later ones.

use common::Mat4;
use common::program::UsageError;

use crate::frustum::{FrustumError, Planes, perspective};

/// `--fov`, `--near` and `--far`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct CameraFlags {
    /// Degrees seen from the bottom to the top of the picture, between 0 and 180
    #[arg(long, value_name = "DEG", default_value_t = 45.0, allow_hyphen_values = true)]
    pub fov: f32,

    /// Depth before the eye from which on there is something to be seen, above 0
    #[arg(long, value_name = "N", default_value_t = 0.1, allow_hyphen_values = true)]
    pub near: f32,

    /// Depth up to which there is something to be seen, beyond the near one; may be inf
    #[arg(long, value_name = "F", default_value_t = 100.0, allow_hyphen_values = true)]
    pub far: f32,
}

impl CameraFlags {
    /// The depths of the near and the far plane.
    #[must_use]
    pub fn planes(&self) -> Planes {
        Planes { near: self.near, far: self.far }
    }

    /// From eye space to clip space, for a picture so many times as wide as it is high.
    ///
    /// # Errors
    /// Where there is no such camera.
    pub fn projection(&self, aspect: f32) -> Result<Mat4, UsageError> {
        let &Self { fov, near, far } = self;
        let refused = |why: String| UsageError(format!("--fov {fov} --near {near} --far {far}: {why}"));
        if near == 0.0 {
            // The limit has a picture, but no depths to draw one by.
            return Err(refused(FrustumError::Near(near).to_string()));
        }
        perspective(fov, aspect, near, far).map_err(|error| refused(error.to_string()))
    }
}
