//! Fragments wait until they are eight, and are shaded at once, whatever triangles they are of.

use blending::translucent::faded;
use common::{Color, Vec2, Vec3};
use fearless_simd::{Simd, f32x8, prelude::*, u32x8};
use filtering::Texture;
use filtering::filter::bilinear;
use scene::mesh::Paint;
use scene::render::Pass;
use scene::scene::{Filtering, Shading, Style};

use super::corners::{COLOR, NORMAL, POINT, Triangle, UV};
use super::light::{Lamp, blinn, lit};
use super::tile::{PIXELS, Tile};
use crate::eight::{code, corners, pack, packed};
use crate::render::in_space;
use crate::texels;

/// How many are shaded at once.
pub(crate) const LANES: usize = 8;

/// How the fragments of a pass look.
pub(crate) struct Look<'a> {
    paint: &'a Paint,
    style: Style,
    eye: Vec3,
    lamps: &'a [Lamp],
    /// As [`scene::render::Pass`] has it.
    pub(crate) alpha: Option<f32>,
}

impl<'a> Look<'a> {
    pub(crate) fn new(pass: &Pass<'a>, style: Style, lamps: &'a [Lamp]) -> Self {
        let Pass { mesh, eye, alpha, .. } = *pass;
        Self { paint: mesh.paint(), style, eye, lamps, alpha }
    }
}

/// A part of a triangle that is seen in a pixel.
#[derive(Clone, Copy, Default)]
struct Seen {
    /// The triangle's number in the list that is being drawn.
    triangle: u32,
    /// The pixel's place in the tile.
    place: u16,
    /// The samples, a bit each.
    samples: u16,
    /// The weights of the corners in the picture.
    weights: Vec3,
}

/// Those of a list of triangles that wait to be shaded: fewer than eight, and those of one triangle more.
pub(crate) struct Fragments(Vec<Seen>);

impl Default for Fragments {
    fn default() -> Self {
        Self(Vec::with_capacity(PIXELS + LANES))
    }
}

/// Eight of them.
pub(crate) struct Group<'a, S: Simd> {
    /// The triangles that they are of, each with a bit for each of its fragments.
    parts: &'a [(u8, &'a Triangle)],
    /// The pixels' columns and rows.
    pixels: [[i32; LANES]; 2],
    /// The weights of the corners in space.
    weights: [f32x8<S>; 3],
}

impl Fragments {
    #[inline(always)]
    pub(crate) fn push(&mut self, triangle: u32, place: usize, samples: u32, weights: Vec3) {
        self.0.push(Seen { triangle, place: place as u16, samples: samples as u16, weights });
    }

    /// Shades eight after the other, as long as there are as many.
    #[inline(always)]
    pub(crate) fn shade<S: Simd>(&mut self, simd: S, look: &Look, triangles: &[Triangle], tile: &mut Tile) {
        let (groups, rest) = self.0.as_chunks::<LANES>();
        if groups.is_empty() {
            return;
        }
        for group in groups {
            shade(simd, look, triangles, group, tile);
        }
        let shaded = self.0.len() - rest.len();
        self.0.drain(..shaded);
    }

    /// Shades what is left, at the end of a list: the last one again and again where there are fewer than eight.
    #[inline(always)]
    pub(crate) fn shade_rest<S: Simd>(
        &mut self,
        simd: S,
        look: &Look,
        triangles: &[Triangle],
        tile: &mut Tile,
    ) {
        let Some(&last) = self.0.last() else { return };
        self.0.resize(LANES, Seen { samples: 0, ..last });
        self.shade(simd, look, triangles, tile);
    }
}

impl<'a, S: Simd> Group<'a, S> {
    /// From the weights in the picture.
    #[inline(always)]
    pub(crate) fn new(
        simd: S,
        parts: &'a [(u8, &'a Triangle)],
        pixels: [[i32; LANES]; 2],
        weights: [f32x8<S>; 3],
    ) -> Self {
        Self { parts, pixels, weights: in_space(simd, parts, weights) }
    }

    /// Their colours. Compiled once for each set of instructions.
    #[inline(always)]
    pub(crate) fn colors(&self, simd: S, look: &Look) -> [u32; LANES] {
        simd.vectorize(
            #[inline(always)]
            || self.shaded(simd, look).to_array(),
        )
    }

    #[inline(always)]
    fn shaded(&self, simd: S, look: &Look) -> u32x8<S> {
        let base = match look.paint {
            Paint::Color(color) => u32x8::splat(simd, packed(*color)),
            Paint::Colors(_) => {
                let [r, g, b] = self.vector(simd, COLOR);
                let a = self.number(simd, COLOR + 3);
                pack([code(simd, r + 0.5), code(simd, g + 0.5), code(simd, b + 0.5), code(simd, a + 0.5)])
            }
            Paint::Texture(texture) => {
                let uv = [self.number(simd, UV), self.number(simd, UV + 1)];
                self.texels(simd, texture, look.style.filter, uv)
            }
        };
        match look.style.shading {
            Shading::Unlit => base,
            Shading::Phong => lit(simd, base, self.number(simd, POINT), self.number(simd, POINT + 1)),
            Shading::BlinnPhong => {
                let (point, normal) = (self.vector(simd, POINT), self.vector(simd, NORMAL));
                let [body, highlight] = blinn(simd, look.lamps, point, normal, look.eye);
                lit(simd, base, body, highlight)
            }
        }
    }

    /// The `n`th of the numbers that are interpolated.
    #[inline(always)]
    fn number(&self, simd: S, n: usize) -> f32x8<S> {
        let [a, b, c] = corners(simd, self.parts, |triangle| {
            [triangle.varyings[0].0[n], triangle.varyings[1].0[n], triangle.varyings[2].0[n]]
        });
        let [x, y, z] = self.weights;
        a * x + b * y + c * z
    }

    /// Three of them, from there on.
    #[inline(always)]
    fn vector(&self, simd: S, n: usize) -> [f32x8<S>; 3] {
        [self.number(simd, n), self.number(simd, n + 1), self.number(simd, n + 2)]
    }

    /// The colours of a texture at (u, v).
    #[inline(always)]
    fn texels(&self, simd: S, texture: &Texture, filter: Filtering, uv: [f32x8<S>; 2]) -> u32x8<S> {
        let (base, all) = (texture.base(), u8::MAX);
        match filter {
            Filtering::Nearest => texels::nearest(simd, texture, uv, all),
            Filtering::Bilinear => {
                let [u, v] = [uv[0].to_array(), uv[1].to_array()];
                texels::each(simd, all, |lane| {
                    base.codes().color(bilinear(base, Vec2::new(u[lane], v[lane]), texture.wrap))
                })
            }
            Filtering::Trilinear => {
                let pixels = &self.pixels;
                let longer_squared =
                    texels::longer_squared(simd, base.size(), pixels, self.parts, Option::as_ref, uv);
                texels::trilinear(simd, texture, uv, longer_squared, all)
            }
        }
    }
}

/// Shades eight fragments, and puts their colours into the tile.
#[inline(always)]
fn shade<S: Simd>(simd: S, look: &Look, triangles: &[Triangle], seen: &[Seen; LANES], tile: &mut Tile) {
    let (parts, count) = parts(triangles, seen);
    let parts = &parts[..count];
    let pixels = seen.map(|one| tile.pixel(one.place.into()));
    let pixels = [pixels.map(|pixel| pixel.x), pixels.map(|pixel| pixel.y)];
    let x = f32x8::load_array(simd, seen.map(|one| one.weights.x));
    let y = f32x8::load_array(simd, seen.map(|one| one.weights.y));
    let z = f32x8::load_array(simd, seen.map(|one| one.weights.z));
    let colors = Group::new(simd, parts, pixels, [x, y, z]).colors(simd, look);
    for (&Seen { place, samples, .. }, color) in seen.iter().zip(colors) {
        let (place, samples) = (usize::from(place), u32::from(samples));
        match look.alpha {
            _ if samples == 0 => {}
            None => tile.paint(simd, place, samples, color),
            Some(alpha) => {
                let [r, g, b, a] = color.to_le_bytes();
                let color = packed(faded(Color { r, g, b, a }, alpha));
                tile.blend(place, samples, color);
            }
        }
    }
}

/// The triangles of eight fragments, and how many these are: fragments of the same one come one after the other.
#[inline(always)]
fn parts<'a>(triangles: &'a [Triangle], seen: &[Seen; LANES]) -> ([(u8, &'a Triangle); LANES], usize) {
    let mut parts = [(0, &triangles[seen[0].triangle as usize]); LANES];
    let mut count = 1;
    for (lane, one) in seen.iter().enumerate() {
        if one.triangle != seen[lane.max(1) - 1].triangle {
            parts[count] = (0, &triangles[one.triangle as usize]);
            count += 1;
        }
        parts[count - 1].0 |= 1 << lane;
    }
    (parts, count)
}
