//! The planes that bound what is drawn, as vectors of clip space.
//!
//! A plane is a vector *p* of four numbers; a point *v* of clip space is on its inner side where *p·v ≥ 0*. What is in
//! the picture satisfies −w ≤ x, y, z ≤ w, which is six such conditions: *x + w ≥ 0* is (1, 0, 0, 1)·*v* ≥ 0, and so on
//! (notes, *Clipping*). The division by w has not happened yet, so all of this holds for points behind the eye, too.

use common::{Vec2, Vec3, Vec4, Vec4Swizzles};

/// Near and far, then left, right, bottom and top. Near comes first: it leaves nothing behind the eye for the others.
// ANCHOR: planes
pub const PLANES: [Vec4; 6] = [
    Vec4::new(0.0, 0.0, 1.0, 1.0),
    Vec4::new(0.0, 0.0, -1.0, 1.0),
    Vec4::new(1.0, 0.0, 0.0, 1.0),
    Vec4::new(-1.0, 0.0, 0.0, 1.0),
    Vec4::new(0.0, 1.0, 0.0, 1.0),
    Vec4::new(0.0, -1.0, 0.0, 1.0),
];
// ANCHOR_END: planes

/// How far a corner may be from the middle of the picture, in pixels to each side, before it is cut.
pub const BAND: f32 = (1 << 15) as f32;

/// The planes outside of which the fill's numbers would not do, for a picture of that size in pixels: near and far, and
/// four that lie 2¹⁵ px from the picture's middle.
///
/// **Why 2¹⁵.** A corner at x/w lies at W/2 + (x/w)·W/2 px in a picture W px wide. Within the planes (2¹⁶/W)·w ± x ≥ 0 the
/// second term is at most 2¹⁵ px, and so is W/2, as no picture is wider than 2¹⁶ px: the corner is within ±2¹⁶ px, up to
/// where lesson 3's edge functions are whole numbers of an `f64`, and where an `f32`, with its 24 bits, still holds each
/// 1/256 px. Beyond, the fill would become slow, and its corners coarser than its grid. What lies between the picture and
/// the band costs nothing, as no row is walked outside of the picture.
// ANCHOR: guard_band
#[must_use]
pub fn guard_band(size: Vec2) -> [Vec4; 6] {
    let Vec2 { x, y } = 2.0 * BAND / size;
    let [near, far, ..] = PLANES;
    [
        near,
        far,
        Vec4::new(1.0, 0.0, 0.0, x),
        Vec4::new(-1.0, 0.0, 0.0, x),
        Vec4::new(0.0, 1.0, 0.0, y),
        Vec4::new(0.0, -1.0, 0.0, y),
    ]
}
// ANCHOR_END: guard_band

/// How far inside of a plane a point is; negative outside. Products of two `f32` are exact in `f64`, and a sum of two
/// numbers has the right sign however it is rounded, so the sign is right for all the planes here.
// ANCHOR: distance
#[inline]
#[must_use]
pub fn distance(plane: Vec4, point: Vec4) -> f64 {
    plane.as_dvec4().dot(point.as_dvec4())
}
// ANCHOR_END: distance

/// The planes, one bit each, that a point is outside of. Where the codes of all corners share a bit the triangle is
/// outside; where none has any it is inside (the outcodes of D. Cohen and I. Sutherland, in W. Newman and R. Sproull,
/// *Principles of Interactive Computer Graphics*, 1973).
// ANCHOR: outcode
#[inline]
#[must_use]
pub fn outcode(planes: &[Vec4], point: Vec4) -> u8 {
    planes.iter().rev().fold(0, |code, &plane| code << 1 | u8::from(distance(plane, point) < 0.0))
}
// ANCHOR_END: outcode

/// The same of the picture's own planes, in six comparisons: those where x, y and z are below −w, then above w. A vertex
/// that is outside of none is beyond no guard band.
// ANCHOR: outside
#[inline]
#[must_use]
pub fn outside(point: Vec4) -> u8 {
    let (position, w) = (point.xyz(), Vec3::splat(point.w));
    (position.cmplt(-w).bitmask() | position.cmpgt(w).bitmask() << 3) as u8
}
// ANCHOR_END: outside

/// The bit of the near plane in [`outside`].
pub const NEAR: u8 = 1 << 2;

#[cfg(test)]
mod tests {
    use super::*;

    /// A point beyond one plane has that plane's bit alone, in either code; one on all planes is outside of none.
    #[test]
    fn each_plane_has_its_own_bit() {
        let mut seen = 0;
        for (n, plane) in PLANES.into_iter().enumerate() {
            // Beyond a plane that asks for −x ≤ w, x is −2 where w is 1.
            let point = Vec4::new(-2.0 * plane.x, -2.0 * plane.y, -2.0 * plane.z, 1.0);
            assert_eq!(outcode(&PLANES, point), 1 << n);
            let bit = outside(point);
            assert_eq!((bit.count_ones(), seen & bit), (1, 0), "{plane}");
            assert_eq!(bit == NEAR, n == 0);
            seen |= bit;
        }
        for corner in [Vec4::ONE, Vec4::new(-1.0, -1.0, -1.0, 1.0), Vec4::ZERO] {
            assert_eq!((outside(corner), outcode(&PLANES, corner)), (0, 0));
        }
        // Behind the eye a point is outside of at least one of each pair.
        assert_eq!(outside(Vec4::new(0.0, 0.0, 0.0, -1.0)).count_ones(), 6);
    }
}
