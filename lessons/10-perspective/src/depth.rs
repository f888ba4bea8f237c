//! What a depth buffer keeps of a fragment's distance.
//!
//! The window has two numbers that are linear in the picture and so need no division to be interpolated: its z, which
//! is (f/(f−n))·(1 − n/w), and 1/w. A [`Depth`] chooses one of them at the corners, and says what is kept of it at a
//! pixel.
//!
//! **How far apart must two surfaces be to be told apart?** A step of z by δ is a step of w by δ·w²(f−n)/(fn): z24 and
//! z-f32 give nearly all of their values to what is near. Floating point is finest around 0; turned round, so that 0
//! is far, it is finest where z is coarsest, and the two cancel: a gap is the same share of the distance everywhere
//! (N. Reed, *Depth Precision Visualized*, 2015). That only helps if the small number is computed as such. Taking it
//! as 1 − z would keep what rounding did to z near 1, and so would any way over −1 to 1. Here it is
//! (n/(f−n))·(f/w − 1), from 1/w, which is as exact for what is far as for what is near.

use std::ops::RangeInclusive;

use common::Vec4;

use crate::frustum::Planes;

// ANCHOR: depth
/// A way to keep depths.
pub trait Depth: Copy {
    /// Whether a larger number is nearer; else a smaller one is.
    const LARGER_IS_NEARER: bool = false;

    /// For a camera with these planes.
    fn new(planes: Planes) -> Self;

    /// What stands where nothing was drawn: what the far plane has.
    fn nothing(self) -> f32;

    /// What of a corner in the window is interpolated.
    fn corner(self, window: Vec4) -> f32;

    /// What is kept, of what was interpolated.
    fn stored(self, interpolated: f32) -> f32;

    /// Whether of two kept depths the first is nearer.
    #[inline]
    fn is_nearer(self, depth: f32, than: f32) -> bool {
        if Self::LARGER_IS_NEARER { depth > than } else { depth < than }
    }
}
// ANCHOR_END: depth

// ANCHOR: z
/// The window's z, rounded to 2²⁴ levels.
#[derive(Clone, Copy, Debug)]
pub struct Z24;

/// The last of the levels.
const LAST_LEVEL: f32 = ((1 << 24) - 1) as f32;

impl Depth for Z24 {
    fn new(_: Planes) -> Self {
        Self
    }

    fn nothing(self) -> f32 {
        LAST_LEVEL
    }

    #[inline]
    fn corner(self, window: Vec4) -> f32 {
        window.z
    }

    /// An f32 holds each of these whole numbers.
    #[inline]
    fn stored(self, z: f32) -> f32 {
        (z * LAST_LEVEL).round_ties_even().clamp(0.0, LAST_LEVEL)
    }
}

/// The window's z as it is.
#[derive(Clone, Copy, Debug)]
pub struct ZF32;

impl Depth for ZF32 {
    fn new(_: Planes) -> Self {
        Self
    }

    fn nothing(self) -> f32 {
        1.0
    }

    #[inline]
    fn corner(self, window: Vec4) -> f32 {
        window.z
    }

    #[inline]
    fn stored(self, z: f32) -> f32 {
        z
    }
}
// ANCHOR_END: z

// ANCHOR: reversed
/// 1 on the near plane, 0 on the far one: (n/(f−n))·(f/w − 1), as a·(1/w) + b.
#[derive(Clone, Copy, Debug)]
pub struct ReversedZF32 {
    a: f32,
    b: f32,
}

impl Depth for ReversedZF32 {
    const LARGER_IS_NEARER: bool = true;

    fn new(Planes { near, far }: Planes) -> Self {
        let n = f64::from(near);
        let k = n / f64::from(far);
        Self { a: (n / (1.0 - k)) as f32, b: (-k / (1.0 - k)) as f32 }
    }

    fn nothing(self) -> f32 {
        0.0
    }

    #[inline]
    fn corner(self, window: Vec4) -> f32 {
        window.w
    }

    #[inline]
    fn stored(self, inverse_w: f32) -> f32 {
        self.a * inverse_w + self.b
    }
}
// ANCHOR_END: reversed

// ANCHOR: logarithmic
/// log(w/n) / log(f/n), from 0 to 1, computed at each pixel: it is not linear in the picture. The far plane must be
/// finite.
#[derive(Clone, Copy, Debug)]
pub struct Logarithmic {
    near: f32,
    per_octave: f32,
}

impl Depth for Logarithmic {
    fn new(Planes { near, far }: Planes) -> Self {
        Self { near, per_octave: (1.0 / (f64::from(far) / f64::from(near)).log2()) as f32 }
    }

    fn nothing(self) -> f32 {
        1.0
    }

    #[inline]
    fn corner(self, window: Vec4) -> f32 {
        window.w
    }

    #[inline]
    fn stored(self, inverse_w: f32) -> f32 {
        -(self.near * inverse_w).log2() * self.per_octave
    }
}
// ANCHOR_END: logarithmic

// ANCHOR: w
/// The distance w itself: a division at each pixel.
#[derive(Clone, Copy, Debug)]
pub struct W {
    far: f32,
}

impl Depth for W {
    fn new(Planes { far, .. }: Planes) -> Self {
        Self { far }
    }

    fn nothing(self) -> f32 {
        self.far
    }

    #[inline]
    fn corner(self, window: Vec4) -> f32 {
        window.w
    }

    #[inline]
    fn stored(self, inverse_w: f32) -> f32 {
        1.0 / inverse_w
    }
}
// ANCHOR_END: w

// ANCHOR: exact_corner
/// What a corner at that distance has, if nothing before it was rounded: z and 1/w, each the nearest `f32`.
fn exact_corner(Planes { near, far }: Planes, distance: f64) -> Vec4 {
    let k = f64::from(near) / f64::from(far);
    let z = (1.0 - f64::from(near) / distance) / (1.0 - k);
    Vec4::new(0.0, 0.0, z as f32, (1.0 / distance) as f32)
}

/// What is kept of a surface at that distance from the eye.
#[must_use]
pub fn kept<D: Depth>(planes: Planes, distance: f64) -> f32 {
    let depth = D::new(planes);
    depth.stored(depth.corner(exact_corner(planes, distance)))
}

/// The distances of which the same is kept as of this one: two surfaces farther apart than the range is long are
/// always told apart there, two in it never. It ends at `f64::MAX` where nothing farther is told apart.
#[must_use]
pub fn alike<D: Depth>(planes: Planes, distance: f64) -> RangeInclusive<f64> {
    let here = kept::<D>(planes, distance);
    let same = |other: f64| kept::<D>(planes, other) == here;
    border(distance, 0.0, same)..=border(distance, f64::MAX, same)
}
// ANCHOR_END: exact_corner

/// The last distance on the way from `inside` to `outside` that is the same; `outside` itself if all are. By bisection:
/// what is kept never grows again once it falls.
fn border(inside: f64, outside: f64, same: impl Fn(f64) -> bool) -> f64 {
    if same(outside) {
        return outside;
    }
    let (mut inside, mut outside) = (inside.to_bits(), outside.to_bits());
    // The bits of positive numbers are in the numbers' order.
    while inside.abs_diff(outside) > 1 {
        let middle = inside.midpoint(outside);
        if same(f64::from_bits(middle)) { inside = middle } else { outside = middle }
    }
    f64::from_bits(inside)
}
