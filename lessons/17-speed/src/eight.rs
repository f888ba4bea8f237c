//! Eight pixels of a row at once, and shaders for them.

use common::{Color, Vec3};
use fearless_simd::{Simd, f32x8, f64x8, prelude::*};
use shaders::shader::{Fragment, Shader, Varying};

/// What a triangle is at eight pixels beside each other.
#[derive(Clone, Copy)]
pub struct Eight<S: Simd> {
    /// The column of the first.
    pub x: i32,
    /// Their row.
    pub y: i32,
    /// Which of them are asked for, a bit each; what the others have means nothing.
    pub asked: u8,
    /// How deep they are.
    pub depths: f32x8<S>,
    /// The weights of the three corners, on the triangle in space.
    pub weights: [f32x8<S>; 3],
}

impl<S: Simd> Eight<S> {
    /// A corner's numbers, interpolated, as [`Varying::interpolate`] does it.
    #[inline(always)]
    pub fn interpolate(&self, [a, b, c]: [f32; 3]) -> f32x8<S> {
        let [x, y, z] = self.weights;
        x * a + y * b + z * c
    }

    /// One of them as a fragment.
    #[inline(always)]
    pub fn fragment<V: Varying>(&self, lane: usize, varyings: [V; 3]) -> Fragment<V> {
        let [x, y, z] = &self.weights;
        let weights = Vec3::new(x.as_slice()[lane], y.as_slice()[lane], z.as_slice()[lane]);
        let varying = V::interpolate(varyings, weights);
        Fragment { x: self.x + lane as i32, y: self.y, depth: self.depths.as_slice()[lane], varying }
    }
}

/// A shader that can be asked for eight pixels at once.
pub trait Wide: Shader<Output = Color> {
    /// Whether it gives each fragment a colour.
    fn keeps_all(&self) -> bool;

    /// The colours of the pixels asked for, and which of these have one, a bit each.
    fn shade<S: Simd>(
        &self,
        simd: S,
        constant: Self::Constant,
        varyings: [Self::Varying; 3],
        eight: &Eight<S>,
    ) -> ([u32; 8], u8);
}

/// Any shader, asked pixel by pixel.
#[derive(Clone, Copy, Debug)]
pub struct EachPixel<T> {
    /// The shader.
    pub shader: T,
    /// Whether it gives each fragment a colour.
    pub keeps_all: bool,
}

/// A colour's four bytes, as they stand in a picture.
#[inline(always)]
pub(crate) fn packed(Color { r, g, b, a }: Color) -> u32 {
    u32::from_le_bytes([r, g, b, a])
}

/// Calls `visit` with the number of each bit that is set.
#[inline(always)]
pub(crate) fn each(mut bits: u8, mut visit: impl FnMut(usize)) {
    while bits != 0 {
        visit(bits.trailing_zeros() as usize);
        bits &= bits - 1;
    }
}

/// Eight f64 as f32, rounded to nearest.
#[inline(always)]
pub(crate) fn narrow<S: Simd>(simd: S, numbers: f64x8<S>) -> f32x8<S> {
    let (low, high) = numbers.split();
    simd.narrow_f64x4(low, high)
}
