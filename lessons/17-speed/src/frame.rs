//! A picture that is drawn in tiles.

use clipping::render::Vertices;
use clipping::{Clipping, Counts, Cull, Mesh};
use common::{Bounds, Color, Image};
use fearless_simd::{Level, Simd, dispatch, f32x8, prelude::*};
use perspective::perspective_weights;
use scene::kept::Kept;
use shaders::shader::Shader;

use crate::blocks::Cover;
use crate::deferred;
use crate::eight::{Eight, Wide, each};
use crate::hierarchy::{Plane, farthest};
use crate::raster::{Depths, Group, mask, raster};
use crate::tile::{Tile, Tiles};
use crate::triangle::Ready;

/// Which of the ideas are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// A tile's side in pixels, a multiple of 8; `None` for one tile as large as the picture.
    pub tile: Option<i32>,
    /// Whether blocks know their farthest depth.
    pub hierarchical: bool,
    /// Whether what is seen is found first and shaded once.
    pub deferred: bool,
    /// How many threads draw.
    pub threads: usize,
}

/// A picture being drawn, and all memory that this takes, kept from one to the next.
pub struct Frame {
    plan: Plan,
    level: Level,
    tiles: Tiles,
    kept: Kept,
}

/// The triangles of a drawing, and for each tile the numbers of those that reach into it.
struct Sorted<C, V> {
    ready: Vec<Ready<C, V>>,
    by_tile: Vec<Vec<u32>>,
}

impl<C, V> Default for Sorted<C, V> {
    fn default() -> Self {
        Self { ready: Vec::new(), by_tile: Vec::new() }
    }
}

impl Frame {
    /// For pictures of that size.
    #[must_use]
    pub fn new(width: i32, height: i32, plan: Plan) -> Self {
        let side = plan.tile.unwrap_or((width.max(height) + 7) & !7).max(8);
        Self { plan, level: Level::new(), tiles: Tiles::new(width, height, side), kept: Kept::default() }
    }

    /// Forgets what was drawn.
    pub fn clear(&mut self, background: Color) {
        self.tiles.clear(background);
    }

    /// Copies what was drawn to a picture of the frame's size.
    pub fn copy_to(&self, image: &mut Image) {
        self.tiles.copy_to(image);
    }

    /// Draws a mesh.
    pub fn draw<W>(&mut self, shader: &W, mesh: &Mesh, cull: Cull) -> Counts
    where
        W: Wide + Sync,
        W::Constant: Send + Sync + 'static,
        W::Varying: Send + Sync + 'static,
    {
        let Self { plan, level, tiles, kept } = self;
        let plan = *plan;
        let mut sorted = std::mem::take(kept.of::<Sorted<W::Constant, W::Varying>>());
        sorted.ready.clear();
        sorted.by_tile.resize_with(tiles.tiles.len(), Vec::new);
        sorted.by_tile.iter_mut().for_each(Vec::clear);
        let counts = sort(shader, mesh, cull, tiles, kept, &mut sorted);
        let background = tiles.background();
        dispatch!(*level, simd => {
            for (tile, numbers) in tiles.tiles.iter_mut().zip(&sorted.by_tile) {
                if !numbers.is_empty() {
                    tile.open(background);
                    draw_tile(simd, shader, &sorted.ready, numbers, tile, plan);
                }
            }
        });
        *kept.of() = sorted;
        counts
    }
}

fn sort<W: Wide>(
    shader: &W,
    mesh: &Mesh,
    cull: Cull,
    tiles: &Tiles,
    kept: &mut Kept,
    Sorted { ready, by_tile }: &mut Sorted<W::Constant, W::Varying>,
) -> Counts
where
    W::Varying: 'static,
{
    let size = (tiles.picture.max + 1).as_vec2();
    let vertices = kept.of::<Vertices<W::Varying>>();
    let fill = |constant, corners, varyings| {
        let Some(triangle) = Ready::new(corners, constant, varyings) else { return };
        let bounds = triangle.bounds(tiles.picture);
        if bounds.max.cmplt(bounds.min).any() {
            return;
        }
        let number = ready.len() as u32;
        ready.push(triangle);
        let Bounds { min, max } = tiles.touched(bounds);
        for y in min.y..=max.y {
            for x in min.x..=max.x {
                by_tile[y as usize * tiles.across + x as usize].push(number);
            }
        }
    };
    clipping::render::triangles_with(vertices, shader, mesh, cull, Clipping::GuardBand, size, fill)
}

#[inline(always)]
fn draw_tile<S: Simd, W: Wide>(
    simd: S,
    shader: &W,
    ready: &[Ready<W::Constant, W::Varying>],
    numbers: &[u32],
    tile: &mut Tile,
    plan: Plan,
) {
    let deferred = plan.deferred && shader.keeps_all();
    for &number in numbers {
        let triangle = &ready[number as usize];
        let Some(edges) = triangle.edges() else { continue };
        let bounds = triangle.bounds(tile.bounds);
        let depths = Depths::new(triangle);
        let plane = Plane::new(&edges, &depths);
        let tile_bounds = tile.bounds;
        let mut last = None;
        let tile = std::cell::RefCell::new(&mut *tile);
        raster(
            simd,
            &edges,
            bounds,
            tile_bounds,
            |x, y, _: Cover| {
                if plan.hierarchical {
                    let mut tile = tile.borrow_mut();
                    if let Some((block, place)) = last.take() {
                        tile.farthest[block] = farthest(simd, &tile, place);
                    }
                    let block = tile.block(x, y);
                    if plane.bounds(x, y)[0] >= tile.farthest[block] {
                        return false;
                    }
                    last = Some((block, tile.place(x, y)));
                }
                true
            },
            |group| {
                let tile = &mut *tile.borrow_mut();
                let here = tile.place(group.x, group.y);
                let depth = depths.at(simd, group.weights);
                let kept = f32x8::from_slice(simd, &tile.depths[here..here + 8]);
                let nearer = group.covered & depth.simd_lt(kept).to_bitmask() as u8;
                if nearer == 0 {
                    return;
                }
                if deferred {
                    let lanes = mask(simd, nearer);
                    lanes.select(depth, kept).store_slice(&mut tile.depths[here..here + 8]);
                    deferred::see(simd, lanes, number, &mut tile.seen[here..here + 8]);
                } else {
                    let colored =
                        shade(simd, shader, triangle, group, depth, nearer, &mut tile.colors[here..here + 8]);
                    let lanes = mask(simd, colored);
                    lanes.select(depth, kept).store_slice(&mut tile.depths[here..here + 8]);
                }
            },
        );
        let tile = tile.into_inner();
        if let Some((block, place)) = last {
            tile.farthest[block] = farthest(simd, tile, place);
        }
    }
    if deferred {
        deferred::shade_seen(simd, shader, ready, tile);
    }
}

/// Shades those of eight pixels that are asked for; returns which have a colour.
#[inline(always)]
pub(crate) fn shade<S: Simd, W: Wide>(
    simd: S,
    shader: &W,
    triangle: &Ready<W::Constant, W::Varying>,
    Group { x, y, weights, .. }: Group<S>,
    depths: f32x8<S>,
    asked: u8,
    colors: &mut [u32],
) -> u8 {
    let weights = in_space(simd, weights, triangle.inverse_w.to_array());
    let (shaded, kept) =
        shader.shade(simd, triangle.constant, triangle.varyings, &Eight { x, y, asked, depths, weights });
    each(kept & asked, |lane| colors[lane] = shaded[lane]);
    kept & asked
}

/// The weights on the triangle in space: see [`perspective_weights`].
#[inline(always)]
fn in_space<S: Simd>(simd: S, [x, y, z]: [f32x8<S>; 3], inverse_w: [f32; 3]) -> [f32x8<S>; 3] {
    let _ = perspective_weights;
    let [a, b, c] = inverse_w;
    let least = a.min(b).min(c);
    let sum = f32x8::splat(simd, least) + (x * (a - least) + y * (b - least) + z * (c - least));
    let share = f32x8::splat(simd, 1.0) / sum;
    [x * a * share, y * b * share, z * c * share]
}

/// Any shader will do.
impl<T: Shader<Output = Color>> Shader for crate::eight::EachPixel<T> {
    type Constant = T::Constant;
    type Varying = T::Varying;
    type Output = Color;

    #[inline(always)]
    fn position(&self, vertex: usize) -> common::Vec4 {
        self.shader.position(vertex)
    }

    #[inline(always)]
    fn triangle(&self, face: usize) -> Option<T::Constant> {
        self.shader.triangle(face)
    }

    #[inline(always)]
    fn corner(&self, face: usize, corner: usize) -> T::Varying {
        self.shader.corner(face, corner)
    }

    #[inline(always)]
    fn fragment(
        &self,
        constant: T::Constant,
        fragment: shaders::shader::Fragment<T::Varying>,
    ) -> Option<Color> {
        self.shader.fragment(constant, fragment)
    }
}

impl<T: Shader<Output = Color>> Wide for crate::eight::EachPixel<T> {
    fn keeps_all(&self) -> bool {
        self.keeps_all
    }

    #[inline(always)]
    fn shade<S: Simd>(
        &self,
        _: S,
        constant: T::Constant,
        varyings: [T::Varying; 3],
        eight: &Eight<S>,
    ) -> ([u32; 8], u8) {
        let (mut colors, mut kept) = ([0; 8], 0);
        each(eight.asked, |lane| {
            if let Some(color) = self.shader.fragment(constant, eight.fragment(lane, varyings)) {
                colors[lane] = crate::eight::packed(color);
                kept |= 1 << lane;
            }
        });
        (colors, kept)
    }
}
