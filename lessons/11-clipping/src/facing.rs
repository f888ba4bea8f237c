//! Which side of a triangle is seen.

use common::{DVec2, Method, Vec2, Vec3, Vec4, Vec4Swizzles};
use triangles::edges::SUBPIXELS;
use triangles::to_screen;

/// A triangle as it is in the world and in clip space, for whoever wants to know which side of it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Its corners in the world, counterclockwise seen from outside.
    pub world: [Vec3; 3],
    /// The eye in the world.
    pub eye: Vec3,
    /// Its corners in clip space.
    pub clip: [Vec4; 3],
    /// The picture's size in pixels.
    pub size: Vec2,
}

/// Positive where a triangle faces the eye, negative where it faces away, 0 where it is seen edge-on.
pub type Facing = fn(&View) -> f64;

/// The ways to tell which side is seen.
pub const FACINGS: &[Method<Facing>] = &[
    Method {
        name: "world-normal",
        run: |view| by_normal(view.world, view.eye),
        promise: "in the world, with nothing but positions and the eye",
        failure: "a third set of positions must be kept; in f32 it is wrong for triangles seen nearly edge-on",
    },
    Method {
        name: "determinant",
        run: |view| facing(view.clip),
        promise: "in clip space, before any division: right wherever the corners are, also behind the eye",
        failure: "nothing but the rounding of the positions that it is given",
    },
    Method {
        name: "signed-area",
        run: |view| by_area(view.clip, view.size),
        promise: "of the very triangle that is filled, rounded to 1/256 px: what has no area there is found, too",
        failure: "after the division: each corner behind the eye turns the sign, one at w = 0 has no place",
    },
];

/// Which side of a triangle is seen, from its corners in clip space: the sign of det[(x, y, w)₀ (x, y, w)₁ (x, y, w)₂],
/// positive where it faces the eye (notes, *Primitive assembly*).
///
/// Each product of two is exact; the sum of three is off by some 2⁻⁵⁰ of its largest term.
// ANCHOR: facing
#[inline]
#[must_use]
pub fn facing(corners: [Vec4; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| corner.xyw().as_dvec3());
    a.cross(b).dot(c)
}
// ANCHOR_END: facing

/// The cosine between the triangle's normal and the way to the eye, but for its size.
// ANCHOR: by_normal
fn by_normal([a, b, c]: [Vec3; 3], eye: Vec3) -> f64 {
    f64::from((b - a).cross(c - a).dot(eye - a))
}
// ANCHOR_END: by_normal

/// Twice the area of the triangle in the picture.
// ANCHOR: by_area
fn by_area(corners: [Vec4; 3], size: Vec2) -> f64 {
    area(corners.map(|corner| to_screen(corner.xyz() / corner.w, size)))
}

/// Twice the area of a triangle with its corners rounded as lesson 3 rounds them, in (1/256 px)²; positive where they run
/// counterclockwise.
#[must_use]
pub fn area(corners: [Vec2; 3]) -> f64 {
    let snap = |coordinate: f32| f64::from((coordinate * SUBPIXELS as f32).round_ties_even());
    let [a, b, c] = corners.map(|corner| DVec2::from_array(corner.to_array().map(snap)));
    (b - a).perp_dot(c - a)
}
// ANCHOR_END: by_area

/// Which triangles are left out for the side that they show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Cull {
    /// Those that do not face the eye: nobody sees the inside of a closed surface from outside.
    #[default]
    Back,
    /// Those that do.
    Front,
    /// None.
    None,
}

impl Cull {
    /// Whether a triangle is left out, by its [`facing`].
    #[inline]
    #[must_use]
    pub fn leaves_out(self, facing: f64) -> bool {
        match self {
            Self::Back => facing <= 0.0,
            Self::Front => facing >= 0.0,
            Self::None => false,
        }
    }
}
