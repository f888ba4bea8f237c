//! What several samples cost, counted; and that one costs and draws what lesson 14 does.

use std::cell::Cell;
use std::path::Path;

use antialiasing::canvas::plain;
use antialiasing::multisampled::{Multisampled, PerPixel, PerSample, Shading};
use antialiasing::storage::{Compressed, Samples, Storage};
use antialiasing::{Canvas, alpha_to_coverage, render, resolve};
use blending::depth::DepthTest;
use blending::plain::draw;
use blending::{AnyState, Blend, BlendOrLogic, Formula, Framebuffer, State, StencilTest, WriteMask};
use clap::ValueEnum;
use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh};
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE};
use common::{Attributes, Bounds, Color, Format, IVec2, Image, Mat4, Model, Vec2, Vec3, Vec4};
use fastrand::Rng;
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{perspective, view};
use shaders::Lit;
use shaders::shader::{Fragment, Shader};
use shaders::source::Texture;
use textures::Wrap;
use zbuffer::Surface;

/// Another shader, and how often it made a colour.
struct Counting<'a, S> {
    shader: S,
    calls: &'a Cell<usize>,
}

impl<S: Shader> Shader for Counting<'_, S> {
    type Constant = S::Constant;
    type Varying = S::Varying;
    type Output = S::Output;

    fn position(&self, vertex: usize) -> Vec4 {
        self.shader.position(vertex)
    }

    fn triangle(&self, face: usize) -> Option<S::Constant> {
        self.shader.triangle(face)
    }

    fn corner(&self, face: usize, corner: usize) -> S::Varying {
        self.shader.corner(face, corner)
    }

    fn fragment(&self, constant: S::Constant, fragment: Fragment<S::Varying>) -> Option<S::Output> {
        self.calls.set(self.calls.get() + 1);
        self.shader.fragment(constant, fragment)
    }
}

/// The head, and the camera of the lesson's picture.
fn head() -> (Loaded, Mesh, Mat4) {
    let needs = Attributes { normals: true, uvs: true };
    let model = Model::read(Path::new(DEFAULT_MODEL), needs).unwrap();
    let head = Loaded::new(model, Image::read(Path::new(DEFAULT_TEXTURE)).unwrap(), Wrap::Clamp);
    let mesh = indexed(&head.model, &head.normals, needs);
    let looks = view(Vec3::new(3.3, 0.25, 1.05), Vec3::new(0.0, -0.03, 0.0), Vec3::Y).unwrap();
    (head, mesh, perspective(45.0, 1.0, 0.1, 100.0).unwrap() * looks)
}

/// How often the head's pixels are shaded in a picture so many pixels wide and high.
fn calls<const N: usize, H: Shading>(side: usize) -> usize {
    let (head, mesh, to_clip) = head();
    let calls = Cell::new(0);
    let lit = Lit::new(head.uniforms(Vec3::Z, to_clip), Texture, Clamped);
    let mut canvas = Multisampled::<N, Samples<N>, H>::new([side; 2], false);
    render(&Counting { shader: lit, calls: &calls }, &mesh, Cull::Back, State::OFF, &mut canvas);
    calls.get()
}

/// Sixteen samples are shaded little more often than one: only pixels that an edge crosses, once for each of its triangles. In
/// a small picture more of them are such.
#[test]
fn sixteen_samples_cost_hardly_more_shading_than_one() {
    for (side, most) in [(800, 1.35), (1600, 1.18)] {
        let [one, sixteen] = [calls::<1, PerPixel>(side), calls::<16, PerPixel>(side)];
        let ratio = sixteen as f64 / one as f64;
        println!("{side}: {one} {sixteen} {ratio:.4}");
        assert!(one > side * side / 10, "{one}");
        assert!((1.02..most).contains(&ratio), "{side}: {ratio}");
    }
    // Shaded one by one they are sixteen times as many.
    let ratio = calls::<16, PerSample>(400) as f64 / calls::<1, PerPixel>(400) as f64;
    assert!((15.5..16.5).contains(&ratio), "{ratio}");
}

/// A canvas that is kept needs no memory for another picture but for the list of the mesh's vertices, as in lesson 11: however
/// many triangles, pixels and samples there are.
#[test]
fn nothing_is_allocated_for_a_triangle_or_a_pixel() {
    fn counts<const N: usize, C: Storage<N>>() -> Vec<u64> {
        let (head, mesh, to_clip) = head();
        let mut image = Image::new(100, 100, Format::Rgb);
        let mut canvas = Multisampled::<N, C>::new([100; 2], false);
        let lit = Lit::new(head.uniforms(Vec3::Z, to_clip), Texture, Clamped);
        let mut frame = || {
            canvas.clear(Color::WHITE);
            render(&lit, &mesh, Cull::Back, State::OFF, &mut canvas);
            canvas.resolve(resolve, &mut image);
        };
        (0..3).map(|_| allocation_counter::measure(&mut frame).count_total).collect()
    }
    assert_eq!(counts::<1, Samples<1>>(), [1; 3]);
    assert_eq!(counts::<16, Samples<16>>(), [1; 3]);
    assert_eq!(counts::<16, Compressed<16>>(), [1; 3]);
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
    let mut canvas = Multisampled::new(SIZE, false);
    canvas.clear(background);
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
        let mut canvas = Multisampled::<1, Samples<1>>::new(size, false);
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
