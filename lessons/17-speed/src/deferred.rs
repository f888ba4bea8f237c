//! Deferred: what is seen is found first, and shaded once.

use fearless_simd::{Simd, f32x8, mask32x8, prelude::*, u32x8};

use crate::eight::Wide;
use crate::frame::shade;
use crate::raster::{Group, spread, weights};
use crate::tile::{NONE, Tile};
use crate::triangle::Ready;

/// Notes that a triangle is seen in those of eight pixels.
#[inline(always)]
pub(crate) fn see<S: Simd>(simd: S, lanes: mask32x8<S>, number: u32, seen: &mut [u32]) {
    let kept = u32x8::from_slice(simd, seen);
    lanes.select(u32x8::splat(simd, number), kept).store_slice(seen);
}

/// Shades what is seen in a tile, and forgets it.
#[inline(always)]
pub(crate) fn shade_seen<S: Simd, W: Wide>(
    simd: S,
    shader: &W,
    ready: &[Ready<W::Constant, W::Varying>],
    tile: &mut Tile,
) {
    let (min, stride) = (tile.bounds.min, tile.stride);
    for place in (0..tile.seen.len()).step_by(8) {
        let numbers = u32x8::from_slice(simd, &tile.seen[place..place + 8]);
        let none = u32x8::splat(simd, NONE);
        let mut left = !numbers.simd_eq(none).to_bitmask() as u8;
        if left == 0 {
            continue;
        }
        none.store_slice(&mut tile.seen[place..place + 8]);
        let (x, y) = (min.x + (place % stride) as i32, min.y + (place / stride) as i32);
        let depths = f32x8::from_slice(simd, &tile.depths[place..place + 8]);
        while left != 0 {
            let number = numbers.as_slice()[left.trailing_zeros() as usize];
            let same = left & numbers.simd_eq(u32x8::splat(simd, number)).to_bitmask() as u8;
            left &= !same;
            let triangle = &ready[number as usize];
            let Some(edges) = triangle.edges() else { continue };
            let here = spread(simd, edges.at(x, y), edges.right);
            let group = Group { x, y, covered: same, weights: weights(simd, here, edges.per_area) };
            shade(simd, shader, triangle, group, depths, same, &mut tile.colors[place..place + 8]);
        }
    }
}
