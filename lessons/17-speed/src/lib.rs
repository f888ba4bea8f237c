//! Lesson 17: the same pixels, as fast as the machine allows.
//!
//! **You will see** lesson 13's picture, and nothing of what is new: not one pixel may differ. **New:** how long it takes. Blocks
//! of pixels, eight pixels at once, tiles that fit into the cache, depths of whole blocks, shading what is seen and nothing
//! else, and all cores.
//!
//! The job: draw a picture in less time. [`METHODS`] starts with lesson 13's loop and adds one idea a row. [`blocks`](mod@blocks) accepts and
//! rejects 8×8 pixels at once. From there on pictures are drawn in a [`frame`]: `simd` has eight pixels of a row in the lanes of
//! a register, `tiles` sorts triangles by where they are, `hierarchical_depth` knows how deep blocks are, `deferred` finds what
//! is seen before it is shaded, `threads` shares out the work; `render` draws a tile with as many of them as are asked for.
//! [`eight`] has shaders for eight pixels, [`filters`] lesson 13's, `texels` what these fetch. [`sixteen`] draws lesson 16's
//! scene with sixteen samples a pixel.
//!
//! From earlier lessons come vertices, cuts and culling (lesson 11's [`Stages`](clipping::render::Stages)), textures (13), and
//! every formula: what is computed here for eight pixels at once is rounded as lessons 3, 4 and 10 round it, in the same order.
//!
//! Conventions: as in lesson 13. Pixels are packed as they stand in a picture, red in the lowest byte.

pub mod blocks;
mod deferred;
pub mod eight;
pub mod filters;
pub mod frame;
mod hierarchical_depth;
mod render;
mod simd;
pub mod sixteen;
mod texels;
mod threads;
mod tile;
mod tiles;
mod triangle;

use clipping::render::triangles;
use clipping::{Clipping, Counts, Cull};
use common::{Color, Image, Lesson, Method, Table};
use filtering::Surface;
use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Nearest, Trilinear};
use filtering::shader::Filtered;
use perspective::depth::ZF32;
use perspective::draw_triangle;
use perspective::lighting::Clamped;

use blocks::Blocks;
use filters::WideFilter;
use frame::Frame;

pub use frame::Plan;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 17,
    name: "speed",
    title: "Speed",
    job: "the same pixels, as fast as the machine allows",
    tables: &[Table { name: "", job: "Draw fast", rows: || Method::rows(METHODS) }],
};

/// Lesson 13's surfaces, and how they are to be drawn.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    /// What is drawn, in this order.
    pub surfaces: &'a [Surface<'a>],
    /// Which triangles are left out.
    pub cull: Cull,
}

/// Who draws one picture after another, all of one size, over whatever was in it.
pub type Drawer = Box<dyn FnMut(&Picture, &mut Image) -> Counts>;

/// Makes a drawer for a method, pictures of a size and so many threads.
type Start = fn(&Renderer, [i32; 2], usize) -> Drawer;

/// For each row of lesson 13's table of filters who draws with it.
const FILTERS: [Start; 5] = [
    Renderer::drawer_by::<Nearest>,
    Renderer::drawer_by::<Bilinear>,
    Renderer::drawer_by::<Bilinear8>,
    Renderer::drawer_by::<Trilinear>,
    Renderer::drawer_by::<Anisotropic>,
];

/// A method.
#[derive(Clone, Copy)]
pub struct Renderer {
    /// Which ideas it uses, if it draws in tiles.
    pub plan: Option<Plan>,
    /// Whether lesson 13's loop goes over blocks, if it does not.
    in_blocks: bool,
}

impl Renderer {
    const SIMPLE: Self = Self { plan: None, in_blocks: false };
    const BLOCKS: Self = Self { plan: None, in_blocks: true };

    const fn tiled(plan: Plan) -> Self {
        Self { plan: Some(plan), in_blocks: false }
    }

    /// Who draws by it, pictures of that size in pixels, textures filtered by that row of lesson 13's table, with so many
    /// threads if it uses them at all.
    #[must_use]
    pub fn drawer(&self, size: [i32; 2], filter: usize, threads: usize) -> Drawer {
        FILTERS[filter](self, size, threads)
    }

    /// Who draws by it with the filter `F`, pictures of that size in pixels, with so many threads if it uses them at all.
    #[must_use]
    pub fn drawer_by<F: WideFilter>(&self, size: [i32; 2], threads: usize) -> Drawer {
        match self.plan {
            None if self.in_blocks => blocks::<F>(),
            None => simple::<F>(),
            Some(plan) if plan.threads == 1 => tiled::<F>(plan, size),
            Some(plan) => tiled::<F>(Plan { threads, ..plan }, size),
        }
    }
}

fn simple<F: WideFilter>() -> Drawer {
    Box::new(|picture, image| {
        image.clear();
        filtering::draw(picture.surfaces, F::default(), picture.cull, image).counts
    })
}

fn blocks<F: WideFilter>() -> Drawer {
    Box::new(|picture, image| {
        image.clear();
        let size = image.size();
        let mut target = perspective::Framebuffer::new(image, ZF32);
        let mut counts = Counts::default();
        for surface in picture.surfaces {
            let shader = filtered(surface, F::default(), size);
            let fill = |constant, corners, varyings| {
                draw_triangle(&shader, constant, corners, varyings, Blocks, &mut target);
            };
            counts += triangles(&shader, surface.mesh, picture.cull, Clipping::GuardBand, size, fill);
        }
        counts
    })
}

fn tiled<F: WideFilter>(plan: Plan, size: [i32; 2]) -> Drawer {
    let mut frame = Frame::new(size, plan);
    Box::new(move |picture, image| {
        frame.clear(Color { a: 0, ..Color::BLACK });
        let mut counts = Counts::default();
        for surface in picture.surfaces {
            let shader = filtered(surface, F::default(), image.size());
            counts += frame.draw(&shader, surface.mesh, picture.cull);
        }
        frame.copy_to(image);
        counts
    })
}

/// Lesson 13's shader for a surface in a picture of that size.
fn filtered<'a, F>(surface: &Surface<'a>, filter: F, size: common::Vec2) -> Filtered<'a, F, Clamped> {
    let &Surface { uniforms, texture, .. } = surface;
    Filtered { uniforms, texture, filter, lighting: Clamped, size }
}

const SIMD: Plan = Plan { tile: None, hierarchical: false, deferred: false, threads: 1 };
const TILES: Plan = Plan { tile: Some(64), ..SIMD };
const HIERARCHICAL: Plan = Plan { hierarchical: true, ..TILES };
const DEFERRED: Plan = Plan { deferred: true, ..HIERARCHICAL };
const THREADS: Plan = Plan { threads: 0, ..DEFERRED };

/// The ways to draw the same pixels, each with one idea more than the one before.
pub const METHODS: &[Method<Renderer>] = &[
    Method {
        name: "simple",
        run: Renderer::SIMPLE,
        promise: "lesson 13's loop: a triangle after the other, a pixel after the other",
        failure: "what is hidden later is shaded all the same; one pixel at a time, on one core",
    },
    Method {
        name: "blocks",
        run: Renderer::BLOCKS,
        promise: "8×8 pixels accepted or rejected at once, by the edge functions at their corners",
        failure: "by itself slower: small triangles touch four blocks for a few pixels",
    },
    Method {
        name: "simd",
        run: Renderer::tiled(SIMD),
        promise: "eight pixels of a row tested and interpolated by the same instructions",
        failure: "lanes outside of a triangle work for nothing; depths and colours of the whole picture pass through the cache",
    },
    Method {
        name: "tiles",
        run: Renderer::tiled(TILES),
        promise: "64×64 pixels after the other, whose depths and colours stay in the cache; cleared when first drawn to",
        failure: "all triangles must be known and sorted first; one that reaches over many tiles is made ready in each",
    },
    Method {
        name: "hierarchical-depth",
        run: Renderer::tiled(HIERARCHICAL),
        promise: "each block knows its farthest depth: what is behind it is rejected at once",
        failure: "nothing is rejected back to front, and each block is looked through again after it has changed",
    },
    Method {
        name: "deferred",
        run: Renderer::tiled(DEFERRED),
        promise: "which triangle is seen is found first; each pixel is shaded once",
        failure: "sixteen bytes more are kept for each pixel; a shader that may drop fragments is not deferred",
    },
    Method {
        name: "threads",
        run: Renderer::tiled(THREADS),
        promise: "tiles share no pixel: all cores draw, and no pixel is locked",
        failure: "two threads share memory, caches and clock; what takes less than waking a thread gains nothing",
    },
];
