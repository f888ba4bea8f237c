use checks::texel::{clamped, column, repeated};
use common::Vec2;
use proptest::prelude::*;
use textures::{METHODS, repeat, texel};

use crate::labelled;

/// In the texture and about it, at its borders, and anything else that an f32 can be.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![-2.0f32..3.0, (-32..48).prop_map(|n| n as f32 / 16.0), any::<f32>()]
}

/// Whether u·n lies so near to a whole number that f32 may round it to that.
fn near_a_border(u: f32, n: u16) -> bool {
    let next = f64::from(u) * f64::from(n);
    (next - next.round()).abs() <= next.abs() * f64::from(f32::EPSILON)
}

proptest! {
    /// With 2ⁿ texels no product is rounded: `nearest` and `repeat` are exact for every number there is.
    #[test]
    fn powers_of_two_are_exact(u in coordinate(), v in coordinate(), log in 0..8u32) {
        let side = 1u16 << log;
        let texture = labelled(side, side);
        let at = |found: [Option<i32>; 2]| found.map(|n| n.unwrap_or(0) as u8);
        if u.is_finite() && v.is_finite() {
            let color = texel(&texture, Vec2::new(u, v));
            prop_assert_eq!([color.r, color.g], at([clamped(u, side), clamped(v, side)]));
        }
        // Just below 0 what is left of u is rounded to 1, and the last texel found; it is the right one.
        let color = repeat(&texture, Vec2::new(u, v));
        let seam = |c: f32| -1e-6 < c - c.round() && c - c.round() < 0.0;
        prop_assume!(!seam(u) && !seam(v));
        prop_assert_eq!([color.r, color.g], at([repeated(u, side), repeated(v, side)]));
    }

    /// With any number of texels it is the right one, but within a rounding of a border.
    #[test]
    fn other_sizes_are_exact_but_for_a_rounding(u in -2.0f32..3.0, v in -2.0f32..3.0, width in 1..250u16, height in 1..250u16) {
        prop_assume!(!near_a_border(u, width) && !near_a_border(v, height));
        let color = texel(&labelled(width, height), Vec2::new(u, v));
        let exact = [clamped(u, width), clamped(v, height)].map(|n| n.unwrap() as u8);
        prop_assert_eq!([color.r, color.g], exact);
    }

    /// Inside the texture, where the slides' first lookup is right, all agree with it but `round`.
    #[test]
    fn inside_all_agree_but_round(u in 0.0f32..1.0, v in 0.0f32..1.0) {
        let texture = labelled(64, 32);
        let expected = texel(&texture, Vec2::new(u, v));
        prop_assert_eq!([column(u, 64), column(v, 32)], [Some(expected.r.into()), Some(expected.g.into())]);
        for method in METHODS.iter().filter(|method| method.name != "round") {
            prop_assert_eq!((method.run.sample)(&texture, Vec2::new(u, v)), expected, "{}", method.name);
        }
    }

    #[test]
    fn no_number_panics(u in any::<f32>(), v in any::<f32>(), width in 0..5u16, height in 0..5u16) {
        for method in METHODS {
            let _ = (method.run.sample)(&labelled(width, height), Vec2::new(u, v));
        }
    }
}
