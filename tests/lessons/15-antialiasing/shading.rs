//! Shading once a pixel: how often, and where.

use antialiasing::{METHODS, STORAGES, Scene, coverage, pattern, resolve};
use blending::{Framebuffer, State, plain};
use checks::coverage::Triangle;
use common::{Color, Format, IVec2, Image, Vec2, Vec3};
use fastrand::Rng;
use verify::method;
use zbuffer::Surface;

fn surfaces(rng: &mut Rng, count: usize) -> Vec<Surface> {
    let corner = |rng: &mut Rng| Vec3::new(rng.f32() * 60.0 - 10.0, rng.f32() * 50.0 - 8.0, rng.f32());
    (0..count)
        .map(|n| Surface { corners: [(); 3].map(|()| corner(rng)), color: Color::random(n as u64) })
        .collect()
}

#[test]
fn one_sample_draws_the_pixels_of_lesson_14() {
    let mut rng = Rng::with_seed(15);
    for _ in 0..200 {
        let surfaces = surfaces(&mut rng, 8);
        let [mut before, mut after] = [(); 2].map(|()| Image::new(41, 33, Format::Rgb));
        plain::draw(&surfaces, &mut Framebuffer::new(&mut before, State::OFF));
        (method(METHODS, "none").picture)(&Scene::of(&surfaces, Color::BLACK), &mut after);
        assert!(before == after);
    }
}

#[test]
fn white_over_black_leaves_its_share_of_samples() {
    let mut rng = Rng::with_seed(16);
    for _ in 0..100 {
        let white = Surface { color: Color::WHITE, ..surfaces(&mut rng, 1)[0] };
        let corners = white.corners.map(Vec3::truncate);
        let exact = Triangle::new(corners);
        for (name, n) in [
            ("none", 1),
            ("msaa-2", 2),
            ("msaa-4", 4),
            ("msaa-8", 8),
            ("msaa-16", 16),
            ("ssaa-16", 16),
            ("ssaa-4", 4),
        ] {
            let mut image = Image::new(41, 33, Format::Rgb);
            (method(METHODS, name).picture)(&Scene::of(&[white], Color::BLACK), &mut image);
            for (x, y, color) in image.pixels() {
                let mask = exact.samples(x, y, pattern(n));
                assert_eq!(coverage(corners, IVec2::new(x, y), pattern(n)), mask);
                let level = (255 * mask.count_ones() + n as u32 / 2) / n as u32;
                assert_eq!(u32::from(color.r), level, "{name} ({x}, {y})");
            }
        }
    }
}

#[test]
fn storages_agree() {
    let mut rng = Rng::with_seed(17);
    for _ in 0..100 {
        let mut surfaces = surfaces(&mut rng, 12);
        surfaces.iter_mut().for_each(|surface| surface.color.a = [255, 128, 7][rng.usize(..3)]);
        let draw = |name| {
            let mut image = Image::new(41, 33, Format::Rgba);
            (method(STORAGES, name).picture)(&Scene::of(&surfaces, Color::rgb(9, 99, 200)), &mut image);
            image
        };
        assert!(draw("samples") == draw("compressed"));
        assert!(draw("samples").pixels().count() > 0);
    }
    assert_eq!(resolve(&[Color::BLACK, Color::WHITE]).r, 128);
    let _ = Vec2::ZERO;
}
