//! Normals from a map, as seen from the surface that it is laid on.
//!
//! In **tangent space** a texel says how far the normal leans from the surface's own: red along the *tangent*, in which u grows,
//! green along the *bitangent*, in which v grows, blue along the normal. So a map may be repeated, or shared by two mirrored halves,
//! and it moves with a surface that bends. The price is a frame at each pixel; and the surface must have the normals and the
//! tangents that the map was made for.
//!
//! A triangle's tangent T and bitangent B follow from its sides, since each is so many times T and so many times B as it is long
//! in u and in v. They are the same all over it. The normal n is interpolated; T is brought to a right angle with it as Gram
//! and Schmidt do, T − n(n·T), and the third vector, ±n × T, is at right angles to both. (E. Lengyel, *Mathematics for 3D Game
//! Programming and Computer Graphics*, 3rd edition, 2012, section 7.8.)

use common::direction::unit;
use common::{DVec2, DVec3, Image, Vec2, Vec3, Vec4, Vec4Swizzles};

use crate::normal_map::decoded;
use crate::scene::Scene;
use crate::surface::{Shape, Smooth, Surface};

/// The directions in which u and v grow on a triangle: ∂p/∂u and ∂p/∂v times a factor above 0, for the corners' positions p.
/// `None` where (u, v) do not tell: where its corners have them on one line, or they are not finite.
// ANCHOR: tangents
#[must_use]
pub fn tangents(positions: [Vec3; 3], uvs: [Vec2; 3]) -> Option<[DVec3; 2]> {
    // In f64 no product of two differences of f32 is infinite, and almost none is rounded to 0.
    let [a, b, c] = positions.map(Vec3::as_dvec3);
    let [i, j, k] = uvs.map(Vec2::as_dvec2);
    let ((p, q), (s, t)): ((DVec3, DVec3), (DVec2, DVec2)) = ((b - a, c - a), (j - i, k - i));
    let determinant = s.perp_dot(t);
    let known = determinant.is_finite() && determinant != 0.0;
    let sign = determinant.signum();
    known.then(|| [(p * t.y - q * s.y) * sign, (q * s.x - p * t.x) * sign])
}
// ANCHOR_END: tangents

/// A triangle's tangent and, as w, 1 or −1: whether n × T points along the bitangent or against it, where the map lies mirrored.
/// 0 where there is no tangent. All in the world; of the corners' normals the sum counts.
// ANCHOR: handed
#[must_use]
pub fn handed(positions: [Vec3; 3], uvs: [Vec2; 3], normals: [Vec3; 3]) -> Vec4 {
    let Some([tangent, bitangent]) = tangents(positions, uvs) else { return Vec4::ZERO };
    let normal: DVec3 = normals.map(Vec3::as_dvec3).iter().sum();
    let sign = normal.cross(tangent).dot(bitangent).signum();
    tangent.normalize_or_zero().extend(sign).as_vec4()
}
// ANCHOR_END: handed

/// A vector of tangent space in the world, at a point with this normal, 1 long or 0; the normal itself where that is 0, there is
/// no tangent, or the one points along the other.
// ANCHOR: turned
#[inline]
#[must_use]
pub fn turned(vector: Vec3, tangent: Vec4, normal: Vec3) -> Vec3 {
    // n × T lies across n and T − n(n·T) alike, and is 0 where that is.
    let Some(across) = normal.cross(tangent.xyz()).try_normalize() else { return normal };
    across.cross(normal) * vector.x + across * (tangent.w * vector.y) + normal * vector.z
}
// ANCHOR_END: turned

/// The normals of a map in tangent space. Glossy all over.
#[derive(Clone, Copy)]
pub struct TangentNormals<'a>(pub &'a Image);

// ANCHOR: surface
impl Surface for TangentNormals<'_> {
    /// The tangent, and whether the map lies mirrored.
    type Constant = Vec4;
    type Varying = Vec3;

    #[inline]
    fn triangle(&self, scene: &Scene, face: usize) -> Vec4 {
        let corners = [0, 1, 2];
        let positions = corners.map(|corner| scene.position(face, corner));
        let uvs = corners.map(|corner| scene.uv(face, corner));
        handed(positions, uvs, corners.map(|corner| scene.normal(face, corner)))
    }

    #[inline]
    fn corner(&self, scene: &Scene, face: usize, corner: usize) -> Vec3 {
        Smooth.corner(scene, face, corner)
    }

    #[inline]
    fn at(&self, scene: &Scene, tangent: Vec4, uv: Vec2, normal: Vec3) -> Shape {
        let vector = decoded(scene.uniforms.wrap.texel(self.0, uv));
        let normal = unit(normal).unwrap_or_default();
        Shape { normal: turned(vector, tangent, normal), gloss: 1.0 }
    }
}
// ANCHOR_END: surface
