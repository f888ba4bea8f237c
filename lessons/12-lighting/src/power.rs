//! Powers of a cosine, which make a highlight small.

use common::Method;

use crate::Draw;
use crate::normalisation::Exact;
use crate::reflection::Halfway;
use crate::shader::per_pixel;

/// A way to compute x^E for many x from 0 to 1 and one E that is not negative.
pub trait Power {
    /// For this exponent: what all x share is computed here.
    fn new(exponent: f32) -> Self;

    /// x^E.
    fn of(&self, x: f32) -> f32;

    /// Of what is less than this the power is taken to be 0, so that nothing more need be known of it.
    #[inline]
    fn least(&self) -> f32 {
        0.0
    }
}

/// By the machine's logarithm and exponential.
#[derive(Clone, Copy, Debug)]
pub struct Powf(f32);

impl Power for Powf {
    fn new(exponent: f32) -> Self {
        Self(exponent)
    }

    #[inline]
    fn of(&self, x: f32) -> f32 {
        x.powf(self.0)
    }
}

/// By squaring: x, x², x⁴, x⁸, and so on, of which those are multiplied that are a bit of E. Right for whole exponents; any
/// other is rounded to the nearest whole one.
#[derive(Clone, Copy, Debug)]
pub struct Squaring(u32);

// ANCHOR: squaring
impl Power for Squaring {
    fn new(exponent: f32) -> Self {
        Self(exponent.round() as u32)
    }

    #[inline]
    fn of(&self, x: f32) -> f32 {
        let (mut power, mut square, mut bits) = (1.0, x, self.0);
        while bits > 0 {
            if bits & 1 == 1 {
                power *= square;
            }
            square *= square;
            bits >>= 1;
        }
        power
    }
}
// ANCHOR_END: squaring

/// x/(E − E·x + x), another function that falls from 1 at x = 1 with the same slope E (C. Schlick, *A fast alternative to
/// Phong's specular model*, Graphics Gems IV, 1994).
#[derive(Clone, Copy, Debug)]
pub struct Schlick(f32);

// ANCHOR: schlick
impl Power for Schlick {
    fn new(exponent: f32) -> Self {
        Self(exponent)
    }

    #[inline]
    fn of(&self, x: f32) -> f32 {
        // In this order nothing cancels near x = 1. At x = E = 0 it is 0/0: there the least number below makes it 0.
        x / (x + self.0 * (1.0 - x)).max(f32::MIN_POSITIVE)
    }
}
// ANCHOR_END: schlick

/// Looked up in a table of 256 powers, of 0 to 1 in equal steps: the nearest one, or interpolated between two.
#[derive(Clone, Copy, Debug)]
pub struct Table<const INTERPOLATED: bool>([f32; SIZE]);

/// How many powers the tables hold.
const SIZE: usize = 256;

// ANCHOR: table
impl<const INTERPOLATED: bool> Power for Table<INTERPOLATED> {
    fn new(exponent: f32) -> Self {
        let step = |n: usize| n as f64 / (SIZE - 1) as f64;
        Self(std::array::from_fn(|n| step(n).powf(exponent.into()) as f32))
    }

    #[inline]
    fn of(&self, x: f32) -> f32 {
        let place = x * (SIZE - 1) as f32;
        if INTERPOLATED {
            let below = (place as usize).min(SIZE - 2);
            let [low, high] = [self.0[below], self.0[below + 1]];
            low + (high - low) * (place - below as f32)
        } else {
            self.0[((place + 0.5) as usize).min(SIZE - 1)]
        }
    }
}
// ANCHOR_END: table

/// One way, as functions that share their code.
#[derive(Clone, Copy)]
pub struct Raise {
    /// x^E, from E and x.
    pub one: fn(f32, f32) -> f32,
    /// Puts x^E in the place of each x; compiled for just this, it is what gets timed.
    pub all: fn(f32, &mut [f32]),
    /// Draws with it, as the row `blinn-phong` of [`METHODS`](crate::METHODS) does.
    pub draw: Draw,
}

impl Raise {
    const fn new<P: Power>() -> Self {
        Self {
            one: |exponent, x| P::new(exponent).of(x),
            all: |exponent, numbers| {
                let power = P::new(exponent);
                numbers.iter_mut().for_each(|x| *x = power.of(*x));
            },
            draw: per_pixel::<Halfway, Exact, P>,
        }
    }
}

/// The ways to compute x^E.
pub const POWERS: &[Method<Raise>] = &[
    Method {
        name: "powf",
        run: Raise::new::<Powf>(),
        promise: "within rounding, for any exponent",
        failure: "a logarithm and an exponential at each pixel, of which platforms round the last digit differently",
    },
    Method {
        name: "squaring",
        run: Raise::new::<Squaring>(),
        promise: "right for whole exponents, to 0.02 of 255 levels at E = 10⁴; one or two multiplications for each bit of E",
        failure: "any other exponent is rounded to a whole one: 1.4 levels of a white highlight at E = 33.5, all of it at E = 0.4",
    },
    Method {
        name: "schlick",
        run: Raise::new::<Schlick>(),
        promise: "a division; the same slope at the brightest point",
        failure: "another curve, which fades more slowly and never wholly: up to 52 levels of a white highlight, at any exponent",
    },
    Method {
        name: "table",
        run: Raise::new::<Table<false>>(),
        promise: "a multiplication and a look into 1 KB",
        failure: "steps, near 1 as high as E/255: 16 levels off a white highlight at E = 32",
    },
    Method {
        name: "table-linear",
        run: Raise::new::<Table<true>>(),
        promise: "two looks into 1 KB and a line between: half a level of a white highlight up to E = 33",
        failure: "large exponents, whose highlight is between the last two: 6 levels at E = 128, 103 at E = 1000",
    },
];
