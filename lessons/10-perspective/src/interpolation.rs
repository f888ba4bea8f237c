//! What lies between the corners of a triangle seen in perspective.
//!
//! The weights λ that lesson 3 finds are those of the pixel between the corners **in the picture**. What the corners
//! have, a texture coordinate or a brightness, is linear on the triangle **in space**, and equal steps there are no
//! equal steps in the picture: they shrink with 1/w, w being the depth before the eye. Where the point in space has
//! the weights μ, projecting it gives λᵢ = μᵢ·Wᵢ/W with the corners' depths Wᵢ and its own W; so μᵢ = λᵢ·W/Wᵢ, and as
//! the μ sum to 1, 1/W = Σ λⱼ/Wⱼ (notes, II.1, *Correcting the barycentric weights*). That is why the window keeps
//! 1/w: it is linear in the picture, and the weights in space follow from it.
//!
//! The depth z of the window is a/w + b, linear in the picture like 1/w, and so interpolated with λ itself.

use std::ops::Range;

use common::{Bounds, Vec3, Vec4, Vec4Swizzles};
use shaders::shader::Varying;
use triangles::edges::{Row, Setup};
use zbuffer::{depth_at, fill_depths};

use crate::division::{Division, Exact};

/// What is done with the pixels of a triangle. Any closure of x, y, depth and varying does.
pub trait Pixels<V> {
    /// At a pixel: its place, its depth, and a function for what is interpolated there, which costs nothing where it
    /// is not called.
    fn pixel(&mut self, x: i32, y: i32, depth: f32, varying: impl FnOnce() -> V);
}

impl<V, F: FnMut(i32, i32, f32, V)> Pixels<V> for F {
    #[inline]
    fn pixel(&mut self, x: i32, y: i32, depth: f32, varying: impl FnOnce() -> V) {
        self(x, y, depth, varying());
    }
}

/// A way to interpolate over a triangle.
pub trait Interpolation: Copy + Default {
    /// Goes through the pixels in `bounds` that a triangle covers. Corners are in the window: x and y in pixels, the
    /// depth, which is interpolated with λ, and 1/w. A triangle whose depths are not all finite, or whose 1/w are not
    /// all finite and at least 0 and one of them above, is left out.
    fn fill<V: Varying>(self, corners: [Vec4; 3], varyings: [V; 3], bounds: Bounds, pixels: impl Pixels<V>);
}

// ANCHOR: weights
/// The weights on the triangle in space of the point that has these weights in the picture, given 1/w of the
/// corners, or any multiples of these: μᵢ = λᵢwᵢ / Σλⱼwⱼ.
///
/// The sum is measured from the smallest 1/w, like a depth: where all are equal it is that number to the last bit.
#[inline]
#[must_use]
pub fn perspective_weights(weights: Vec3, inverse_w: Vec3) -> Vec3 {
    weights_by::<Exact>(weights, inverse_w)
}

/// The same by another division.
#[inline]
fn weights_by<D: Division>(weights: Vec3, inverse_w: Vec3) -> Vec3 {
    weights * inverse_w * D::reciprocal(depth_at(inverse_w, weights))
}
// ANCHOR_END: weights

// ANCHOR: affine
/// Linear in the picture, as in lessons 5 to 9.
#[derive(Clone, Copy, Debug, Default)]
pub struct Affine;

impl Interpolation for Affine {
    #[inline]
    fn fill<V: Varying>(
        self,
        corners: [Vec4; 3],
        varyings: [V; 3],
        bounds: Bounds,
        mut pixels: impl Pixels<V>,
    ) {
        if relative(corners).is_some() {
            fill_depths(corners.map(Vec4::xyz), bounds, move |x, y, depth, weights| {
                pixels.pixel(x, y, depth, || V::interpolate(varyings, weights));
            });
        }
    }
}
// ANCHOR_END: affine

// ANCHOR: per_pixel
/// Linear in space: a division at each pixel.
#[derive(Clone, Copy, Debug, Default)]
pub struct PerPixel<D = Exact>(pub D);

impl<D: Division> Interpolation for PerPixel<D> {
    #[inline]
    fn fill<V: Varying>(
        self,
        corners: [Vec4; 3],
        varyings: [V; 3],
        bounds: Bounds,
        mut pixels: impl Pixels<V>,
    ) {
        let Some(inverse_w) = relative(corners) else { return };
        fill_depths(corners.map(Vec4::xyz), bounds, move |x, y, depth, weights| {
            pixels.pixel(x, y, depth, || V::interpolate(varyings, weights_by::<D>(weights, inverse_w)));
        });
    }
}
// ANCHOR_END: per_pixel

/// Linear in space at every `N`th pixel of a row and at its last, linear in the picture between.
///
/// So Quake drew its walls: every 16 pixels where it was written for the Pentium, whose division runs beside the pixels
/// before it, every 8 in its portable C (id Software, *Quake*, 1996, `WinQuake/d_draw16.s` and `d_scan.c`). It had no
/// pixel drawn for nothing; here a stretch that is hidden costs its division all the same.
#[derive(Clone, Copy, Debug, Default)]
pub struct Every<const N: u8>;

// ANCHOR: every
impl<const N: u8> Interpolation for Every<N> {
    #[inline]
    fn fill<V: Varying>(
        self,
        corners: [Vec4; 3],
        varyings: [V; 3],
        bounds: Bounds,
        mut pixels: impl Pixels<V>,
    ) {
        let depths = Vec3::from_array(corners.map(|corner| corner.z));
        let Some(inverse_w) = relative(corners).filter(|_| depths.is_finite()) else { return };
        let Some(setup) = Setup::new(corners.map(Vec4::xy), bounds) else { return };
        for y in setup.bounds.min.y..=setup.bounds.max.y {
            let Row { pixels: Range { start, end }, mut edges } = setup.row(y);
            let begin = edges;
            let exact = |x: i64| {
                let weights = (begin + setup.right * (x - start) as f64) * setup.per_area;
                V::interpolate(varyings, perspective_weights(weights.as_vec3(), inverse_w))
            };
            // A step past the row's end would be a step past the triangle's side, perhaps past the horizon, where 1/w
            // is 0: the last stretch ends at the last pixel, and is as long as is left.
            let mut first = start;
            let mut here = (start < end).then(|| exact(start));
            while let Some(from) = here {
                let next = (first + i64::from(N)).min(end - 1);
                let to = exact(next);
                let step = to.plus(from.times(-1.0)).times(1.0 / (next - first).max(1) as f32);
                for x in first..(first + i64::from(N)).min(end) {
                    let depth = depth_at(depths, (edges * setup.per_area).as_vec3());
                    pixels.pixel(x as i32, y, depth, || from.plus(step.times((x - first) as f32)));
                    edges += setup.right;
                }
                first += i64::from(N);
                here = (first < end).then_some(to);
            }
        }
    }
}
// ANCHOR_END: every

/// The corners' 1/w as shares of the largest, so that none is too small to be multiplied, and equal ones are 1. `None` where
/// a triangle is to be left out: see [`Interpolation::fill`].
#[inline]
#[must_use]
pub fn relative(corners: [Vec4; 3]) -> Option<Vec3> {
    let inverse_w = Vec3::from_array(corners.map(|corner| corner.w));
    let largest = inverse_w.max_element();
    let good = inverse_w.is_finite() && inverse_w.min_element() >= 0.0 && largest > 0.0;
    good.then(|| (inverse_w / largest).max(Vec3::splat(f32::MIN_POSITIVE)))
}
