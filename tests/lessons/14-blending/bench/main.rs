//! What blending costs: `cargo bench -p blending-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `loop` | everything off, lesson 13's loop; the same pixels, nearest texels | sides of 200, 800, 1600 px |
//! | `state` | layers by type, and the same state decided when the program runs; the crates | 800 px |
//! | `order` | tests before shading, and after it; twelve crates in a row, the nearest first | 800 px |
//! | `division` | each way to divide, ten layers over a whole picture | 800 px |
//!
//! First come ratios of times from one run in which both sides take turns, so that they hold on a machine that is now
//! fast and now slow.

use std::hint::black_box;
use std::path::Path;

use blending::crates::CRATE;
use blending::division::Division;
use blending::division::{Div256, Exact, Float, Shift8};
use blending::scene::{Entity, View};
use blending::{AnyState, Divide, Framebuffer, Late, METHODS, Over, State, TwoShift, crates, plain};
use clipping::{Clipping, Cull, SLABS, render};
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE};
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec3};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use filtering::filter::Nearest;
use filtering::scene::{Filterable, fine};
use filtering::shader::Filtered;
use filtering::{MIPMAPS, Surface, Wrap};
use lighting::PointLight;
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{perspective, view};
use transforms::translate;
use verify::method;
use verify::turns::ratio;
use zbuffer::Surface as Flat;

const SIDES: [u16; 3] = [200, 800, 1600];

fn read([model, texture]: [&str; 2]) -> Filterable {
    let model = Model::read(Path::new(model), Attributes { normals: true, uvs: true }).expect("an asset");
    let texture = Image::read(Path::new(texture)).expect("an asset");
    let texture = if texture.width() < 16 { fine(&texture) } else { texture };
    let loaded = Loaded::new(model, texture, Default::default());
    Filterable::new(loaded, *method(MIPMAPS, "box-linear"), Wrap::Repeat)
}

/// Lesson 13's scene: the head on its floor.
struct Scene([Filterable; 2]);

impl Scene {
    fn new() -> Self {
        Self([read([DEFAULT_MODEL, DEFAULT_TEXTURE]), read(SLABS)])
    }

    fn surfaces(&self) -> [Surface<'_>; 2] {
        let looks = view(Vec3::new(2.0, 0.2, 3.3), Vec3::new(0.3, -0.35, 0.0), Vec3::Y);
        let to_clip = perspective(45.0, 1.0, 0.1, 100.0).expect("a camera") * looks.expect("they are apart");
        self.0.each_ref().map(|model| model.surface(Vec3::new(0.4, 0.8, 0.8).normalize(), to_clip))
    }

    fn by_lesson_13(&self, image: &mut Image) {
        black_box((method(filtering::METHODS, "nearest").draw)(&self.surfaces(), Cull::Back, image).counts);
    }

    /// With everything off.
    fn by_lesson_14(&self, image: &mut Image) {
        let size = image.size();
        let mut target = Framebuffer::new(image, State::OFF);
        for Surface { uniforms, mesh, texture } in self.surfaces() {
            let shader = Filtered { uniforms, texture, filter: Nearest, lighting: Clamped, size };
            black_box(render(&shader, mesh, Cull::Back, Clipping::GuardBand, &mut target));
        }
    }
}

/// The program's view of a square picture.
fn crate_view() -> View {
    let eye = Vec3::new(0.6, 1.2, 3.25);
    let looks = view(eye, Vec3::ZERO, Vec3::Y).expect("eye and centre are apart");
    View {
        to_clip: perspective(45.0, 1.0, 0.1, 100.0).expect("a camera") * looks,
        eye,
        light: PointLight::default(),
    }
}

fn by_type(crate_: &Filterable, divide: &Divide, image: &mut Image) {
    black_box((divide.entities)(&crates::entities(crate_), &crate_view(), image).counts);
}

fn by_option(crate_: &Filterable, divide: &Divide, image: &mut Image) {
    let target = Framebuffer::new(image, AnyState::USUAL);
    black_box((divide.entities_under)(target, &crates::entities(crate_), &crate_view()).1);
}

/// Twelve crates, one behind the other, the nearest first.
fn row(crate_: &Filterable) -> Vec<Entity<'_>> {
    let place = |n: u8| translate(Vec3::new(0.1, 0.15, -1.2) * f32::from(n)) * Mat4::IDENTITY;
    (0..12).map(|n| Entity { model: crate_, to_world: place(n), alpha: 1.0 }).collect()
}

fn early(crate_: &Filterable, image: &mut Image) {
    let mut target = Framebuffer::new(image, State::OFF);
    for entity in row(crate_) {
        black_box(entity.draw(&crate_view(), Cull::Back, &mut target));
    }
}

fn late(crate_: &Filterable, image: &mut Image) {
    let mut target = Late(Framebuffer::new(image, State::OFF));
    for entity in row(crate_) {
        black_box(entity.draw(&crate_view(), Cull::Back, &mut target));
    }
}

/// Ten layers over a whole picture.
fn layers<D: Division>(image: &mut Image) {
    let corners = |z: f32| [(-10.0, -10.0), (1e4, -10.0), (-10.0, 1e4)].map(|(x, y)| Vec3::new(x, y, z));
    let surface = |n: u8| Flat {
        corners: corners(0.9 - f32::from(n) / 20.0),
        color: Color { a: 40 + 10 * n, ..Color::random(n.into()) },
    };
    let surfaces: Vec<Flat> = (0..10).map(surface).collect();
    plain::draw(&surfaces, &mut Framebuffer::new(image, State::blending(Over(D::default()))));
}

/// Draws ten layers.
type Layers = fn(&mut Image);

const DIVISIONS: [(&str, Layers); 5] = [
    ("float", layers::<Float>),
    ("exact", layers::<Exact>),
    ("two-shift", layers::<TwoShift>),
    ("shift-8", layers::<Shift8>),
    ("div-256", layers::<Div256>),
];

fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

fn ratios(_: &mut Criterion) {
    let (scene, crate_) = (Scene::new(), read(CRATE));
    println!("times of one run, taking turns:");
    for side in SIDES {
        let [mut a, mut b] = [canvas(side), canvas(side)];
        scene.by_lesson_14(&mut a);
        scene.by_lesson_13(&mut b);
        assert!(a == b, "both draw the same pixels");
        let taken = ratio(|| scene.by_lesson_14(&mut a), || scene.by_lesson_13(&mut b));
        println!("{side}x{side}: everything off / lesson 13's loop: {taken:.3}");
    }
    let [mut a, mut b] = [canvas(800), canvas(800)];
    let two_shift = method(METHODS, "two-shift");
    let taken = ratio(|| by_option(&crate_, two_shift, &mut a), || by_type(&crate_, two_shift, &mut b));
    assert!(a == b, "both draw the same pixels");
    println!("800x800: decided when the program runs / by type: {taken:.3}");
    let [mut a, mut b] = [canvas(800), canvas(800)];
    let taken = ratio(|| late(&crate_, &mut a), || early(&crate_, &mut b));
    assert!(a == b, "both draw the same pixels");
    println!("800x800: late tests / early tests: {taken:.3}");
    for (name, layers) in DIVISIONS {
        let taken = ratio(|| layers(&mut a), || self::layers::<TwoShift>(&mut b));
        println!("800x800: layers, {name} / two-shift: {taken:.3}");
    }
}

fn loops(c: &mut Criterion) {
    let scene = Scene::new();
    let mut group = c.benchmark_group("loop");
    for side in SIDES {
        let mut image = canvas(side);
        group.throughput(Throughput::Elements(u64::from(side) * u64::from(side)));
        group.bench_function(BenchmarkId::new("lesson-13", side), |b| {
            b.iter(|| scene.by_lesson_13(&mut image));
        });
        group.bench_function(BenchmarkId::new("everything-off", side), |b| {
            b.iter(|| scene.by_lesson_14(&mut image));
        });
    }
}

fn state(c: &mut Criterion) {
    let crate_ = read(CRATE);
    let mut image = canvas(800);
    let mut group = c.benchmark_group("state");
    for row in METHODS {
        group.bench_function(BenchmarkId::new("type", row.name), |b| {
            b.iter(|| by_type(&crate_, &row.run, &mut image));
        });
        group.bench_function(BenchmarkId::new("option", row.name), |b| {
            b.iter(|| by_option(&crate_, &row.run, &mut image));
        });
    }
}

fn order(c: &mut Criterion) {
    let crate_ = read(CRATE);
    let mut image = canvas(800);
    let mut group = c.benchmark_group("order");
    group.bench_function("early", |b| b.iter(|| early(&crate_, &mut image)));
    group.bench_function("late", |b| b.iter(|| late(&crate_, &mut image)));
}

fn division(c: &mut Criterion) {
    let mut image = canvas(800);
    let mut group = c.benchmark_group("division");
    group.throughput(Throughput::Elements(10 * 800 * 800));
    for (name, layers) in DIVISIONS {
        group.bench_function(name, |b| b.iter(|| layers(&mut image)));
    }
}

criterion_group!(benches, ratios, loops, state, order, division);
criterion_main!(benches);
