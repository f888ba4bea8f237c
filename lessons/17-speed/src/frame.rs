//! A picture that is drawn in tiles, by as many of the ideas as a [`Plan`] says.

use clipping::render::{Computed, Stages};
use clipping::{Clipping, Counts, Cull, Mesh};
use common::{Color, Image};
use fearless_simd::{Level, dispatch};
use scene::kept::Kept;

use crate::blocks::SIDE;
use crate::eight::Wide;
use crate::render::Job;
use crate::threads::Threads;
use crate::tile::{Canvas, Tile};
use crate::tiles::{Sorted, at_least, parts};

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
    /// Which instructions the machine has.
    level: Level,
    canvas: Canvas,
    kept: Kept,
    threads: Threads,
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
        Self {
            plan,
            level: Level::new(),
            canvas: Canvas::new(size, side, plan.deferred),
            kept: Kept::default(),
            threads: Threads::new(plan.threads),
        }
    }

    /// The same with the instructions of that level, one that the machine has.
    #[must_use]
    pub fn at_level(self, level: Level) -> Self {
        Self { level, ..self }
    }

    /// Forgets what was drawn.
    pub fn clear(&mut self, background: Color) {
        self.canvas.clear(background);
    }

    /// Copies what was drawn to a picture of the frame's size.
    pub fn copy_to(&self, image: &mut Image) {
        let bytes = image.bytes_per_pixel();
        // A picture without pixels has no row.
        let row = (image.width() as usize * bytes).max(1);
        let (canvas, side) = (&self.canvas, self.canvas.grid.side as usize);
        // A row of tiles at once.
        self.threads.each_piece(image.buffer_mut(), side * row, |n, rows| {
            rows.chunks_mut(row).zip(n * side..).for_each(|(to, y)| canvas.copy_row(y, to, bytes));
        });
    }

    // ANCHOR: draw
    /// Draws a mesh. What was drawn before stays where it is nearer, or as near.
    pub fn draw<W: Shared>(&mut self, shader: &W, mesh: &Mesh, cull: Cull) -> Counts {
        let Self { plan, level, canvas, kept, threads } = self;
        let grid = canvas.grid;
        let size = (grid.picture.max + 1).as_vec2();
        let stages = Stages::new(shader, cull, Clipping::GuardBand, size);

        let mut vertices: Vec<Computed<W::Varying>> = std::mem::take(kept.of());
        let mut sorted: Vec<Sorted<W::Constant, W::Varying>> = std::mem::take(kept.of());
        let mut counts = Counts::default();
        threads.run(|| {
            // 1. Vertices, each once.
            threads.fill(&mut vertices, mesh.vertices.len(), |n| stages.vertex(&mesh.vertices[n]));

            // 2. Triangles, sorted into tiles, in as many parts as will keep all threads busy.
            let (count, part) = parts(mesh.faces.len(), plan.threads);
            let sorted = at_least(&mut sorted, count);
            threads.each(sorted, |n, sorted| {
                let triangles = mesh.some_triangles(part(n));
                sorted.fill(&stages, &vertices, triangles, &grid, |triangle| triangle.bounds(grid.picture));
            });
            sorted.iter().for_each(|part| counts += part.counts);
            counts.vertices = vertices.len();

            // 3. Tiles.
            let deferred = plan.deferred && shader.keeps_all();
            let job = Job { shader, sorted, plan: *plan, deferred };
            let background = canvas.background;
            threads.each(&mut canvas.tiles, |n, tile: &mut Tile| {
                if sorted.iter().any(|part| !part.by_tile[n].is_empty()) {
                    tile.open(background);
                    dispatch!(*level, simd => job.tile(simd, tile));
                }
            });
        });
        *kept.of() = vertices;
        *kept.of() = sorted;
        counts
    }
    // ANCHOR_END: draw
}
