//! Lesson 16's scene with sixteen samples a pixel, by this lesson's blocks, lanes, tiles and threads.
//!
//! **Better:** a picture of 1024×768 pixels has 100 MB of samples; what a surface covers of them passes through the cache again.
//! Here all triangles of a frame are sorted into tiles first, and a tile is drawn at once, from the first surface to the last,
//! and resolved: its samples, 132 KB, stay in a core's second cache, and each core needs just one tile. Sixteen samples are
//! covered and compared by a few instructions; fragments, of whatever triangles, are shaded eight at a time. Of a
//! block of 8×8 pixels that an opaque triangle is the first to reach, and covers whole, no sample is asked, and its depths are
//! written only when another triangle comes.
//! **What it costs:** meshes of all looks must be one kind of triangle, so what is interpolated is an array of numbers
//! (`corners`), and what it means is told when the program runs, once for eight fragments.
//!
//! Pixels are those of lesson 16's own loops, to the last bit: each number is computed by the same operations in the same
//! order. With one sample a pixel they draw themselves.

mod corners;
mod fragments;
mod light;
mod raster;
mod samples;
mod tile;

use std::sync::{Mutex, PoisonError};

use clipping::render::{Computed, Stages};
use clipping::{Clipping, Counts};
use common::Image;
use fearless_simd::{Level, dispatch};
use scene::lamps::Lamps;
use scene::render::{Frame, Loops, Pass, Renderer};
use scene::scene::Style;

use crate::eight::packed;
use crate::threads::Threads;
use crate::tiles::{Grid, Sorted, at_least, parts};
use corners::{Constant, Corners, Numbers};
use fragments::{Fragments, Look};
use light::Lamp;
use tile::{SIDE, Tile};

/// What draws a scene in tiles, with all the memory that it takes, kept from frame to frame.
pub struct Sixteen {
    threads: Threads,
    tiled: Tiled,
    /// Pictures of one sample a pixel.
    loops: Loops,
}

/// What draws pictures of sixteen samples a pixel.
struct Tiled {
    level: Level,
    /// For the vertices, and for the pixels.
    lamps: (Lamps, Vec<Lamp>),
    passes: Vec<Prepared>,
    /// For each thread what it works with.
    desks: Vec<Mutex<Desk>>,
}

/// A pass, ready to be drawn.
#[derive(Default)]
struct Prepared {
    vertices: Vec<Computed<Numbers>>,
    /// Its triangles, in the first so many parts.
    sorted: Vec<Sorted<Constant, Numbers>>,
    parts: usize,
    counts: Counts,
}

/// A tile, and the fragments in it that are not shaded yet; in cache lines of its own, since what one thread writes would be
/// fetched again by a thread that reads another part of the line.
#[derive(Default)]
#[repr(align(128))]
struct Desk {
    tile: Tile,
    fragments: Fragments,
}

impl Sixteen {
    /// With so many threads, at least one.
    ///
    /// # Panics
    /// Where the system starts no thread.
    #[must_use]
    pub fn new(threads: usize) -> Self {
        let tiled = Tiled {
            level: Level::new(),
            lamps: Default::default(),
            passes: Vec::new(),
            desks: (0..threads.max(1)).map(|_| Mutex::default()).collect(),
        };
        Self { threads: Threads::new(threads), tiled, loops: Loops::default() }
    }

    /// The same with the instructions of that level, one that the machine has.
    #[must_use]
    pub fn at_level(self, level: Level) -> Self {
        Self { tiled: Tiled { level, ..self.tiled }, ..self }
    }
}

impl Prepared {
    /// Computes the vertices of a pass, and sorts its triangles into tiles.
    fn prepare(&mut self, threads: &Threads, pass: &Pass, lamps: &Lamps, style: Style, grid: &Grid) {
        let Self { vertices, sorted, counts, .. } = self;
        let size = (grid.picture.max + 1).as_vec2();
        let corners = Corners { pass, placed: pass.placed(lamps), style, size };
        let stages = Stages::new(&corners, pass.cull, Clipping::GuardBand, size);
        let mesh = pass.mesh.assembled();
        threads.fill(vertices, mesh.vertices.len(), |n| stages.vertex(&mesh.vertices[n]));
        let (count, part) = parts(mesh.faces.len(), threads.count());
        self.parts = count;
        let sorted = at_least(sorted, count);
        threads.each(sorted, |n, sorted| {
            let triangles = mesh.some_triangles(part(n));
            sorted.fill(&stages, vertices, triangles, grid, |triangle| triangle.pixels(grid.picture));
        });
        *counts = Counts::default();
        sorted.iter().for_each(|part| *counts += part.counts);
        counts.vertices = vertices.len();
    }
}

/// All that is known of a frame once its triangles are sorted.
struct Ordered<'a> {
    grid: Grid,
    background: u32,
    looks: &'a [Look<'a>],
    passes: &'a [Prepared],
    desks: &'a [Mutex<Desk>],
    level: Level,
}

impl Ordered<'_> {
    /// Draws a row of tiles into its bytes of the picture.
    fn draw_row(&self, row: usize, bytes: &mut [u8]) {
        let desk = &self.desks[rayon::current_thread_index().unwrap_or(0) % self.desks.len()];
        // Each thread has its own, so none waits here.
        let Desk { tile, fragments } = &mut *desk.lock().unwrap_or_else(PoisonError::into_inner);
        let Grid { picture, across, .. } = self.grid;
        for number in row * across..(row + 1) * across {
            tile.bounds = self.grid.tile(number);
            tile.clear(self.background);
            dispatch!(self.level, simd => {
                for (look, pass) in self.looks.iter().zip(self.passes) {
                    for sorted in &pass.sorted[..pass.parts] {
                        raster::draw(simd, look, &sorted.by_tile[number], tile, fragments);
                    }
                }
                tile.resolve(simd, bytes, picture.max.x as usize + 1);
            });
        }
    }
}

impl Renderer for Sixteen {
    fn draw(&mut self, frame: &Frame, picture: &mut Image) -> Counts {
        let Self { threads, tiled, loops } = self;
        if frame.antialiased {
            threads.run(|| tiled.draw(threads, frame, picture))
        } else {
            loops.draw(frame, picture)
        }
    }
}

impl Tiled {
    fn draw(&mut self, threads: &Threads, frame: &Frame, picture: &mut Image) -> Counts {
        let scene = frame.scene;
        let grid = Grid::new([picture.width(), picture.height()], SIDE);
        self.lamps.0.set(&scene.lights);
        self.lamps.1.clear();
        self.lamps.1.extend(scene.lights.iter().map(Lamp::new));
        let Self { level, lamps: (at_vertices, at_pixels), passes, desks } = self;
        let drawn: Vec<Pass> = frame.passes().collect();
        let passes = at_least(passes, drawn.len());
        threads.each(passes, |n, pass| pass.prepare(threads, &drawn[n], at_vertices, scene.style, &grid));
        let mut counts = Counts::default();
        passes.iter().for_each(|pass| counts += pass.counts);
        let looks: Vec<Look> = drawn.iter().map(|pass| Look::new(pass, scene.style, at_pixels)).collect();
        let background = packed(scene.background);
        let ordered = Ordered { grid, background, looks: &looks, passes, desks, level: *level };
        // A picture without pixels has no row.
        let row = (SIDE as usize * 3 * picture.width() as usize).max(1);
        threads.each_piece(picture.buffer_mut(), row, |row, bytes| ordered.draw_row(row, bytes));
        counts
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::time::Duration;

    use clipping::Cull;
    use common::{Color, Format, Mat4, Vec2, Vec3};
    use filtering::light::SRGB;
    use filtering::{Texture, Wrap};
    use lighting::PointLight;
    use lighting::light::Falloff;
    use scene::keys::Key;
    use scene::mesh::Paint;
    use scene::shapes::{cube, sphere};
    use scene::versions::in_perspective;
    use scene::{
        Entity, Filtering, Levels, METHODS, Mesh, Scene, Shading, Shape, Simulation, Target, VERSIONS,
        Vertex, render_scene,
    };

    use super::*;

    fn targets(width: u16, height: u16) -> [Target; 3] {
        let with = |sixteen| Target::with(Box::new(sixteen), width, height);
        let fallback = Sixteen::new(3).at_level(Level::baseline());
        [Target::new(width, height), with(Sixteen::new(1)), with(fallback)]
    }

    /// Draws by lesson 16's renderer and by this one, with one thread and the machine's best instructions and with three and those
    /// that all machines of its kind have: all must agree.
    fn assert_same(
        targets: &mut [Target; 3],
        what: &str,
        mut draw: impl FnMut(&mut Target) -> scene::Counts,
    ) {
        let [counts, one, three] = targets.each_mut().map(&mut draw);
        assert!(counts == one && counts == three, "{what}: {counts:?}, {one:?}, {three:?}");
        let [expected, one, three] = targets.each_ref().map(Target::picture);
        let differ = |other: &Image| expected.pixels().zip(other.pixels()).filter(|(a, b)| a != b).count();
        assert_eq!((differ(one), differ(three)), (0, 0), "{what}");
    }

    #[test]
    fn each_version_is_as_lesson_16_draws_it() {
        let mut targets = [(131, 97), (64, 32)].map(|(width, height)| targets(width, height));
        for version in VERSIONS {
            let mut simulation = Simulation::new(version, METHODS[3].run).unwrap();
            for keys in [&[][..], &[Key::F1], &[Key::F2], &[Key::F1, Key::W, Key::W, Key::W, Key::Left]] {
                for &key in keys {
                    simulation.press(key);
                    simulation.release(key);
                    simulation.advance(Duration::from_millis(450));
                }
                for targets in &mut targets {
                    let what = format!("version {}, {keys:?}", version.number);
                    assert_same(targets, &what, |target| simulation.draw(target));
                }
            }
        }
    }

    /// Numbers from 0 to 1, of a seed.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f32 {
            self.0 += 1;
            f32::from(Color::random(self.0).g) / 255.0
        }

        fn below(&mut self, n: usize) -> usize {
            ((self.next() * n as f32) as usize).min(n - 1)
        }

        fn vector(&mut self, reach: f32) -> Vec3 {
            Vec3::new(self.next() - 0.5, self.next() - 0.5, self.next() - 0.5) * (2.0 * reach)
        }
    }

    /// Entities of all looks, through which the eye may reach; textures finer and coarser than pixels, and repeated or not.
    fn scene(numbers: &mut Numbers) -> Scene {
        let style = Style {
            shading: [Shading::Unlit, Shading::Phong, Shading::BlinnPhong][numbers.below(3)],
            filter: [Filtering::Nearest, Filtering::Bilinear, Filtering::Trilinear][numbers.below(3)],
            cull: [Cull::None, Cull::Back, Cull::Front][numbers.below(3)],
        };
        let entities = (0..1 + numbers.below(6)).map(|_| {
            let floor = {
                let corner = |x: f32, z: f32| Vertex {
                    position: Vec3::new(x, 0.0, z) * 50.0,
                    normal: Vec3::Y,
                    uv: Vec2::new(x, z) * 20.0,
                };
                let vertices =
                    [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]].map(|[x, z]| corner(x, z)).to_vec();
                Shape { vertices, triangles: vec![[0, 1, 2], [0, 2, 3]] }
            };
            let shape = vec![cube(), sphere(5, 9), sphere(40, 60), floor].swap_remove(numbers.below(4));
            let mut color = |n: u64| Color { a: [255, 255, 90][n as usize % 3], ..Color::random(n) };
            let paint = match numbers.below(3) {
                0 => Paint::Color(color(numbers.below(200) as u64)),
                1 => Paint::Colors((0..shape.vertices.len() as u64).map(&mut color).collect()),
                _ => {
                    let mut image = Image::new(1 + numbers.below(9) as u16, 7, Format::Rgba);
                    image.set_all(|n| color(n as u64));
                    let levels = [image.clone(), image.scale(3, 3), image.scale(1, 1)];
                    let wrap = [Wrap::Repeat, Wrap::Repeat, Wrap::Clamp, Wrap::Mirror][numbers.below(4)];
                    Paint::Texture(Arc::new(Texture::of_levels(&levels, wrap, &SRGB)))
                }
            };
            Entity {
                position: numbers.vector(3.0) - Vec3::new(0.0, 0.0, 3.0),
                degrees: numbers.vector(180.0),
                scale: Vec3::ONE + numbers.vector(0.9),
                alpha: [1.0, 1.0, 0.6][numbers.below(3)],
                ..Entity::new(Levels::one(Mesh::new(&shape, paint)))
            }
        });
        let entities = entities.collect();
        let lights = (0..numbers.below(4)).map(|_| PointLight {
            position: numbers.vector(6.0),
            diffuse: numbers.next(),
            specular: numbers.next() - 0.2,
            shininess: 40.0 * numbers.next(),
            falloff: [Falloff::None, Falloff::Linear, Falloff::Quadratic][numbers.below(3)],
            ..PointLight::default()
        });
        let lights = lights.map(|light| PointLight { specular: light.specular.max(0.0), ..light }).collect();
        Scene { entities, lights, background: Color::rgb(10, 20, 30), style }
    }

    #[test]
    fn what_is_on_the_far_plane_is_not_seen() {
        let corner =
            |x: f32, y: f32| Vertex { position: Vec3::new(x, y, 0.0), normal: Vec3::Z, uv: Vec2::ZERO };
        let vertices = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| corner(x, y));
        let square = Shape { vertices: vertices.to_vec(), triangles: vec![[0, 1, 2], [0, 2, 3]] };
        let mesh = Mesh::new(&square, Paint::Color(Color::WHITE));
        let style = Style { shading: Shading::Unlit, filter: Filtering::Nearest, cull: Cull::None };
        let entities = vec![Entity::new(Levels::one(mesh))];
        let scene = Scene { entities, lights: Vec::new(), background: Color::BLACK, style };
        let mut targets = targets(64, 64);
        targets.iter_mut().for_each(|target| target.antialiased = true);
        for (depth, lit) in [(1.0, 0), (0.5, 64 * 64)] {
            let mut projection = Mat4::IDENTITY;
            projection.w_axis.z = depth;
            assert_same(&mut targets, &format!("depth {depth}"), |target| {
                render_scene(&scene, target, &projection, &Mat4::IDENTITY)
            });
            let white =
                |target: &Target| target.picture().pixels().filter(|pixel| pixel.2 == Color::WHITE).count();
            assert_eq!(white(&targets[1]), lit, "depth {depth}");
        }
    }

    #[test]
    fn any_scene_is_as_lesson_16_draws_it() {
        let mut targets = targets(75, 50);
        targets.iter_mut().for_each(|target| target.antialiased = true);
        let projection = in_perspective(70.0, Vec2::new(75.0, 50.0));
        for seed in 0..400 {
            let scene = scene(&mut Numbers(1000 * seed));
            assert_same(&mut targets, &format!("seed {seed}"), |target| {
                render_scene(&scene, target, &projection, &Mat4::IDENTITY)
            });
        }
    }
}
