//! What drawing costs: `cargo bench -p shaders-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `flat` | lesson 9's flat shader, lesson 4's loop written for this one look; the same pixels | sides of 200, 800, 1600 px |
//! | `gouraud-texture` | lesson 9's shader, the slides' renderer | the same |
//! | `sliver` | lesson 3's exact edges, the test of the whole bounding box | 100 to 6400 px of a diagonal |
//!
//! Last come ratios of times from one run in which both sides take turns, so that they hold on a machine that
//! is now fast and now slow.

mod listing;

use std::hint::black_box;
use std::path::Path;

use camera::lookat;
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3};
use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use gouraud::corner_normals;
use listing::Listing;
use shaders::{Framebuffer, SHADERS, Uniforms, fit};
use transforms::projection;
use triangles::METHODS;
use verify::method;
use verify::turns::ratio_on;
use zbuffer::{surfaces, z_f32};

const SIDES: [u16; 3] = [200, 800, 1600];
const BOTH: Attributes = Attributes { normals: true, uvs: true };

fn asset(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets").join(name)
}

/// The head and its texture.
fn head() -> (Model, Image) {
    let model = Model::read(&asset("head.obj"), BOTH).expect("the model is an asset");
    let texture = Image::read(&asset("head.tga")).expect("the texture is an asset");
    (model, texture)
}

fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

/// From the front and infinitely far away, as lesson 4 draws; or from the slides' eye.
fn uniforms<'a>(
    model: &'a Model,
    normals: &'a [[Vec3; 3]],
    texture: &'a Image,
    view: Option<Mat4>,
) -> Uniforms<'a> {
    let (zoom, distance) = if view.is_some() { (0.4, 6f32.sqrt()) } else { (0.5, f32::INFINITY) };
    let to_clip = fit(zoom, Vec2::ONE) * projection(distance) * view.unwrap_or_default();
    Uniforms { normals, texture: Some(texture), to_clip, ..Uniforms::new(model) }
}

fn slides_view() -> Mat4 {
    lookat(Vec3::new(1.0, 1.0, 2.0), Vec3::ZERO, Vec3::Y).expect("eye and centre are apart")
}

/// Lesson 9's shader of that name, compiled for itself.
fn by_shader(uniforms: &Uniforms, name: &str, target: &mut Framebuffer) {
    (method(SHADERS, name).generic)(uniforms, target);
}

/// Lesson 4's way, from the model to the picture.
fn by_lesson_4(model: &Model, image: &mut Image) {
    let surfaces = surfaces(model, Vec3::Z, image);
    z_f32(&surfaces, image);
}

/// A sliver along the diagonal, 2 px wide.
fn sliver(length: u16) -> [Vec2; 3] {
    let end = f32::from(length) / 2f32.sqrt();
    [Vec2::new(0.3, 0.7), Vec2::new(end, end + 1.4), Vec2::new(end + 1.4, end)]
}

fn flat(c: &mut Criterion) {
    let (model, texture) = head();
    let normals = corner_normals(&model);
    let mut group = c.benchmark_group("flat");
    for side in SIDES {
        let uniforms = uniforms(&model, &normals, &texture, None);
        let (mut target, mut image) = (Framebuffer::new(canvas(side)), canvas(side));
        by_shader(&uniforms, "flat", &mut target);
        by_lesson_4(&model, &mut image);
        assert!(target.image == image, "the two draw the same");
        group.throughput(Throughput::Elements(u64::from(side) * u64::from(side)));
        group.bench_function(BenchmarkId::new("lesson-9", side), |b| {
            b.iter_batched_ref(
                || canvas(side),
                |image| {
                    let mut target = Framebuffer::new(std::mem::replace(image, canvas(0)));
                    by_shader(&uniforms, "flat", &mut target);
                    *image = target.image;
                },
                BatchSize::LargeInput,
            );
        });
        group.bench_function(BenchmarkId::new("lesson-4", side), |b| {
            b.iter_batched_ref(|| canvas(side), |image| by_lesson_4(&model, image), BatchSize::LargeInput);
        });
    }
}

fn gouraud_texture(c: &mut Criterion) {
    let (model, texture) = head();
    let normals = corner_normals(&model);
    let slides_texture = Listing::texture(&texture);
    let mut group = c.benchmark_group("gouraud-texture");
    for side in SIDES {
        let uniforms = uniforms(&model, &normals, &texture, Some(slides_view()));
        let (mut target, mut listing) = (Framebuffer::new(canvas(side)), Listing::new(side));
        by_shader(&uniforms, "gouraud-texture", &mut target);
        listing.draw(&uniforms, &slides_texture);
        let drawn = target.image.pixels().filter(|pixel| pixel.2 != Color::BLACK).count();
        assert!(drawn.abs_diff(listing.drawn()) * 50 < drawn, "the two draw the same but for the border");
        group.throughput(Throughput::Elements(u64::from(side) * u64::from(side)));
        group.bench_function(BenchmarkId::new("lesson-9", side), |b| {
            b.iter_batched_ref(
                || Framebuffer::new(canvas(side)),
                |target| by_shader(&uniforms, "gouraud-texture", target),
                BatchSize::LargeInput,
            );
        });
        group.bench_function(BenchmarkId::new("listing", side), |b| {
            b.iter_batched_ref(
                || Listing::new(side),
                |listing| listing.draw(&uniforms, &slides_texture),
                BatchSize::LargeInput,
            );
        });
    }
}

fn slivers(c: &mut Criterion) {
    let mut group = c.benchmark_group("sliver");
    for length in [100, 200, 400, 800, 1600, 3200, 6400] {
        let mut image = canvas(length);
        group.throughput(Throughput::Elements(u64::from(length)));
        for name in ["edges", "barycentric"] {
            let draw = method(METHODS, name).draw;
            group.bench_function(BenchmarkId::new(name, length), |b| {
                b.iter(|| draw(black_box(sliver(length)), &mut image, Color::WHITE));
            });
        }
    }
}

fn ratios(_: &mut Criterion) {
    let (model, texture) = head();
    let normals = corner_normals(&model);
    let slides_texture = Listing::texture(&texture);
    println!("\ntimes of one run, taking turns:");
    for side in SIDES {
        let uniforms = uniforms(&model, &normals, &texture, None);
        let flat = ratio_on(
            || canvas(side),
            |image| {
                let mut target = Framebuffer::new(std::mem::replace(image, canvas(0)));
                by_shader(&uniforms, "flat", &mut target);
                *image = target.image;
            },
            |image| by_lesson_4(&model, image),
        );
        println!("{side}x{side}: lesson 9's flat shader / lesson 4's loop: {flat:.3}");
    }
    for side in SIDES {
        let uniforms = uniforms(&model, &normals, &texture, Some(slides_view()));
        let textured = ratio_on(
            || (Listing::new(side), Framebuffer::new(canvas(side))),
            |(listing, _)| listing.draw(&uniforms, &slides_texture),
            |(_, target)| by_shader(&uniforms, "gouraud-texture", target),
        );
        println!("{side}x{side}: the slides' listing / lesson 9's gouraud-texture: {textured:.2}");
    }
    for length in [100, 400, 1600, 6400] {
        let draw = |name: &str, length| {
            let draw = method(METHODS, name).draw;
            move |image: &mut Image| {
                (0..20).for_each(|_| draw(black_box(sliver(length)), image, Color::WHITE));
            }
        };
        let longer = ratio_on(|| canvas(2 * length), draw("edges", 2 * length), draw("edges", length));
        println!("a sliver of {} px / one of {length} px: {longer:.2}", 2 * length);
    }
}

criterion_group!(benches, ratios, flat, gouraud_texture, slivers);
criterion_main!(benches);
