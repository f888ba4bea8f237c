//! Directions: vectors of which it counts where they point, not how long they are.

use glam::Vec3;

/// A vector times the power of two that brings its largest component to between 2 and 4 (subnormal ones not
/// quite): no square of one and no product of two of these leaves the range of `f32`.
///
/// A power of two rounds nothing, so what follows gives the digits that it would have given without, wherever
/// those existed. 0 stays 0; what is not finite becomes NaN.
#[inline]
#[must_use]
pub fn scaled(v: Vec3) -> Vec3 {
    // The bits of an f32's exponent: 2^e has e + 127 there. Of infinity, all are set, and the factor is 0.
    const EXPONENT: u32 = 0xff << 23;
    const LARGEST: u32 = 0xfe << 23;
    let exponent = v.abs().max_element().to_bits() & EXPONENT;
    v * f32::from_bits((EXPONENT - exponent).min(LARGEST))
}

/// The vector of length 1 in a direction that is given by a vector of any length; `None` where that is 0 or
/// not finite.
#[inline]
#[must_use]
pub fn unit(v: Vec3) -> Option<Vec3> {
    scaled(v).try_normalize()
}

/// The length of a vector, in f64 on the way: no square of an `f32` is too large or too small there.
#[must_use]
pub fn length(v: Vec3) -> f32 {
    v.as_dvec3().length() as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_length_but_0_will_do() {
        for exponent in -149..=127 {
            let length = 2f64.powi(exponent) as f32;
            assert_eq!(unit(Vec3::new(0.0, -length, 0.0)), Some(Vec3::NEG_Y), "2^{exponent}");
            assert_eq!(super::length(Vec3::new(0.0, -length, 0.0)), length);
            let diagonal = unit(Vec3::new(length, 0.0, length)).unwrap();
            assert!(
                (diagonal - Vec3::new(0.5f32.sqrt(), 0.0, 0.5f32.sqrt())).length() < 1e-7,
                "2^{exponent}"
            );
        }
        for none in
            [Vec3::ZERO, Vec3::INFINITY, Vec3::NAN, Vec3::new(1.0, f32::NAN, 0.0), Vec3::X * f32::INFINITY]
        {
            assert_eq!(unit(none), None, "{none}");
        }
        assert!((unit(Vec3::MAX).unwrap() - Vec3::ONE.normalize()).length() < 1e-7);
    }

    /// Scaling changes no digit of what needed none.
    #[test]
    fn ordinary_lengths_give_what_they_gave() {
        for n in 0..1000 {
            let component = |k: u64| {
                (f64::from(crate::Color::random(3 * n + k).r) - 127.3) as f32 * 1.7f32.powi(n as i32 % 40)
            };
            let v = Vec3::new(component(0), component(1), component(2));
            assert_eq!(unit(v), v.try_normalize(), "{v}");
        }
    }
}
