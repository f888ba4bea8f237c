//! Texels for eight fragments. Which texels is told at once; they are fetched and mixed one fragment after the other, since
//! they lie anywhere.

use common::Vec2;
use fearless_simd::{Simd, f32x8, f64x8, prelude::*, u32x8};
use filtering::Texture;
use filtering::filter::{Bilinear, Filter, Nearest, bilinear, trilinear};
use filtering::footprint::Gradients;
use scene::scene::Filtering;

use super::corners::Triangle;
use super::fragments::{Eight, LANES};
use crate::eight::{narrow, packed};

/// The colours at (u, v).
#[inline(always)]
pub(crate) fn colors<S: Simd>(
    simd: S,
    texture: &Texture,
    filter: Filtering,
    eight: &Eight<S>,
    [u, v]: [f32x8<S>; 2],
) -> u32x8<S> {
    let (us, vs) = (u.to_array(), v.to_array());
    let uv = |lane: usize| Vec2::new(us[lane], vs[lane]);
    let mut colors = [0; LANES];
    let each = colors.iter_mut().enumerate();
    match filter {
        Filtering::Nearest => {
            each.for_each(|(lane, color)| *color = packed(Nearest.color(texture, uv(lane), ())));
        }
        Filtering::Bilinear => {
            each.for_each(|(lane, color)| *color = packed(Bilinear.color(texture, uv(lane), ())));
        }
        Filtering::Trilinear => {
            let base = texture.base();
            let longer_squared = longer_squared(simd, base.size(), eight, [u, v]).to_array();
            each.for_each(|(lane, color)| {
                let light = if longer_squared[lane] > 1.0 {
                    trilinear(texture, uv(lane), 0.5 * libm::log2f(longer_squared[lane]))
                } else {
                    bilinear(base, uv(lane), texture.wrap)
                };
                *color = packed(base.codes().color(light));
            });
        }
    }
    u32x8::load_array(simd, colors)
}

/// The squares of the longer sides of eight footprints, in texels: see [`Gradients::footprint`].
#[inline(always)]
fn longer_squared<S: Simd>(simd: S, size: Vec2, eight: &Eight<S>, uv: [f32x8<S>; 2]) -> f32x8<S> {
    let [x, y] = [column(simd, &eight.pixels[0]), column(simd, &eight.pixels[1])];
    let slope = [of(simd, eight, |g| g.inverse_w.x), of(simd, eight, |g| g.inverse_w.y)];
    let w = 1.0 / (slope[0] * x + slope[1] * y + of(simd, eight, |g| g.inverse_w.z));
    let [u, v] = [widened(uv[0]), widened(uv[1])];
    // How far u or v moves to the next pixel along an axis, in texels.
    let moved = |along: f64x8<S>, slope: f64x8<S>, place: f64x8<S>, texels: f32| {
        narrow(simd, (along - slope * place) * w) * texels
    };
    let [ux, vx] = [
        moved(of(simd, eight, |g| g.u.x), slope[0], u, size.x),
        moved(of(simd, eight, |g| g.v.x), slope[0], v, size.y),
    ];
    let [uy, vy] = [
        moved(of(simd, eight, |g| g.u.y), slope[1], u, size.x),
        moved(of(simd, eight, |g| g.v.y), slope[1], v, size.y),
    ];
    (ux * ux + vx * vx).max_precise(uy * uy + vy * vy)
}

/// A number of the gradients of each one's triangle.
#[inline(always)]
fn of<S: Simd>(simd: S, eight: &Eight<S>, number: impl Fn(&Gradients) -> f64) -> f64x8<S> {
    let number = |triangle: &Triangle| triangle.constant.gradients.as_ref().map_or(0.0, &number);
    if eight.same {
        return f64x8::splat(simd, number(eight.triangles[0]));
    }
    let mut numbers = [0.0; LANES];
    for (to, triangle) in numbers.iter_mut().zip(&eight.triangles) {
        *to = number(triangle);
    }
    f64x8::load_array(simd, numbers)
}

/// The centres of pixels along an axis.
#[inline(always)]
fn column<S: Simd>(simd: S, pixels: &[i32; LANES]) -> f64x8<S> {
    f64x8::load_array(simd, pixels.map(f64::from)) + 0.5
}

#[inline(always)]
fn widened<S: Simd>(numbers: f32x8<S>) -> f64x8<S> {
    let (low, high) = numbers.widen();
    low.combine(high)
}
