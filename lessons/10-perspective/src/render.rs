//! The loop: vertices to the window, triangles to fragments.

use common::{Vec2, Vec4};
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;

use crate::depth::Depth;
use crate::interpolation::{Interpolation, Pixels};
use crate::window;

/// Draws triangles, whose corners are numbers of vertices from 0 to `vertices` − 1; the shader's positions are in clip
/// space. Returns how many were left out since a corner is at the eye's depth or behind it, where w ≤ 1e-6.
///
/// # Panics
/// Where a triangle has a vertex beyond the last.
// ANCHOR: render
pub fn render<S: Shader + ?Sized>(
    shader: &S,
    vertices: usize,
    triangles: &[[u32; 3]],
    interpolation: impl Interpolation,
    depth: impl Depth,
    target: &mut impl Target<S::Output>,
) -> usize {
    let size = (target.bounds().max + 1).as_vec2();
    let places: Vec<Option<Vec4>> =
        (0..vertices).map(|vertex| place(shader.position(vertex), size, depth)).collect();
    let mut left_out = 0;
    for (face, triangle) in triangles.iter().enumerate() {
        let Some(constant) = shader.triangle(face) else { continue };
        let [Some(a), Some(b), Some(c)] = triangle.map(|vertex| places[vertex as usize]) else {
            left_out += 1;
            continue;
        };
        let varyings = [0, 1, 2].map(|corner| shader.corner(face, corner));
        draw_triangle(shader, constant, [a, b, c], varyings, interpolation, target);
    }
    left_out
}
// ANCHOR_END: render

/// Where a vertex is in the window, with what is to be interpolated in the place of z.
fn place(clip: Vec4, size: Vec2, depth: impl Depth) -> Option<Vec4> {
    window(clip, size).map(|window| window.with_z(depth.corner(window)))
}

// ANCHOR: draw_triangle
/// Draws one triangle. Corners are in the window: x and y in pixels, the depth, which is interpolated linearly in the
/// picture and tested by the target, and 1/w, above 0. `constant` is what the shader's own step for the triangle gave,
/// `varyings` what it gave at the corners.
#[inline]
pub fn draw_triangle<S: Shader + ?Sized>(
    shader: &S,
    constant: S::Constant,
    corners: [Vec4; 3],
    varyings: [S::Varying; 3],
    interpolation: impl Interpolation,
    target: &mut impl Target<S::Output>,
) {
    let bounds = target.bounds();
    interpolation.fill(corners, varyings, bounds, Fragments::new(shader, constant, target));
}

/// A triangle's pixels become fragments of a shader: tested, computed, written.
pub struct Fragments<'a, S: Shader + ?Sized, T> {
    shader: &'a S,
    constant: S::Constant,
    target: &'a mut T,
}

impl<'a, S: Shader + ?Sized, T> Fragments<'a, S, T> {
    /// Of a shader, for a triangle whose own step gave that constant.
    pub fn new(shader: &'a S, constant: S::Constant, target: &'a mut T) -> Self {
        Self { shader, constant, target }
    }
}

impl<S: Shader + ?Sized, T: Target<S::Output>> Pixels<S::Varying> for Fragments<'_, S, T> {
    #[inline]
    fn pixel(&mut self, x: i32, y: i32, depth: f32, varying: impl FnOnce() -> S::Varying) {
        if self.target.test(x, y, depth) {
            let fragment = Fragment { x, y, depth, varying: varying() };
            if let Some(output) = self.shader.fragment(self.constant, fragment) {
                self.target.write(x, y, depth, output);
            }
        }
    }
}
// ANCHOR_END: draw_triangle
