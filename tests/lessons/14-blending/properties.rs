//! Any state, and any fragments: a framebuffer against all operations, one after the other, in whole numbers.

use blending::{
    AnyFramebuffer, AnyState, Blend, BlendOrLogic, Compare, DepthTest, Equation, Factor, Formula,
    Framebuffer, Late, LogicOp, METHODS, State, StencilOp, StencilTest, WriteMask, faded, plain,
};
use checks::fragment::{Pipeline, Sample, Stencil};
use checks::visibility::nearest;
use clap::ValueEnum;
use common::{Bounds, Color, Format, IVec2, Image, Vec3};
use fastrand::Rng;
use proptest::prelude::*;
use verify::method;
use zbuffer::Surface;

use crate::state::{any_color, name};

const WIDTH: u16 = 13;
const HEIGHT: u16 = 9;

fn one_of<E: ValueEnum + Copy>(rng: &mut Rng) -> E {
    let variants = E::value_variants();
    variants[rng.usize(..variants.len())]
}

fn any_state(rng: &mut Rng) -> AnyState {
    let scissor = rng.bool().then(|| {
        let min = IVec2::new(rng.i32(-3..9), rng.i32(-3..7));
        Bounds { min, max: min + IVec2::new(rng.i32(-1..12), rng.i32(-1..9)) }
    });
    let stencil = rng.bool().then(|| StencilTest {
        function: one_of(rng),
        // Few numbers, so that equal ones meet.
        reference: rng.u8(..4),
        read_mask: [255, rng.u8(..)][rng.usize(..2)],
        write_mask: [255, rng.u8(..)][rng.usize(..2)],
        fail: one_of::<StencilOp>(rng),
        depth_fail: one_of(rng),
        pass: one_of(rng),
    });
    let formula = |rng: &mut Rng| Formula {
        equation: one_of::<Equation>(rng),
        source: one_of::<Factor>(rng),
        destination: one_of(rng),
    };
    let blend = Blend { color: formula(rng), alpha: formula(rng), constant: any_color(rng) };
    State {
        scissor,
        stencil,
        depth: DepthTest { function: one_of::<Compare>(rng), write: rng.bool() },
        blend: BlendOrLogic {
            blend,
            logic: rng.bool().then(|| one_of::<LogicOp>(rng)),
            ..AnyState::USUAL.blend
        },
        mask: WriteMask { r: rng.u8(..4) > 0, g: rng.u8(..4) > 0, b: rng.u8(..4) > 0, a: rng.u8(..4) > 0 },
    }
}

/// The same for the reference, by OpenGL's names.
fn pipeline(state: &AnyState) -> Pipeline {
    let formula = |Formula { equation, source, destination }: Formula| {
        [name(&equation), name(&source), name(&destination)]
    };
    let BlendOrLogic { blend, logic, .. } = state.blend;
    Pipeline {
        scissor: state.scissor.map(|Bounds { min, max }| {
            let size = max - min + 1;
            [min.x, min.y, size.x, size.y].map(i64::from)
        }),
        stencil: state.stencil.map(|stencil| Stencil {
            function: name(&stencil.function),
            reference: stencil.reference.into(),
            read_mask: stencil.read_mask.into(),
            write_mask: stencil.write_mask.into(),
            operations: [stencil.fail, stencil.depth_fail, stencil.pass].map(|operation| name(&operation)),
        }),
        depth: (name(&state.depth.function), state.depth.write),
        blend: [formula(blend.color), formula(blend.alpha)],
        constant: blend.constant,
        logic: logic.map(|logic| name(&logic)),
        mask: [state.mask.r, state.mask.g, state.mask.b, state.mask.a],
    }
}

/// Triangles at one depth each, of few depths, so that equal ones meet.
fn any_surfaces(rng: &mut Rng) -> Vec<Surface> {
    let surface = |rng: &mut Rng| {
        let depth = f32::from(rng.u8(..5)) / 4.0;
        let corners = [(); 3].map(|()| Vec3::new(rng.f32() * 24.0 - 6.0, rng.f32() * 18.0 - 5.0, depth));
        Surface { corners, color: any_color(rng) }
    };
    (0..12).map(|_| surface(rng)).collect()
}

/// A picture of any colours, and any stencils.
fn any_picture(rng: &mut Rng) -> (Image, Vec<u8>) {
    let mut image = Image::new(WIDTH, HEIGHT, Format::Rgba);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, any_color(rng));
    }
    let stencils = (0..image.width() * image.height()).map(|_| rng.u8(..4)).collect();
    (image, stencils)
}

/// All samples after all triangles.
fn expected(state: &AnyState, surfaces: &[Surface], image: &Image, stencils: &[u8]) -> Vec<Sample> {
    let pipeline = pipeline(state);
    let sample = |((x, y, color), &stencil): ((i32, i32, Color), &u8)| {
        let sample = Sample { color, depth: 1.0, stencil: stencil.into() };
        surfaces.iter().fold(sample, |sample, Surface { corners, color }| {
            let Some(seen) = nearest(&[*corners], x, y) else { return sample };
            pipeline.after([x, y].map(i64::from), seen.depth, *color, sample).1
        })
    };
    image.pixels().zip(stencils).map(sample).collect()
}

fn samples(target: &AnyFramebuffer) -> Vec<Sample> {
    let pixels = target.image.pixels().zip(&target.stencils);
    let sample = |((x, y, color), &stencil): ((i32, i32, Color), &u8)| Sample {
        color,
        depth: target.depths.get(x, y).into(),
        stencil: stencil.into(),
    };
    pixels.map(sample).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn a_framebuffer_does_what_its_state_says(seed: u64) {
        let mut rng = Rng::with_seed(seed);
        let (state, surfaces, (mut image, stencils)) =
            (any_state(&mut rng), any_surfaces(&mut rng), any_picture(&mut rng));
        let expected = expected(&state, &surfaces, &image, &stencils);
        let mut other = image.clone();
        let mut target = Framebuffer::new(&mut image, state);
        target.stencils.clone_from(&stencils);
        let target = (method(METHODS, "two-shift").triangles_under)(target, &surfaces);
        prop_assert_eq!(samples(&target), &*expected, "early, {:?}", state);

        let mut late = Late(Framebuffer::new(&mut other, state));
        late.0.stencils.clone_from(&stencils);
        plain::draw(&surfaces, &mut late);
        prop_assert_eq!(samples(&late.0), expected, "late, {:?}", state);
    }

    #[test]
    fn what_is_exact_for_all_products_is_exact_under_any_state(seed: u64) {
        let mut rng = Rng::with_seed(seed);
        let (state, surfaces, (image, _)) = (any_state(&mut rng), any_surfaces(&mut rng), any_picture(&mut rng));
        let [float, exact, two_shift] = ["float", "exact", "two-shift"].map(|name| {
            let mut image = image.clone();
            drop((method(METHODS, name).triangles_under)(Framebuffer::new(&mut image, state), &surfaces));
            image
        });
        prop_assert!(float == exact && exact == two_shift, "{:?}", state);
    }

    /// An alpha is at most what it was, at most its share of 255, and half a code from the exact product.
    #[test]
    fn a_share_of_an_alpha(a: u8, share in 0.0f32..=1.0) {
        let got = f64::from(faded(Color { r: 1, g: 2, b: 3, a }, share).a);
        prop_assert!((got - f64::from(a) * f64::from(share)).abs() <= 0.5 + 1e-4, "{}", got);
    }
}

/// Half of 255 is 127, as the assignment has it; no share, or too large a one, breaks an alpha.
#[test]
fn shares_at_the_ends() {
    let alpha = |a, share| faded(Color { r: 9, g: 8, b: 7, a }, share);
    assert_eq!(alpha(255, 0.5), Color { r: 9, g: 8, b: 7, a: 127 });
    for (share, expected) in
        [(0.0, 0), (1.0, 200), (7.0, 200), (-1.0, 0), (f32::NAN, 0), (f32::INFINITY, 200), (0.25, 50)]
    {
        assert_eq!(alpha(200, share).a, expected, "{share}");
    }
    assert!((0..=255).all(|a| alpha(a, 1.0).a == a && alpha(a, 0.0).a == 0));
}
