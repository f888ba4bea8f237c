//! What one sample keeps is what a pixel of lesson 14 does, and so does each of several that are covered alike.

use std::path::Path;

use antialiasing::canvas::plain;
use antialiasing::multisampled::{Multisampled, PerPixel};
use antialiasing::storage::{Compressed, Samples, Storage};
use antialiasing::{Canvas, alpha_to_coverage, render, resolve};
use blending::depth::DepthTest;
use blending::plain::draw;
use blending::{AnyState, Blend, BlendOrLogic, Formula, Framebuffer, State, StencilTest, WriteMask};
use clap::ValueEnum;
use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh};
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE};
use common::{Attributes, Bounds, Color, Format, IVec2, Image, Mat4, Model, Vec2, Vec3};
use fastrand::Rng;
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{perspective, view};
use shaders::Lit;
use shaders::source::Texture;
use textures::Wrap;
use zbuffer::Surface;

/// The head, and the camera of the lesson's picture.
fn head() -> (Loaded, Mesh, Mat4) {
    let needs = Attributes { normals: true, uvs: true };
    let model = Model::read(Path::new(DEFAULT_MODEL), needs).unwrap();
    let head = Loaded::new(model, Image::read(Path::new(DEFAULT_TEXTURE)).unwrap(), Wrap::Clamp);
    let mesh = indexed(&head.model, &head.normals, needs);
    let looks = view(Vec3::new(3.3, 0.25, 1.05), Vec3::new(0.0, -0.03, 0.0), Vec3::Y).unwrap();
    (head, mesh, perspective(45.0, 1.0, 0.1, 100.0).unwrap() * looks)
}

/// Width and height of the pictures under any state.
const SIZE: [usize; 2] = [23, 17];

/// Any state of lesson 14, all of it decided when the program runs.
fn any_state(rng: &mut Rng) -> AnyState {
    fn any<E: ValueEnum + Copy>(rng: &mut Rng) -> E {
        E::value_variants()[rng.usize(..E::value_variants().len())]
    }
    let formula = |rng: &mut Rng| Formula { equation: any(rng), source: any(rng), destination: any(rng) };
    let [min, max] = [IVec2::new(rng.i32(-2..9), rng.i32(-2..9)), IVec2::new(rng.i32(9..25), rng.i32(9..25))];
    AnyState {
        scissor: rng.bool().then_some(Bounds { min, max }),
        stencil: rng.bool().then(|| StencilTest {
            function: any(rng),
            reference: rng.u8(..4),
            read_mask: rng.u8(..),
            write_mask: rng.u8(..),
            fail: any(rng),
            depth_fail: any(rng),
            pass: any(rng),
        }),
        depth: DepthTest { function: any(rng), write: rng.bool() },
        blend: BlendOrLogic {
            blend: Blend { color: formula(rng), alpha: formula(rng), constant: any_color(rng) },
            logic: (rng.u8(..4) == 0).then(|| any(rng)),
            division: Default::default(),
        },
        mask: WriteMask { r: rng.bool(), g: rng.bool(), b: rng.bool(), a: rng.bool() },
    }
}

fn any_color(rng: &mut Rng) -> Color {
    let [r, g, b, a] = [(); 4].map(|()| rng.u8(..));
    Color { r, g, b, a }
}

/// Draws triangles with `N` samples, each under the state beside it.
fn sampled<const N: usize, C: Storage<N>>(
    drawn: &[(Surface, AnyState)],
    background: Color,
) -> Multisampled<N, C, PerPixel, u8> {
    let mut canvas = Multisampled::new(SIZE);
    canvas.clear(background, false);
    drawn.iter().for_each(|(surface, state)| plain(surface, *state, Vec2::ONE, &mut canvas));
    canvas
}

/// Asserts that each sample keeps what a pixel of lesson 14 does: colour, depth and stencil.
fn assert_as_lesson_14<const N: usize, C: Storage<N>>(drawn: &[(Surface, AnyState)], background: Color) {
    let mut image = Image::new(SIZE[0] as u16, SIZE[1] as u16, Format::Rgba);
    image.set_all(|_| background);
    let mut target = Framebuffer::new(&mut image, AnyState::USUAL);
    for (surface, state) in drawn {
        target = target.under(*state);
        draw(std::slice::from_ref(surface), &mut target);
    }
    let canvas = sampled::<N, C>(drawn, background);
    for (pixel, (x, y, color)) in target.image.pixels().enumerate() {
        assert!(canvas.colors.colors(pixel).iter().all(|&sample| sample == color), "({x}, {y}): {drawn:?}");
        assert!(
            canvas.depths[pixel].iter().all(|&depth| depth == target.depths.get(x, y)),
            "({x}, {y}): {drawn:?}"
        );
        assert_eq!(canvas.stencils[pixel], [target.stencils[pixel]; N], "({x}, {y}): {drawn:?}");
    }
}

/// Triangles anywhere about the picture, with one sample.
#[test]
fn under_any_state_one_sample_keeps_what_lesson_14_does() {
    let mut rng = Rng::with_seed(15);
    for _ in 0..400 {
        let corner = |rng: &mut Rng| Vec3::new(rng.f32() * 39.0 - 8.0, rng.f32() * 33.0 - 8.0, rng.f32());
        let surface =
            |rng: &mut Rng| Surface { corners: [(); 3].map(|()| corner(rng)), color: any_color(rng) };
        let drawn: Vec<_> = (0..8).map(|_| (surface(&mut rng), any_state(&mut rng))).collect();
        assert_as_lesson_14::<1, Samples<1>>(&drawn, any_color(&mut rng));
    }
}

/// Rectangles of whole pixels: each sample is covered as the centre is, if by the other one of two triangles at the diagonal.
#[test]
fn under_any_state_every_sample_keeps_what_a_pixel_of_lesson_14_does() {
    let mut rng = Rng::with_seed(16);
    for _ in 0..400 {
        let mut drawn = Vec::new();
        for _ in 0..6 {
            let [x, y] = [rng.i32(-3..20), rng.i32(-3..14)];
            let [right, top] = [x + rng.i32(1..20), y + rng.i32(1..14)].map(|n| n as f32);
            let (left, bottom, z) = (x as f32, y as f32, rng.f32());
            let corners =
                [(left, bottom), (right, bottom), (right, top), (left, top)].map(|(x, y)| Vec3::new(x, y, z));
            let (color, state) = (any_color(&mut rng), any_state(&mut rng));
            let halves = if rng.bool() { [[0, 1, 2], [0, 2, 3]] } else { [[3, 1, 0], [1, 3, 2]] };
            drawn.extend(halves.map(|half| (Surface { corners: half.map(|n| corners[n]), color }, state)));
        }
        let background = any_color(&mut rng);
        assert_as_lesson_14::<2, Samples<2>>(&drawn, background);
        assert_as_lesson_14::<4, Compressed<4>>(&drawn, background);
        assert_as_lesson_14::<8, Compressed<8>>(&drawn, background);
        assert_as_lesson_14::<16, Samples<16>>(&drawn, background);
        assert_as_lesson_14::<16, Compressed<16>>(&drawn, background);
    }
}

/// A mesh in perspective, textured and lit: lesson 14's loop draws the same pixels.
#[test]
fn one_sample_draws_a_model_as_lesson_14_does() {
    let (head, mesh, to_clip) = head();
    let lit = Lit::new(head.uniforms(Vec3::new(0.6, 0.0, 0.8), to_clip), Texture, Clamped);
    for size in [[97, 131], [240, 180]] {
        let [mut before, mut after] =
            [(); 2].map(|()| Image::new(size[0] as u16, size[1] as u16, Format::Rgb));
        let mut target = Framebuffer::new(&mut before, State::OFF);
        let counts = clipping::render(&lit, &mesh, Cull::Back, Clipping::GuardBand, &mut target);
        let mut canvas = Multisampled::<1, Samples<1>>::new(size);
        assert_eq!(render(&lit, &mesh, Cull::Back, State::OFF, &mut canvas), counts);
        canvas.resolve(resolve, &mut after);
        assert!(target.depths == canvas.depths(&after));
        assert!(before == after && before.pixels().filter(|pixel| pixel.2 != Color::BLACK).count() > 2000);
    }
}

/// As many samples as alpha's share of them, to the nearest; more alpha covers all that less does; and all of them are the
/// pattern's.
#[test]
fn alpha_covers_the_nearest_number_of_samples() {
    for samples in [1, 2, 4, 8, 16, 32] {
        let mut before = 0;
        for alpha in 0..=255 {
            let mask = alpha_to_coverage(alpha, samples);
            let off = f64::from(mask.count_ones()) - f64::from(alpha) / 255.0 * f64::from(samples);
            assert!(off.abs() < 0.5, "{alpha} of {samples}: {mask:b}");
            assert_eq!(mask & before, before);
            assert_eq!(u64::from(mask) >> samples, 0);
            before = mask;
        }
        assert_eq!(before.count_ones(), samples);
    }
}
