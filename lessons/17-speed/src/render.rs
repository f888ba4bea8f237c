//! A tile's triangles, one after the other.

use common::{Bounds, IVec2};
use fearless_simd::{Simd, f32x8, prelude::*, u32x8};

use crate::blocks::{Cover, SIDE, cover};
use crate::deferred::{see, shade_block, spell_out};
use crate::eight::{Eight, Part, Wide, corners, mask, merged};
use crate::frame::Plan;
use crate::hierarchical_depth::Plane;
use crate::simd::{Row, from_least};
use crate::tile::{NONE, Tile};
use crate::tiles::{BITS, Sorted};
use crate::triangle::{Edges, Ready};

/// What all tiles of a drawing have in common.
pub(crate) struct Job<'a, W: Wide> {
    pub(crate) shader: &'a W,
    pub(crate) sorted: &'a [Sorted<W::Constant, W::Varying>],
    pub(crate) plan: Plan,
    pub(crate) deferred: bool,
}

/// A triangle that is being drawn.
struct One<'a, C, V> {
    number: u32,
    triangle: &'a Ready<C, V>,
    edges: Edges,
}

impl<W: Wide> Job<'_, W> {
    /// A triangle of a tile, by its number there.
    #[inline(always)]
    pub(crate) fn triangle(&self, tile: &Tile, number: u32) -> &Ready<W::Constant, W::Varying> {
        &self.sorted[(number >> BITS) as usize].by_tile[tile.number][(number & ((1 << BITS) - 1)) as usize]
    }

    /// Draws the triangles that reach into a tile.
    #[inline(always)]
    pub(crate) fn tile<S: Simd>(&self, simd: S, tile: &mut Tile) {
        for (part, Sorted { by_tile, .. }) in self.sorted.iter().enumerate() {
            for (number, triangle) in by_tile[tile.number].iter().enumerate() {
                let Some(edges) = triangle.edges() else { continue };
                let bounds = triangle.bounds(tile.bounds);
                let number = number as u32 | (part as u32) << BITS;
                let one = One { number, triangle, edges };
                if bounds.max.x - bounds.min.x < SIDE {
                    self.narrow(simd, &one, bounds, tile);
                } else {
                    self.large(simd, &one, bounds, tile);
                }
            }
        }
        if self.deferred {
            let side = tile.stride as i32 / SIDE;
            for block in 0..tile.blocks.len() {
                if tile.blocks[block].is_seen {
                    let corner =
                        tile.bounds.min + IVec2::new(block as i32 % side, block as i32 / side) * SIDE;
                    shade_block(simd, self, corner, block, tile);
                }
            }
        }
    }

    /// A triangle that is at most eight pixels wide: eight of each row are asked, from its leftmost pixel on.
    #[inline(always)]
    fn narrow<S: Simd>(
        &self,
        simd: S,
        one: &One<W::Constant, W::Varying>,
        Bounds { min, max }: Bounds,
        tile: &mut Tile,
    ) {
        let &One { triangle, edges, .. } = one;
        let [first, last] = [(min - tile.bounds.min) / SIDE, (max - tile.bounds.min) / SIDE];
        let nearest = triangle.z.min_element();
        let mut is_hidden = self.plan.hierarchical;
        for j in first.y..=last.y {
            for i in first.x..=last.x {
                is_hidden &= nearest >= tile.blocks[tile.block(i, j)].farthest;
            }
        }
        if is_hidden {
            return;
        }
        for j in first.y..=last.y {
            for i in first.x..=last.x {
                let n = tile.block(i, j);
                if tile.blocks[n].whole != NONE {
                    spell_out(simd, self, tile.bounds.min + IVec2::new(i, j) * SIDE, n, tile);
                }
                let block = &mut tile.blocks[n];
                block.nearest = block.nearest.min(nearest);
                (block.is_seen, block.has_changed) = (self.deferred, true);
            }
        }
        let inside = u8::MAX >> (min.x + SIDE - 1 - max.x);
        let mut row = edges.row(simd, min.x, min.y);
        for y in min.y..=max.y {
            let covered = row.covered(edges.inside) & inside;
            if covered != 0 {
                self.eight(simd, one, &row, [min.x, y], covered, tile);
            }
            row.step(edges.up);
        }
    }

    // ANCHOR: large
    /// A wider one, block by block.
    #[inline(always)]
    fn large<S: Simd>(
        &self,
        simd: S,
        one: &One<W::Constant, W::Varying>,
        Bounds { min, max }: Bounds,
        tile: &mut Tile,
    ) {
        let &One { number, triangle, edges } = one;
        let plane = Plane::new(&edges, triangle.z);
        let [first, last] = [(min - tile.bounds.min) / SIDE, (max - tile.bounds.min) / SIDE];
        for j in first.y..=last.y {
            for i in first.x..=last.x {
                let corner = tile.bounds.min + IVec2::new(i, j) * SIDE;
                let cover = cover(edges.at(corner.x, corner.y), edges.right, edges.up, edges.inside);
                if cover == Cover::Nothing {
                    continue;
                }
                let n = tile.block(i, j);
                let [least, most] = plane.bounds(corner.x, corner.y);
                if self.plan.hierarchical {
                    if least < tile.blocks[n].farthest {
                        tile.measure(simd, n, tile.place(corner.x, corner.y));
                    }
                    if least >= tile.blocks[n].farthest {
                        continue;
                    }
                }
                if self.deferred {
                    let block = &mut tile.blocks[n];
                    block.is_seen = true;
                    if cover == Cover::Whole && most < block.nearest {
                        (block.whole, block.nearest, block.farthest, block.has_changed) =
                            (number, least, most, false);
                        continue;
                    }
                    if block.whole != NONE {
                        spell_out(simd, self, corner, n, tile);
                    }
                }
                let block = &mut tile.blocks[n];
                (block.nearest, block.has_changed) = (block.nearest.min(least), true);
                let [low, high] = [min.y.max(corner.y), max.y.min(corner.y + SIDE - 1)];
                let mut row = edges.row(simd, corner.x, low);
                for y in low..=high {
                    let covered = if cover == Cover::Whole { u8::MAX } else { row.covered(edges.inside) };
                    if covered != 0 {
                        self.eight(simd, one, &row, [corner.x, y], covered, tile);
                    }
                    row.step(edges.up);
                }
            }
        }
    }
    // ANCHOR_END: large

    // ANCHOR: eight
    /// Tests and draws those of eight pixels that are covered.
    #[inline(always)]
    fn eight<S: Simd>(
        &self,
        simd: S,
        &One { number, triangle, edges }: &One<W::Constant, W::Varying>,
        row: &Row<S>,
        [x, y]: [i32; 2],
        covered: u8,
        tile: &mut Tile,
    ) {
        let place = tile.place(x, y);
        let weights = row.weights(simd, edges.per_area);
        let depths = from_least(simd, triangle.z, weights);
        let kept = f32x8::from_slice(simd, &tile.depths[place..place + 8]);
        let mut drawn = covered & depths.simd_lt(kept).to_bitmask() as u8;
        if drawn == 0 {
            return;
        }
        if self.deferred {
            see(simd, tile, place, drawn, number, weights);
        } else {
            let colors = &mut tile.colors[place..place + 8];
            drawn = shade(simd, self.shader, &[(drawn, triangle)], [x, y], weights, depths, drawn, colors);
        }
        mask(simd, drawn).select(depths, kept).store_slice(&mut tile.depths[place..place + 8]);
    }
    // ANCHOR_END: eight
}

/// Shades those of eight pixels that are asked for; returns which have a colour.
#[inline(always)]
#[expect(clippy::too_many_arguments)]
pub(crate) fn shade<S: Simd, W: Wide>(
    simd: S,
    shader: &W,
    parts: &[Part<W::Constant, W::Varying>],
    [x, y]: [i32; 2],
    weights: [f32x8<S>; 3],
    depths: f32x8<S>,
    asked: u8,
    colors: &mut [u32],
) -> u8 {
    let weights = in_space(simd, parts, weights);
    let (shaded, kept) = shader.shade(simd, &Eight { x, y, asked, depths, weights, parts });
    let drawn = kept & asked;
    merged(simd, mask(simd, drawn), shaded, u32x8::from_slice(simd, colors)).store_slice(colors);
    drawn
}

/// The weights on the triangles in space from those in the picture, as lesson 10's `perspective_weights` has them.
#[inline(always)]
pub(crate) fn in_space<S: Simd, C, V>(
    simd: S,
    parts: &[Part<C, V>],
    [x, y, z]: [f32x8<S>; 3],
) -> [f32x8<S>; 3] {
    let [a, b, c] = corners(simd, parts, |triangle| triangle.inverse_w.to_array());
    let least = a.min(b).min(c);
    let sum = least + ((a - least) * x + (b - least) * y + (c - least) * z);
    let w = f32x8::splat(simd, 1.0) / sum;
    [x * a * w, y * b * w, z * c * w]
}
