//! The colour of a pixel's footprint.
//!
//! Texel i of n has its centre at u = (i + ½)/n, so between which two centres u lies is told by u·n − ½.
//!
//! What is blended is light: each texel is decoded, sums are of light, and the sum is encoded once, at the end. (Unless a
//! texture's codes are to be taken for light: see [`crate::MIPMAPS`].) Alpha is blended as it is, by itself: colours count as
//! if all were opaque.

use common::{Color, Vec2, Vec4};

use crate::footprint::{Asked, Axes, Footprint, level_of};
use crate::layout::Layout;
use crate::texture::{Level, Texture};
use crate::wrap::Wrap;

/// A way to find the colour of a pixel.
pub trait Filter: Copy {
    /// What it asks for besides (u, v).
    type Footprint: Asked;

    /// The colour at (u, v), the pixel's centre.
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Self::Footprint) -> Color;
}

// ANCHOR: nearest
/// The texel that (u, v) is in.
#[inline]
#[must_use]
pub fn nearest<L: Layout>(level: &Level<L>, uv: Vec2, wrap: Wrap) -> Color {
    let texel = |u: f32, n: i32| {
        // So near to the end of a period that the product is rounded to it, it is the period's last texel.
        let i = (wrap.place(u) * n as f32) as i32;
        wrap.texel(i.min(n * wrap.period() - 1), n)
    };
    level.texel(texel(uv.x, level.width()), texel(uv.y, level.height()))
}
// ANCHOR_END: nearest

// ANCHOR: bilinear
/// The light between the centres of four texels, linear in u and in v.
#[inline]
#[must_use]
pub fn bilinear<L: Layout>(level: &Level<L>, uv: Vec2, wrap: Wrap) -> Vec4 {
    blend_four(level, uv, wrap, |share| share)
}
// ANCHOR_END: bilinear

// ANCHOR: bilinear_8
/// The same with weights of 8 bits, k/256, as graphics hardware has them (NVIDIA, *CUDA C++ Programming Guide*, *Linear
/// Filtering*: "9-bit fixed point format with 8 bits of fractional value").
#[inline]
#[must_use]
pub fn bilinear_8<L: Layout>(level: &Level<L>, uv: Vec2, wrap: Wrap) -> Vec4 {
    blend_four(level, uv, wrap, |share| (share * 256.0 + 0.5) as i32 as f32 / 256.0)
}
// ANCHOR_END: bilinear_8

// ANCHOR: blend_four
/// The light between four texels; `weight` is made of the share, from 0 to 1, of the way from one centre to the next.
#[inline(always)]
fn blend_four<L: Layout>(level: &Level<L>, uv: Vec2, wrap: Wrap, weight: impl Fn(f32) -> f32) -> Vec4 {
    let ([left, right], across) = between(uv.x, level.width(), wrap);
    let ([below, above], up) = between(uv.y, level.height(), wrap);
    let (across, up) = (weight(across), weight(up));
    let texels =
        [(left, below), (right, below), (left, above), (right, above)].map(|(i, j)| level.texel(i, j));
    // Where all four are alike, as they are in most places of a chequered floor, there is nothing to decode but one.
    let bits = texels.map(|Color { r, g, b, a }| u32::from_ne_bytes([r, g, b, a]));
    let light = |texel: usize| level.codes().light(texels[texel]);
    if bits == [bits[0]; 4] {
        return light(0);
    }
    mix(mix(light(0), light(1), across), mix(light(2), light(3), across), up)
}

/// The two of n texels between whose centres u lies, and the share of the way from the first to the second.
#[inline(always)]
fn between(u: f32, n: i32, wrap: Wrap) -> ([i32; 2], f32) {
    // ½ more instead of less, so that it is no less than 0 and a cast rounds it down.
    let place = wrap.place(u) * n as f32 + 0.5;
    let i = place as i32;
    ([wrap.texel(i - 1, n), wrap.texel(i, n)], place - i as f32)
}

/// The light a share of the way from one to another. Between two that are alike it is just theirs.
#[inline]
fn mix(from: Vec4, to: Vec4, share: f32) -> Vec4 {
    from + (to - from) * share
}
// ANCHOR_END: blend_four

// ANCHOR: trilinear
/// The light between two levels, bilinear in each. What is finer than the picture itself, or NaN, is looked up in the picture,
/// what is coarser than the last level in that one.
#[inline]
#[must_use]
pub fn trilinear<L: Layout>(texture: &Texture<L>, uv: Vec2, level: f32) -> Vec4 {
    let (levels, wrap) = (texture.levels(), texture.wrap);
    let last = levels.len() - 1;
    // Counted, not cast: how often is what the last pixel's level tells a processor, which so fetches texels while this one's
    // is still computed. NaN and what is below 0 is at no level.
    let (mut finer, mut coarser) = (0, 1.0);
    while finer < last && level >= coarser {
        (finer, coarser) = (finer + 1, coarser + 1.0);
    }
    if finer == last {
        return bilinear(&levels[last], uv, wrap);
    }
    let share = level - finer as f32;
    let light = bilinear(&levels[finer], uv, wrap);
    if share > 0.0 { mix(light, bilinear(&levels[finer + 1], uv, wrap), share) } else { light }
}
// ANCHOR_END: trilinear

/// The most probes that one pixel costs.
pub const MOST_PROBES: u16 = 16;

// ANCHOR: anisotropic
/// The mean of up to 16 probes along the footprint's long axis, each trilinear, at the level of the short one.
///
/// As many as the long axis is times as long as the short one, or, where this is less than a texel, as the texel; where 16
/// do not reach, the level is that of a 16th of the long axis. (The extension `EXT_texture_filter_anisotropic` of OpenGL
/// has the quotient rounded up. Rounded to nearest, a footprint that is hardly longer than wide costs one probe, and is not
/// broadened by a second.)
#[inline]
#[must_use]
pub fn anisotropic<L: Layout>(texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Vec4 {
    let size = texture.base().size();
    let Axes { direction, major, minor } = footprint.texels(size).axes();
    let width = minor.max(major / f32::from(MOST_PROBES));
    // A cast turns NaN into 0; one probe there is always.
    let count = ((major / width.max(1.0)).round() as u16).clamp(1, MOST_PROBES);
    let level = libm::log2f(width);
    let step = direction * (major / f32::from(count)) / size;
    let first = uv - step * (f32::from(count - 1) / 2.0);
    let probes = (0..count).map(|n| trilinear(texture, first + step * f32::from(n), level));
    probes.sum::<Vec4>() / f32::from(count)
}
// ANCHOR_END: anisotropic

/// See [`nearest`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Nearest;

impl Filter for Nearest {
    type Footprint = ();

    #[inline]
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, (): ()) -> Color {
        nearest(texture.base(), uv, texture.wrap)
    }
}

/// See [`bilinear`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Bilinear;

impl Filter for Bilinear {
    type Footprint = ();

    #[inline]
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, (): ()) -> Color {
        texture.base().codes().color(bilinear(texture.base(), uv, texture.wrap))
    }
}

/// See [`bilinear_8`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Bilinear8;

impl Filter for Bilinear8 {
    type Footprint = ();

    #[inline]
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, (): ()) -> Color {
        texture.base().codes().color(bilinear_8(texture.base(), uv, texture.wrap))
    }
}

/// See [`trilinear`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Trilinear;

impl Filter for Trilinear {
    type Footprint = Footprint;

    #[inline]
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        let base = texture.base();
        let longer_squared = footprint.longer_squared(base.size());
        // Where the texture is enlarged it takes no logarithm to know the level.
        let light = if longer_squared > 1.0 {
            trilinear(texture, uv, level_of(longer_squared))
        } else {
            bilinear(base, uv, texture.wrap)
        };
        base.codes().color(light)
    }
}

/// See [`anisotropic`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Anisotropic;

impl Filter for Anisotropic {
    type Footprint = Footprint;

    #[inline]
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        texture.base().codes().color(anisotropic(texture, uv, footprint))
    }
}
