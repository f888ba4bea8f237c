//! What a shader is, and the one loop that draws with any.

use std::cell::RefCell;

use common::{Color, Vec2, Vec3, Vec4, Vec4Swizzles};
use triangles::fill;
use zbuffer::depth_at;

use crate::Target;

// ANCHOR: shader
/// The three steps in which a look is computed. What a shader does not use has the type `()` and costs nothing.
pub trait Shader {
    /// Computed once a triangle.
    type Constant: Copy;
    /// Computed at each corner and interpolated between them.
    type Varying: Varying;

    /// Before anything else of a triangle: what is the same all over it, or `None` to leave it out.
    fn triangle(&self, face: usize) -> Option<Self::Constant>;

    /// At a corner (0, 1 or 2): where it is in the picture (pixels and depth, not yet divided by w), and what
    /// is interpolated.
    fn vertex(&self, face: usize, corner: usize) -> (Vec4, Self::Varying);

    /// At a pixel: its colour, or `None` to leave colour and depth as they are.
    fn fragment(&self, constant: Self::Constant, varying: Self::Varying) -> Option<Color>;
}
// ANCHOR_END: shader

// ANCHOR: varying
/// What can be interpolated: a weighted mean of three.
pub trait Varying: Copy + Default {
    /// The mean of the three corners' values, each with its barycentric weight.
    fn interpolate(corners: [Self; 3], weights: Vec3) -> Self;
}
// ANCHOR_END: varying

// ANCHOR: varying_nothing
impl Varying for () {
    #[inline]
    fn interpolate(_: [(); 3], _: Vec3) {}
}
// ANCHOR_END: varying_nothing

impl Varying for f32 {
    #[inline]
    fn interpolate(corners: [f32; 3], weights: Vec3) -> f32 {
        Vec3::from_array(corners).dot(weights)
    }
}

impl Varying for Vec2 {
    #[inline]
    fn interpolate(corners: [Vec2; 3], weights: Vec3) -> Vec2 {
        textures::interpolate(corners, weights)
    }
}

// ANCHOR: varying_pair
impl<A: Varying, B: Varying> Varying for (A, B) {
    #[inline]
    fn interpolate(corners: [(A, B); 3], weights: Vec3) -> (A, B) {
        (A::interpolate(corners.map(|c| c.0), weights), B::interpolate(corners.map(|c| c.1), weights))
    }
}
// ANCHOR_END: varying_pair

/// Three corners' weights.
impl Varying for Vec3 {
    #[inline]
    fn interpolate([a, b, c]: [Vec3; 3], weights: Vec3) -> Vec3 {
        a * weights.x + b * weights.y + c * weights.z
    }
}

// ANCHOR: program
/// A shader that keeps what it computed for the triangle at hand, as the slides' C++ shaders do. Shaders of
/// all types then look the same from outside, and `dyn Program` is any of them.
pub trait Program {
    /// Takes up a triangle; `false` leaves it out.
    fn triangle(&mut self, face: usize) -> bool;
    /// Takes up one of its corners and says where it is in the picture, not yet divided by w.
    fn vertex(&mut self, face: usize, corner: usize) -> Vec4;
    /// The colour at a pixel with these barycentric weights, or `None` to leave it as it is.
    fn fragment(&self, weights: Vec3) -> Option<Color>;
}
// ANCHOR_END: program

/// A [`Shader`] as a [`Program`].
pub struct Stored<S: Shader> {
    shader: S,
    constant: Option<S::Constant>,
    varyings: [S::Varying; 3],
}

impl<S: Shader> Stored<S> {
    /// With no triangle yet.
    pub fn new(shader: S) -> Self {
        Self { shader, constant: None, varyings: Default::default() }
    }
}

impl<S: Shader> Program for Stored<S> {
    fn triangle(&mut self, face: usize) -> bool {
        self.constant = self.shader.triangle(face);
        self.constant.is_some()
    }

    fn vertex(&mut self, face: usize, corner: usize) -> Vec4 {
        let (position, varying) = self.shader.vertex(face, corner);
        self.varyings[corner] = varying;
        position
    }

    fn fragment(&self, weights: Vec3) -> Option<Color> {
        self.shader.fragment(self.constant?, S::Varying::interpolate(self.varyings, weights))
    }
}

/// Any [`Program`] as a [`Shader`], so that one loop draws with both: it is the weights that are interpolated,
/// each 1 at its own corner.
impl Shader for RefCell<&mut dyn Program> {
    type Constant = ();
    type Varying = Vec3;

    fn triangle(&self, face: usize) -> Option<()> {
        self.borrow_mut().triangle(face).then_some(())
    }

    fn vertex(&self, face: usize, corner: usize) -> (Vec4, Vec3) {
        (self.borrow_mut().vertex(face, corner), Vec3::AXES[corner])
    }

    fn fragment(&self, (): (), weights: Vec3) -> Option<Color> {
        self.borrow().fragment(weights)
    }
}

/// Draws the triangles 0 to `faces` − 1. Returns how many were left out since a corner is at the eye's height
/// or behind it, where w ≤ 1e-6.
// ANCHOR: render
pub fn render<S: Shader>(shader: &S, faces: usize, target: &mut Target) -> usize {
    let mut left_out = 0;
    for face in 0..faces {
        // 1. The triangle's own step, which may reject it before anything is computed for its corners.
        let Some(constant) = shader.triangle(face) else { continue };
        // 2. The corners, and the division by w.
        let (a, b, c) = (shader.vertex(face, 0), shader.vertex(face, 1), shader.vertex(face, 2));
        let (clip, varyings) = ([a.0, b.0, c.0], [a.1, b.1, c.1]);
        if !clip.iter().all(|corner| corner.w > 1e-6) {
            left_out += 1;
            continue;
        }
        let corners = clip.map(|corner| (corner / corner.w).xyz());
        // 3. The pixels: depth test, colour, and only then the new depth. What is the same all over the triangle
        // moves into the closure, where the compiler sees that no pixel changes it.
        let z = Vec3::from_array(corners.map(|corner| corner.z));
        let Target { image, depths } = &mut *target;
        fill(corners.map(Vec3::truncate), depths.bounds(), move |x, y, weights| {
            let depth = depth_at(z, weights);
            if depth > depths.get(x, y)
                && let Some(color) = shader.fragment(constant, S::Varying::interpolate(varyings, weights))
            {
                depths.set(x, y, depth);
                image.set(x, y, color);
            }
        });
    }
    left_out
}
// ANCHOR_END: render
