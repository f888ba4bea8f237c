//! Flags of the programs under a point light.

use common::program::values;
use common::{DVec3, Vec3};

use crate::light::{Falloff, PointLight};

/// `--light-at`, `--ambient`, `--diffuse`, `--specular`, `--shininess` and `--falloff`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct PointLightFlags {
    /// Where the light is
    #[arg(long, value_name = "x,y,z", default_value = "1,1,2", value_parser = place, allow_hyphen_values = true)]
    pub light_at: DVec3,

    /// What of a surface's colour is seen where no light falls, from 0 on
    #[arg(long, value_name = "A", default_value_t = 0.2, value_parser = share, allow_hyphen_values = true)]
    pub ambient: f32,

    /// What is seen more of it where the light falls straight on it, from 0 on
    #[arg(long, value_name = "D", default_value_t = 0.4, value_parser = share, allow_hyphen_values = true)]
    pub diffuse: f32,

    /// How much white a highlight adds, from 0 on
    #[arg(long, value_name = "S", default_value_t = 0.4, value_parser = share, allow_hyphen_values = true)]
    pub specular: f32,

    /// The exponent that makes highlights small, from 0 on
    #[arg(long, value_name = "E", default_value_t = 32.0, value_parser = share, allow_hyphen_values = true)]
    pub shininess: f32,

    /// How light fades with the distance d: not at all, as 1/d, or as 1/d²
    #[arg(
        long,
        value_name = "none|linear|quadratic",
        value_enum,
        hide_possible_values = true,
        default_value = "none"
    )]
    pub falloff: Falloff,
}

impl PointLightFlags {
    /// The light, seen from an origin.
    #[must_use]
    pub fn light(&self, origin: DVec3) -> PointLight {
        let &Self { light_at, ambient, diffuse, specular, shininess, falloff } = self;
        let position = (light_at - origin).as_vec3();
        PointLight { position, ambient, diffuse, specular, shininess, falloff }
    }
}

/// `--stretch`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct StretchFlag {
    /// Stretch the model along its axes by factors above 0, before anything else
    #[arg(id = "stretch", long = "stretch", value_name = "x,y,z", default_value = "1,1,1", value_parser = factors, allow_hyphen_values = true)]
    pub factors: Vec3,
}

/// Beyond this a light has no direction that an `f32` could tell.
const FARTHEST: f64 = 1e18;

fn place(text: &str) -> Result<DVec3, String> {
    let place = DVec3::from_array(values::numbers(text)?);
    let near = place.abs().max_element() <= FARTHEST && !place.is_nan();
    near.then_some(place).ok_or_else(|| "write 3 numbers from -1e18 to 1e18".into())
}

/// What shares and exponents may be at most.
const MOST: f32 = 1e6;

fn share(text: &str) -> Result<f32, String> {
    let share = text.parse().ok().filter(|share| (0.0..=MOST).contains(share));
    share.ok_or_else(|| "write a number from 0 to 1000000".into())
}

fn factors(text: &str) -> Result<Vec3, String> {
    let factors = Vec3::from_array(values::numbers(text)?);
    let good = factors.to_array().iter().all(|factor| (1e-3..=1e3).contains(factor));
    good.then_some(factors).ok_or_else(|| "write 3 numbers from 0.001 to 1000".into())
}
