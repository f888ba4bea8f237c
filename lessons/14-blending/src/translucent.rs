//! Surfaces that let light through: the alpha of a whole entity, times that of its vertices.

use common::{Color, Vec4};
use shaders::shader::{Fragment, Shader, Varying};

/// Any shader's colours, with less alpha.
pub struct Translucent<S, A = ()> {
    /// What makes the colours.
    pub shader: S,
    /// The alpha of the whole entity, from 0 to 1.
    pub alpha: f32,
    /// The alphas at the corners, from 0 to 1, where there are any.
    pub vertices: A,
}

/// Alphas at the corners of triangles, or none, for `()`, which are not interpolated.
pub trait VertexAlphas {
    /// What is interpolated.
    type Varying: Varying;
    /// At a corner of a triangle.
    fn corner(&self, face: usize, corner: usize) -> Self::Varying;
    /// At a pixel.
    fn alpha(varying: Self::Varying) -> f32;
}

impl VertexAlphas for () {
    type Varying = ();

    #[inline]
    fn corner(&self, _: usize, _: usize) {}

    #[inline]
    fn alpha((): ()) -> f32 {
        1.0
    }
}

/// Three for each triangle.
impl VertexAlphas for &[[f32; 3]] {
    type Varying = f32;

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> f32 {
        self[face][corner]
    }

    #[inline]
    fn alpha(varying: f32) -> f32 {
        varying
    }
}

// ANCHOR: translucent
impl<S: Shader<Output = Color>, A: VertexAlphas> Shader for Translucent<S, A> {
    type Constant = S::Constant;
    type Varying = (S::Varying, A::Varying);
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        self.shader.position(vertex)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<S::Constant> {
        self.shader.triangle(face)
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        (self.shader.corner(face, corner), self.vertices.corner(face, corner))
    }

    #[inline]
    fn fragment(&self, constant: S::Constant, fragment: Fragment<Self::Varying>) -> Option<Color> {
        let Fragment { x, y, depth, varying: (varying, alpha) } = fragment;
        let color = self.shader.fragment(constant, Fragment { x, y, depth, varying })?;
        Some(faded(color, self.alpha * A::alpha(alpha)))
    }
}

/// A colour with that share of its alpha, rounded to nearest. A half is rounded down: half of 255 is 127, as in the
/// assignment's version 8. What is above 1 counts as 1, what is below 0, or NaN, as 0.
#[inline]
#[must_use]
pub fn faded(color: Color, share: f32) -> Color {
    // What is taken away is rounded up; a cast clamps.
    let share = share.max(0.0);
    let taken = (f32::from(color.a) * (1.0 - share) + 0.5) as u8;
    Color { a: color.a - taken.min(color.a), ..color }
}
// ANCHOR_END: translucent
