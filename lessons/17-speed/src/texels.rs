//! Texels for eight fragments.
//!
//! Which texels, and with which shares, is computed for eight at once, by lesson 13's operations in lesson 13's order; they are
//! fetched and mixed one fragment after the other, since they lie anywhere. Their light is decoded once, when a texture is
//! first drawn with, and not at each fetch: 16 bytes a texel in place of four, which takes a sixth or more off a trilinear
//! picture's time. Where lesson 13 asks whether a second level is needed at all, or whether four texels differ, both cost less
//! here than a branch that a processor cannot foresee: between equal ones lies just the same, and a share of 0 changes nothing.

use common::{Color, Vec2, Vec4};
use fearless_simd::{Simd, f32x8, f64x8, i32x8, mask64x8, prelude::*, u32x8};
use filtering::footprint::Gradients;
use filtering::texture::{Level, Texture};
use filtering::{Wrap, filter};

use crate::eight::{Part, lanes, narrow, packed};
use crate::triangle::Ready;

/// How many fragments there are.
const LANES: usize = 8;

/// A colour for each of those that are asked for, found one by one.
#[inline(always)]
pub(crate) fn each<S: Simd>(simd: S, asked: u8, color: impl Fn(usize) -> Color) -> u32x8<S> {
    let mut colors = [0; LANES];
    if asked == u8::MAX {
        colors.iter_mut().enumerate().for_each(|(lane, place)| *place = packed(color(lane)));
    } else {
        lanes(asked).for_each(|lane| colors[lane] = packed(color(lane)));
    }
    u32x8::load_array(simd, colors)
}

/// The texels that (u, v) are in: see [`filter::nearest`].
#[inline(always)]
pub(crate) fn nearest<S: Simd>(simd: S, texture: &Texture, [u, v]: [f32x8<S>; 2], asked: u8) -> u32x8<S> {
    let level = texture.base();
    let i = texel(simd, u, level.width(), texture.wrap);
    let j = texel(simd, v, level.height(), texture.wrap);
    // Row after row: no texture has so many texels that this overflows.
    let places = (j * level.width() + i).to_array();
    each(simd, asked, |lane| level.at(places[lane] as usize))
}

/// Which of n texels each u is in: see lesson 13's `nearest`.
#[inline(always)]
fn texel<S: Simd>(simd: S, u: f32x8<S>, n: i32, wrap: Wrap) -> i32x8<S> {
    let zero = f32x8::splat(simd, 0.0);
    let place = match wrap {
        Wrap::Clamp => u.simd_gt(0.0).select(u.min(1.0), zero),
        Wrap::Repeat => fraction(simd, u),
        Wrap::Mirror => fraction(simd, u * 0.5) * 2.0,
    };
    let last = n * wrap.period() - 1;
    let i = (place * n as f32).to_int::<i32x8<S>>().min(last);
    if wrap == Wrap::Mirror { i.min(i32x8::splat(simd, 2 * n - 1) - i) } else { i }.max(0)
}

/// u − ⌊u⌋, as lesson 13's `wrap` has it; 0 for what is not finite. What is beyond the whole numbers that a lane holds is cut
/// off to any of these, and leaves a rest of 1 or more.
#[inline(always)]
fn fraction<S: Simd>(simd: S, u: f32x8<S>) -> f32x8<S> {
    let zero = f32x8::splat(simd, 0.0);
    let rest = u - u.to_int::<i32x8<S>>().to_float::<f32x8<S>>();
    let place = rest.simd_lt(0.0).select(rest + 1.0, rest);
    rest.abs().simd_lt(1.0).select(place, zero)
}

/// Between two levels: see [`filter::Trilinear`]; `longer_squared` is what [`longer_squared`] tells.
#[inline(always)]
pub(crate) fn trilinear<S: Simd>(
    simd: S,
    texture: &Texture,
    [u, v]: [f32x8<S>; 2],
    longer_squared: f32x8<S>,
    asked: u8,
) -> u32x8<S> {
    let (level, codes) = (level(simd, longer_squared), texture.base().codes());
    if texture.wrap == Wrap::Repeat {
        let lights = repeated(simd, texture, [u, v], level, asked);
        return each(simd, asked, |lane| codes.color(lights[lane]));
    }
    let [u, v, level] = [u.to_array(), v.to_array(), level.to_array()];
    each(simd, asked, |lane| one(texture, Vec2::new(u[lane], v[lane]), level[lane]))
}

/// The colour between two levels at one (u, v). Compiled once, and not for each set of instructions.
#[inline(never)]
fn one(texture: &Texture, uv: Vec2, level: f32) -> Color {
    texture.base().codes().color(filter::trilinear(texture, uv, level))
}

/// The light of a texture that is repeated: see [`filter::trilinear`].
#[inline(always)]
fn repeated<S: Simd>(
    simd: S,
    texture: &Texture,
    [u, v]: [f32x8<S>; 2],
    level: f32x8<S>,
    asked: u8,
) -> [Vec4; LANES] {
    let levels = texture.levels();
    let last = levels.len() - 1;
    let finer = level.min(last as f32).to_int::<i32x8<S>>();
    // At the last level there is no coarser one, and its own counts whole.
    let share =
        finer.simd_lt(last as i32).select(level - finer.to_float::<f32x8<S>>(), f32x8::splat(simd, 0.0));
    let finer = finer.to_array().map(|level| level as usize);
    let coarser = finer.map(|level| (level + 1).min(last));
    let (u, v) = (fraction(simd, u), fraction(simd, v));
    let of = |numbers: [usize; LANES]| numbers.map(|number| &levels[number]);
    let mut lights = within(simd, of(finer), [u, v], asked);
    // Where texels are larger than pixels level 0 is all that counts; and they mostly are for eight fragments or for none.
    if share.simd_gt(0.0).any_true() {
        let (coarse, share) = (within(simd, of(coarser), [u, v], asked), share.to_array());
        for lane in 0..LANES {
            lights[lane] = mix(lights[lane], coarse[lane], share[lane]);
        }
    }
    lights
}

/// The light of each one's level between four texels, at places from 0 to 1.
#[inline(always)]
fn within<S: Simd>(simd: S, levels: [&Level; LANES], [u, v]: [f32x8<S>; 2], asked: u8) -> [Vec4; LANES] {
    let columns = between(simd, u, levels.map(Level::width));
    let rows = between(simd, v, levels.map(Level::height));
    let mut lights = [Vec4::ZERO; LANES];
    for lane in lanes(asked) {
        lights[lane] = four(levels[lane], columns.lane(lane), rows.lane(lane));
    }
    lights
}

/// The light between four texels.
#[inline(always)]
fn four(
    level: &Level,
    ([left, right], across): ([i32; 2], f32),
    ([below, above], up): ([i32; 2], f32),
) -> Vec4 {
    let lights = level.lights();
    // Row after row.
    let [below, above] = [below, above].map(|row| (row * level.width()) as usize);
    let [left, right] = [left, right].map(|column| column as usize);
    let low = mix(lights[below + left], lights[below + right], across);
    let high = mix(lights[above + left], lights[above + right], across);
    mix(low, high, up)
}

/// For eight places in rows of texels: between the centres of which two they lie, and the share of the way to the second.
struct Between {
    texels: [[i32; LANES]; 2],
    share: [f32; LANES],
}

impl Between {
    #[inline(always)]
    fn lane(&self, lane: usize) -> ([i32; 2], f32) {
        ([self.texels[0][lane], self.texels[1][lane]], self.share[lane])
    }
}

/// Of places from 0 to 1 in rows of so many texels.
#[inline(always)]
fn between<S: Simd>(simd: S, u: f32x8<S>, texels: [i32; LANES]) -> Between {
    let count = i32x8::load_array(simd, texels);
    let place = u * count.to_float::<f32x8<S>>() + 0.5;
    let i = place.to_int::<i32x8<S>>();
    let share = place - i.to_float::<f32x8<S>>();
    let zero = i32x8::splat(simd, 0);
    let first = i.simd_eq(0).select(count - 1, i - 1);
    let second = i.simd_ge(count).select(zero, i);
    Between { texels: [first.to_array(), second.to_array()], share: share.to_array() }
}

/// The light a share of the way from one to another.
#[inline(always)]
fn mix(from: Vec4, to: Vec4, share: f32) -> Vec4 {
    from + (to - from) * share
}

/// The squares of the longer sides of eight footprints, in texels: see [`Gradients::footprint`]. `pixels` are columns and
/// rows, `gradients` finds those of a triangle in what is the same all over it.
#[inline(always)]
pub(crate) fn longer_squared<S: Simd, C, V>(
    simd: S,
    size: Vec2,
    pixels: &[[i32; LANES]; 2],
    parts: &[Part<C, V>],
    gradients: impl Fn(&C) -> Option<&Gradients>,
    uv: [f32x8<S>; 2],
) -> f32x8<S> {
    let of = &gradients;
    let [x, y] = [centers(simd, &pixels[0]), centers(simd, &pixels[1])];
    let slope = [number(simd, parts, of, |g| g.inverse_w.x), number(simd, parts, of, |g| g.inverse_w.y)];
    let w = 1.0 / (slope[0] * x + slope[1] * y + number(simd, parts, of, |g| g.inverse_w.z));
    let [u, v] = [widened(uv[0]), widened(uv[1])];
    let [ux, uy] = [number(simd, parts, of, |g| g.u.x), number(simd, parts, of, |g| g.u.y)];
    let [vx, vy] = [number(simd, parts, of, |g| g.v.x), number(simd, parts, of, |g| g.v.y)];
    // How far u and v move to the next pixel along x and along y.
    let ux = narrow(simd, (ux - slope[0] * u) * w) * size.x;
    let uy = narrow(simd, (uy - slope[1] * u) * w) * size.x;
    let vx = narrow(simd, (vx - slope[0] * v) * w) * size.y;
    let vy = narrow(simd, (vy - slope[1] * v) * w) * size.y;
    (ux * ux + vx * vx).max_precise(uy * uy + vy * vy)
}

/// A number of the gradients of each one's triangle; 0 where it has none.
#[inline(always)]
fn number<S: Simd, C, V>(
    simd: S,
    parts: &[Part<C, V>],
    gradients: &impl Fn(&C) -> Option<&Gradients>,
    number: impl Fn(&Gradients) -> f64,
) -> f64x8<S> {
    let of = |triangle: &Ready<C, V>| gradients(&triangle.constant).map_or(0.0, &number);
    let mut numbers = f64x8::splat(simd, of(parts[0].1));
    for &(lanes, triangle) in &parts[1..] {
        let lanes = mask64x8::from_bitmask(simd, lanes.into());
        numbers = lanes.select(f64x8::splat(simd, of(triangle)), numbers);
    }
    numbers
}

/// The centres of pixels along an axis.
#[inline(always)]
fn centers<S: Simd>(simd: S, pixels: &[i32; LANES]) -> f64x8<S> {
    f64x8::load_array(simd, pixels.map(f64::from)) + 0.5
}

#[inline(always)]
fn widened<S: Simd>(numbers: f32x8<S>) -> f64x8<S> {
    let (low, high) = numbers.widen();
    low.combine(high)
}

/// The levels at which footprints are as large as texels, from the square of their longer side; 0 where they are smaller, or NaN.
#[inline(always)]
fn level<S: Simd>(simd: S, longer_squared: f32x8<S>) -> f32x8<S> {
    let is_reduced = longer_squared.simd_gt(1.0);
    log2(is_reduced.select(longer_squared, f32x8::splat(simd, 1.0))) * 0.5
}

/// The logarithm to the base 2 of numbers from 1 on, by the operations of [`libm::log2f`] in the same order, and so with the
/// same last digit (FreeBSD's `e_log2f.c`, where the constants are explained); some large number for what is infinite.
#[inline(always)]
fn log2<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    const IVLN2HI: f32 = 1.442_871_1;
    const IVLN2LO: f32 = -1.760_528_5e-4;
    const LG1: f32 = 0.666_666_6;
    const LG2: f32 = 0.400_009_72;
    const LG3: f32 = 0.284_987_87;
    const LG4: f32 = 0.242_790_79;
    // x as 2^k times a number from √½ to √2.
    let bits = x.to_bits() + (0x3f80_0000 - 0x3f35_04f3);
    let k: f32x8<S> = ((bits >> 23) - 0x7f).to_float();
    let f = f32x8::from_bits((bits & 0x007f_ffff) + 0x3f35_04f3) - 1.0;
    let s = f / (f + 2.0);
    let z = s * s;
    let w = z * z;
    let t1 = w * (w * LG4 + LG2);
    let t2 = z * (w * LG3 + LG1);
    let r = t2 + t1;
    let hfsq = f * 0.5 * f;
    let hi = f32x8::from_bits((f - hfsq).to_bits() & 0xffff_f000);
    let lo = f - hi - hfsq + s * (hfsq + r);
    (lo + hi) * IVLN2LO + lo * IVLN2HI + hi * IVLN2HI + k
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    #[test]
    fn logarithms_have_libms_last_digit() {
        let bits: Vec<u32> = (1.0_f32.to_bits()..f32::INFINITY.to_bits()).step_by(997).collect();
        for bits in bits.as_chunks::<LANES>().0 {
            let x = bits.map(f32::from_bits);
            let logarithms = dispatch!(Level::new(), simd => log2(f32x8::load_array(simd, x)).to_array());
            assert_eq!(logarithms, x.map(libm::log2f), "{x:?}");
        }
    }
}
