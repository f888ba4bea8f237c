//! Lesson 16's scene with sixteen samples a pixel, by the ideas of this lesson.
//!
//! **Better:** a picture of 1024×768 pixels has 100 MB of samples, which pass through the cache for each surface that is drawn.
//! Here all triangles of a frame are sorted into tiles first, and a tile is drawn at once, from the first surface to the last,
//! and resolved: its samples, 132 KB, stay in a core's second cache, and each core needs just one tile. Sixteen samples are
//! covered and compared by a few instructions; fragments, of whatever triangles, are shaded eight at a time.
//! **What it costs:** meshes of all looks must be one kind of triangle, so what is interpolated is an array of numbers
//! ([`corners`]), and what it means is told when the program runs, once for eight fragments.
//!
//! Pixels are those of lesson 16's own loops, to the last bit: each number is computed by the same operations in the same
//! order. With one sample a pixel they draw themselves.

mod corners;
mod fragments;
mod light;
mod raster;
mod samples;
mod texture;
mod tile;

use std::sync::{Mutex, PoisonError};

use clipping::render::{Vertices, triangles_with};
use clipping::{Clipping, Counts};
use common::{Bounds, IVec2, Image};
use fearless_simd::{Level, dispatch};
use rayon::prelude::*;
use scene::lamps::Lamps;
use scene::render::{Frame, Loops, Pass, Renderer};
use scene::scene::Style;

use crate::eight::packed;
use corners::{Corners, Numbers, Triangle};
use fragments::{Fragments, Look};
use light::Lamp;
use samples::SAMPLES;
use tile::{SIDE, Tile};

/// What draws a scene in tiles, with all the memory that it takes, kept from frame to frame.
pub struct Sixteen {
    /// The threads, if there are several.
    pool: Option<rayon::ThreadPool>,
    level: Level,
    /// For the vertices, and for the pixels.
    lamps: (Lamps, Vec<Lamp>),
    vertices: Vertices<Numbers>,
    triangles: Vec<Triangle>,
    /// For each tile the numbers of the triangles that reach into it.
    by_tile: Vec<Vec<u32>>,
    /// For each thread what it works with.
    desks: Vec<Mutex<Desk>>,
    /// Pictures of one sample a pixel.
    loops: Loops,
}

/// A tile, and the fragments in it that are not shaded yet.
#[derive(Default)]
struct Desk {
    tile: Tile,
    fragments: Fragments,
}

impl Sixteen {
    /// With so many threads, at least one.
    ///
    /// # Errors
    /// Where the system starts none.
    pub fn new(threads: usize) -> anyhow::Result<Self> {
        let threads = threads.max(1);
        let pool = || rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        Ok(Self {
            pool: if threads > 1 { Some(pool()?) } else { None },
            level: Level::new(),
            lamps: Default::default(),
            vertices: Vertices::default(),
            triangles: Vec::new(),
            by_tile: Vec::new(),
            desks: (0..threads).map(|_| Mutex::default()).collect(),
            loops: Loops::default(),
        })
    }

    /// Computes the vertices of a pass, and sorts its triangles into tiles.
    fn sort(&mut self, number: usize, pass: &Pass, style: Style, picture: Bounds) -> Counts {
        let Self { lamps, vertices, triangles, by_tile, .. } = self;
        let size = (picture.max + 1).as_vec2();
        let across = tiles(picture).x;
        let corners = Corners { number, pass, placed: pass.placed(&lamps.0), style, size };
        let fill = |constant, corners, numbers| {
            let Some(triangle) = Triangle::new(corners, constant, numbers) else { return };
            let Bounds { min, max } = triangle.pixels(picture);
            if max.cmplt(min).any() {
                return;
            }
            let (first, last) = (min / SIDE, max / SIDE);
            for y in first.y..=last.y {
                for x in first.x..=last.x {
                    by_tile[(y * across + x) as usize].push(triangles.len() as u32);
                }
            }
            triangles.push(triangle);
        };
        triangles_with(vertices, &corners, pass.mesh.assembled(), pass.cull, Clipping::GuardBand, size, fill)
    }
}

/// All that is known of a frame once its triangles are sorted.
struct Sorted<'a> {
    picture: Bounds,
    background: u32,
    looks: &'a [Look<'a>],
    triangles: &'a [Triangle],
    by_tile: &'a [Vec<u32>],
    desks: &'a [Mutex<Desk>],
    level: Level,
}

impl Sorted<'_> {
    /// Draws a row of tiles into its bytes of the picture.
    fn draw_row(&self, row: usize, bytes: &mut [u8]) {
        let desk = &self.desks[rayon::current_thread_index().unwrap_or(0) % self.desks.len()];
        // Each thread has its own, so none waits here.
        let Desk { tile, fragments } = &mut *desk.lock().unwrap_or_else(PoisonError::into_inner);
        let max = self.picture.max;
        let across = tiles(self.picture).x as usize;
        for (x, numbers) in (0..).zip(&self.by_tile[row * across..(row + 1) * across]) {
            let min = IVec2::new(x, row as i32) * SIDE;
            tile.bounds = Bounds { min, max: (min + SIDE - 1).min(max) };
            tile.clear(self.background);
            dispatch!(self.level, simd => {
                if !numbers.is_empty() {
                    tile.depths.fill([1.0; SAMPLES]);
                    raster::draw(simd, self.looks, self.triangles, numbers, tile, fragments);
                }
                tile.resolve(simd, bytes, max.x as usize + 1);
            });
        }
    }
}

/// How many tiles a picture has in a row, and rows of them.
fn tiles(picture: Bounds) -> IVec2 {
    (picture.max + SIDE) / SIDE
}

impl Renderer for Sixteen {
    fn draw(&mut self, frame: &Frame, picture: &mut Image) -> Counts {
        if !frame.antialiased {
            return self.loops.draw(frame, picture);
        }
        let (scene, bounds) = (frame.scene, picture.bounds());
        self.lamps.0.set(&scene.lights);
        self.lamps.1.clear();
        self.lamps.1.extend(scene.lights.iter().map(Lamp::new));
        self.triangles.clear();
        let IVec2 { x: across, y: up } = tiles(bounds);
        self.by_tile.resize_with((across * up) as usize, Vec::new);
        self.by_tile.iter_mut().for_each(Vec::clear);
        let mut counts = Counts::default();
        let passes: Vec<Pass> = frame.passes().collect();
        for (number, pass) in passes.iter().enumerate() {
            counts += self.sort(number, pass, scene.style, bounds);
        }
        let looks: Vec<Look> =
            passes.iter().map(|pass| Look::new(pass, scene.style, &self.lamps.1)).collect();
        let sorted = Sorted {
            picture: bounds,
            background: packed(scene.background),
            looks: &looks,
            triangles: &self.triangles,
            by_tile: &self.by_tile,
            desks: &self.desks,
            level: self.level,
        };
        let row = SIDE as usize * 3 * picture.width() as usize;
        let draw = |(row, bytes): (usize, &mut [u8])| sorted.draw_row(row, bytes);
        match &self.pool {
            None => picture.buffer_mut().chunks_mut(row).enumerate().for_each(draw),
            Some(pool) => pool.install(|| {
                picture.buffer_mut().par_chunks_mut(row).with_max_len(1).enumerate().for_each(draw);
            }),
        }
        counts
    }
}
