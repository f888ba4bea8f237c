//! What drawing costs: `cargo bench -p clipping-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `loop` | lesson 11's loop with everything in the picture and nothing culled, lesson 9's; one shader, the same pixels | sides of 200, 800, 1600 px |
//! | `head` | the same with back faces culled | the same |
//! | `methods` | each way to clip, the default picture | 800 px |
//!
//! First come ratios of times from one run in which both sides take turns, so that they hold on a machine that is now
//! fast and now slow; and counts of what culling and an index buffer save.

use std::hint::black_box;
use std::path::Path;

use camera::lookat;
use clipping::mesh::indexed;
use clipping::{ASSEMBLIES, Clipping, Cull, METHODS, Mesh, SLABS, draw, facing, render};
use common::{Attributes, Format, Image, Mat4, Model, Vec2, Vec3, Vec4};
use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use perspective::depth::ZF32;
use perspective::scene::Loaded;
use perspective::{perspective, view, window};
use shaders::lighting::Gouraud;
use shaders::source::Texture;
use shaders::{Framebuffer, Lit, Uniforms, fit};
use textures::Wrap;
use transforms::projection;
use triangles::fill;
use verify::turns::ratio;

const SIDES: [u16; 3] = [200, 800, 1600];
const BOTH: Attributes = Attributes { normals: true, uvs: true };

/// A model and its texture, with its vertices unified.
fn read([model, texture]: [&Path; 2], wrap: Wrap) -> (Loaded, Mesh) {
    let model = Model::read(model, BOTH).expect("the model is an asset");
    let loaded = Loaded::new(model, Image::read(texture).expect("the texture is an asset"), wrap);
    let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
    (loaded, mesh)
}

fn head() -> (Loaded, Mesh) {
    let asset = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../assets").join(name);
    read([&asset("head.obj"), &asset("head.tga")], Wrap::Clamp)
}

fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

/// The slides' eye, as lesson 9 has it: a larger z is nearer.
fn slides() -> Mat4 {
    let looks = lookat(Vec3::new(1.0, 1.0, 2.0), Vec3::ZERO, Vec3::Y).expect("eye and centre are apart");
    fit(0.4, Vec2::ONE) * projection(6f32.sqrt()) * looks
}

/// The same picture with the nearer z smaller, and all of it between near and far.
fn turned() -> Mat4 {
    Mat4::from_diagonal(Vec4::new(1.0, 1.0, -0.25, 1.0)) * slides()
}

/// The program's default view of a square picture.
fn default_view() -> Mat4 {
    let looks = view(Vec3::new(1.7, -0.72, 2.5), Vec3::new(0.0, -0.2, 0.0), Vec3::Y);
    perspective(45.0, 1.0, 0.1, 100.0).expect("a camera") * looks.expect("eye and centre are apart")
}

/// Lesson 9's loop.
fn by_lesson_9(uniforms: &Uniforms, target: &mut Framebuffer) {
    shaders::draw(uniforms, Texture, Gouraud, target);
}

/// Lesson 11's, with lesson 9's shader.
fn by_lesson_11(uniforms: &Uniforms, mesh: &Mesh, cull: Cull, target: &mut perspective::Framebuffer<ZF32>) {
    black_box(render(&Lit::new(*uniforms, Texture, Gouraud), mesh, cull, Clipping::GuardBand, target));
}

/// The shares of a model's fragments, as many as its triangles cover pixels, that are of triangles that face away: of all
/// fragments, and of those that lesson 9 does not drop as turned away from a light along z.
fn shares_of_backs(head: &Loaded, to_clip: Mat4, side: u16) -> [f64; 2] {
    let bounds = canvas(side).bounds();
    let size = (bounds.max + 1).as_vec2();
    // Of all and of the lit ones: those that face the eye, those that face away.
    let mut counts = [[0_u64; 2]; 2];
    for (face, normals) in head.model.faces().zip(&head.normals) {
        let clip = face.map(|corner| to_clip * corner.extend(1.0));
        let [Some(a), Some(b), Some(c)] = clip.map(|corner| window(corner, size)) else { continue };
        let back = usize::from(facing(clip) <= 0.0);
        let brightness = Vec3::from_array(normals.map(|normal| normal.z));
        fill([a, b, c].map(|corner| Vec2::new(corner.x, corner.y)), bounds, |_, _, weights| {
            counts[0][back] += 1;
            counts[1][back] += u64::from(brightness.dot(weights) >= 0.0);
        });
    }
    counts.map(|[fronts, backs]| 100.0 * backs as f64 / (fronts + backs) as f64)
}

fn ratios(_: &mut Criterion) {
    let (head, own_mesh) = head();
    for (name, to_clip) in [("the slides' eye", turned()), ("the default eye", default_view())] {
        let [all, lit] = shares_of_backs(&head, to_clip, 800);
        println!(
            "of the head's fragments at {name} {all:.1} % face away; of those lit from the front, {lit:.1} %"
        );
    }
    for row in ASSEMBLIES {
        let mesh = (row.run)(&head.model, &head.normals, BOTH);
        println!("{}: {} vertices, {} indices", row.name, mesh.vertices.len(), mesh.indices.len());
    }
    println!("\ntimes of one run, taking turns:");
    for side in SIDES {
        let (before, after) = (head.uniforms(Vec3::Z, slides()), head.uniforms(Vec3::Z, turned()));
        for (what, cull) in [("nothing culled", Cull::None), ("culled", Cull::Back)] {
            let (mut lesson_9, mut image) = (Framebuffer::new(canvas(side)), canvas(side));
            let mut lesson_11 = perspective::Framebuffer::new(&mut image, ZF32);
            let taken = ratio(
                || {
                    lesson_11.depths.clear();
                    by_lesson_11(&after, &own_mesh, cull, &mut lesson_11);
                },
                || {
                    lesson_9.depths.clear();
                    by_lesson_9(&before, &mut lesson_9);
                },
            );
            println!("{side}x{side}: lesson 11's loop, {what} / lesson 9's: {taken:.3}");
        }
    }
    let light = Vec3::new(0.4, 0.8, 0.8).normalize();
    for side in SIDES {
        let [mut a, mut b] = [canvas(side), canvas(side)];
        let uniforms = head.uniforms(light, default_view());
        let scene = [(uniforms, &own_mesh)];
        let draw = |cull, image: &mut Image| drop(black_box(draw(&scene, cull, Clipping::GuardBand, image)));
        let taken = ratio(|| draw(Cull::Back, &mut a), || draw(Cull::None, &mut b));
        println!("{side}x{side}: the head at the default eye, culled / not: {taken:.3}");
    }
    for row in ASSEMBLIES {
        let mesh = (row.run)(&head.model, &head.normals, BOTH);
        let [mut a, mut b] = [canvas(800), canvas(800)];
        let after = head.uniforms(Vec3::Z, turned());
        let draw = |mesh: &Mesh, image: &mut Image| {
            by_lesson_11(&after, mesh, Cull::Back, &mut perspective::Framebuffer::new(image, ZF32));
        };
        let taken = ratio(|| draw(&mesh, &mut a), || draw(&own_mesh, &mut b));
        println!("800x800: the head, {} / indexed: {taken:.3}", row.name);
    }
}

fn loops(c: &mut Criterion) {
    let (head, own_mesh) = head();
    for (group, cull) in [("loop", Cull::None), ("head", Cull::Back)] {
        let mut group = c.benchmark_group(group);
        for side in SIDES {
            let (before, after) = (head.uniforms(Vec3::Z, slides()), head.uniforms(Vec3::Z, turned()));
            let (mut target, mut image) = (Framebuffer::new(canvas(side)), canvas(side));
            by_lesson_9(&before, &mut target);
            by_lesson_11(&after, &own_mesh, Cull::None, &mut perspective::Framebuffer::new(&mut image, ZF32));
            let differ =
                image.pixels().filter(|&(x, y, color)| target.image.get(x, y) != Some(color)).count();
            // In perspective a texel is another here and there, and none is where none was.
            let empty = image.pixels().filter(|&(x, y, _)| target.image.get(x, y).is_none()).count();
            assert!(empty == 0 && differ < usize::from(side) * usize::from(side) / 4, "{differ}");
            group.throughput(Throughput::Elements(u64::from(side) * u64::from(side)));
            group.bench_function(BenchmarkId::new("lesson-9", side), |b| {
                b.iter_batched_ref(
                    || Framebuffer::new(canvas(side)),
                    |target| by_lesson_9(&before, target),
                    BatchSize::LargeInput,
                );
            });
            group.bench_function(BenchmarkId::new("lesson-11", side), |b| {
                b.iter_batched_ref(
                    || canvas(side),
                    |image| {
                        let mut target = perspective::Framebuffer::new(image, ZF32);
                        by_lesson_11(&after, &own_mesh, cull, &mut target);
                    },
                    BatchSize::LargeInput,
                );
            });
        }
    }
}

fn methods(c: &mut Criterion) {
    let models = [head(), read(SLABS.map(Path::new), Wrap::Repeat)];
    let light = Vec3::new(0.4, 0.8, 0.8).normalize();
    let mut group = c.benchmark_group("methods");
    for row in METHODS {
        let scene = models.each_ref().map(|(loaded, mesh)| (loaded.uniforms(light, default_view()), mesh));
        group.bench_function(row.name, |b| {
            b.iter_batched_ref(
                || canvas(800),
                |image| draw(&scene, Cull::Back, row.run, image).counts,
                BatchSize::LargeInput,
            );
        });
    }
}

criterion_group!(benches, ratios, loops, methods);
criterion_main!(benches);
