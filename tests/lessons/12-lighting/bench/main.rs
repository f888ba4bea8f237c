//! What light costs: `cargo bench -p lighting-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `head` | the four methods, the head as the program draws it | 800 px |
//! | `normalisations`, `powers` | each row, in the same picture by `blinn-phong` | 800 px |
//!
//! First come ratios of times from one run in which both sides take turns, so that they hold on a machine that is now
//! fast and now slow. The promise is that of the course: what a scene does not use it does not pay for. Lesson 9's looks
//! without a point light, drawn by lesson 11's loop, take as long compiled here beside lesson 12's shaders as where lesson
//! 11 compiles them, to within 5 %; they interpolate not a byte more, which a test checks.

use std::hint::black_box;
use std::path::Path;

use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh, render};
use common::{Attributes, Format, Image, Mat4, Model, Vec3};
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use lighting::{Draw, METHODS, NORMALISATIONS, POWERS, PointLight, Scene};
use perspective::depth::ZF32;
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{Framebuffer, perspective, view};
use shaders::lighting::{Flat, Lighting};
use shaders::source::{Source, Texture, White};
use shaders::{Lit, Uniforms};
use textures::Wrap;
use verify::turns::ratio;

const SIDES: [u16; 3] = [200, 800, 1600];
const BOTH: Attributes = Attributes { normals: true, uvs: true };
const EYE: Vec3 = Vec3::new(0.55, 0.35, 2.35);

fn head() -> (Loaded, Mesh) {
    let asset = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../assets").join(name);
    let model = Model::read(&asset("head.obj"), BOTH).expect("the model is an asset");
    let texture = Image::read(&asset("head.tga")).expect("the texture is an asset");
    let loaded = Loaded::new(model, texture, Wrap::Clamp);
    let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
    (loaded, mesh)
}

/// The program's default view of a square picture.
fn camera() -> Mat4 {
    let looks = view(EYE, Vec3::new(0.0, 0.12, 0.0), Vec3::Y).expect("eye and centre are apart");
    perspective(45.0, 1.0, 0.1, 100.0).expect("a camera") * looks
}

fn scene(loaded: &Loaded) -> Scene<'_> {
    Scene::placed(loaded, Mat4::IDENTITY, camera(), EYE, PointLight::default()).expect("nothing is flattened")
}

fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

/// A look of lesson 9 in lesson 11's loop, compiled here.
fn unlit(uniforms: &Uniforms, mesh: &Mesh, source: impl Source, lighting: impl Lighting, image: &mut Image) {
    let mut target = Framebuffer::new(image, ZF32);
    let shader = Lit::new(*uniforms, source, lighting);
    black_box(render(&shader, mesh, Cull::Back, Clipping::GuardBand, &mut target));
}

fn ratios(_: &mut Criterion) {
    let (head, mesh) = head();
    let scene = scene(&head);
    let uniforms = head.uniforms(Vec3::new(0.4, 0.8, 0.8).normalize(), camera());
    println!("times of one run, taking turns:");
    for side in SIDES {
        let [mut a, mut b] = [canvas(side), canvas(side)];
        let beside = ratio(
            || unlit(&uniforms, &mesh, Texture, Clamped, &mut a),
            || drop(black_box(clipping::draw(&[(uniforms, &mesh)], Cull::Back, Clipping::GuardBand, &mut b))),
        );
        println!("{side}x{side}: gouraud-texture beside lesson 12's shaders / in lesson 11: {beside:.3}");
    }
    for side in SIDES {
        for row in METHODS {
            let [mut a, mut b] = [canvas(side), canvas(side)];
            let lit = ratio(
                || drop(black_box((row.run)(&scene, &mesh, Cull::Back, &mut a))),
                || unlit(&uniforms, &mesh, White, Flat, &mut b),
            );
            println!("{side}x{side}: {} / lesson 9's flat: {lit:.3}", row.name);
        }
    }
    let rows = NORMALISATIONS.iter().map(|row| (row.name, row.run.draw));
    for (name, draw) in rows.chain(POWERS.iter().map(|row| (row.name, row.run.draw))) {
        let [mut a, mut b] = [canvas(800), canvas(800)];
        let blinn = *verify::method(METHODS, "blinn-phong");
        let other = ratio(
            || drop(black_box(draw(&scene, &mesh, Cull::Back, &mut a))),
            || drop(black_box(blinn(&scene, &mesh, Cull::Back, &mut b))),
        );
        println!("800x800: {name} / exact and powf: {other:.3}");
    }
}

fn pictures(c: &mut Criterion) {
    let (head, mesh) = head();
    let scene = scene(&head);
    let mut group = |name: &str, rows: Vec<(&'static str, Draw)>| {
        let mut group = c.benchmark_group(name);
        for (name, draw) in rows {
            group.bench_function(name, |b| {
                let draw = |image: &mut Image| draw(&scene, &mesh, Cull::Back, image).counts;
                b.iter_batched_ref(|| canvas(800), draw, BatchSize::LargeInput);
            });
        }
    };
    group("head", METHODS.iter().map(|row| (row.name, row.run)).collect());
    group("normalisations", NORMALISATIONS.iter().map(|row| (row.name, row.run.draw)).collect());
    group("powers", POWERS.iter().map(|row| (row.name, row.run.draw)).collect());
}

criterion_group!(benches, ratios, pictures);
criterion_main!(benches);
