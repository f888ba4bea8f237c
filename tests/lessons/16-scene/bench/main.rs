//! What a frame costs: `cargo bench -p scene-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `frame` | the course's own scene by one sample and by sixteen | 1024×768 |
//! | `parts` | each of its parts by itself, and `nothing`: to clear and to resolve | the same, sixteen samples |
//!
//! First comes what a scene costs that uses nothing, one entity of one colour without light, against lesson 15's loop: a
//! ratio of times from one run in which both take turns.

use std::hint::black_box;

use antialiasing::Canvas;
use antialiasing::multisampled::Multisampled;
use antialiasing::storage::{Compressed, Samples};
use clipping::Cull;
use common::{Color, Format, Image, Mat4, Vec3};
use criterion::{Criterion, criterion_group, criterion_main};
use perspective::{perspective, view};
use plain::Plain;
use scene::head::head;
use scene::levels::Sizes;
use scene::version_11::{PARTS, VERSION};
use scene::{Entity, Filtering, METHODS, Paint, Scene, Shading, Style, Target, render_scene};
use verify::method;
use verify::turns::ratio;

#[path = "../plain.rs"]
mod plain;

const SIZE: [u16; 2] = [1024, 768];

/// The course's own scene at its beginning, and the matrices of its eye.
fn own() -> (Scene, [Mat4; 2]) {
    let sizes = method::<Sizes>(METHODS, "by-size");
    let mut scene = (VERSION.scene)(sizes).expect("its files are assets");
    VERSION.animate.expect("it moves")(&mut scene, 0.0);
    let projection = (VERSION.projection)(Image::new(SIZE[0], SIZE[1], Format::Rgb).size());
    let camera = VERSION.camera.expect("it has an eye that moves").camera();
    (scene, [projection, camera.inverse()])
}

fn target(antialiased: bool) -> Target {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    target.antialiased = antialiased;
    target
}

/// A scene that uses nothing against lesson 15's loop.
fn nothing_used<C: Canvas<Stencil = ()>>(antialiased: bool) {
    let (color, background) = (Color::rgb(200, 150, 100), Color::BLACK);
    let entity = Entity::new(head(&Paint::Color(color)).expect("its files are assets"));
    let style = Style { shading: Shading::Unlit, filter: Filtering::Nearest, cull: Cull::Back };
    let scene = Scene { entities: vec![entity.clone()], lights: Vec::new(), background, style };
    let projection = perspective(45.0, 4.0 / 3.0, 0.1, 100.0).expect("a camera");
    let camera = view(Vec3::new(1.0, 0.5, 2.5), Vec3::ZERO, Vec3::Y).expect("eye and centre are apart");
    let (mut target, mut canvas) = (target(antialiased), C::new(SIZE.map(usize::from)));
    let mut picture = Image::new(SIZE[0], SIZE[1], Format::Rgb);
    let plain = Plain { mesh: entity.levels.finest(), to_clip: projection * camera, color };
    plain.draw(background, &mut canvas, &mut picture);
    render_scene(&scene, &mut target, &projection, &camera);
    assert!(picture == *target.picture(), "both draw the same pixels");
    let taken = ratio(
        || {
            black_box(render_scene(&scene, &mut target, &projection, &camera));
        },
        || {
            black_box(plain.draw(background, &mut canvas, &mut picture));
        },
    );
    println!(
        "the head unlit in one colour, antialiased: {antialiased}, scene / lesson 15's loop: {taken:.3}"
    );
}

fn ratios(_: &mut Criterion) {
    println!("times of one run, taking turns:");
    nothing_used::<Multisampled<1, Samples<1>>>(false);
    nothing_used::<Multisampled<16, Compressed<16>>>(true);
}

fn frame(c: &mut Criterion) {
    let (scene, [projection, inverse]) = own();
    let mut group = c.benchmark_group("frame");
    for (name, antialiased) in [("1", false), ("16", true)] {
        let mut target = target(antialiased);
        group.bench_function(name, |b| b.iter(|| render_scene(&scene, &mut target, &projection, &inverse)));
    }
}

fn parts(c: &mut Criterion) {
    let (mut scene, [projection, inverse]) = own();
    let entities = std::mem::take(&mut scene.entities);
    let mut target = target(true);
    let mut group = c.benchmark_group("parts");
    for (name, range) in [("nothing", 0..0)].into_iter().chain(PARTS) {
        scene.entities = entities[range].to_vec();
        group.bench_function(name, |b| b.iter(|| render_scene(&scene, &mut target, &projection, &inverse)));
    }
}

criterion_group!(benches, ratios, frame, parts);
criterion_main!(benches);
