//! Lesson 13's shader, eight pixels at once.

use common::{Color, Vec2};
use fearless_simd::{Simd, f32x8, prelude::*, u32x8};
use filtering::Texture;
use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Filter, Nearest, Trilinear};
use filtering::footprint::Asked;
use filtering::shader::Filtered;
use perspective::lighting::Clamped;

use crate::eight::{Eight, Wide, channels, code, pack};
use crate::texels;

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
        let [u, v] = [u.to_array(), v.to_array()];
        texels::each(simd, eight.asked, |lane| {
            let uv = Vec2::new(u[lane], v[lane]);
            one(self, texture, uv, eight.constant(lane).0, [eight.x + lane as i32, eight.y])
        })
    }
}

/// The colour at one (u, v). Compiled once, and not for each set of instructions.
#[inline(never)]
fn one<F: WideFilter>(
    filter: F,
    texture: &Texture,
    uv: Vec2,
    constant: <F::Footprint as Asked>::Constant,
    [x, y]: [i32; 2],
) -> Color {
    filter.color(texture, uv, F::Footprint::at(constant, x, y, uv))
}

impl WideFilter for Bilinear {}
impl WideFilter for Bilinear8 {}
impl WideFilter for Anisotropic {}

impl WideFilter for Nearest {
    #[inline(always)]
    fn colors<S: Simd>(
        self,
        simd: S,
        texture: &Texture,
        uv: [f32x8<S>; 2],
        eight: &Textured<S, Self>,
    ) -> u32x8<S> {
        texels::nearest(simd, texture, uv, eight.asked)
    }
}

impl WideFilter for Trilinear {
    #[inline(always)]
    fn colors<S: Simd>(
        self,
        simd: S,
        texture: &Texture,
        uv: [f32x8<S>; 2],
        eight: &Textured<S, Self>,
    ) -> u32x8<S> {
        // A function of its own: it is long, and asked for in several places.
        simd.vectorize(
            #[inline(always)]
            || {
                let pixels = [std::array::from_fn(|lane| eight.x + lane as i32), [eight.y; 8]];
                let size = texture.base().size();
                let parts = eight.parts;
                let longer_squared =
                    texels::longer_squared(simd, size, &pixels, parts, |(gradients, ())| Some(gradients), uv);
                texels::trilinear(simd, texture, uv, longer_squared, eight.asked)
            },
        )
    }
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
    let [r, g, b] = channels(colors);
    pack([
        code(simd, r * intensity + 0.5),
        code(simd, g * intensity + 0.5),
        code(simd, b * intensity + 0.5),
        colors >> 24,
    ])
}
