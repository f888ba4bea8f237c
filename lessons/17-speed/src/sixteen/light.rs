//! Blinn's model at eight fragments: lesson 12's operations in lesson 12's order, where it branches both ways and a choice.

use common::Vec3;
use fearless_simd::{Simd, f32x8, mask32x8, prelude::*, u32x8};
use lighting::PointLight;
use lighting::light::Falloff;
use lighting::power::Power;
use scene::lamps::Seen;

use crate::eight::{channels, code, pack};

/// A light, made ready.
pub(crate) struct Lamp {
    light: PointLight,
    /// The exponent, rounded.
    exponent: u32,
    /// From here on powers of a cosine are 1/1024 or more: what is less is not seen.
    least: f32,
}

impl Lamp {
    pub(crate) fn new(light: &PointLight) -> Self {
        let exponent = light.shininess.round() as u32;
        Self { light: *light, exponent, least: Seen::new(light.shininess).least() }
    }
}

type Vector<S> = [f32x8<S>; 3];

#[inline(always)]
fn dot<S: Simd>([ax, ay, az]: Vector<S>, [bx, by, bz]: Vector<S>) -> f32x8<S> {
    ax * bx + ay * by + az * bz
}

/// One number where a mask says so, else 0.
#[inline(always)]
fn only<S: Simd>(simd: S, mask: mask32x8<S>, number: f32x8<S>) -> f32x8<S> {
    mask.select(number, f32x8::splat(simd, 0.0))
}

/// From eight points to one.
#[inline(always)]
fn to<S: Simd>([x, y, z]: Vector<S>, place: Vec3) -> Vector<S> {
    [place.x - x, place.y - y, place.z - z]
}

/// As [`lighting::normalisation::Exact`].
#[inline(always)]
fn direction<S: Simd>(simd: S, v: Vector<S>) -> Vector<S> {
    let share = 1.0 / dot(v, v).sqrt();
    let is_good = share.simd_lt(f32::INFINITY) & share.simd_gt(0.0);
    let [x, y, z] = v;
    [only(simd, is_good, x * share), only(simd, is_good, y * share), only(simd, is_good, z * share)]
}

/// What eight points with these normals reflect of all lights: of their own colour, and of white.
#[inline(always)]
pub(crate) fn blinn<S: Simd>(
    simd: S,
    lamps: &[Lamp],
    point: Vector<S>,
    normal: Vector<S>,
    eye: Vec3,
) -> [f32x8<S>; 2] {
    let (n, v) = (direction(simd, normal), direction(simd, to(point, eye)));
    let (mut bodies, mut highlights) = (f32x8::splat(simd, 0.0), f32x8::splat(simd, 0.0));
    for Lamp { light, exponent, least } in lamps {
        let to_light = to(point, light.position);
        let l = direction(simd, to_light);
        let n_dot_l = dot(n, l);
        let is_bright = n_dot_l.simd_gt(0.0);
        let arriving = arriving(simd, light.falloff, to_light);
        let body = arriving * light.diffuse * n_dot_l + light.ambient;
        bodies += is_bright.select(body, f32x8::splat(simd, light.ambient));
        if light.specular == 0.0 {
            continue;
        }
        let between = [l[0] + v[0], l[1] + v[1], l[2] + v[2]];
        let along = dot(n, between);
        let along = only(simd, along.simd_gt(0.0), along);
        let is_seen = is_bright & !(along * along).simd_lt(dot(between, between) * (0.9 * least * least));
        if !is_seen.any_true() {
            continue;
        }
        let cosine = dot(n, direction(simd, between)).max(0.0).min(1.0);
        let is_seen = is_seen & cosine.simd_ge(*least);
        let highlight = arriving * light.specular * power(simd, cosine, *exponent);
        highlights += only(simd, is_seen, highlight);
    }
    [bodies, highlights]
}

/// What is left of light on its way: see [`Falloff::share`].
#[inline(always)]
fn arriving<S: Simd>(simd: S, falloff: Falloff, to_light: Vector<S>) -> f32x8<S> {
    if falloff == Falloff::None {
        return f32x8::splat(simd, 1.0);
    }
    let squared = dot(to_light, to_light);
    f32x8::load_array(simd, squared.to_array().map(|squared| falloff.share(squared)))
}

/// By squaring: see [`lighting::power::Squaring`].
#[inline(always)]
fn power<S: Simd>(simd: S, x: f32x8<S>, mut bits: u32) -> f32x8<S> {
    let (mut power, mut square) = (f32x8::splat(simd, 1.0), x);
    while bits > 0 {
        if bits & 1 == 1 {
            power *= square;
        }
        square *= square;
        bits >>= 1;
    }
    power
}

/// Eight colours, lit: see [`lighting::Reflected::color`].
#[inline(always)]
pub(crate) fn lit<S: Simd>(simd: S, base: u32x8<S>, body: f32x8<S>, highlight: f32x8<S>) -> u32x8<S> {
    let white = highlight * 255.0;
    let [r, g, b] = channels(base);
    pack([
        code(simd, r * body + white + 0.5),
        code(simd, g * body + white + 0.5),
        code(simd, b * body + white + 0.5),
        base >> 24,
    ])
}
