//! Every function, operation, factor, equation, logic operation, mask and scissor, against what OpenGL says of it.

use blending::blend::BlendStage;
use blending::mask::MaskStage;
use blending::scissor::ScissorStage;
use blending::{
    Blend, Compare, DepthTest, Equation, Factor, Formula, Kept, LogicOp, StencilOp, StencilTest, WriteMask,
    test,
};
use checks::fragment::{blended, logic, passes, rounded, stencil_op};
use clap::ValueEnum;
use common::{Bounds, Color, IVec2};
use fastrand::Rng;

/// What a value is called on the command line, by OpenGL's name.
pub(crate) fn name<E: ValueEnum>(value: &E) -> String {
    value.to_possible_value().expect("each has a name").get_name().into()
}

/// Depths, of which some have no order.
const DEPTHS: [f32; 12] =
    [0.0, -0.0, 1e-45, 0.25, 0.5, 0.500_000_06, 1.0, 2.0, -1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];

/// OpenGL has so many of each: none is missing.
#[test]
fn there_are_as_many_as_opengl_has() {
    assert_eq!((Compare::value_variants().len(), StencilOp::value_variants().len()), (8, 8));
    assert_eq!((Factor::value_variants().len(), Equation::value_variants().len()), (15, 5));
    assert_eq!(LogicOp::value_variants().len(), 16);
}

#[test]
fn every_function_on_depths() {
    for function in Compare::value_variants() {
        for (incoming, kept) in DEPTHS.iter().flat_map(|&a| DEPTHS.iter().map(move |&b| (a, b))) {
            let expected = passes(&name(function), incoming.into(), kept.into());
            assert_eq!(function.passes(incoming, kept), expected, "{function:?} {incoming} {kept}");
        }
    }
}

#[test]
fn every_function_on_all_stencils() {
    for function in Compare::value_variants() {
        for (incoming, kept) in (0..=255_u8).flat_map(|a| (0..=255_u8).map(move |b| (a, b))) {
            let expected = passes(&name(function), incoming.into(), kept.into());
            assert_eq!(function.passes(incoming, kept), expected, "{function:?} {incoming} {kept}");
        }
    }
}

#[test]
fn every_stencil_operation_on_all_numbers() {
    for operation in StencilOp::value_variants() {
        for (kept, reference) in (0..=255_u8).flat_map(|a| (0..=255_u8).map(move |b| (a, b))) {
            let expected = stencil_op(&name(operation), kept.into(), reference.into());
            assert_eq!(
                i64::from(operation.apply(kept, reference)),
                expected,
                "{operation:?} {kept} {reference}"
            );
        }
    }
}

/// Where the stencil test fails the depth test is not asked, and where it passes, its operation hangs on the depth test.
#[test]
fn how_far_a_fragment_came_chooses_the_operation() {
    let stencil = |function| StencilTest {
        function,
        fail: StencilOp::Zero,
        depth_fail: StencilOp::Decr,
        pass: StencilOp::Incr,
        ..StencilTest::ALWAYS
    };
    let depth = DepthTest { function: Compare::Less, write: true };
    for (function, fragment, expected) in [
        (Compare::Never, 0.25, (false, Kept { stencil: 0, depth: 0.5 })),
        (Compare::Never, 0.75, (false, Kept { stencil: 0, depth: 0.5 })),
        (Compare::Always, 0.75, (false, Kept { stencil: 6, depth: 0.5 })),
        (Compare::Always, 0.5, (false, Kept { stencil: 6, depth: 0.5 })),
        (Compare::Always, f32::NAN, (false, Kept { stencil: 6, depth: 0.5 })),
        (Compare::Always, 0.25, (true, Kept { stencil: 8, depth: 0.25 })),
    ] {
        let got = test(&stencil(function), &depth, fragment, Kept { stencil: 7, depth: 0.5 });
        assert_eq!(got, expected, "{function:?} {fragment}");
    }
}

/// The reference is on the left: `less` lets through what is kept above it.
#[test]
fn the_reference_is_on_the_left() {
    let stencil = StencilTest { function: Compare::Less, reference: 3, ..StencilTest::ALWAYS };
    let depth = DepthTest { function: Compare::Always, write: false };
    let seen =
        (0..8).map(|stencil_kept| test(&stencil, &depth, 0.5, Kept { stencil: stencil_kept, depth: 0.5 }).0);
    assert_eq!(seen.collect::<Vec<_>>(), [false, false, false, false, true, true, true, true]);
}

/// Some bits are read, others written; what is read is masked on both sides, what is replaced is the whole reference.
#[test]
fn masks_of_the_stencil() {
    let stencil = StencilTest {
        function: Compare::Equal,
        reference: 0b1010_0110,
        read_mask: 0b0000_1111,
        write_mask: 0b1111_0000,
        pass: StencilOp::Replace,
        fail: StencilOp::Invert,
        ..StencilTest::ALWAYS
    };
    let depth = DepthTest { function: Compare::Always, write: false };
    for (kept, seen, after) in [
        (0b0101_0110, true, 0b1010_0110),
        (0b0101_0111, false, 0b1010_0111),
        (0b1111_0110, true, 0b1010_0110),
    ] {
        let got = test(&stencil, &depth, 0.5, Kept { stencil: kept, depth: 0.5 });
        assert_eq!(got, (seen, Kept { stencil: after, depth: 0.5 }), "{kept:08b}");
    }
}

/// `incr` stops at 255 and `decr` at 0, whatever of it may be written; the others go round.
#[test]
fn a_stencil_counts_to_its_end_or_round() {
    let counted = |pass, from: u8, write_mask| {
        let stencil = StencilTest { pass, write_mask, ..StencilTest::ALWAYS };
        let depth = DepthTest { function: Compare::Always, write: false };
        (0..300)
            .fold(Kept { stencil: from, depth: 1.0 }, |kept, _| test(&stencil, &depth, 0.5, kept).1)
            .stencil
    };
    assert_eq!(counted(StencilOp::Incr, 0, 255), 255);
    assert_eq!(counted(StencilOp::Decr, 255, 255), 0);
    assert_eq!(counted(StencilOp::IncrWrap, 0, 255), 44);
    assert_eq!(counted(StencilOp::DecrWrap, 0, 255), 212);
    assert_eq!(counted(StencilOp::Invert, 9, 255), 9);
    // A carry into bits that are not written is lost.
    assert_eq!(counted(StencilOp::Incr, 0, 0b11), 0);
}

/// The notes' mask hides where the stencil is 0, and leaves it as it is.
#[test]
fn a_mask_hides_where_it_is_0() {
    let depth = DepthTest { function: Compare::Less, write: true };
    for stencil in 0..=255 {
        let (seen, after) = test(&StencilTest::MASK, &depth, 0.25, Kept { stencil, depth: 0.5 });
        let depth = if stencil > 0 { 0.25 } else { 0.5 };
        assert_eq!((seen, after), (stencil > 0, Kept { stencil, depth }));
    }
}

/// A depth may be tested and not written, or written and not tested.
#[test]
fn a_depth_is_written_where_it_is_asked_for() {
    for (function, write, fragment, expected) in [
        (Compare::Less, true, 0.25, (true, 0.25)),
        (Compare::Less, false, 0.25, (true, 0.5)),
        (Compare::Always, true, 0.75, (true, 0.75)),
        (Compare::Always, false, 0.75, (true, 0.5)),
        (Compare::Never, true, 0.25, (false, 0.5)),
        (Compare::Notequal, true, 0.5, (false, 0.5)),
        (Compare::Equal, true, 0.5, (true, 0.5)),
        (Compare::Gequal, true, f32::INFINITY, (true, f32::INFINITY)),
    ] {
        let (seen, after) = test(
            &StencilTest::ALWAYS,
            &DepthTest { function, write },
            fragment,
            Kept { stencil: 3, depth: 0.5 },
        );
        assert_eq!(
            (seen, after.depth, after.stencil),
            (expected.0, expected.1, 3),
            "{function:?} {fragment}"
        );
    }
}

/// NaN passes `always` and `notequal`, and nothing else; once it is kept, nothing else passes any more.
#[test]
fn nan_is_no_depth_that_anything_is_nearer_than() {
    let depth = |function| DepthTest { function, write: true };
    for function in Compare::value_variants() {
        let passes = matches!(function, Compare::Always | Compare::Notequal);
        for (fragment, kept) in [(f32::NAN, 0.5), (0.5, f32::NAN), (f32::NAN, f32::NAN)] {
            let got =
                test(&StencilTest::ALWAYS, &depth(*function), fragment, Kept { stencil: 0, depth: kept });
            assert_eq!(got.0, passes, "{function:?} {fragment} {kept}");
        }
    }
}

/// Any colours, and those at the ends more often.
pub(crate) fn any_color(rng: &mut Rng) -> Color {
    let mut channel = || {
        let any = rng.u8(..);
        [0, 1, 127, 128, 254, 255, any, any][rng.usize(..8)]
    };
    Color { r: channel(), g: channel(), b: channel(), a: channel() }
}

/// All 225 pairs of factors under each equation, on a thousand triples of colours each.
#[test]
fn every_factor_under_every_equation() {
    let mut rng = Rng::with_seed(14);
    for equation in Equation::value_variants() {
        for source in Factor::value_variants() {
            for destination in Factor::value_variants() {
                let formula = Formula { equation: *equation, source: *source, destination: *destination };
                let names = [name(equation), name(source), name(destination)];
                for _ in 0..1000 {
                    let [s, d, constant] = [(); 3].map(|()| any_color(&mut rng));
                    let got = Blend { color: formula, alpha: formula, constant }.color(s, d);
                    let names = names.each_ref().map(String::as_str);
                    let expected =
                        [0, 1, 2, 3].map(|channel| rounded(blended(names, channel, s, d, constant)));
                    assert_eq!([got.r, got.g, got.b, got.a], expected, "{names:?} {s:?} {d:?} {constant:?}");
                }
            }
        }
    }
}

/// Colours and alpha each have their own formula.
#[test]
fn alpha_is_blended_by_itself() {
    let blend = Blend {
        color: Formula { equation: Equation::FuncAdd, source: Factor::One, destination: Factor::One },
        alpha: Formula {
            equation: Equation::FuncReverseSubtract,
            source: Factor::SrcAlpha,
            destination: Factor::One,
        },
        ..Blend::OVER
    };
    let got = blend.color(Color { r: 100, g: 200, b: 3, a: 51 }, Color { r: 1, g: 100, b: 4, a: 200 });
    // 200 − 51·51/255 = 189.8.
    assert_eq!(got, Color { r: 101, g: 255, b: 7, a: 190 });
}

/// The default is the layer over what is there.
#[test]
fn over_is_source_alpha_and_the_rest() {
    let mut rng = Rng::with_seed(15);
    for _ in 0..200_000 {
        let [s, d] = [(); 2].map(|()| any_color(&mut rng));
        assert_eq!(Blend::OVER.color(s, d), blending::over(s, d), "{s:?} {d:?}");
    }
}

/// All 65,536 pairs of bytes under each of the sixteen.
#[test]
fn every_logic_operation_on_all_bytes() {
    for operation in LogicOp::value_variants() {
        let name = name(operation);
        for (s, d) in (0..=255_u8).flat_map(|s| (0..=255_u8).map(move |d| (s, d))) {
            // Another pair in each channel.
            let (source, destination) = (
                Color { r: s, g: d, b: !s, a: s.rotate_left(3) },
                Color { r: d, g: s, b: s ^ d, a: d.rotate_left(1) },
            );
            let got = operation.color(source, destination);
            let pairs = [
                (source.r, destination.r),
                (source.g, destination.g),
                (source.b, destination.b),
                (source.a, destination.a),
            ];
            assert_eq!(
                [got.r, got.g, got.b, got.a],
                pairs.map(|(s, d)| logic(&name, s, d)),
                "{name} {s} {d}"
            );
        }
    }
}

#[test]
fn every_write_mask() {
    let (new, old) = (Color { r: 1, g: 2, b: 3, a: 4 }, Color { r: 10, g: 20, b: 30, a: 40 });
    for bits in 0..16 {
        let write = |bit: u8| bits >> bit & 1 == 1;
        let mask = WriteMask { r: write(0), g: write(1), b: write(2), a: write(3) };
        let letters: String =
            "rgba".chars().zip(0..).filter(|&(_, bit)| write(bit)).map(|(letter, _)| letter).collect();
        assert_eq!(letters.parse(), Ok(mask));
        let got = mask.color(new, old);
        let expected = [(1, 10), (2, 20), (3, 30), (4, 40)];
        let channels = [got.r, got.g, got.b, got.a];
        for (bit, (channel, (new, old))) in channels.into_iter().zip(expected).enumerate() {
            assert_eq!(channel, if write(bit as u8) { new } else { old }, "{letters}");
        }
    }
}

/// Both corners of a scissor's rectangle are in it, and nothing around it.
#[test]
fn a_scissor_ends_at_its_pixels() {
    let scissor = Bounds { min: IVec2::new(-2, 3), max: IVec2::new(4, 5) };
    for (x, y) in (-5..9).flat_map(|x| (0..9).map(move |y| (x, y))) {
        let inside = (-2..-2 + 7).contains(&x) && (3..3 + 3).contains(&y);
        assert_eq!(ScissorStage::contains(scissor, IVec2::new(x, y)), inside, "({x}, {y})");
    }
    let empty = Bounds { min: IVec2::ZERO, max: IVec2::splat(-1) };
    assert!((-3..3).all(|n| !ScissorStage::contains(empty, IVec2::splat(n))));
}
