//! Sixteen samples of a pixel at once.

use antialiasing::pattern::{PLACES, pattern};
use common::{DVec2, DVec3, Vec3};
use fearless_simd::{Simd, f32x16, f64x8, i32x16, prelude::*};
use triangles::edges::SUBPIXELS;

use crate::eight::narrow;
use crate::triangle::Edges;

/// How many there are.
pub(crate) const SAMPLES: usize = 16;

/// All of them.
pub(crate) const ALL: u32 = 0xffff;

/// Where they are, along each axis, in 1/256 px from the pixel's centre.
const WHOLE: [[i32; SAMPLES]; 2] = {
    let (places, mut at, mut s) = (pattern(SAMPLES), [[0; SAMPLES]; 2], 0);
    while s < SAMPLES {
        let step = SUBPIXELS as i32 / PLACES;
        at[0][s] = places[s][0] * step - SUBPIXELS as i32 / 2;
        at[1][s] = places[s][1] * step - SUBPIXELS as i32 / 2;
        s += 1;
    }
    at
};

/// The same to compute with.
const AT: [[f64; SAMPLES]; 2] = {
    let (mut at, mut s) = ([[0.0; SAMPLES]; 2], 0);
    while s < SAMPLES {
        at[0][s] = WHOLE[0][s] as f64;
        at[1][s] = WHOLE[1][s] as f64;
        s += 1;
    }
    at
};

/// The sums of these over each set of eight samples: of the first eight, and of the others.
const SUMS: [[[f64; 2]; 256]; 2] = {
    let (mut sums, mut set) = ([[[0.0; 2]; 256]; 2], 0);
    while set < 2 * 256 {
        let mut s = 0;
        while s < 8 {
            if (set % 256) >> s & 1 == 1 {
                let sum = &mut sums[set / 256][set % 256];
                sum[0] += AT[0][set / 256 * 8 + s];
                sum[1] += AT[1][set / 256 * 8 + s];
            }
            s += 1;
        }
        set += 1;
    }
    sums
};

/// What an edge function is more at the samples of a pixel than at its centre: whole numbers.
#[derive(Clone, Copy)]
pub(crate) struct Offsets<S: Simd>([[f64x8<S>; 2]; 3]);

impl<S: Simd> Offsets<S> {
    #[inline(always)]
    pub(crate) fn new(simd: S, edges: &Edges) -> Self {
        Self([Self::side(simd, edges, 0), Self::side(simd, edges, 1), Self::side(simd, edges, 2)])
    }

    #[inline(always)]
    fn side(simd: S, edges: &Edges, side: usize) -> [f64x8<S>; 2] {
        let (right, up) = (edges.right[side] / SUBPIXELS as f64, edges.up[side] / SUBPIXELS as f64);
        [
            Self::places(simd, 0, 0) * right + Self::places(simd, 1, 0) * up,
            Self::places(simd, 0, 1) * right + Self::places(simd, 1, 1) * up,
        ]
    }

    /// Half of the places along an axis.
    #[inline(always)]
    fn places(simd: S, axis: usize, half: usize) -> f64x8<S> {
        f64x8::from_slice(simd, &AT[axis][8 * half..8 * half + 8])
    }

    /// The samples that are inside of all three sides, a bit each.
    #[inline(always)]
    pub(crate) fn covered(&self, at: DVec3, inside: DVec3) -> u32 {
        self.half_covered(at, inside, 0) | self.half_covered(at, inside, 1) << 8
    }

    #[inline(always)]
    fn half_covered(&self, at: DVec3, inside: DVec3, half: usize) -> u32 {
        let [a, b, c] = &self.0;
        let a = (a[half] + at.x).simd_ge(inside.x);
        let b = (b[half] + at.y).simd_ge(inside.y);
        let c = (c[half] + at.z).simd_ge(inside.z);
        (a & b & c).to_bitmask() as u32
    }
}

/// The same for a triangle so small that all these fit into an `i32`: less what is inside at least.
#[derive(Clone, Copy)]
pub(crate) struct Margins<S: Simd>([i32x16<S>; 3]);

impl<S: Simd> Margins<S> {
    #[inline(always)]
    pub(crate) fn new(simd: S, edges: &Edges) -> Self {
        Self([Self::side(simd, edges, 0), Self::side(simd, edges, 1), Self::side(simd, edges, 2)])
    }

    #[inline(always)]
    fn side(simd: S, edges: &Edges, side: usize) -> i32x16<S> {
        let [right, up] = [edges.right, edges.up].map(|step| step[side] as i32 / SUBPIXELS as i32);
        let (x, y) = (i32x16::load_array(simd, WHOLE[0]), i32x16::load_array(simd, WHOLE[1]));
        x * right + y * up - edges.inside[side] as i32
    }

    /// The samples that are inside of all three sides, a bit each.
    #[inline(always)]
    pub(crate) fn covered(&self, at: [i32; 3]) -> u32 {
        let [a, b, c] = self.0;
        // The sign of the three together is that of the least.
        ((a + at[0]) | (b + at[1]) | (c + at[2])).simd_ge(0).to_bitmask() as u32
    }
}

/// How deep a triangle is at the samples of its pixels, as lesson 15 computes it.
#[derive(Clone, Copy)]
pub(crate) struct Depths<S: Simd> {
    nearest: f64,
    pub(crate) per_edge: DVec3,
    offsets: [f64x8<S>; 2],
}

impl<S: Simd> Depths<S> {
    #[inline(always)]
    pub(crate) fn new(corners: Vec3, edges: &Edges, offsets: &Offsets<S>) -> Self {
        let nearest = corners.min_element();
        let per_edge = (corners - nearest).as_dvec3() * edges.per_area;
        let [a, b, c] = offsets.0;
        let low = a[0] * per_edge.x + b[0] * per_edge.y + c[0] * per_edge.z;
        let high = a[1] * per_edge.x + b[1] * per_edge.y + c[1] * per_edge.z;
        Self { nearest: nearest.into(), per_edge, offsets: [low, high] }
    }

    #[inline(always)]
    pub(crate) fn at(&self, simd: S, at: DVec3) -> f32x16<S> {
        let center = self.nearest + self.per_edge.dot(at);
        let [low, high] = self.offsets;
        narrow(simd, low + center).combine(narrow(simd, high + center))
    }
}

/// The edge functions at the centroid of those samples whose bits are set: see lesson 15. Sums of whole numbers are the same in
/// whichever order they are added up.
#[inline(always)]
pub(crate) fn centroid(at: DVec3, edges: &Edges, samples: u32) -> DVec3 {
    let [low, high] = [0, 1].map(|n| DVec2::from_array(SUMS[n][(samples >> (8 * n) & 0xff) as usize]));
    let place = low + high;
    let sum = (edges.right * place.x + edges.up * place.y) / SUBPIXELS as f64;
    let count = f64::from(samples.count_ones());
    (at * count + sum) / count
}
