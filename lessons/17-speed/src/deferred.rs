//! Deferred: what is seen is found first, and shaded once.

use common::IVec2;
use fearless_simd::{Simd, f32x8, prelude::*, u32x8};

use crate::blocks::SIDE;
use crate::eight::{Wide, mask, merged};
use crate::render::{Job, shade};
use crate::simd::from_least;
use crate::tile::{NONE, Tile};

// ANCHOR: see
/// Notes that a triangle is seen in some of eight pixels.
#[inline(always)]
pub(crate) fn see<S: Simd>(
    simd: S,
    tile: &mut Tile,
    place: usize,
    lanes: u8,
    number: u32,
    weights: [f32x8<S>; 3],
) {
    let lanes = mask(simd, lanes);
    let seen = &mut tile.seen[place..place + 8];
    merged(simd, lanes, u32x8::splat(simd, number), u32x8::from_slice(simd, seen)).store_slice(seen);
    for (weight, kept) in weights.into_iter().zip(&mut tile.weights) {
        let kept = &mut kept[place..place + 8];
        let old = f32x8::from_slice(simd, kept).to_bits();
        f32x8::from_bits(merged(simd, lanes, weight.to_bits(), old)).store_slice(kept);
    }
}
// ANCHOR_END: see

/// Writes down, pixel by pixel, the triangle that is seen in all of a block.
#[inline(always)]
pub(crate) fn spell_out<S: Simd, W: Wide>(
    simd: S,
    job: &Job<W>,
    corner: IVec2,
    block: usize,
    tile: &mut Tile,
) {
    // A function of its own: it is asked for in several places, and not often.
    simd.vectorize(
        #[inline(always)]
        || {
            let number = tile.blocks[block].whole;
            tile.blocks[block].whole = NONE;
            let triangle = job.triangle(tile, number);
            let Some(edges) = triangle.edges() else { return };
            let mut row = edges.row(simd, corner.x, corner.y);
            for y in corner.y..corner.y + SIDE {
                let place = tile.place(corner.x, y);
                let weights = row.weights(simd, edges.per_area);
                from_least(simd, triangle.z, weights).store_slice(&mut tile.depths[place..place + 8]);
                see(simd, tile, place, u8::MAX, number, weights);
                row.step(edges.up);
            }
        },
    );
}

/// Shades what is seen in a block.
#[inline(always)]
pub(crate) fn shade_block<S: Simd, W: Wide>(
    simd: S,
    job: &Job<W>,
    corner: IVec2,
    block: usize,
    tile: &mut Tile,
) {
    tile.blocks[block].is_seen = false;
    let whole = tile.blocks[block].whole;
    if whole != NONE {
        tile.blocks[block].whole = NONE;
        let triangle = job.triangle(tile, whole);
        let Some(edges) = triangle.edges() else { return };
        let mut row = edges.row(simd, corner.x, corner.y);
        for y in corner.y..corner.y + SIDE {
            let place = tile.place(corner.x, y);
            let weights = row.weights(simd, edges.per_area);
            let depths = from_least(simd, triangle.z, weights);
            depths.store_slice(&mut tile.depths[place..place + 8]);
            // What was seen before it.
            u32x8::splat(simd, NONE).store_slice(&mut tile.seen[place..place + 8]);
            let colors = &mut tile.colors[place..place + 8];
            shade(simd, job.shader, &[(u8::MAX, triangle)], [corner.x, y], weights, depths, u8::MAX, colors);
            row.step(edges.up);
        }
        return;
    }
    for y in corner.y..corner.y + SIDE {
        let place = tile.place(corner.x, y);
        let numbers = u32x8::from_slice(simd, &tile.seen[place..place + 8]);
        u32x8::splat(simd, NONE).store_slice(&mut tile.seen[place..place + 8]);
        let asked = numbers.simd_ne(NONE).to_bitmask() as u8;
        if asked == 0 {
            continue;
        }
        let mut left = asked;
        let number = numbers.as_slice()[left.trailing_zeros() as usize];
        let mut parts = [(0, job.triangle(tile, number)); 8];
        let mut count = 0;
        while left != 0 {
            let number = numbers.as_slice()[left.trailing_zeros() as usize];
            let same = numbers.simd_eq(number).to_bitmask() as u8;
            parts[count] = (same, job.triangle(tile, number));
            count += 1;
            left &= !same;
        }
        let [a, b, c] = &tile.weights;
        let weights = [
            f32x8::from_slice(simd, &a[place..place + 8]),
            f32x8::from_slice(simd, &b[place..place + 8]),
            f32x8::from_slice(simd, &c[place..place + 8]),
        ];
        let depths = f32x8::from_slice(simd, &tile.depths[place..place + 8]);
        let colors = &mut tile.colors[place..place + 8];
        shade(simd, job.shader, &parts[..count], [corner.x, y], weights, depths, asked, colors);
    }
}
