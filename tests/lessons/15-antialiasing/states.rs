//! Lesson 14's operations, each sample by itself.

use antialiasing::area::Area;
use antialiasing::multisampled::{Multisampled, PerPixel, PerSample, Shading};
use antialiasing::ordered::Ordered;
use antialiasing::storage::{Compressed, Samples, Storage};
use antialiasing::{Canvas, METHODS, STORAGES, Scene, alpha_to_coverage, pattern, resolve};
use blending::{
    Compare, DepthTest, Framebuffer, LogicOp, Over, State, StencilOp, StencilTest, TwoShift, WriteMask, plain,
};
use checks::coverage::Triangle;
use common::{Bounds, Color, Format, IVec2, Image, Vec2, Vec4};
use zbuffer::Surface;

use crate::scenes::{Corners, above, fan, flat, right_of};

/// Width and height of the picture.
const SIZE: [u16; 2] = [9, 7];

const N: usize = 8;

fn at(corners: Corners, depth: f32) -> [Vec4; 3] {
    corners.map(|[x, y]| Vec4::new(x, y, depth, 1.0))
}

fn pixels() -> impl Iterator<Item = (i32, i32)> {
    let [width, height] = SIZE.map(i32::from);
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)))
}

fn canvas<C: Canvas>(background: Color) -> C {
    let mut canvas = C::new(SIZE.map(usize::from));
    canvas.clear(background, false);
    canvas
}

fn resolved(canvas: &impl Canvas) -> Image {
    let mut image = Image::new(SIZE[0], SIZE[1], Format::Rgba);
    canvas.resolve(resolve, &mut image);
    image
}

/// The samples of a pixel that a triangle covers.
fn mask(corners: Corners, (x, y): (i32, i32), n: usize) -> u32 {
    Triangle::new(corners.map(Vec2::from)).samples(x, y, pattern(n))
}

/// The mean of so many samples of one colour and the rest of another.
fn mean(samples: u32, one: Color, other: Color, n: usize) -> Color {
    let all: Vec<Color> = (0..n).map(|s| if samples >> s & 1 == 1 { one } else { other }).collect();
    resolve(&all)
}

fn test(function: Compare, reference: u8, [fail, depth_fail, pass]: [StencilOp; 3]) -> StencilTest {
    StencilTest { function, reference, read_mask: 255, write_mask: 255, fail, depth_fail, pass }
}

/// Each sample counts for itself what passes, what is hidden and what fails.
#[test]
fn each_sample_has_a_stencil_of_its_own() {
    use StencilOp::{Incr, Invert, Keep, Replace};
    let [first, second, third] = [fan([4.4, 3.1])[0], fan([4.4, 3.1])[1], right_of(5.3)];
    let mut canvas: Multisampled<N, Samples<N>, PerSample, u8> = canvas(Color::BLACK);
    let white = |_| Some(Color::WHITE);
    let state = |stencil| State { scissor: (), stencil, depth: blending::Less, blend: (), mask: () };
    // What passes becomes 1; of what is behind it, 255 − 1; then only where it is 0, else one more.
    canvas.fill(state(test(Compare::Always, 1, [Keep, Keep, Replace])), at(first, 0.25), [(); 3], white);
    canvas.fill(state(test(Compare::Always, 9, [Keep, Invert, Replace])), at(third, 0.5), [(); 3], white);
    canvas.fill(state(test(Compare::Equal, 0, [Incr, Keep, Keep])), at(second, 0.125), [(); 3], |_| {
        Some(Color::RED)
    });
    let mut seen = [0; 5];
    for (pixel, at) in pixels().enumerate() {
        let masks = [first, second, third].map(|corners| mask(corners, at, N));
        for (s, &kept) in canvas.stencils[pixel].iter().enumerate() {
            let [first, second, third] = masks.map(|mask| mask >> s & 1 == 1);
            let before: u8 = match (first, third) {
                (true, true) => !1,
                (true, false) => 1,
                (false, true) => 9,
                (false, false) => 0,
            };
            let expected = if second && before != 0 { before + 1 } else { before };
            assert_eq!(kept, expected, "{at:?}, sample {s}");
            let red = second && before == 0;
            let color = if red {
                Color::RED
            } else if first || third {
                Color::WHITE
            } else {
                Color::BLACK
            };
            assert_eq!(canvas.colors.colors(pixel)[s], color, "{at:?}, sample {s}");
            for (n, case) in [first && third, first && !third, third && !first, second && before != 0, red]
                .into_iter()
                .enumerate()
            {
                seen[n] += u32::from(case);
            }
        }
    }
    assert!(seen.iter().all(|&samples| samples > 0), "{seen:?}");
    canvas.clear(Color::BLACK, false);
    assert!(canvas.stencils.iter().flatten().all(|&kept| kept == 0));
}

/// What is transparent is laid over each covered sample; what is there shows in the others.
#[test]
fn each_sample_is_blended_by_itself() {
    let (red, background) = (Color { a: 100, ..Color::RED }, Color::rgb(0, 40, 200));
    let over = blending::over(red, background);
    fn drawn<C: Storage<N>, H: Shading>(corners: &[Corners], color: Color, background: Color) -> Image {
        let mut canvas: Multisampled<N, C, H> = canvas(background);
        for &corners in corners {
            canvas.fill(State::blending(Over::<TwoShift>::default()), at(corners, 0.5), [(); 3], |_| {
                Some(color)
            });
        }
        resolved(&canvas)
    }
    let corners = fan([4.4, 3.1]);
    let image = drawn::<Compressed<N>, PerSample>(&corners[..1], red, background);
    for at in pixels() {
        let expected = mean(mask(corners[0], at, N), over, background, N);
        assert_eq!(image.get(at.0, at.1), Some(expected), "{at:?}");
    }
    // Neighbours lie over no sample twice: their common sides are not seen.
    let image = drawn::<Samples<N>, PerSample>(&corners, red, background);
    for at in pixels() {
        let covered = corners.iter().fold(0, |covered, &corners| covered | mask(corners, at, N));
        assert_eq!(image.get(at.0, at.1), Some(mean(covered, over, background, N)), "{at:?}");
    }
}

/// A state without depth writes keeps none, one that lets everything pass shows the last, and the scissor cuts whole pixels.
#[test]
fn depth_scissor_logic_and_mask_are_the_states() {
    let depth = |function, write| DepthTest { function, write };
    let state = |depth| State { scissor: (), stencil: (), depth, blend: (), mask: () };
    let mut canvas: Multisampled<N, Samples<N>> = canvas(Color::BLACK);
    let [near, far] = [at(right_of(3.4), 0.25), at(above(2.7), 0.75)];
    canvas.fill(state(depth(Compare::Less, false)), near, [(); 3], |_| Some(Color::WHITE));
    assert!(canvas.depths.iter().flatten().all(|&depth| depth == 1.0));
    canvas.fill(state(depth(Compare::Less, true)), near, [(); 3], |_| Some(Color::WHITE));
    canvas.fill(state(depth(Compare::Always, true)), far, [(); 3], |_| Some(Color::GREEN));
    for (pixel, at) in pixels().enumerate() {
        let [near, far] = [right_of(3.4), above(2.7)].map(|corners| mask(corners, at, N));
        for (s, &kept) in canvas.depths[pixel].iter().enumerate() {
            let expected = if far >> s & 1 == 1 {
                0.75
            } else if near >> s & 1 == 1 {
                0.25
            } else {
                1.0
            };
            assert!((kept - expected).abs() < 1e-6, "{at:?}, sample {s}: {kept}");
        }
    }
    // The nearest of a pixel's depths is what its picture shows.
    let image = resolved(&canvas);
    let depths = canvas.depths(&image);
    for (pixel, (x, y)) in pixels().enumerate() {
        assert_eq!(depths.get(x, y), canvas.depths[pixel].iter().copied().fold(1.0, f32::min));
    }

    let scissor = Bounds { min: IVec2::new(2, 1), max: IVec2::new(5, 4) };
    let mask = WriteMask { r: true, g: false, b: true, a: true };
    let state = State { scissor, stencil: (), depth: (), blend: LogicOp::Xor, mask };
    canvas.clear(Color::rgb(15, 15, 15), false);
    canvas.fill(state, at(right_of(-9.0), 0.5), [(); 3], |_| Some(Color::rgb(85, 85, 85)));
    let image = resolved(&canvas);
    for (x, y) in pixels() {
        let inside = scissor.contains(x, y);
        let expected = if inside { [90, 15, 90] } else { [15; 3] };
        let Color { r, g, b, .. } = image.get(x, y).unwrap();
        assert_eq!([r, g, b], expected, "({x}, {y})");
    }
    assert!(canvas.depths.iter().flatten().all(|&depth| depth == 1.0));
}

/// A depth that is not finite is no plane: such a triangle is left out, as in lesson 10, also where everything passes.
#[test]
fn what_has_no_depth_or_no_w_is_left_out() {
    fn nothing<C: Canvas<Stencil = ()>>() {
        let always = DepthTest { function: Compare::Always, write: true };
        let state = State { scissor: (), stencil: (), depth: always, blend: (), mask: () };
        let good = at(right_of(-9.0), 0.5);
        for (corner, axis, value) in [
            (0, 2, f32::NAN),
            (1, 2, f32::INFINITY),
            (2, 2, f32::NEG_INFINITY),
            (1, 3, f32::NAN),
            (2, 3, -1.0),
            (0, 3, f32::INFINITY),
            (2, 0, f32::NAN),
        ] {
            let mut corners = good;
            corners[corner][axis] = value;
            let mut canvas: C = canvas(Color::BLACK);
            canvas.fill(state, corners, [(); 3], |_| panic!("{corners:?}"));
        }
        let mut canvas: C = canvas(Color::BLACK);
        canvas.fill(state, good, [(); 3], |_| Some(Color::WHITE));
        assert!(resolved(&canvas).pixels().all(|pixel| pixel.2 == Color::WHITE));
    }
    nothing::<Multisampled<1, Samples<1>>>();
    nothing::<Multisampled<16, Compressed<16>>>();
    nothing::<Multisampled<4, Samples<4>, PerSample>>();
    nothing::<Ordered>();
    nothing::<Area>();
}

/// Alpha covers its share of the samples, of which a triangle at an edge has but some; those alone keep colour and depth.
#[test]
fn alpha_covers_samples_of_those_that_are_covered() {
    for alpha in [0, 15, 16, 100, 128, 240, 255] {
        let mut canvas = Multisampled::<N, Samples<N>>::new(SIZE.map(usize::from));
        canvas.clear(Color::BLACK, true);
        let corners = fan([4.4, 3.1])[1];
        canvas.fill(State::OFF, at(corners, 0.5), [(); 3], |_| Some(Color { a: alpha, ..Color::WHITE }));
        for (pixel, at) in pixels().enumerate() {
            let covered = mask(corners, at, N) & alpha_to_coverage(alpha, N as u32);
            for s in 0..N {
                let drawn = covered >> s & 1 == 1;
                assert_eq!(
                    canvas.colors.colors(pixel)[s].r,
                    if drawn { 255 } else { 0 },
                    "{alpha}, {at:?}, {s}"
                );
                assert_eq!(canvas.depths[pixel][s] < 1.0, drawn, "{alpha}, {at:?}, {s}");
            }
        }
    }
}

/// Whether alpha covers samples is the scene's to say: what is kept from picture to picture draws each as one made for it does.
#[test]
fn alpha_is_asked_from_scene_to_scene() {
    let half = |depth, color: Color| flat(right_of(3.3), depth, Color { a: 128, ..color });
    let triangles = [half(0.75, Color::RED), half(0.25, Color::GREEN)];
    let [over, covering] = [false, true].map(|alpha_to_coverage| Scene {
        alpha_to_coverage,
        ..Scene::of(&triangles, Color::rgb(0, 40, 200))
    });
    for row in METHODS.iter().chain(STORAGES) {
        let mut frames = (row.run.frames)(SIZE.map(usize::from));
        let pictures = [over, covering, over].map(|scene| {
            let [mut kept, mut fresh] = [(); 2].map(|()| Image::new(SIZE[0], SIZE[1], Format::Rgba));
            frames(&scene, &mut kept);
            (row.run.picture)(&scene, &mut fresh);
            assert!(kept == fresh, "{}", row.name);
            kept
        });
        assert!(pictures[0] != pictures[1] && pictures[0] == pictures[2], "{}", row.name);
    }
}

/// With alpha to coverage a sample that alpha leaves out keeps colour and depth, but the stencil has counted it as one that
/// passes: the test comes first. OpenGL, unless early tests are asked for, lays alpha's mask on the covered samples before, and
/// would not have counted it.
#[test]
fn the_stencil_counts_samples_that_alpha_leaves_out() {
    use StencilOp::{Incr, Keep};
    let alpha = 100;
    let corners = fan([4.4, 3.1])[1];
    let stencil = test(Compare::Always, 0, [Keep, Keep, Incr]);
    let state = State { scissor: (), stencil, depth: blending::Less, blend: (), mask: () };
    let mut canvas: Multisampled<N, Compressed<N>, PerPixel, u8> = Multisampled::new(SIZE.map(usize::from));
    canvas.clear(Color::BLACK, true);
    canvas.fill(state, at(corners, 0.5), [(); 3], |_| Some(Color { a: alpha, ..Color::WHITE }));
    let mut left_out = 0;
    for (pixel, at) in pixels().enumerate() {
        let covered = mask(corners, at, N);
        let drawn = covered & alpha_to_coverage(alpha, N as u32);
        for s in 0..N {
            let [covered, drawn] = [covered, drawn].map(|mask| mask >> s & 1 == 1);
            assert_eq!(canvas.stencils[pixel][s], u8::from(covered), "{at:?}, sample {s}");
            assert_eq!(canvas.depths[pixel][s] < 1.0, drawn, "{at:?}, sample {s}");
            left_out += u32::from(covered && !drawn);
        }
    }
    assert!(left_out > 20, "{left_out}");
    // So do fragments that the shader discards.
    canvas.clear(Color::BLACK, false);
    canvas.fill(state, at(corners, 0.5), [(); 3], |_| None);
    for (pixel, at) in pixels().enumerate() {
        let covered = mask(corners, at, N);
        assert!((0..N).all(|s| u32::from(canvas.stencils[pixel][s]) == covered >> s & 1), "{at:?}");
        assert_eq!((canvas.colors.colors(pixel), canvas.depths[pixel]), (&[Color::BLACK][..], [1.0; N]));
    }
}

/// One sample keeps the depths of lesson 14's loop, to the last bit.
#[test]
fn one_sample_keeps_the_depths_of_lesson_14() {
    let mut surfaces: Vec<Surface> =
        fan([4.4, 3.1]).iter().map(|&corners| flat(corners, 0.5, Color::RED)).collect();
    for (n, corner) in surfaces.iter_mut().flat_map(|surface| &mut surface.corners).enumerate() {
        corner.z = ((n * 37 + 5) % 101) as f32 / 103.0;
    }
    let mut image = Image::new(SIZE[0], SIZE[1], Format::Rgb);
    let mut expected = Framebuffer::new(&mut image, State::OFF);
    plain::draw(&surfaces, &mut expected);
    let mut canvas: Multisampled<1, Samples<1>> = canvas(Color::BLACK);
    for surface in &surfaces {
        antialiasing::canvas::plain(surface, State::OFF, Vec2::ONE, &mut canvas);
    }
    let mut drawn = 0;
    for (pixel, (x, y)) in pixels().enumerate() {
        let depth = expected.depths.get(x, y);
        assert_eq!(canvas.depths[pixel][0].to_bits(), depth.to_bits(), "({x}, {y})");
        drawn += u32::from(depth < 1.0);
    }
    assert!(drawn > 20);
}

/// A pixel that was covered in parts, all of one colour in the end, takes one colour again.
#[test]
fn a_pixel_of_one_colour_keeps_one_colour() {
    let mut canvas: Multisampled<N, Compressed<N>> = canvas(Color::BLACK);
    let several = |canvas: &Multisampled<N, Compressed<N>>| {
        pixels().enumerate().filter(|&(pixel, _)| canvas.colors.colors(pixel).len() > 1).count()
    };
    assert_eq!(several(&canvas), 0);
    // The left half of a column of pixels, white; then the right half, red, which is more to keep; then white over it.
    let left = right_of(4.5).map(|[x, y]| [9.0 - x, y]);
    canvas.fill(State::OFF, at(left, 0.5), [(); 3], |_| Some(Color::WHITE));
    assert_eq!(several(&canvas), 7);
    canvas.fill(State::OFF, at(right_of(4.5), 0.5), [(); 3], |_| Some(Color::RED));
    assert_eq!(several(&canvas), 7);
    canvas.fill(State::OFF, at(right_of(4.5), 0.25), [(); 3], |_| Some(Color::WHITE));
    assert_eq!(several(&canvas), 0);
    assert!(resolved(&canvas).pixels().all(|pixel| pixel.2 == Color::WHITE));
}

/// Nothing of one picture is left in the next.
#[test]
fn a_canvas_forgets() {
    fn forgets<C: Canvas<Stencil = ()>>() {
        let draw = |canvas: &mut C, depth: f32| {
            for (n, corners) in fan([4.4, 3.1]).into_iter().enumerate() {
                canvas.fill(State::OFF, at(corners, depth), [(); 3], |_| Some(Color::random(n as u64)));
            }
        };
        let mut kept: C = canvas(Color::WHITE);
        draw(&mut kept, 0.25);
        let first = resolved(&kept);
        kept.clear(Color::WHITE, false);
        assert!(resolved(&kept).pixels().all(|pixel| pixel.2 == Color::WHITE));
        draw(&mut kept, 0.75);
        assert!(resolved(&kept) == first);
    }
    forgets::<Multisampled<1, Samples<1>>>();
    forgets::<Multisampled<N, Samples<N>>>();
    forgets::<Multisampled<N, Compressed<N>>>();
    forgets::<Ordered>();
    forgets::<Area>();
}
