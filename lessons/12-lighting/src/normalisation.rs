//! Vectors made 1 long.
//!
//! Between two corners a normal is interpolated along the chord, not along the arc: it becomes shorter, the more so the
//! farther the two point apart, and a cosine computed with it is too small. A division by its length mends that: a square
//! root and a division, for the normal, for the directions to light and eye, and for the half-way vector, at each pixel.
//!
//! **1/√x without a root.** Read as a whole number, the bits of a positive `f32` are about 2²³·(127 + log₂ x). So those of
//! 1/√x are about 3/2·127·2²³ less half of those of x. A Newton step for the root of 1/y² − x, y·(3 − x·y²)/2, then doubles
//! the number of right digits. The constant is that of *Quake III Arena* (id Software, 1999, `code/game/q_math.c`,
//! `Q_rsqrt`, with one step); C. Lomont (*Fast inverse square root*, 2003) explains it.

use common::{Method, Vec3};

use crate::Draw;
use crate::light::{PointLight, Reflected};
use crate::power::Powf;
use crate::reflection::{Halfway, PointLit, Reflection};
use crate::shader::per_pixel;

/// A way to make vectors 1 long.
pub trait Normalisation: Copy {
    /// A vector of length 1 in the direction of one whose length is from 10⁻¹⁹ to 10¹⁹; 0 stays 0.
    fn direction(v: Vec3) -> Vec3;

    /// What is made of an interpolated normal, likewise.
    #[inline]
    #[must_use]
    fn normal(v: Vec3) -> Vec3 {
        Self::direction(v)
    }
}

/// Normals are taken as they were interpolated. (Directions to light and eye, which are as long as these are far, are made
/// 1 long exactly.)
#[derive(Clone, Copy, Debug)]
pub struct Never;

impl Normalisation for Never {
    #[inline]
    fn direction(v: Vec3) -> Vec3 {
        Exact::direction(v)
    }

    #[inline]
    fn normal(v: Vec3) -> Vec3 {
        v
    }
}

/// By the machine's root and division; a vector too short or too long for its square becomes 0.
#[derive(Clone, Copy, Debug)]
pub struct Exact;

impl Normalisation for Exact {
    #[inline]
    fn direction(v: Vec3) -> Vec3 {
        v.normalize_or_zero()
    }
}

/// By halving bits, and so many Newton steps.
#[derive(Clone, Copy, Debug)]
pub struct Fast<const STEPS: usize>;

// ANCHOR: fast
/// What half of the bits is subtracted from.
pub const MAGIC: u32 = 0x5f37_59df;

impl<const STEPS: usize> Fast<STEPS> {
    /// 1/√x for a normal positive x; a finite number for 0.
    #[inline]
    #[must_use]
    pub fn inverse_root(x: f32) -> f32 {
        let guess = f32::from_bits(MAGIC.wrapping_sub(x.to_bits() >> 1));
        (0..STEPS).fold(guess, |y, _| y * (1.5 - 0.5 * x * y * y))
    }
}

impl<const STEPS: usize> Normalisation for Fast<STEPS> {
    #[inline]
    fn direction(v: Vec3) -> Vec3 {
        v * Self::inverse_root(v.length_squared())
    }
}
// ANCHOR_END: fast

/// One way, as functions that share their code.
#[derive(Clone, Copy)]
pub struct Normalise {
    /// What is made of an interpolated normal.
    pub one: fn(Vec3) -> Vec3,
    /// Does so with each; compiled for just this, it is what gets timed.
    pub all: fn(&mut [Vec3]),
    /// As [`blinn_phong`](crate::blinn_phong), with it.
    pub reflect: fn(Vec3, Vec3, Vec3, &PointLight) -> Reflected,
    /// Draws with it, as the row `blinn-phong` of [`METHODS`](crate::METHODS) does.
    pub draw: Draw,
}

impl Normalise {
    const fn new<N: Normalisation>() -> Self {
        Self {
            one: N::normal,
            all: |normals| normals.iter_mut().for_each(|normal| *normal = N::normal(*normal)),
            reflect: |point, normal, eye, light| {
                PointLit::<Halfway, N, Powf>::new(light).reflect(point, normal, eye)
            },
            draw: per_pixel::<Halfway, N, Powf>,
        }
    }
}

/// The ways to make an interpolated normal 1 long.
pub const NORMALISATIONS: &[Method<Normalise>] = &[
    Method {
        name: "never",
        run: Normalise::new::<Never>(),
        promise: "nothing to compute for the normal; right where a triangle's normals are one",
        failure: "dark between corners, highlights most of all: 129 grey levels off on the head",
    },
    Method {
        name: "fast-0",
        run: Normalise::new::<Fast<0>>(),
        promise: "a shift and a subtraction of whole numbers; within 3.5 %",
        failure: "of four vectors each is off, and the power makes more of it: 91 levels on the head at E = 32",
    },
    Method {
        name: "fast-1",
        run: Normalise::new::<Fast<1>>(),
        promise: "four multiplications and a subtraction more; within 0.18 %",
        failure: "highlights: 11 levels off on the head at E = 32, 36 at E = 128",
    },
    Method {
        name: "fast-2",
        run: Normalise::new::<Fast<2>>(),
        promise: "again four multiplications and a subtraction; within 5·10⁻⁶",
        failure: "large exponents: ½ a level more than exact at E = 1000, 6 levels at E = 10⁴",
    },
    Method {
        name: "exact",
        run: Normalise::new::<Exact>(),
        promise: "within rounding: half a level, that of a colour, at any exponent",
        failure: "a root and a division, each of which takes longer than a multiplication",
    },
];
