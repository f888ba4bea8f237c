//! A point light, and what a surface reflects of it.

use common::{Color, Vec3};

/// A light that shines from one point in all directions.
///
/// Ambient light stands for what comes from everywhere, by way of other surfaces: it is the same in all places. The three
/// shares and the exponent are finite and not negative; shares above 1 are allowed, and what is too bright for a channel is
/// clamped there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it is in the world.
    pub position: Vec3,
    /// A: what of a surface's colour is seen without it.
    pub ambient: f32,
    /// D: what of a surface's colour is seen more where the light falls straight on it.
    pub diffuse: f32,
    /// S: how much white is added where the surface mirrors the light straight into the eye.
    pub specular: f32,
    /// E: the exponent that makes a highlight small, the greater the smaller.
    pub shininess: f32,
    /// How diffuse and specular light fade with the distance.
    pub falloff: Falloff,
}

impl Default for PointLight {
    /// The light of the lesson's program.
    fn default() -> Self {
        Self {
            position: Vec3::new(1.0, 1.0, 2.0),
            ambient: 0.2,
            diffuse: 0.4,
            specular: 0.4,
            shininess: 32.0,
            falloff: Falloff::None,
        }
    }
}

/// How light fades with the distance d from where it comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Falloff {
    /// Not at all.
    #[default]
    None,
    /// As 1/d.
    Linear,
    /// As 1/d²: the light that passes through a sphere about the point is the same for any radius.
    Quadratic,
}

/// What light near its own source is computed for at least, squared: so nothing is ever infinite.
const NEAREST_SQUARED: f32 = 1e-12;

impl Falloff {
    /// What is left of light after a distance, of which the square is given; a distance below 10⁻⁶ counts as 10⁻⁶.
    // ANCHOR: falloff
    #[inline]
    #[must_use]
    pub fn share(self, distance_squared: f32) -> f32 {
        let squared = distance_squared.max(NEAREST_SQUARED);
        match self {
            Self::None => 1.0,
            Self::Linear => 1.0 / squared.sqrt(),
            Self::Quadratic => 1.0 / squared,
        }
    }
    // ANCHOR_END: falloff
}

/// What a surface reflects towards the eye, as shares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflected {
    /// Of the surface's own colour: A + D·max(0, n·l).
    pub body: f32,
    /// Of white, the light's colour: S·s, with s = max(0, r·v)^E or max(0, n·h)^E.
    pub highlight: f32,
}

impl Reflected {
    /// The colour that is seen of a surface with the colour `base`: base·body + white·highlight. Each channel is rounded to
    /// nearest and clamped to 255; alpha stays.
    // ANCHOR: color
    #[inline]
    #[must_use]
    pub fn color(self, base: Color) -> Color {
        // A float cast saturates, so this line does the clamping.
        let channel = |base: u8| (f32::from(base) * self.body + 255.0 * self.highlight + 0.5) as u8;
        Color { r: channel(base.r), g: channel(base.g), b: channel(base.b), a: base.a }
    }
    // ANCHOR_END: color
}
