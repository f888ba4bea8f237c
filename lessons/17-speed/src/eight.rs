//! Eight pixels of a row at once, and shaders for them.

use common::{Color, Vec3, Vec4};
use fearless_simd::{Simd, f32x8, f64x8, i32x8, mask32x8, prelude::*, u32x8};
use shaders::shader::{Fragment, Shader, Varying};

use crate::triangle::Ready;

/// Some of eight pixels, a bit each, and the triangle that is seen there.
pub(crate) type Part<'a, C, V> = (u8, &'a Ready<C, V>);

/// Eight pixels beside each other, and the triangles that are seen in them: mostly one.
pub struct Eight<'a, S: Simd, C, V> {
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
    pub(crate) parts: &'a [Part<'a, C, V>],
}

impl<S: Simd, C: Copy, V: Varying> Eight<'_, S, C, V> {
    /// A number that corners have, interpolated as [`Varying::interpolate`] does it.
    #[inline(always)]
    pub fn interpolate(&self, simd: S, number: impl Fn(&V) -> f32) -> f32x8<S> {
        let [a, b, c] = corners(simd, self.parts, |triangle| {
            [number(&triangle.varyings[0]), number(&triangle.varyings[1]), number(&triangle.varyings[2])]
        });
        let [x, y, z] = self.weights;
        a * x + b * y + c * z
    }

    /// What is the same all over the triangle that is seen in one of them.
    #[inline(always)]
    pub fn constant(&self, lane: usize) -> &C {
        &self.triangle(lane).constant
    }

    #[inline(always)]
    fn triangle(&self, lane: usize) -> &Ready<C, V> {
        let part = self.parts.iter().find(|(lanes, _)| lanes >> lane & 1 == 1);
        part.unwrap_or(&self.parts[0]).1
    }

    /// One of them as a fragment.
    #[inline(always)]
    pub fn fragment(&self, lane: usize) -> Fragment<V> {
        let [x, y, z] = &self.weights;
        let weights = Vec3::new(x.as_slice()[lane], y.as_slice()[lane], z.as_slice()[lane]);
        let varying = V::interpolate(self.triangle(lane).varyings, weights);
        Fragment { x: self.x + lane as i32, y: self.y, depth: self.depths.as_slice()[lane], varying }
    }
}

// ANCHOR: corners
/// What the three corners have, at each pixel those of the triangle that is seen there.
#[inline(always)]
pub(crate) fn corners<S: Simd, C, V>(
    simd: S,
    parts: &[Part<C, V>],
    numbers: impl Fn(&Ready<C, V>) -> [f32; 3],
) -> [f32x8<S>; 3] {
    let [a, b, c] = numbers(parts[0].1);
    let mut all = [f32x8::splat(simd, a), f32x8::splat(simd, b), f32x8::splat(simd, c)];
    for &(lanes, triangle) in &parts[1..] {
        let lanes = mask(simd, lanes);
        let [a, b, c] = numbers(triangle);
        all[0] = lanes.select(f32x8::splat(simd, a), all[0]);
        all[1] = lanes.select(f32x8::splat(simd, b), all[1]);
        all[2] = lanes.select(f32x8::splat(simd, c), all[2]);
    }
    all
}
// ANCHOR_END: corners

/// A shader that can be asked for eight pixels at once.
pub trait Wide: Shader<Output = Color> + Sync {
    /// Whether it gives each fragment a colour.
    fn keeps_all(&self) -> bool;

    /// The colours of the pixels asked for, their four bytes as they stand in a picture, and which have one, a bit each.
    fn shade<S: Simd>(&self, simd: S, eight: &Eight<S, Self::Constant, Self::Varying>) -> (u32x8<S>, u8);
}

/// Any shader, asked pixel by pixel.
#[derive(Clone, Copy, Debug)]
pub struct EachPixel<T> {
    /// The shader.
    pub shader: T,
    /// Whether it gives each fragment a colour.
    pub keeps_all: bool,
}

impl<T: Shader<Output = Color>> Shader for EachPixel<T> {
    type Constant = T::Constant;
    type Varying = T::Varying;
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        self.shader.position(vertex)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<T::Constant> {
        self.shader.triangle(face)
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> T::Varying {
        self.shader.corner(face, corner)
    }

    #[inline(always)]
    fn fragment(&self, constant: T::Constant, fragment: Fragment<T::Varying>) -> Option<Color> {
        self.shader.fragment(constant, fragment)
    }
}

impl<T: Shader<Output = Color> + Sync> Wide for EachPixel<T> {
    fn keeps_all(&self) -> bool {
        self.keeps_all
    }

    #[inline(always)]
    fn shade<S: Simd>(&self, simd: S, eight: &Eight<S, T::Constant, T::Varying>) -> (u32x8<S>, u8) {
        let (mut colors, mut kept) = ([0; 8], 0);
        for lane in lanes(eight.asked) {
            if let Some(color) = self.shader.fragment(*eight.constant(lane), eight.fragment(lane)) {
                colors[lane] = packed(color);
                kept |= 1 << lane;
            }
        }
        (u32x8::load_array(simd, colors), kept)
    }
}

/// A colour's four bytes, as they stand in a picture.
#[inline(always)]
#[must_use]
pub fn packed(Color { r, g, b, a }: Color) -> u32 {
    u32::from_le_bytes([r, g, b, a])
}

/// A colour from its four bytes.
#[inline(always)]
pub(crate) fn unpacked(color: u32) -> Color {
    let [r, g, b, a] = color.to_le_bytes();
    Color { r, g, b, a }
}

/// Red, green and blue of eight colours, as numbers to compute with.
#[inline(always)]
pub(crate) fn channels<S: Simd>(colors: u32x8<S>) -> [f32x8<S>; 3] {
    [(colors & 0xff).to_float(), (colors >> 8 & 0xff).to_float(), (colors >> 16 & 0xff).to_float()]
}

/// Rounded down to a code from 0 to 255, as a cast does it: NaN is 0.
#[inline(always)]
pub(crate) fn code<S: Simd>(simd: S, number: f32x8<S>) -> u32x8<S> {
    let positive = number.simd_gt(0.0).select(number, f32x8::splat(simd, 0.0));
    positive.min(255.0).to_int::<i32x8<S>>().bitcast()
}

/// Four channels' codes as colours.
#[inline(always)]
pub(crate) fn pack<S: Simd>([r, g, b, a]: [u32x8<S>; 4]) -> u32x8<S> {
    r | g << 8 | b << 16 | a << 24
}

/// The numbers of the bits that are set.
#[inline(always)]
pub(crate) fn lanes(bits: u8) -> impl Iterator<Item = usize> {
    (0..8).filter(move |lane| bits >> lane & 1 == 1)
}

/// A mask of lanes from bits.
#[inline(always)]
pub(crate) fn mask<S: Simd>(simd: S, bits: u8) -> mask32x8<S> {
    mask32x8::from_bitmask(simd, bits.into())
}

/// New numbers in the lanes of a mask, and old ones in the others, by bits that change. Of `select` between what is read and
/// what is written in the same place compilers make a masked store, with which `deferred` took 1.4 times as long on the machine
/// of the book's charts.
#[inline(always)]
pub(crate) fn merged<S: Simd>(simd: S, lanes: mask32x8<S>, new: u32x8<S>, old: u32x8<S>) -> u32x8<S> {
    old ^ lanes.select(new ^ old, u32x8::splat(simd, 0))
}

/// Eight f64 as f32, rounded to nearest.
#[inline(always)]
pub(crate) fn narrow<S: Simd>(simd: S, numbers: f64x8<S>) -> f32x8<S> {
    let (low, high) = numbers.split();
    simd.narrow_f64x4(low, high)
}
