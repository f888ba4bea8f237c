//! Maps of the normals of the head's fine shape, for meshes that have fewer triangles than the shape has detail.
//!
//! In **object space** a texel holds the normal itself, whatever mesh it is laid on: red, green and blue are x, y and z. In
//! **tangent space** it holds where the normal lies as seen from a mesh: along the direction in which u grows, along that in
//! which v grows, and along the mesh's own normal. Such a map is right for the mesh it was made for.
//!
//! A texel of 8 bits a channel holds a coordinate n as 128 + 127·n, rounded.

use common::{Color, Format, Image};
use glam::DVec3;

use super::atlas::eye_texels;
use super::relief::raised;
use super::shape::{BASE, body};
use super::surface::gradient;
use super::texels::{Point, Sheet, Texel, Texels, index};

/// The unit normal of the fine shape at each texel that shows something of it.
pub struct Normals(Vec<Option<DVec3>>);

impl Normals {
    /// Of a bust with an eye, and of what a coarser bust shows beyond its patches; `depth` is the share of the relief.
    #[must_use]
    pub fn of(bust: &Texels, coarse: &Texels, depth: f64) -> Self {
        let mut normals = vec![None; bust.len()];
        for (x, y, texel) in bust.iter().chain(coarse.iter()) {
            normals[index(x, y)].get_or_insert_with(|| normal(texel, depth));
        }
        eye_texels().for_each(|(x, y, q)| normals[index(x, y)] = Some(q));
        Self(normals)
    }

    /// The map in object space.
    #[must_use]
    pub fn in_object_space(&self) -> Image {
        let mut map = Sheet::new(Format::Rgb);
        map.fill(&self.0, |normal| encoded(*normal));
        map.padded()
    }

    /// The map in the tangent space of a mesh.
    #[must_use]
    pub fn in_tangent_space(&self, triangles: &[[Point; 3]], texels: &Texels) -> Image {
        let mut map = Sheet::new(Format::Rgb);
        for (x, y, texel) in texels.iter() {
            if let Some(normal) = self.0[index(x, y)] {
                let [t, b, n] = frame(&triangles[texel.triangle], texel.normal);
                map.set(x, y, encoded(DVec3::new(normal.dot(t), normal.dot(b), normal.dot(n))));
            }
        }
        map.padded()
    }
}

/// The normal of the fine shape near a point of a bust.
fn normal(Texel { position: p, normal, .. }: Texel, depth: f64) -> DVec3 {
    if p.y < BASE + 1e-6 {
        return DVec3::NEG_Y;
    }
    let p = p - normal * body(p);
    raised(p, gradient(p).normalize(), depth)
}

/// The directions in which u and v grow on a triangle, turned so that both are at right angles to a unit normal and to each
/// other, and the normal.
///
/// From the triangle's two sides as combinations of the two directions. Lengyel, "Mathematics for 3D Game Programming and
/// Computer Graphics", 3rd edition (2012), section 7.8.
fn frame(triangle: &[Point; 3], normal: DVec3) -> [DVec3; 3] {
    let [a, b, c] = triangle;
    let (p, q) = (b.position - a.position, c.position - a.position);
    let (s, t) = (b.uv - a.uv, c.uv - a.uv);
    let area = s.perp_dot(t);
    let tangent = (p * t.y - q * s.y) * area.signum();
    let tangent = (tangent - normal * tangent.dot(normal)).normalize();
    [tangent, normal.cross(tangent) * area.signum(), normal]
}

/// A unit vector as a texel.
#[must_use]
pub fn encoded(n: DVec3) -> Color {
    let [r, g, b] = n.to_array().map(|n| (128.0 + 127.0 * n.clamp(-1.0, 1.0)).round() as u8);
    Color::rgb(r, g, b)
}
