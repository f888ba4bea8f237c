//! A picture that is drawn in tiles.

use clipping::render::{Computed, Stages};
use clipping::{Clipping, Counts, Cull, Mesh};
use common::{Color, Image};
use fearless_simd::{Level, dispatch};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use scene::kept::Kept;

use crate::blocks::SIDE;
use crate::eight::Wide;
use crate::render::Job;
use crate::sort::{Sorted, parts};
use crate::tile::{Tile, Tiles};

/// Which of the ideas are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// A tile's side in pixels, rounded up to a multiple of 8; `None` for one tile as large as the picture.
    pub tile: Option<i32>,
    /// Whether blocks know their farthest depth.
    pub hierarchical: bool,
    /// Whether what is seen is found first and shaded once.
    pub deferred: bool,
    /// How many threads draw, at least 1.
    pub threads: usize,
}

/// A picture being drawn, and all memory that this takes, kept from one to the next.
pub struct Frame {
    plan: Plan,
    level: Level,
    tiles: Tiles,
    kept: Kept,
    /// The threads, where there is more than one.
    pool: Option<ThreadPool>,
}

/// What a shader must be for threads to share it.
pub trait Shared: Wide<Constant: Send + Sync + 'static, Varying: Send + Sync + 'static> {}

impl<W: Wide<Constant: Send + Sync + 'static, Varying: Send + Sync + 'static>> Shared for W {}

impl Frame {
    /// For pictures of that size in pixels.
    ///
    /// # Panics
    /// Where the system starts no thread.
    #[must_use]
    pub fn new(size: [i32; 2], plan: Plan) -> Self {
        let side = (plan.tile.unwrap_or(size[0].max(size[1])).max(1) + SIDE - 1) & !(SIDE - 1);
        let tiles = Tiles::new(size, side, plan.deferred);
        let pool = (plan.threads > 1).then(|| {
            ThreadPoolBuilder::new().num_threads(plan.threads).build().expect("the system starts threads")
        });
        Self { plan, level: Level::new(), tiles, kept: Kept::default(), pool }
    }

    /// The same with the instructions of that level, one that the machine has.
    #[must_use]
    pub fn at_level(self, level: Level) -> Self {
        Self { level, ..self }
    }

    /// Forgets what was drawn.
    pub fn clear(&mut self, background: Color) {
        self.tiles.clear(background);
    }

    /// Copies what was drawn to a picture of the frame's size.
    pub fn copy_to(&self, image: &mut Image) {
        let bytes = image.bytes_per_pixel();
        // A picture without pixels has no row.
        let row = (image.width() as usize * bytes).max(1);
        let tiles = &self.tiles;
        let copy = |(y, to): (usize, &mut [u8])| tiles.copy_row(y, to, bytes);
        let rows = image.buffer_mut();
        match &self.pool {
            Some(pool) => pool.install(|| rows.par_chunks_exact_mut(row).enumerate().for_each(copy)),
            None => rows.chunks_exact_mut(row).enumerate().for_each(copy),
        }
    }

    /// Draws a mesh. What was drawn before stays where it is nearer, or as near.
    pub fn draw<W: Shared>(&mut self, shader: &W, mesh: &Mesh, cull: Cull) -> Counts {
        let Self { plan, level, tiles, kept, pool } = self;
        let (plan, level, pool) = (*plan, *level, pool.as_ref());
        let size = (tiles.picture.max + 1).as_vec2();
        let stages = Stages::new(shader, cull, Clipping::GuardBand, size);

        // 1. Vertices, each once.
        let mut vertices: Vec<Computed<W::Varying>> = std::mem::take(kept.of());
        let vertex = |n: usize| stages.vertex(&mesh.vertices[n]);
        match pool {
            Some(pool) => pool.install(|| {
                (0..mesh.vertices.len())
                    .into_par_iter()
                    .with_min_len(1024)
                    .map(vertex)
                    .collect_into_vec(&mut vertices);
            }),
            None => {
                vertices.clear();
                vertices.extend((0..mesh.vertices.len()).map(vertex));
            }
        }

        // 2. Triangles, sorted into tiles, in as many parts as will keep all threads busy.
        let mut sorted: Vec<Sorted<W::Constant, W::Varying>> = std::mem::take(kept.of());
        let parts = parts(mesh.faces.len(), plan.threads);
        sorted.resize_with(parts.len(), Sorted::default);
        let sort = |(part, sorted): (&std::ops::Range<usize>, &mut Sorted<_, _>)| {
            sorted.fill(&stages, &vertices, mesh.some_triangles(part.clone()), tiles)
        };
        let counts = match pool {
            Some(pool) => {
                pool.install(|| parts.par_iter().zip(&mut sorted).map(sort).reduce(Counts::default, plus))
            }
            None => parts.iter().zip(&mut sorted).map(sort).fold(Counts::default(), plus),
        };
        let counts = Counts { vertices: vertices.len(), ..counts };

        // 3. Tiles.
        let background = tiles.background;
        let job = Job { shader, sorted: &sorted, plan, deferred: plan.deferred && shader.keeps_all() };
        let draw = |(n, tile): (usize, &mut Tile)| {
            if sorted.iter().any(|part| !part.by_tile[n].is_empty()) {
                tile.open(background);
                dispatch!(level, simd => job.tile(simd, n, tile));
            }
        };
        match pool {
            Some(pool) => pool.install(|| tiles.tiles.par_iter_mut().enumerate().for_each(draw)),
            None => tiles.tiles.iter_mut().enumerate().for_each(draw),
        }
        *kept.of() = vertices;
        *kept.of() = sorted;
        counts
    }
}

fn plus(mut one: Counts, other: Counts) -> Counts {
    one += other;
    one
}
