//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.

use blending::blend::{Blend, BlendStage, Equation, Factor, Formula};
use blending::compare::Compare;
use blending::depth::DepthTest;
use blending::division::{Div256, Division, Exact, Shift8, TwoShift};
use blending::logic::LogicOp;
use blending::stencil::{StencilOp, StencilTest};
use blending::{Kept, over, test};
use common::Color;
use filtering::light::SRGB;

/// The stencil that lets two layers through.
const TWO: StencilTest =
    StencilTest { function: Compare::Greater, reference: 2, pass: StencilOp::Incr, ..StencilTest::ALWAYS };

/// What a pixel keeps after each of the example's four fragments.
fn four_fragments(stencil: &StencilTest) -> Vec<(bool, u8, f32)> {
    let depth = DepthTest { function: Compare::Less, write: true };
    let mut kept = Kept { stencil: 0, depth: 1.0 };
    let mut arrive = |fragment: f32| {
        let (passes, after) = test(stencil, &depth, fragment, kept);
        kept = after;
        (passes, after.stencil, after.depth)
    };
    [0.6, 0.7, 0.5, 0.3].map(&mut arrive).to_vec()
}

#[test]
fn two_layers_and_no_third() {
    let expected = [(true, 1, 0.6), (false, 1, 0.6), (true, 2, 0.5), (false, 2, 0.5)];
    assert_eq!(four_fragments(&TWO), expected);
    // Only the lowest bit may change.
    let stencils: Vec<u8> =
        four_fragments(&StencilTest { write_mask: 1, ..TWO }).iter().map(|kept| kept.1).collect();
    assert_eq!(stencils, [1, 1, 0, 1]);
}

/// The table of the comparisons.
const ALL: [Compare; 8] = [
    Compare::Never,
    Compare::Less,
    Compare::Equal,
    Compare::Lequal,
    Compare::Greater,
    Compare::Notequal,
    Compare::Gequal,
    Compare::Always,
];

/// Which of the three cases each comparison passes, and what it does with a NaN.
#[test]
fn eight_comparisons() {
    let cases = |compare: Compare| [(0, 1), (1, 1), (1, 0)].map(|(a, b)| compare.passes(a, b));
    let mut all: Vec<[bool; 3]> = ALL.map(cases).to_vec();
    assert_eq!(cases(Compare::Lequal), [true, true, false]);
    assert_eq!(cases(Compare::Greater), [false, false, true]);
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), 8);
    let passes_nan = |compare: &&Compare| compare.passes(f32::NAN, 0.5);
    let passing: Vec<&Compare> = ALL.iter().filter(passes_nan).collect();
    assert_eq!(passing, [&Compare::Notequal, &Compare::Always]);
}

/// The table of the logic operations, each by its four bits.
#[test]
fn sixteen_operations() {
    let operations: [(LogicOp, u32); 16] = [
        (LogicOp::Clear, 0b0000),
        (LogicOp::Nor, 0b0001),
        (LogicOp::AndInverted, 0b0010),
        (LogicOp::CopyInverted, 0b0011),
        (LogicOp::AndReverse, 0b0100),
        (LogicOp::Invert, 0b0101),
        (LogicOp::Xor, 0b0110),
        (LogicOp::Nand, 0b0111),
        (LogicOp::And, 0b1000),
        (LogicOp::Equiv, 0b1001),
        (LogicOp::Noop, 0b1010),
        (LogicOp::OrInverted, 0b1011),
        (LogicOp::Copy, 0b1100),
        (LogicOp::OrReverse, 0b1101),
        (LogicOp::Or, 0b1110),
        (LogicOp::Set, 0b1111),
    ];
    for (operation, bits) in operations {
        assert_eq!(operation.apply(0b1100, 0b1010) & 0b1111, bits, "{operation:?}");
    }
}

/// Red and blue panes of one half before a white wall.
#[test]
fn two_panes_before_a_wall() {
    let (red, blue) = (Color { a: 128, ..Color::RED }, Color { a: 128, ..Color::rgb(0, 0, 255) });
    // Half of 255 is 127 or 128.
    let got = over(red, over(blue, Color::WHITE));
    let near = [(got.r, 191), (got.g, 64), (got.b, 128)];
    assert!(near.iter().all(|&(got, expected): &(u8, u8)| got.abs_diff(expected) <= 1), "{got:?}");
    assert_eq!(got.a, 255);
}

#[test]
fn two_halves_let_a_quarter_through() {
    let half = Color { a: 128, ..Color::WHITE };
    assert!(over(half, half).a.abs_diff(191) <= 1);
    assert_eq!(over(half, Color { a: 0, ..Color::BLACK }).a, 128);
}

/// Straight colours in groups: three eighths where it should be one half.
#[test]
fn straight_colours_are_not_associative() {
    let [white, black] = [Color::WHITE, Color::BLACK].map(|color| Color { a: 128, ..color });
    let one_by_one = over(white, over(black, Color::BLACK)).r;
    let in_a_group = over(over(white, black), Color::BLACK).r;
    assert!(one_by_one.abs_diff(128) <= 1 && in_a_group.abs_diff(96) <= 1, "{one_by_one} {in_a_group}");
}

/// Premultiplied ones by their factors, in the table's words: as near as bytes come.
#[test]
fn premultiplied_colours_are_associative() {
    let formula =
        Formula { equation: Equation::FuncAdd, source: Factor::One, destination: Factor::OneMinusSrcAlpha };
    let blend = Blend { color: formula, alpha: formula, ..Blend::OVER };
    let layers = |n: u64| {
        let Color { r, g, b, .. } = Color::random(n);
        let a = Color::random(n + 5000).r;
        let times = |channel: u8| TwoShift::mix(channel, 0, a);
        Color { r: times(r), g: times(g), b: times(b), a }
    };
    for n in 0..1000 {
        let [a, b, c] = [n, n + 1000, n + 2000].map(layers);
        let from_back = blend.color(a, blend.color(b, c));
        let in_groups = blend.color(blend.color(a, b), c);
        for (x, y) in [
            (from_back.r, in_groups.r),
            (from_back.g, in_groups.g),
            (from_back.b, in_groups.b),
            (from_back.a, in_groups.a),
        ] {
            assert!(x.abs_diff(y) <= 2, "{a:?} {b:?} {c:?}");
        }
    }
}

/// A layer over another one, so many times.
fn layers<D: Division>(source: u8, alpha: u8, mut destination: u8, count: usize) -> u8 {
    (0..count).for_each(|_| destination = D::mix(source, destination, alpha));
    destination
}

/// The place where white on white comes to rest, and where white on black does.
#[test]
fn a_thousand_layers() {
    for (alpha, rest) in [(1, 127), (10, 231)] {
        assert_eq!(layers::<Shift8>(255, alpha, 255, 1000), rest);
        assert_eq!(255 * u32::from(alpha) / (1 + u32::from(alpha)), u32::from(rest));
        assert_eq!(layers::<TwoShift>(255, alpha, 255, 1000), 255);
    }
    assert_eq!([1, 2].map(|alpha| layers::<Exact>(255, alpha, 0, 1000)), [128, 192]);
    let exact = 255.0 * (1.0 - (1.0 - 2.0 / 255.0_f64).powi(1000));
    assert!((exact - 254.9).abs() < 0.05, "{exact}");
}

/// The two shifts as they are proved: right up to 65,662, and wrong for the next one.
#[test]
fn two_shifts_hold_for_q_up_to_257() {
    let two_shifts = |x: u32| {
        let t = x + 128;
        (t + t / 256) / 256
    };
    let nearest = |x: u32| (2 * x + 255) / 510;
    assert!((0..65_663).all(|x| two_shifts(x) == nearest(x)));
    assert_ne!(two_shifts(65_663), nearest(65_663));
    let most = 255 * 255 + 128;
    assert!(most + most / 256 < 1 << 16);
    // The lesson's function is this one.
    for (a, b) in (0..=255_u8).flat_map(|a| (0..=255).map(move |b| (a, b))) {
        let x = u32::from(a) * u32::from(b);
        assert_eq!(u32::from(TwoShift::mix(a, 0, b)), two_shifts(x));
    }
}

#[test]
fn a_stretched_alpha_is_one_level_off_at_most() {
    assert_eq!(Shift8::mix(255, 255, 255), 254);
    for (a, b) in (0..=255_u8).flat_map(|a| (0..=255).map(move |b| (a, b))) {
        assert!(Div256::mix(a, 0, b).abs_diff(Exact::mix(a, 0, b)) <= 1);
    }
}

#[test]
fn half_of_white_by_code_and_by_light() {
    let light = |code: u8| SRGB.light(Color::rgb(code, code, code)).x / 255.0;
    assert!((light(128) - 0.22).abs() < 0.005);
    assert_eq!(SRGB.color(common::Vec4::splat(127.5)).r, 188);
}

/// Green before red, both one half, before black: what sorting gives, and what equal weights do.
#[test]
fn weights_of_one() {
    let [green, red] = [[0.0, 1.0], [1.0, 0.0]].map(|color: [f64; 2]| color.map(|c| c * 0.5));
    let sorted = [0, 1].map(|c| green[c] + 0.5 * red[c]);
    assert_eq!(sorted, [0.25, 0.5]);
    let mean = [0, 1].map(|c| (green[c] + red[c]) / (0.5 + 0.5));
    assert_eq!(mean.map(|c| c * (1.0 - 0.25)), [0.375, 0.375]);
}

/// With alpha at 10 of 255, eleven premultiplied reds.
#[test]
fn eleven_reds() {
    let mut reds: Vec<u8> = (0..=255).map(|red| TwoShift::mix(red, 0, 10)).collect();
    reds.dedup();
    assert_eq!(reds.len(), 11);
}
