//! Lesson 13's shader, eight pixels at once.

use common::Vec2;
use fearless_simd::{Simd, f32x8, i32x8, prelude::*, u32x8};
use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Filter, Nearest, Trilinear};
use filtering::footprint::Asked;
use filtering::shader::Filtered;
use filtering::{Texture, Wrap};
use perspective::lighting::Clamped;

use crate::eight::{Eight, Wide, lanes, packed};

/// Eight pixels as lesson 13's shader has them: a triangle's gradients, texture coordinates and a brightness.
pub type Textured<'a, S, F> = Eight<'a, S, (<<F as Filter>::Footprint as Asked>::Constant, ()), (Vec2, f32)>;

/// A filter for eight pixels at once.
pub trait WideFilter: Filter<Footprint: Asked<Constant: Send + Sync + 'static>> + Default + Sync {
    /// The colours at eight (u, v).
    #[inline(always)]
    fn colors<S: Simd>(
        self,
        simd: S,
        texture: &Texture,
        [u, v]: [f32x8<S>; 2],
        eight: &Textured<S, Self>,
    ) -> u32x8<S> {
        let mut colors = [0; 8];
        for lane in lanes(eight.asked) {
            let uv = Vec2::new(u.as_slice()[lane], v.as_slice()[lane]);
            let footprint = Self::Footprint::at(eight.constant(lane).0, eight.x + lane as i32, eight.y, uv);
            colors[lane] = packed(self.color(texture, uv, footprint));
        }
        u32x8::load_array(simd, colors)
    }
}

impl WideFilter for Bilinear {}
impl WideFilter for Bilinear8 {}
impl WideFilter for Trilinear {}
impl WideFilter for Anisotropic {}

impl WideFilter for Nearest {
    #[inline(always)]
    fn colors<S: Simd>(
        self,
        simd: S,
        texture: &Texture,
        [u, v]: [f32x8<S>; 2],
        eight: &Textured<S, Self>,
    ) -> u32x8<S> {
        let level = texture.base();
        let i = texel(simd, u, level.width(), texture.wrap);
        let j = texel(simd, v, level.height(), texture.wrap);
        // Row after row: no texture has so many texels that this overflows.
        let places = (j * level.width() + i).to_array();
        let mut colors = [0; 8];
        if eight.asked == u8::MAX {
            colors
                .iter_mut()
                .zip(places)
                .for_each(|(color, place)| *color = packed(level.at(place as usize)));
        } else {
            lanes(eight.asked).for_each(|lane| colors[lane] = packed(level.at(places[lane] as usize)));
        }
        u32x8::load_array(simd, colors)
    }
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

/// u − ⌊u⌋, as lesson 13's `wrap` has it.
#[inline(always)]
fn fraction<S: Simd>(simd: S, u: f32x8<S>) -> f32x8<S> {
    let zero = f32x8::splat(simd, 0.0);
    let rest = u - u.to_int::<i32x8<S>>().to_float::<f32x8<S>>();
    let positive = rest.simd_lt(0.0).select(rest + 1.0, rest);
    rest.abs().simd_lt(1.0).select(positive, zero)
}

impl<F: WideFilter> Wide for Filtered<'_, F, Clamped> {
    fn keeps_all(&self) -> bool {
        true
    }

    #[inline(always)]
    fn shade<S: Simd>(&self, simd: S, eight: &Eight<S, Self::Constant, Self::Varying>) -> (u32x8<S>, u8) {
        let u = eight.interpolate(simd, |(uv, _)| uv.x);
        let v = eight.interpolate(simd, |(uv, _)| uv.y);
        let intensity = eight.interpolate(simd, |(_, intensity)| *intensity).max_precise(0.0);
        let colors = self.filter.colors(simd, self.texture, [u, v], eight);
        (shaded(simd, colors, intensity), u8::MAX)
    }
}

/// Colours under a light: see `Color::shaded`.
#[inline(always)]
fn shaded<S: Simd>(simd: S, colors: u32x8<S>, intensity: f32x8<S>) -> u32x8<S> {
    let channel = |shift: u32| -> u32x8<S> { (colors >> shift) & 0xff };
    let (r, g, b) = (
        shade(simd, channel(0), intensity),
        shade(simd, channel(8), intensity),
        shade(simd, channel(16), intensity),
    );
    r | (g << 8) | (b << 16) | (colors & 0xff00_0000)
}

#[inline(always)]
fn shade<S: Simd>(simd: S, channel: u32x8<S>, intensity: f32x8<S>) -> u32x8<S> {
    let light = channel.to_float::<f32x8<S>>() * intensity + 0.5;
    // What is too bright is clamped. NaN is made of 0 times an infinite brightness, and becomes a number whose low bits are 0.
    let clamped = light.simd_ge(255.0).select(f32x8::splat(simd, 255.0), light);
    clamped.to_int::<i32x8<S>>().bitcast::<u32x8<S>>() & 0xff
}
