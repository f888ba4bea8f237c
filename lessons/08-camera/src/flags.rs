//! Flags of the programs that look at a point, this lesson's and later ones.

use common::Vec3;
use common::program::{UsageError, values};

use crate::turntable::turned;

/// `--eye`, `--center` and `--up`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct ViewFlags {
    /// Where the eye is
    #[arg(long, value_name = "x,y,z", default_value = "1,1,2", value_parser = values::point, allow_hyphen_values = true)]
    pub eye: Vec3,

    /// The point it looks at, which becomes the middle of the picture
    #[arg(long, value_name = "x,y,z", default_value = "0,0,0", value_parser = values::point, allow_hyphen_values = true)]
    pub center: Vec3,

    /// The direction that is up in the picture
    #[arg(long, value_name = "x,y,z", default_value = "0,1,0", value_parser = values::point, allow_hyphen_values = true)]
    pub up: Vec3,
}

impl ViewFlags {
    /// The view, by one of the lesson's methods or functions.
    ///
    /// # Errors
    /// Where there is no direction from the eye to the centre.
    pub fn look<V>(&self, look: fn(Vec3, Vec3, Vec3) -> Option<V>) -> Result<V, UsageError> {
        let one_point = || UsageError("--eye and --center are one point: move one of them".into());
        look(self.eye, self.center, self.up).ok_or_else(one_point)
    }

    /// The same at stop `n` of so many on a full turn, to the right, about the centre.
    #[must_use]
    pub fn turned(&self, n: u16, stops: u16) -> Self {
        let share = f32::from(n) / f32::from(stops);
        Self { eye: turned(self.eye, self.center, self.up, share), ..*self }
    }

    /// From the eye to the centre.
    #[must_use]
    pub fn distance(&self) -> f32 {
        self.eye.distance(self.center)
    }
}

/// `--turntable`, beside `--depth`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct TurntableFlag {
    /// Draw this many pictures on a circle around the model, NAME-000 and so on
    #[arg(id = "turntable", long = "turntable", value_name = "N", value_parser = clap::value_parser!(u16).range(1..=999), conflicts_with_all = ["compare", "depth"])]
    pub stops: Option<u16>,
}
