//! 1/x, exact and fast.
//!
//! Read as a whole number, the bits of a positive `f32` are about 2²³·(127 + log₂ x): an exponent, and below it a
//! fraction that is linear where the logarithm is curved. So a difference of such numbers is about the bits of a
//! quotient, and the bits of 1/x are about 2·127·2²³ less those of x (J. F. Blinn, *Floating-point tricks*, IEEE
//! Computer Graphics and Applications 17(4), 1997). A Newton step for the root of 1/y − x, y·(2 − x·y), then doubles
//! the number of right digits, without a division.

use common::Method;

use crate::depth::ZF32;
use crate::interpolation::{Interpolation, PerPixel};
use crate::{Draw, Visit, draw};

/// A way to compute 1/x.
pub trait Division: Copy + Default {
    /// 1/x for a normal positive x up to 2¹²⁵.
    fn reciprocal(x: f32) -> f32;
}

/// By the machine's division: the nearest `f32`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

impl Division for Exact {
    #[inline]
    fn reciprocal(x: f32) -> f32 {
        1.0 / x
    }
}

/// By subtracting bits, and so many Newton steps.
#[derive(Clone, Copy, Debug, Default)]
pub struct Fast<const STEPS: usize>;

// ANCHOR: fast
/// What the bits are subtracted from. The error is the same on both sides with this one, and so smallest.
pub const MAGIC: u32 = 0x7ef3_11c3;

impl<const STEPS: usize> Division for Fast<STEPS> {
    #[inline]
    fn reciprocal(x: f32) -> f32 {
        let guess = f32::from_bits(MAGIC.wrapping_sub(x.to_bits()));
        (0..STEPS).fold(guess, |y, _| y * (2.0 - x * y))
    }
}
// ANCHOR_END: fast

/// One way, as functions that share their code.
#[derive(Clone, Copy)]
pub struct Reciprocal {
    /// 1/x.
    pub one: fn(f32) -> f32,
    /// Puts 1/x in the place of each x; compiled for just this, it is what gets timed.
    pub all: fn(&mut [f32]),
    /// Draws models with it, once a pixel.
    pub draw: Draw,
    /// Goes through a triangle with it, as the row `per-pixel` of [`METHODS`](crate::METHODS) does.
    pub visit: Visit,
}

impl Reciprocal {
    const fn new<D: Division>() -> Self {
        Self {
            one: D::reciprocal,
            all: |numbers| numbers.iter_mut().for_each(|x| *x = D::reciprocal(*x)),
            draw: draw::<PerPixel<D>, ZF32>,
            visit: |corners, varyings, bounds, visit| {
                PerPixel::<D>::default().fill(corners, varyings, bounds, visit);
            },
        }
    }
}

/// The ways to divide by w.
pub const DIVISIONS: &[Method<Reciprocal>] = &[
    Method {
        name: "fast-0",
        run: Reciprocal::new::<Fast<0>>(),
        promise: "one subtraction of whole numbers; within 5.1 %",
        failure: "weights that sum to 0.95 to 1.05: textures bend inside of every triangle",
    },
    Method {
        name: "fast-1",
        run: Reciprocal::new::<Fast<1>>(),
        promise: "two multiplications and a subtraction more; within 0.26 %",
        failure: "a texture of 200 texels or more is off by half a texel",
    },
    Method {
        name: "fast-2",
        run: Reciprocal::new::<Fast<2>>(),
        promise: "again two multiplications and a subtraction; within 7e-6",
        failure: "17 bits instead of 24: half a texel off from 76,000 texels on",
    },
    Method {
        name: "exact",
        run: Reciprocal::new::<Exact>(),
        promise: "the nearest f32",
        failure: "a division waits longer than a multiplication",
    },
];
