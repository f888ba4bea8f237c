//! What several samples cost: `cargo bench -p antialiasing-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `loop` | one sample, lesson 14's loop with all left out; one shader, the same pixels | sides of 200, 800, 1600 px |
//! | `methods` | each way to draw, the program's head and rays | 800 px |
//! | `storages` | each way to keep colours, the same, and under six layers that one sees through | 800 px |
//! | `sizes` | one sample and sixteen, a picture full of triangles of one size | legs of 2 to 128 px |
//!
//! First come ratios of times from one run in which both sides take turns, so that they hold on a machine that is now fast and
//! now slow.

use std::hint::black_box;
use std::path::Path;

use antialiasing::cover::fan;
use antialiasing::multisampled::{Multisampled, PerPixel};
use antialiasing::storage::{Compressed, Samples};
use antialiasing::{Canvas, Draw, Frames, METHODS, STORAGES, Scene, World, render, resolve};
use blending::scene::{Entity, View};
use blending::{Framebuffer, State};
use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh, SLABS};
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE};
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use filtering::filter::Nearest;
use filtering::scene::{Filterable, fine};
use filtering::shader::Filtered;
use filtering::{MIPMAPS, Texture, Wrap};
use lighting::PointLight;
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{perspective, view};
use shaders::target::Target;
use verify::method;
use verify::turns::ratio;
use zbuffer::Surface;

const SIDES: [u16; 3] = [200, 800, 1600];
const SIZES: [u16; 7] = [2, 4, 8, 16, 32, 64, 128];
const BOTH: Attributes = Attributes { normals: true, uvs: true };

/// One sample, and sixteen.
type One = Multisampled<1, Samples<1>>;
type Sixteen = Multisampled<16, Compressed<16>, PerPixel>;

/// A model with its texture.
fn read([model, texture]: [&str; 2]) -> Loaded {
    let model = Model::read(Path::new(model), BOTH).expect("the model is an asset");
    let texture = Image::read(Path::new(texture)).expect("the texture is an asset");
    Loaded::new(model, texture, textures::Wrap::Repeat)
}

fn camera(eye: Vec3, center: Vec3) -> Mat4 {
    let looks = view(eye, center, Vec3::Y).expect("eye and centre are apart");
    perspective(45.0, 1.0, 0.1, 100.0).expect("a camera") * looks
}

fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

/// Lesson 13's head on its floor, with the cheapest of its filters.
struct Floor(Vec<(Loaded, Mesh, Texture)>);

impl Floor {
    fn new() -> Self {
        let [mut head, mut floor] = [read([DEFAULT_MODEL, DEFAULT_TEXTURE]), read(SLABS)];
        floor.texture = fine(&floor.texture);
        let mipmap = method(MIPMAPS, "box-linear");
        let models = [&mut head, &mut floor].map(|loaded| {
            let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
            (mesh, mipmap.texture(&loaded.texture, Wrap::Repeat))
        });
        let with = |(loaded, (mesh, texture))| (loaded, mesh, texture);
        Self([head, floor].into_iter().zip(models).map(with).collect())
    }

    /// Calls `draw` with each model's shader and mesh.
    fn each(&self, size: Vec2, mut draw: impl FnMut(&Filtered<Nearest, Clamped>, &Mesh)) {
        let light = Vec3::new(0.4, 0.8, 0.8).normalize();
        let to_clip = camera(Vec3::new(2.0, 0.2, 3.3), Vec3::new(0.3, -0.35, 0.0));
        for (loaded, mesh, texture) in &self.0 {
            let uniforms = loaded.uniforms(light, to_clip);
            draw(&Filtered { uniforms, texture, filter: Nearest, lighting: Clamped, size }, mesh);
        }
    }

    fn by_lesson_14(&self, target: &mut Framebuffer<State>) {
        target.clear();
        self.each(target.image.size(), |shader, mesh| {
            black_box(clipping::render(shader, mesh, Cull::Back, Clipping::GuardBand, target));
        });
    }

    fn by<C: Canvas<Stencil = ()>>(&self, canvas: &mut C, image: &mut Image) {
        canvas.clear(Color::BLACK, false);
        self.each(canvas.size(), |shader, mesh| {
            black_box(render(shader, mesh, Cull::Back, State::OFF, canvas));
        });
        canvas.resolve(resolve, image);
    }
}

/// The program's scene without what it enlarges.
struct Cover {
    head: Filterable,
    rays: Vec<Surface>,
}

impl Cover {
    fn new(side: u16) -> Self {
        let mipmap = *method(MIPMAPS, "box-linear");
        let head = Filterable::new(read([DEFAULT_MODEL, DEFAULT_TEXTURE]), mipmap, Wrap::Repeat);
        Self { head, rays: fan(Vec2::splat(side.into())) }
    }

    /// Draws it with the head so many times, each time as opaque.
    fn draw(&self, frames: &mut Frames, alphas: &[f32], image: &mut Image) {
        let entity = |&alpha| Entity { model: &self.head, to_world: Mat4::IDENTITY, alpha };
        let entities: Vec<Entity> = alphas.iter().map(entity).collect();
        let eye = Vec3::new(3.3, 0.25, 1.05);
        let view =
            View { to_clip: camera(eye, Vec3::new(0.0, -0.03, 0.0)), eye, light: PointLight::default() };
        let world = World { entities: &entities, view, cull: Cull::Back };
        let scene = Scene { world: Some(world), ..Scene::of(&self.rays, Color::BLACK) };
        black_box(frames(&scene, image));
    }
}

/// Pictures by one way to draw, which keeps its canvas.
fn kept(draw: &Draw) -> Frames {
    (draw.frames)([800; 2])
}

/// Triangles with right angles and legs of so many pixels, which cover a picture, none on whole pixels.
fn tiles(leg: u16, side: u16) -> Vec<Surface> {
    let (leg, count) = (f32::from(leg), side.div_ceil(leg));
    let tile = |n: u16| {
        let corner = Vec2::new(f32::from(n % count), f32::from(n / count)) * leg - 0.37;
        let at = |x: f32, y: f32| (corner + Vec2::new(x, y) * leg).extend(0.5);
        [[at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)], [at(1.0, 1.0), at(0.0, 1.0), at(1.0, 0.0)]]
    };
    let corners = (0..count * count).flat_map(tile);
    corners.zip(0..).map(|(corners, n)| Surface { corners, color: Color::random(n) }).collect()
}

fn ratios(_: &mut Criterion) {
    let floor = Floor::new();
    println!("times of one run, taking turns:");
    for side in SIDES {
        let [mut a, mut b] = [canvas(side), canvas(side)];
        let mut one = One::new([side.into(); 2]);
        let mut target = Framebuffer::new(&mut b, State::OFF);
        floor.by(&mut one, &mut a);
        floor.by_lesson_14(&mut target);
        assert!(a == *target.image, "both draw the same pixels");
        let taken = ratio(|| floor.by(&mut one, &mut a), || floor.by_lesson_14(&mut target));
        println!("{side}x{side}: one sample / lesson 14's loop: {taken:.3}");
    }
    let cover = Cover::new(800);
    let [mut a, mut b] = [canvas(800), canvas(800)];
    for row in METHODS {
        let [mut by_row, mut none] = [&row.run, method(METHODS, "none")].map(kept);
        let taken =
            ratio(|| cover.draw(&mut by_row, &[1.0], &mut a), || cover.draw(&mut none, &[1.0], &mut b));
        println!("800x800: {} / none: {taken:.3}", row.name);
    }
    for (what, alphas) in [("opaque", &[1.0][..]), ("six layers", &[0.3; 6])] {
        let [mut plain, mut one] = ["samples", "compressed"].map(|name| kept(method(STORAGES, name)));
        let taken = ratio(|| cover.draw(&mut one, alphas, &mut a), || cover.draw(&mut plain, alphas, &mut b));
        println!("800x800: {what}, compressed / samples: {taken:.3}");
    }
    for leg in SIZES {
        let tiles = tiles(leg, 800);
        let scene = Scene::of(&tiles, Color::BLACK);
        let (mut sixteen, mut one) = (Sixteen::new([800; 2]), One::new([800; 2]));
        let taken = ratio(
            || {
                scene.draw_to(&a, &mut sixteen);
            },
            || {
                scene.draw_to(&b, &mut one);
            },
        );
        println!("800x800: triangles with legs of {leg} px, sixteen samples / one: {taken:.3}");
    }
}

fn loops(c: &mut Criterion) {
    let floor = Floor::new();
    let mut group = c.benchmark_group("loop");
    for side in SIDES {
        let [mut a, mut b] = [canvas(side), canvas(side)];
        let mut one = One::new([side.into(); 2]);
        let mut target = Framebuffer::new(&mut b, State::OFF);
        group.throughput(Throughput::Elements(u64::from(side) * u64::from(side)));
        group.bench_function(BenchmarkId::new("lesson-14", side), |bencher| {
            bencher.iter(|| floor.by_lesson_14(&mut target));
        });
        group.bench_function(BenchmarkId::new("one-sample", side), |bencher| {
            bencher.iter(|| floor.by(&mut one, &mut a));
        });
    }
}

fn methods(c: &mut Criterion) {
    let (cover, mut image) = (Cover::new(800), canvas(800));
    for (group, rows) in [("methods", METHODS), ("storages", STORAGES)] {
        let mut group = c.benchmark_group(group);
        group.sample_size(10);
        for row in rows {
            let mut frames = kept(&row.run);
            group.bench_function(row.name, |b| b.iter(|| cover.draw(&mut frames, &[1.0], &mut image)));
        }
    }
}

fn sizes(c: &mut Criterion) {
    let mut group = c.benchmark_group("sizes");
    group.sample_size(10);
    let image = canvas(800);
    for leg in SIZES {
        let tiles = tiles(leg, 800);
        let scene = Scene::of(&tiles, Color::BLACK);
        group.throughput(Throughput::Elements(tiles.len() as u64));
        let mut one = One::new([800; 2]);
        group.bench_function(BenchmarkId::new("one", leg), |b| b.iter(|| scene.draw_to(&image, &mut one)));
        let mut sixteen = Sixteen::new([800; 2]);
        group.bench_function(BenchmarkId::new("sixteen", leg), |b| {
            b.iter(|| scene.draw_to(&image, &mut sixteen));
        });
    }
}

criterion_group!(benches, ratios, loops, methods, sizes);
criterion_main!(benches);
