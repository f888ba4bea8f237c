//! Flags of the programs that look at a point, this lesson's and later ones.

use common::direction::length;
use common::program::{UsageError, values};
use common::{DVec3, Vec3};

use crate::turntable::turned;

/// `--eye`, `--center` and `--up`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct ViewFlags {
    /// Where the eye is
    #[arg(long, value_name = "x,y,z", default_value = "1,1,2", value_parser = values::point, allow_hyphen_values = true)]
    pub eye: DVec3,

    /// The point it looks at, which becomes the middle of the picture
    #[arg(long, value_name = "x,y,z", default_value = "0,0,0", value_parser = values::point, allow_hyphen_values = true)]
    pub center: DVec3,

    /// The direction that is up in the picture
    #[arg(long, value_name = "x,y,z", default_value = "0,1,0", value_parser = values::point, allow_hyphen_values = true)]
    pub up: DVec3,
}

impl ViewFlags {
    /// The point about which the model is read and seen: the world's origin, or the centre where that is farther
    /// than 1024 from it, as places on maps are. From there on what is left of `f32`'s digits would show: about
    /// 1/20 px of a picture that is 2 wide. (Seen about the centre, `listing` is right.)
    #[must_use]
    pub fn origin(&self) -> DVec3 {
        if self.center.length() > 1024.0 { self.center } else { DVec3::ZERO }
    }

    /// Eye and centre, from the [`origin`](Self::origin).
    fn ends(&self) -> [Vec3; 2] {
        [self.eye, self.center].map(|end| (end - self.origin()).as_vec3())
    }

    /// The view about the [`origin`](Self::origin), by one of the lesson's methods or functions.
    ///
    /// # Errors
    /// Where there is no direction from the eye to the centre.
    pub fn look<V>(&self, look: fn(Vec3, Vec3, Vec3) -> Option<V>) -> Result<V, UsageError> {
        let one_point = || UsageError("--eye and --center are one point: move one of them".into());
        let [eye, center] = self.ends();
        look(eye, center, self.up.as_vec3()).ok_or_else(one_point)
    }

    /// The same at stop `n` of so many on a full turn, to the right, about the centre.
    #[must_use]
    pub fn turned(&self, n: u16, stops: u16) -> Self {
        let share = f32::from(n) / f32::from(stops);
        let [eye, center] = self.ends();
        let eye = turned(eye, center, self.up.as_vec3(), share);
        Self { eye: self.origin() + eye.as_dvec3(), ..*self }
    }

    /// From the eye to the centre.
    #[must_use]
    pub fn distance(&self) -> f32 {
        let [eye, center] = self.ends();
        length(eye - center)
    }
}

/// `--turntable`, beside `--depth`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct TurntableFlag {
    /// Draw this many pictures on a circle around the model, NAME-000 and so on
    #[arg(id = "turntable", long = "turntable", value_name = "N", value_parser = clap::value_parser!(u16).range(1..=999), conflicts_with_all = ["compare", "depth"])]
    pub stops: Option<u16>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_centre_farther_than_1024_becomes_the_origin() {
        let origin = |center| ViewFlags { eye: DVec3::ONE, center, up: DVec3::Y }.origin();
        let [near, far] = [1024.0, 1024.5].map(|x| DVec3::new(0.0, x, 0.0));
        assert_eq!([origin(DVec3::X), origin(near), origin(far)], [DVec3::ZERO, DVec3::ZERO, far]);
    }

    #[test]
    fn the_view_far_away_is_the_view_near_by() {
        let near = ViewFlags { eye: DVec3::new(3.0, 4.0, 12.0), center: DVec3::ZERO, up: DVec3::Y };
        let by = DVec3::new(5000.0, -70.0, 300.0);
        let far = ViewFlags { eye: near.eye + by, center: by, ..near };
        assert_eq!(far.look(crate::lookat).ok(), near.look(crate::lookat).ok());
        assert_eq!([near.distance(), far.distance()], [13.0; 2]);
        assert_eq!(far.turned(1, 4).eye, near.turned(1, 4).eye + by);
    }
}
