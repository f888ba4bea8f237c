//! Tests before shading and after it: where both show the same, where they must not, and what a shader that replaces depths
//! forbids.

use std::cell::Cell;

use blending::depth::DepthStage;
use blending::{
    AnyState, Buffers, Compare, DepthTest, Framebuffer, Late, Less, Operations, Outputs, Over, Replaced,
    State, StencilOp, StencilTest, TwoShift,
};
use common::{Bounds, Color, Format, IVec2, Image, Vec3, Vec4};
use fastrand::Rng;
use perspective::division::Exact;
use perspective::interpolation::PerPixel;
use perspective::render::draw_triangle;
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;

use crate::state::any_color;

/// Triangles in the window, each of one colour, whose shader counts how often it is asked.
struct Shaded {
    /// Leaves out every other fragment, as on a chess board.
    discards: bool,
    calls: Cell<usize>,
}

impl Shader for Shaded {
    type Constant = Color;
    type Varying = ();
    type Output = Color;

    fn position(&self, _: usize) -> Vec4 {
        Vec4::W
    }

    fn triangle(&self, _: usize) -> Option<Color> {
        None
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, color: Color, Fragment { x, y, .. }: Fragment<()>) -> Option<Color> {
        self.calls.set(self.calls.get() + 1);
        (!self.discards || (x + y) % 2 == 0).then_some(color)
    }
}

/// The same colours, and a depth that falls from left to right, whatever the triangle's is.
struct Replacing(Shaded);

impl Shader for Replacing {
    type Constant = Color;
    type Varying = ();
    type Output = Replaced<Color>;

    fn position(&self, vertex: usize) -> Vec4 {
        self.0.position(vertex)
    }

    fn triangle(&self, face: usize) -> Option<Color> {
        self.0.triangle(face)
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, color: Color, fragment: Fragment<()>) -> Option<Replaced<Color>> {
        let output = self.0.fragment(color, fragment)?;
        Some(Replaced { depth: 1.0 - (fragment.x as f32 + 0.5) / 64.0, output })
    }
}

type Triangle = ([Vec4; 3], Color);

/// Any triangles, of both windings and at any depths, some cut off by the picture's border.
fn triangles(seed: u64) -> Vec<Triangle> {
    let mut rng = Rng::with_seed(seed);
    let corner = |rng: &mut Rng| Vec4::new(rng.f32() * 60.0 - 10.0, rng.f32() * 40.0 - 6.0, rng.f32(), 1.0);
    (0..40).map(|_| ([(); 3].map(|()| corner(&mut rng)), any_color(&mut rng))).collect()
}

fn draw<S: Shader<Constant = Color, Varying = ()>>(
    shader: &S,
    triangles: &[Triangle],
    target: &mut impl Target<S::Output>,
) {
    for &(corners, color) in triangles {
        draw_triangle(shader, color, corners, [(); 3], PerPixel(Exact), target);
    }
}

/// Picture, depths and stencil that drawing leaves behind, early and late, and how often the shader was asked.
struct Left<S> {
    image: Image,
    depths: Vec<f32>,
    stencils: Vec<S>,
    calls: usize,
}

fn both<S: Operations>(state: S, discards: bool, seed: u64) -> [Left<S::Stencil>; 2] {
    [false, true].map(|late| {
        let shader = Shaded { discards, calls: Cell::new(0) };
        let mut image = Image::new(41, 27, Format::Rgba);
        let mut target = Framebuffer::new(&mut image, state);
        if late {
            let mut late = Late(target);
            draw(&shader, &triangles(seed), &mut late);
            target = late.0;
        } else {
            draw(&shader, &triangles(seed), &mut target);
        }
        let Framebuffer { depths, stencils, .. } = target;
        let depths =
            (0..27).flat_map(|y| (0..41).map(move |x| (x, y))).map(|(x, y)| depths.get(x, y)).collect();
        Left { image, depths, stencils, calls: shader.calls.get() }
    })
}

fn assert_same<S: PartialEq>([early, late]: &[Left<S>; 2], what: &str) {
    assert!(early.image == late.image, "{what}: the pictures differ");
    assert!(early.depths == late.depths, "{what}: the depths differ");
    assert!(early.stencils == late.stencils, "{what}: the stencils differ");
    assert!(early.calls < late.calls, "{what}: early tests save nothing: {} {}", early.calls, late.calls);
    assert!(early.image.pixels().any(|pixel| pixel.2.r > 0), "{what}: nothing is drawn");
}

/// What counts and marks in every way a fragment can end.
const COUNTS: StencilTest = StencilTest {
    function: Compare::Lequal,
    reference: 0b0001_0011,
    read_mask: 0b0000_0011,
    write_mask: 255,
    fail: StencilOp::Invert,
    depth_fail: StencilOp::IncrWrap,
    pass: StencilOp::DecrWrap,
};

#[test]
fn both_orders_show_the_same_where_nothing_is_discarded() {
    let scissor = Bounds { min: IVec2::new(3, 2), max: IVec2::new(33, 19) };
    for seed in 0..8 {
        assert_same(&both(State::OFF, false, seed), "depth alone");
        assert_same(&both(State::blending(Over(TwoShift)), false, seed), "blending");
        let state = State { scissor, stencil: COUNTS, depth: Less, blend: Over(TwoShift), mask: () };
        assert_same(&both(state, false, seed), "all");
        let function = Compare::Lequal;
        let depth = DepthTest { function, write: false };
        let state = State { scissor: Some(scissor), depth, ..AnyState::USUAL };
        assert_same(&both(state, false, seed), "without depths written");
    }
}

/// Depths are written with colours, so that a fragment that is discarded leaves none, whichever way it is tested.
#[test]
fn both_orders_show_the_same_where_fragments_are_discarded_and_no_stencil_counts() {
    for seed in 0..8 {
        assert_same(&both(State::OFF, true, seed), "depth alone");
        assert_same(&both(State::blending(Over(TwoShift)), true, seed), "blending");
        // A stencil that is only read is no harm.
        let state = State { scissor: (), stencil: StencilTest::MASK, depth: Less, blend: (), mask: () };
        let [early, late] = both(state, true, seed);
        assert!(early.image == late.image && early.stencils == late.stencils);
    }
}

/// A discarded fragment counts early, since nobody knows yet that it will be, and late it does not.
#[test]
fn a_discarded_fragment_counts_in_an_early_stencil() {
    let count = StencilTest { pass: StencilOp::Incr, depth_fail: StencilOp::Incr, ..StencilTest::ALWAYS };
    let state = State { scissor: (), stencil: count, depth: Less, blend: (), mask: () };
    let [early, late] = both(state, true, 5);
    assert!(early.image == late.image && early.depths == late.depths);
    for (place, (early, late)) in early.stencils.iter().zip(&late.stencils).enumerate() {
        // 41 is odd, so that places alternate as the chess board does.
        let kept = (place % 41 + place / 41) % 2 == 0;
        assert!(if kept { early == late } else { *late == 0 }, "{place}: {early} {late}");
    }
    let fragments = |left: &Left<u8>| left.stencils.iter().map(|&count| usize::from(count)).sum::<usize>();
    assert!(fragments(&early) > fragments(&late) && fragments(&late) > 500);
    assert_eq!(late.calls, fragments(&early), "each fragment is shaded late, and counted early");
}

/// Where the stencil's count decides what is seen next, the pictures differ, too.
#[test]
fn a_discarded_fragment_changes_the_picture_by_an_early_stencil() {
    let once = StencilTest { function: Compare::Equal, pass: StencilOp::Incr, ..StencilTest::ALWAYS };
    let state = State { scissor: (), stencil: once, depth: (), blend: (), mask: () };
    let wall = |z: f32, color| {
        ([(-90.0, -90.0), (190.0, -90.0), (0.0, 190.0)].map(|(x, y)| Vec4::new(x, y, z, 1.0)), color)
    };
    let seen = [false, true].map(|late| {
        let [holes, whole] = [true, false].map(|discards| Shaded { discards, calls: Cell::new(0) });
        let mut image = Image::new(2, 1, Format::Rgb);
        let target = Framebuffer::new(&mut image, state);
        let draw_both = |target: &mut dyn FnMut(&Shaded, Triangle)| {
            target(&holes, wall(0.5, Color::RED));
            target(&whole, wall(0.5, Color::GREEN));
        };
        if late {
            let mut target = Late(target);
            draw_both(&mut |shader, triangle| draw(shader, &[triangle], &mut target));
        } else {
            let mut target = target;
            draw_both(&mut |shader, triangle| draw(shader, &[triangle], &mut target));
        }
        [0, 1].map(|x| image.get(x, 0).unwrap())
    });
    assert_eq!(seen, [[Color::RED, Color::BLACK], [Color::RED, Color::GREEN]]);
}

/// A replaced depth is what is tested and what is kept, whatever the triangle's is.
#[test]
fn a_shader_replaces_depths() {
    let shader = Replacing(Shaded { discards: false, calls: Cell::new(0) });
    let mut image = Image::new(41, 27, Format::Rgba);
    let mut target = Late(Framebuffer::new(&mut image, State::OFF));
    let all = triangles(3);
    draw(&shader, &all, &mut target);
    let Framebuffer { depths, .. } = target.0;
    // All that covers a pixel has one depth there, so the first drawn stays: as if only the first were drawn.
    let mut first = Image::new(41, 27, Format::Rgba);
    let flat: Vec<Triangle> =
        all.iter().map(|&(corners, color)| (corners.map(|corner| corner.with_z(0.5)), color)).collect();
    draw(&shader.0, &flat, &mut Framebuffer::new(&mut first, State::OFF));
    assert!(image == first && image.pixels().any(|pixel| pixel.2.g > 0));
    for (x, y, color) in image.pixels() {
        let expected =
            if color == (Color { r: 0, g: 0, b: 0, a: 0 }) { 1.0 } else { 1.0 - (x as f32 + 0.5) / 64.0 };
        assert!(depths.get(x, y) == expected || color.a == 0, "({x}, {y})");
    }
}

/// A replaced depth that is NaN passes no test but those that no order is needed for.
#[test]
fn a_replaced_depth_may_be_nan() {
    for (function, seen) in [(Compare::Less, false), (Compare::Gequal, false), (Compare::Always, true)] {
        let mut image = Image::new(1, 1, Format::Rgb);
        let depth = DepthTest { function, write: true };
        let state = State { scissor: (), stencil: (), depth, blend: (), mask: () };
        let mut target = Late(Framebuffer::new(&mut image, state));
        target.write(0, 0, 0.5, Replaced { depth: f32::NAN, output: Color::RED });
        let kept = target.0.depths.get(0, 0);
        assert_eq!((image.get(0, 0) == Some(Color::RED), kept.is_nan()), (seen, seen), "{function:?}");
    }
}

/// A target that was cleared is as good as new, tested early or late, whatever it takes.
#[test]
fn a_framebuffer_is_cleared() {
    let state = State { scissor: (), stencil: COUNTS, depth: Less, blend: Over(TwoShift), mask: () };
    for replaced in [false, true] {
        let [mut image, mut other] = [(); 2].map(|()| Image::new(41, 27, Format::Rgba));
        let mut target = Late(Framebuffer::new(&mut image, state));
        draw(&Shaded { discards: false, calls: Cell::new(0) }, &triangles(1), &mut target);
        assert!(target.0.stencils.iter().any(|&stencil| stencil > 0));
        if replaced {
            Target::<Replaced<Color>>::clear(&mut target);
        } else {
            Target::<Color>::clear(&mut target);
        }
        let new = Framebuffer::new(&mut other, state);
        assert!(target.0.stencils == new.stencils && target.0.depths == new.depths);
        assert!(target.0.image == new.image);
    }
}

/// So are buffers of several outputs.
#[test]
fn several_buffers_are_cleared() {
    let [mut image, mut other] = [(); 2].map(|()| Image::new(3, 2, Format::Rgb));
    let mut target = Buffers::new(Framebuffer::new(&mut image, State::OFF));
    assert!(target.test(2, 1, 0.5) && !target.test(2, 1, 1.0));
    target.write(2, 1, 0.5, Outputs { color: Color::RED, normal: Vec3::Y, distance: 7.0 });
    assert_eq!((target.normals[5], target.distances.get(2, 1)), (Vec3::Y, 7.0));
    assert!(!target.test(2, 1, 0.5));
    target.clear();
    let new = Buffers::new(Framebuffer::new(&mut other, State::OFF));
    assert!(target.normals == new.normals && target.distances == new.distances);
    assert!(
        target.framebuffer.depths == new.framebuffer.depths
            && *target.framebuffer.image == *new.framebuffer.image
    );
}

/// Without a depth test, by type or when the program runs, all pass and no depth is kept.
#[test]
fn without_a_depth_test_all_pass() {
    fn check<D: DepthStage>(depth: D) {
        for (fragment, kept) in [(0.25, 0.5), (0.75, 0.5), (f32::NAN, 0.5)] {
            assert!(depth.passes(fragment, kept) && !depth.writes());
        }
    }
    check(());
    check(None::<DepthTest>);
    check(None::<Less>);
    assert!(Less.writes() && !Some(Less).passes(0.5, 0.5) && Some(Less).writes());
}
