//! What perspective costs: `cargo bench -p perspective-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `flat` | lesson 10's loop and lesson 9's with the flat shader, which interpolates nothing; the same pixels | sides of 200, 800, 1600 px |
//! | `gouraud-texture` | lesson 9's loop, and lesson 10's with each way to interpolate | the same |
//!
//! Last come ratios of times from one run in which both sides take turns, so that they hold on a machine that is now fast
//! and now slow. The promise is that of the course: with the flat shader lesson 10's loop takes at most 1.05 times as
//! long as lesson 9's. There is no division in it: what is not interpolated needs no weights.

use std::path::Path;

use camera::lookat;
use common::{Attributes, Format, Image, Mat4, Model, Vec2, Vec3};
use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use perspective::depth::{Depth, Logarithmic, ReversedZF32, W, Z24, ZF32};
use perspective::division::Exact;
use perspective::interpolation::{Affine, Every, Interpolation, PerPixel};
use perspective::scene::Loaded;
use perspective::{Framebuffer, Planes, render};
use shaders::lighting::{Flat, Gouraud, Lighting};
use shaders::source::{Source, Texture, White};
use shaders::{Lit, Uniforms, fit};
use textures::Wrap;
use transforms::{projection, scale};
use verify::turns::ratio_on;

const SIDES: [u16; 3] = [200, 800, 1600];
const BOTH: Attributes = Attributes { normals: true, uvs: true };

fn asset(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../assets").join(name)
}

fn head() -> Loaded {
    let model = Model::read(&asset("head.obj"), BOTH).expect("the model is an asset");
    Loaded::new(model, Image::read(&asset("head.tga")).expect("the texture is an asset"), Wrap::Clamp)
}

/// Lesson 9's view of it from the slides' eye, in which a larger depth is nearer.
fn slides_view() -> Mat4 {
    let view = lookat(Vec3::new(1.0, 1.0, 2.0), Vec3::ZERO, Vec3::Y).expect("eye and centre are apart");
    fit(0.4, Vec2::ONE) * projection(6f32.sqrt()) * view
}

fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

/// By lesson 9.
fn by_lesson_9(
    uniforms: &Uniforms,
    source: impl Source,
    lighting: impl Lighting,
    target: &mut shaders::Framebuffer,
) {
    shaders::draw(uniforms, source, lighting, target);
}

/// By lesson 10: the same places and looks, a smaller depth is nearer.
fn by_lesson_10<D: Depth>(
    uniforms: &Uniforms,
    source: impl Source,
    lighting: impl Lighting,
    interpolation: impl Interpolation,
    image: &mut Image,
) {
    let to_clip = scale(Vec3::new(1.0, 1.0, -1.0)) * uniforms.to_clip;
    let shader = Lit::new(Uniforms { to_clip, ..*uniforms }, source, lighting);
    let depth = D::new(Planes { near: 0.1, far: 100.0 });
    let mut target = Framebuffer::new(image, depth);
    let (vertices, triangles) = (uniforms.model.positions().len(), uniforms.model.triangles());
    render(&shader, vertices, triangles, interpolation, depth, &mut target);
}

/// A picture by lesson 10's flat shader.
fn flat_10(uniforms: &Uniforms, image: &mut Image) {
    by_lesson_10::<ZF32>(uniforms, White, Flat, PerPixel(Exact), image);
}

/// One by lesson 10's gouraud-texture.
fn textured_10<D: Depth>(uniforms: &Uniforms, interpolation: impl Interpolation, image: &mut Image) {
    by_lesson_10::<D>(uniforms, Texture, Gouraud, interpolation, image);
}

/// One by lesson 9's shaders: the framebuffer is made there as well.
fn whole_9(uniforms: &Uniforms, source: impl Source, lighting: impl Lighting, image: &mut Image) {
    let mut target = shaders::Framebuffer::new(std::mem::replace(image, canvas(0)));
    by_lesson_9(uniforms, source, lighting, &mut target);
    *image = target.image;
}

/// How many pixels of two pictures differ.
fn differ(a: &Image, b: &Image) -> usize {
    a.pixels().filter(|&(x, y, color)| b.get(x, y) != Some(color)).count()
}

type Drawing<'a> = (&'static str, Box<dyn Fn(&mut Image) + 'a>);

fn group(c: &mut Criterion, name: &str, side: u16, drawings: &[Drawing]) {
    let mut group = c.benchmark_group(name);
    group.throughput(Throughput::Elements(u64::from(side) * u64::from(side)));
    for (way, draw) in drawings {
        group.bench_function(BenchmarkId::new(*way, side), |b| {
            b.iter_batched_ref(|| canvas(side), |image| draw(image), BatchSize::LargeInput);
        });
    }
}

fn flat(c: &mut Criterion) {
    let head = head();
    let uniforms = head.uniforms(Vec3::Z, slides_view());
    for side in SIDES {
        let drawings: [Drawing; 2] = [
            ("lesson-9", Box::new(|image| whole_9(&uniforms, White, Flat, image))),
            ("lesson-10", Box::new(|image| flat_10(&uniforms, image))),
        ];
        let [nine, ten] = [0, 1].map(|n: usize| {
            let mut image = canvas(side);
            (drawings[n].1)(&mut image);
            image
        });
        // Depths from 0 to 1 are coarser than those about 0, where two surfaces touch.
        assert!(differ(&nine, &ten) <= usize::from(side) / 50, "{} pixels differ", differ(&nine, &ten));
        group(c, "flat", side, &drawings);
    }
}

fn textured(c: &mut Criterion) {
    let head = head();
    let uniforms = head.uniforms(Vec3::Z, slides_view());
    for side in SIDES {
        let drawings: [Drawing; 5] = [
            ("lesson-9", Box::new(|image| whole_9(&uniforms, Texture, Gouraud, image))),
            ("affine", Box::new(|image| textured_10::<ZF32>(&uniforms, Affine, image))),
            ("every-16", Box::new(|image| textured_10::<ZF32>(&uniforms, Every::<16>, image))),
            ("every-8", Box::new(|image| textured_10::<ZF32>(&uniforms, Every::<8>, image))),
            ("per-pixel", Box::new(|image| textured_10::<ZF32>(&uniforms, PerPixel(Exact), image))),
        ];
        group(c, "gouraud-texture", side, &drawings);
    }
}

/// Each draws on a new picture.
fn ratio(side: u16, a: impl FnMut(&mut Image), b: impl FnMut(&mut Image)) -> f64 {
    ratio_on(|| canvas(side), a, b)
}

fn ratios(_: &mut Criterion) {
    let head = head();
    let uniforms = head.uniforms(Vec3::Z, slides_view());
    println!("\ntimes of one run, taking turns:");
    for side in SIDES {
        let flat =
            ratio(side, |image| flat_10(&uniforms, image), |image| whole_9(&uniforms, White, Flat, image));
        println!("{side}x{side}, flat: lesson 10's loop / lesson 9's: {flat:.3}");
    }
    for side in SIDES {
        let nine = |image: &mut Image| whole_9(&uniforms, Texture, Gouraud, image);
        let over = |name: &str, found: f64| {
            println!("{side}x{side}, gouraud-texture: lesson 10's {name} / lesson 9's loop: {found:.3}");
        };
        over("affine", ratio(side, |image| textured_10::<ZF32>(&uniforms, Affine, image), nine));
        over("every-16", ratio(side, |image| textured_10::<ZF32>(&uniforms, Every::<16>, image), nine));
        over("every-8", ratio(side, |image| textured_10::<ZF32>(&uniforms, Every::<8>, image), nine));
        over("per-pixel", ratio(side, |image| textured_10::<ZF32>(&uniforms, PerPixel(Exact), image), nine));
    }
    let z_f32 = |image: &mut Image| textured_10::<ZF32>(&uniforms, PerPixel(Exact), image);
    let over = |name: &str, found: f64| println!("800x800, depths: {name} / z-f32: {found:.3}");
    over("z24", ratio(800, |image| textured_10::<Z24>(&uniforms, PerPixel(Exact), image), z_f32));
    over(
        "reversed-z-f32",
        ratio(800, |image| textured_10::<ReversedZF32>(&uniforms, PerPixel(Exact), image), z_f32),
    );
    over(
        "logarithmic",
        ratio(800, |image| textured_10::<Logarithmic>(&uniforms, PerPixel(Exact), image), z_f32),
    );
    over("w", ratio(800, |image| textured_10::<W>(&uniforms, PerPixel(Exact), image), z_f32));
}

criterion_group!(benches, ratios, flat, textured);
criterion_main!(benches);
