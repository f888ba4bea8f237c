//! Triangles in the window, to be filled as often as a method asks.

use clipping::render::triangles;
use clipping::{Clipping, Counts, Cull, Mesh};
use common::{Color, Vec2, Vec4};
use perspective::division::Exact;
use perspective::draw_triangle;
use perspective::interpolation::PerPixel;
use shaders::shader::Shader;
use shaders::target::Target;
use zbuffer::Surface;

use crate::plain;

// ANCHOR: fill
/// A triangle in the window, computed and cut.
pub trait Fill {
    /// The sum of its corners' depths, three times their mean.
    fn depth_sum(&self) -> f32;

    /// Its fragments, to any target.
    fn fill(&self, target: &mut impl Target<Color>);
}

/// In one colour.
impl Fill for Surface {
    fn depth_sum(&self) -> f32 {
        self.corners.iter().map(|corner| corner.z).sum()
    }

    #[inline]
    fn fill(&self, target: &mut impl Target<Color>) {
        plain::draw(std::slice::from_ref(self), target);
    }
}
// ANCHOR_END: fill

// ANCHOR: placed
/// A triangle of a shader, ready to be filled.
pub struct Placed<'a, S: Shader> {
    /// What it looks like.
    pub shader: &'a S,
    /// What the shader's own step for the triangle gave.
    pub constant: S::Constant,
    /// Its corners in the window: x and y in pixels, the depth from 0 to 1, and 1/w.
    pub corners: [Vec4; 3],
    /// What is interpolated between them.
    pub varyings: [S::Varying; 3],
}

impl<S: Shader<Output = Color>> Fill for Placed<'_, S> {
    fn depth_sum(&self) -> f32 {
        self.corners.iter().map(|corner| corner.z).sum()
    }

    #[inline]
    fn fill(&self, target: &mut impl Target<Color>) {
        draw_triangle(self.shader, self.constant, self.corners, self.varyings, PerPixel(Exact), target);
    }
}

/// Adds those triangles of a mesh that are seen in a picture of that size to a list, in their order. What reaches
/// beyond the near plane, the far plane or lesson 11's guard band is cut.
///
/// # Panics
/// Where the mesh has a vertex or a face that the shader has not.
pub fn gather<'a, S: Shader>(
    shader: &'a S,
    mesh: &Mesh,
    cull: Cull,
    size: Vec2,
    list: &mut Vec<Placed<'a, S>>,
) -> Counts {
    triangles(shader, mesh, cull, Clipping::GuardBand, size, |constant, corners, varyings| {
        list.push(Placed { shader, constant, corners, varyings });
    })
}
// ANCHOR_END: placed
