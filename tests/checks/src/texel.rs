//! The texel that a texture coordinate is in, decided in `i128`.

/// ⌊u·n⌋ for a texture of `n` texels, without any rounding; `None` where u is not finite. What lies beyond
/// 2⁸⁰ or so is cut down to ±2¹⁰⁰, with no effect on which texel it is.
#[must_use]
pub fn column(u: f32, n: u16) -> Option<i128> {
    // A finite f32 is mantissa·2^exponent, both whole.
    let bits = u.to_bits();
    let biased = (bits >> 23 & 0xff) as i32;
    let (mantissa, exponent) = match biased {
        0xff => return None,
        0 => (i128::from(bits & 0x7f_ffff), -149),
        _ => (i128::from(bits & 0x7f_ffff | 0x80_0000), biased - 150),
    };
    let product = if u.is_sign_negative() { -mantissa } else { mantissa } * i128::from(n);
    Some(match exponent {
        // A shift to the right rounds down, below 0 as well.
        ..0 => product >> (-exponent).min(120),
        0..60 => product << exponent,
        _ => product.signum() << 100,
    })
}

/// The texel that u is in, or the nearest one of the texture.
#[must_use]
pub fn clamped(u: f32, n: u16) -> Option<i32> {
    Some(column(u, n)?.clamp(0, i128::from(n) - 1) as i32)
}

/// The texel that u is in if the texture is repeated without end.
#[must_use]
pub fn repeated(u: f32, n: u16) -> Option<i32> {
    // From 2²³ on every f32 is whole, and so at the left border.
    if u.is_finite() && u.abs() >= (1 << 23) as f32 {
        return Some(0);
    }
    Some(column(u, n)?.rem_euclid(i128::from(n)) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn borders_are_exact() {
        let third = 1.0f32 / 3.0;
        // The f32 nearest to ⅓ is above it.
        assert_eq!([column(third, 3), column(third.next_down(), 3)], [Some(1), Some(0)]);
        assert_eq!([0.0, -1e-45, 0.5, 1.0, -0.25].map(|u| column(u, 4)), [0, -1, 2, 4, -1].map(Some));
        assert_eq!([1e30, -1e30, f32::MAX].map(|u| clamped(u, 4)), [3, 0, 3].map(Some));
        assert_eq!([1.25, -0.25, 1e30].map(|u| repeated(u, 4)), [1, 3, 0].map(Some));
        assert_eq!([f32::NAN, f32::INFINITY].map(|u| column(u, 4)), [None, None]);
    }
}
