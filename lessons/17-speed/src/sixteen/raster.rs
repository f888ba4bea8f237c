//! From triangles to fragments: which samples of a tile are covered, and seen.

use common::{Bounds, IVec2};
use fearless_simd::{Simd, f32x16, mask32x16, prelude::*};

use super::corners::Triangle;
use super::fragments::{Fragments, Look};
use super::samples::{ALL, Depths, Margins, Offsets, centroid};
use super::tile::Tile;
use crate::blocks::{Cover, SIDE, cover_within};
use crate::triangle::Edges;

/// Draws the triangles with these numbers into a tile, in this order.
#[inline(always)]
pub(crate) fn draw<S: Simd>(
    simd: S,
    looks: &[Look],
    triangles: &[Triangle],
    numbers: &[u32],
    tile: &mut Tile,
    fragments: &mut Fragments,
) {
    let mut pass = 0;
    for &number in numbers {
        let triangle = &triangles[number as usize];
        if triangle.constant.pass != pass {
            fragments.shade_rest(simd, &looks[pass], triangles, tile);
            pass = triangle.constant.pass;
        }
        let Some(edges) = triangle.edges() else { continue };
        let writes = looks[pass].alpha.is_none();
        find(simd, triangle, &edges, number, writes, tile, fragments);
        fragments.shade(simd, &looks[pass], triangles, tile);
    }
    fragments.shade_rest(simd, &looks[pass], triangles, tile);
}

/// A triangle up to so many pixels wide and high is small: all its pixels are asked, and no blocks.
const SMALL: i32 = 16;

/// Finds the fragments of a triangle that are seen, and keeps their depths.
#[inline(always)]
fn find<S: Simd>(
    simd: S,
    triangle: &Triangle,
    edges: &Edges,
    number: u32,
    writes: bool,
    tile: &mut Tile,
    fragments: &mut Fragments,
) {
    let Bounds { min, max } = triangle.pixels(tile.bounds);
    let offsets = Offsets::new(simd, edges);
    let margins = Margins::new(simd, edges);
    let depths = Depths::new(triangle.z, edges, &offsets);
    let whole = triangle.pixels(Bounds::EVERYTHING);
    let is_small = (whole.max - whole.min).max_element() < SMALL;
    let (first, side) = if is_small { (min, SMALL) } else { (min & !(SIDE - 1), SIDE) };
    for block_y in (first.y..=max.y).step_by(side as usize) {
        for block_x in (first.x..=max.x).step_by(side as usize) {
            let cover = if is_small { Cover::Part } else { cover(edges, block_x, block_y) };
            if cover == Cover::Nothing {
                continue;
            }
            let last = max.min(IVec2::new(block_x, block_y) + side - 1);
            let left = block_x.max(min.x);
            for y in block_y.max(min.y)..=last.y {
                let mut next = edges.at(left, y);
                for x in left..=last.x {
                    let at = next;
                    next += edges.right;
                    let covered = match cover {
                        Cover::Whole => ALL,
                        _ if is_small => margins.covered(at.as_ivec3().to_array()),
                        _ => offsets.covered(at, edges.inside),
                    };
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
