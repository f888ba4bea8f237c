//! What a triangle's corners have, whatever its look: an array of numbers.

use common::{Bounds, IVec2, Vec2, Vec3, Vec4};
use filtering::footprint::Gradients;
use scene::mesh::Paint;
use scene::render::Pass;
use scene::scene::{Shading, Style};
use scene::shader::{AtPixels, AtVertices, Base, Lighting, Placed, Textured};
use shaders::shader::{Fragment, Shader, Varying};

use crate::triangle::Ready;

/// What is interpolated: places for all that some look needs.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Numbers(pub(crate) [f32; 12]);

/// The first of three: a point in the world; or of two: how lit it is, and how bright its highlight.
pub(crate) const POINT: usize = 0;
/// The first of three: the normal there.
pub(crate) const NORMAL: usize = 3;
/// The first of two: texture coordinates.
pub(crate) const UV: usize = 6;
/// The first of four: red, green, blue and alpha.
pub(crate) const COLOR: usize = 8;

impl Varying for Numbers {
    #[inline(always)]
    fn times(self, weight: f32) -> Self {
        Self(self.0.map(|number| number * weight))
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(std::array::from_fn(|n| self.0[n] + other.0[n]))
    }
}

/// How (u, v) change over a triangle, if a filter asks for it.
pub(crate) type Constant = Option<Gradients>;

/// A triangle of any look.
pub(crate) type Triangle = Ready<Constant, Numbers>;

/// A pass as a shader, as far as vertices and triangles go: fragments are shaded elsewhere.
pub(crate) struct Corners<'a> {
    pub(crate) pass: &'a Pass<'a>,
    pub(crate) placed: Placed<'a>,
    pub(crate) style: Style,
    /// The picture's size in pixels.
    pub(crate) size: Vec2,
}

impl Shader for Corners<'_> {
    type Constant = Constant;
    type Varying = Numbers;
    type Output = ();

    #[inline(always)]
    fn position(&self, vertex: usize) -> Vec4 {
        self.pass.to_clip * self.pass.mesh.positions()[vertex].extend(1.0)
    }

    #[inline(always)]
    fn triangle(&self, face: usize) -> Option<Constant> {
        let Self { pass: &Pass { mesh, .. }, style, size, .. } = *self;
        Some(match mesh.paint() {
            Paint::Texture(texture) => {
                let vertices = [0, 1, 2].map(|corner| mesh.vertex(face, corner));
                let textured = Textured { texture, uvs: mesh.uvs(), filter: style.filter, size };
                textured.triangle(vertices, || vertices.map(|vertex| self.position(vertex)))
            }
            Paint::Color(_) | Paint::Colors(_) => None,
        })
    }

    #[inline(always)]
    fn corner(&self, face: usize, corner: usize) -> Numbers {
        let Self { pass: &Pass { mesh, .. }, placed, style, .. } = *self;
        let vertex = mesh.vertex(face, corner);
        let mut numbers = Numbers::default();
        let mut put = |first: usize, more: &[f32]| numbers.0[first..first + more.len()].copy_from_slice(more);
        match mesh.paint() {
            Paint::Color(_) => {}
            Paint::Colors(colors) => {
                let (color, alpha): (Vec3, f32) = (&colors[..]).vertex(vertex);
                put(COLOR, &color.extend(alpha).to_array());
            }
            Paint::Texture(_) => put(UV, &mesh.uvs()[vertex].to_array()),
        }
        match style.shading {
            Shading::Unlit => {}
            Shading::Phong => {
                let (body, highlight) = AtVertices(placed).vertex(vertex);
                put(POINT, &[body, highlight]);
            }
            Shading::BlinnPhong => {
                let (point, normal) = AtPixels(placed).vertex(vertex);
                put(POINT, &point.to_array());
                put(NORMAL, &normal.to_array());
            }
        }
        numbers
    }

    fn fragment(&self, _: Constant, _: Fragment<Numbers>) -> Option<()> {
        None
    }
}

impl Triangle {
    /// The pixels that the box about its corners touches, in a picture of these; empty where `max` is below `min`.
    #[inline(always)]
    pub(crate) fn pixels(&self, picture: Bounds) -> Bounds {
        let [a, b, c] = self.corners.map(IVec2::from_array);
        // Some samples are on a pixel's border, and belong to it although they touch the next one.
        let [low, high]: [IVec2; 2] = [(a.min(b).min(c) - 1) >> 8, a.max(b).max(c) >> 8];
        Bounds { min: low.max(picture.min), max: high.min(picture.max) }
    }
}
