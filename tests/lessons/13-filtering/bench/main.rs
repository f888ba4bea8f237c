//! What filtering costs: `cargo bench -p filtering-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `loop` | `nearest`, lesson 11's loop with lesson 9's texture; the same pixels | sides of 200, 800, 1600 px |
//! | `methods` | each way to filter, the default picture | 800 px |
//! | `mipmaps` | each way to make levels, the head's texture | 1024 texels |
//! | `layouts` | each order of texels, walked at 0°, 45° and 90° | 64, 512 and 4096 texels |
//!
//! First come ratios of times from one run in which both sides take turns, so that they hold on a machine that is now
//! fast and now slow. `nearest` asks for no footprint, so that its ratio tells what the footprint costs those who do not
//! ask for it.

use std::hint::black_box;
use std::path::Path;

use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh, SLABS};
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use filtering::scene::fine;
use filtering::{Footprint, LAYOUTS, METHODS, MIPMAPS, Surface, Texture, Wrap};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use verify::method;
use verify::turns::ratio;

const SIDES: [u16; 3] = [200, 800, 1600];

/// The program's scene.
struct Scene {
    models: [(Loaded, Mesh); 2],
    textures: [Texture; 2],
}

impl Scene {
    fn new() -> Self {
        let asset = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../assets").join(name);
        let needs = Attributes { normals: true, uvs: true };
        let read = |model: &Path, texture: Image| {
            let model = Model::read(model, needs).expect("the model is an asset");
            let loaded = Loaded::new(model, texture, textures::Wrap::Repeat);
            let mesh = indexed(&loaded.model, &loaded.normals, needs);
            (loaded, mesh)
        };
        let texture = |path: &Path| Image::read(path).expect("the texture is an asset");
        let [slabs, checks] = SLABS.map(Path::new);
        let models =
            [read(&asset("head.obj"), texture(&asset("head.tga"))), read(slabs, fine(&texture(checks)))];
        let mipmap = method(MIPMAPS, "box-linear");
        let textures = [0, 1].map(|n: usize| mipmap.texture(&models[n].0.texture, Wrap::Repeat));
        Self { models, textures }
    }

    /// By lesson 11, with lesson 9's texture.
    fn by_lesson_11(&self, image: &mut Image) {
        let models = self.models.each_ref().map(|(loaded, mesh)| (loaded.uniforms(light(), to_clip()), mesh));
        black_box(clipping::draw(&models, Cull::Back, Clipping::GuardBand, image).counts);
    }

    /// By one of this lesson's methods.
    fn by(&self, name: &str, image: &mut Image) {
        let surfaces = [0, 1].map(|n: usize| {
            let (loaded, mesh) = &self.models[n];
            Surface { uniforms: loaded.uniforms(light(), to_clip()), mesh, texture: &self.textures[n] }
        });
        black_box((method(METHODS, name).draw)(&surfaces, Cull::Back, image).counts);
    }
}

fn light() -> Vec3 {
    Vec3::new(0.4, 0.8, 0.8).normalize()
}

/// The program's default view of a square picture.
fn to_clip() -> Mat4 {
    let looks = view(Vec3::new(2.0, 0.2, 3.3), Vec3::new(0.3, -0.35, 0.0), Vec3::Y);
    perspective(45.0, 1.0, 0.1, 100.0).expect("a camera") * looks.expect("eye and centre are apart")
}

fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

fn ratios(_: &mut Criterion) {
    let scene = Scene::new();
    println!("times of one run, taking turns:");
    for side in SIDES {
        let [mut a, mut b] = [canvas(side), canvas(side)];
        scene.by("nearest", &mut a);
        scene.by_lesson_11(&mut b);
        assert!(a == b, "both draw the same pixels");
        let taken = ratio(|| scene.by("nearest", &mut a), || scene.by_lesson_11(&mut b));
        println!("{side}x{side}: nearest / lesson 11's loop: {taken:.3}");
    }
    for row in METHODS {
        let [mut a, mut b] = [canvas(800), canvas(800)];
        let taken = ratio(|| scene.by(row.name, &mut a), || scene.by("nearest", &mut b));
        println!("800x800: {} / nearest: {taken:.3}", row.name);
    }
}

fn loops(c: &mut Criterion) {
    let scene = Scene::new();
    let mut group = c.benchmark_group("loop");
    for side in SIDES {
        let mut image = canvas(side);
        group.throughput(Throughput::Elements(u64::from(side) * u64::from(side)));
        group.bench_function(BenchmarkId::new("lesson-11", side), |b| {
            b.iter(|| scene.by_lesson_11(&mut image));
        });
        group.bench_function(BenchmarkId::new("nearest", side), |b| {
            b.iter(|| scene.by("nearest", &mut image));
        });
    }
}

fn methods(c: &mut Criterion) {
    let scene = Scene::new();
    let mut group = c.benchmark_group("methods");
    let mut image = canvas(800);
    for row in METHODS {
        group.bench_function(row.name, |b| b.iter(|| scene.by(row.name, &mut image)));
    }
}

fn mipmaps(c: &mut Criterion) {
    let scene = Scene::new();
    let mut group = c.benchmark_group("mipmaps");
    group.sample_size(10);
    for row in MIPMAPS {
        let image = &scene.models[0].0.texture;
        group.bench_function(row.name, |b| b.iter(|| row.run.levels(image, Wrap::Repeat)));
    }
}

fn layouts(c: &mut Criterion) {
    let mut group = c.benchmark_group("layouts");
    // Rows so long that up a column of a large texture no line of memory is still in the cache when it is needed again.
    let mut colors = vec![Color::BLACK; 32 * 4096];
    group.throughput(Throughput::Elements(colors.len() as u64));
    for side in [64, 512, 4096] {
        let mut image = canvas(side);
        let mut rng = fastrand::Rng::with_seed(13);
        image.buffer_mut().iter_mut().for_each(|byte| *byte = rng.u8(..));
        for row in LAYOUTS {
            let walk = (row.run.walk)(&image);
            for degrees in [0.0_f32, 45.0, 90.0] {
                let along = Vec2::from_angle(degrees.to_radians()) / f32::from(side);
                let step = Footprint { x: along, y: along.perp() };
                let id = BenchmarkId::new(row.name, format!("{side}-{degrees}"));
                group.bench_function(id, |b| b.iter(|| walk(Vec2::ZERO, step, 4096, &mut colors)));
            }
        }
    }
}

criterion_group!(benches, ratios, loops, methods, mipmaps, layouts);
criterion_main!(benches);
