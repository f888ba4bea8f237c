//! From triangles to fragments: which samples of a tile are covered, and seen.

use common::{Bounds, DVec3, IVec2};
use fearless_simd::{Simd, f32x16, mask32x16, prelude::*};

use super::corners::Triangle;
use super::fragments::{Fragments, Group, LANES, Look};
use super::samples::{ALL, Depths, Margins, Offsets, centroid};
use super::tile::{Known, Tile};
use crate::blocks::{Cover, SIDE, cover_within};
use crate::triangle::Edges;

/// Draws a list of triangles that look alike into a tile, in this order.
#[inline(always)]
pub(crate) fn draw<S: Simd>(
    simd: S,
    look: &Look,
    triangles: &[Triangle],
    tile: &mut Tile,
    fragments: &mut Fragments,
) {
    for number in 0..triangles.len() as u32 {
        find(simd, look, triangles, number, tile, fragments);
        fragments.shade(simd, look, triangles, tile);
    }
    fragments.shade_rest(simd, look, triangles, tile);
}

/// A triangle up to so many pixels wide and high is small: all its pixels are asked, and no blocks.
const SMALL: i32 = 16;

/// Finds the fragments of a triangle that are seen, and keeps their depths. Where it is the first to cover a block whole, it
/// paints it at once.
#[inline(always)]
fn find<S: Simd>(
    simd: S,
    look: &Look,
    triangles: &[Triangle],
    number: u32,
    tile: &mut Tile,
    fragments: &mut Fragments,
) {
    let triangle = &triangles[number as usize];
    let Some(edges) = &triangle.edges() else { return };
    let writes = look.alpha.is_none();
    let Bounds { min, max } = triangle.pixels(tile.bounds);
    let offsets = Offsets::new(simd, edges);
    let asked = Asked { number, edges, depths: Depths::new(triangle.z, edges, &offsets), writes };
    let whole = triangle.pixels(Bounds::EVERYTHING);
    let is_small = (whole.max - whole.min).max_element() < SMALL;
    if is_small {
        let margins = Margins::new(simd, edges);
        for y in (min.y & !(SIDE - 1)..=max.y).step_by(SIDE as usize) {
            for x in (min.x & !(SIDE - 1)..=max.x).step_by(SIDE as usize) {
                write_depths(simd, IVec2::new(x, y), tile);
            }
        }
        let covered = |at: DVec3| margins.covered(at.as_ivec3().to_array());
        return ask(simd, &asked, Bounds { min, max }, covered, tile, fragments);
    }
    let is_in_view = triangle.z.max_element() < 1.0;
    for y in (min.y & !(SIDE - 1)..=max.y).step_by(SIDE as usize) {
        for x in (min.x & !(SIDE - 1)..=max.x).step_by(SIDE as usize) {
            let cover = cover(edges, x, y);
            if cover == Cover::Nothing {
                continue;
            }
            let corner = IVec2::new(x, y);
            let bounds = Bounds { min: min.max(corner), max: max.min(corner + SIDE - 1) };
            let block = tile.block(x, y);
            // Nothing is nearer, nor need its depths be written before something else comes.
            if cover == Cover::Whole && is_in_view && writes && matches!(tile.known[block], Known::Cleared) {
                tile.known[block] = Known::Of(triangle.bare());
                paint_block(simd, look, triangle, edges, corner, tile);
                continue;
            }
            write_depths(simd, corner, tile);
            let covered = |at| if cover == Cover::Whole { ALL } else { offsets.covered(at, edges.inside) };
            ask(simd, &asked, bounds, covered, tile, fragments);
        }
    }
}

/// Shades a block that a triangle covers whole, row after row.
#[inline(always)]
fn paint_block<S: Simd>(
    simd: S,
    look: &Look,
    triangle: &Triangle,
    edges: &Edges,
    IVec2 { x, y: first }: IVec2,
    tile: &mut Tile,
) {
    let part = [(u8::MAX, triangle)];
    let mut row = edges.row(simd, x, first);
    for y in first..first + SIDE {
        let pixels = [[0, 1, 2, 3, 4, 5, 6, 7].map(|column| x + column), [y; LANES]];
        let group = Group::new(simd, &part, pixels, row.weights(simd, edges.per_area));
        tile.paint_row(tile.place(x, y), group.colors(simd, look));
        row.step(edges.up);
    }
}

/// A triangle whose samples are asked.
struct Asked<'a, S: Simd> {
    number: u32,
    edges: &'a Edges,
    depths: Depths<S>,
    /// Whether it leaves its depths behind.
    writes: bool,
}

/// Finds which samples of some pixels are covered and not hidden, and keeps them as fragments.
#[inline(always)]
fn ask<S: Simd>(
    simd: S,
    &Asked { number, edges, ref depths, writes }: &Asked<S>,
    bounds: Bounds,
    covered: impl Fn(DVec3) -> u32,
    tile: &mut Tile,
    fragments: &mut Fragments,
) {
    for y in bounds.min.y..=bounds.max.y {
        let mut next = edges.at(bounds.min.x, y);
        for x in bounds.min.x..=bounds.max.x {
            let at = next;
            next += edges.right;
            let covered = covered(at);
            if covered == 0 {
                continue;
            }
            let place = tile.place(x, y);
            let depths = depths.at(simd, at);
            let kept = f32x16::load_array(simd, tile.depths[place]);
            let seen = depths.simd_lt(kept).to_bitmask() as u32 & covered;
            if seen == 0 {
                continue;
            }
            if writes {
                let mask = mask32x16::from_bitmask(simd, seen.into());
                mask.select(depths, kept).store_array(&mut tile.depths[place]);
            }
            let has_center = at.cmpge(edges.inside).all();
            let at = if has_center { at } else { centroid(at, edges, covered) };
            fragments.push(number, place, seen, (at * edges.per_area).as_vec3());
        }
    }
}

/// Writes the depths of a block's samples, if they are known otherwise.
#[inline(always)]
fn write_depths<S: Simd>(simd: S, corner: IVec2, tile: &mut Tile) {
    let block = tile.block(corner.x, corner.y);
    let known = std::mem::replace(&mut tile.known[block], Known::Written);
    match known {
        Known::Written => {}
        Known::Cleared => {
            for y in corner.y..corner.y + SIDE {
                let place = tile.place(corner.x, y);
                tile.depths[place..place + SIDE as usize].as_flattened_mut().fill(1.0);
            }
        }
        Known::Of(triangle) => {
            let Some(edges) = triangle.edges() else { return };
            let depths = Depths::new(triangle.z, &edges, &Offsets::new(simd, &edges));
            for y in corner.y..corner.y + SIDE {
                let place = tile.place(corner.x, y);
                let mut at = edges.at(corner.x, y);
                for samples in &mut tile.depths[place..place + SIDE as usize] {
                    depths.at(simd, at).store_array(samples);
                    at += edges.right;
                }
            }
        }
    }
}

/// How much of a block's samples is covered. A sample is up to half a pixel away from its pixel's centre, so that they all are in
/// a square as wide as the block, from half a pixel to the left of and below the first centre.
#[inline(always)]
fn cover(edges: &Edges, x: i32, y: i32) -> Cover {
    let Edges { right, up, inside, .. } = *edges;
    let corner = edges.at(x, y) - (right + up) / 2.0;
    cover_within(f64::from(SIDE), corner, right, up, inside)
}
