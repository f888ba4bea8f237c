//! What a shader is, and the one loop that draws with any.

use common::{Vec2, Vec3, Vec4, Vec4Swizzles};
use zbuffer::{fill_depths, to_screen};

use crate::target::Target;

// ANCHOR: shader
/// The four steps in which a look is computed. What a shader does not use has the type `()` and costs nothing.
pub trait Shader {
    /// Computed once a triangle.
    type Constant: Copy;
    /// Computed at each corner and interpolated between them.
    type Varying: Varying;
    /// What it makes of a fragment: a colour, or whatever else a target takes.
    type Output;

    /// At a vertex, which many triangles may share: where it is, in homogeneous coordinates. In which space is up to
    /// whoever draws; for [`render`] the picture is −w ≤ x, y ≤ w, and z/w is the depth.
    fn position(&self, vertex: usize) -> Vec4;

    /// Before anything else of a triangle: what is the same all over it, or `None` to leave it out.
    fn triangle(&self, face: usize) -> Option<Self::Constant>;

    /// At a corner (0, 1 or 2) of a triangle: what is interpolated.
    fn corner(&self, face: usize, corner: usize) -> Self::Varying;

    /// At a pixel: what is seen there, or `None` to leave the target as it is.
    fn fragment(&self, constant: Self::Constant, fragment: Fragment<Self::Varying>) -> Option<Self::Output>;
}

/// What a triangle is at the centre of one of its pixels.
#[derive(Clone, Copy, Debug)]
pub struct Fragment<V> {
    /// The pixel's column.
    pub x: i32,
    /// The pixel's row.
    pub y: i32,
    /// How deep it is there.
    pub depth: f32,
    /// What was interpolated.
    pub varying: V,
}
// ANCHOR_END: shader

// ANCHOR: varying
/// What can be interpolated: whatever can be stretched and added.
pub trait Varying: Copy {
    /// So many times this.
    #[must_use]
    fn times(self, weight: f32) -> Self;

    /// This and another.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// The sum of three corners' values, each times its weight. Weights of 1 in all give a mean.
    #[inline]
    #[must_use]
    fn interpolate([a, b, c]: [Self; 3], weights: Vec3) -> Self {
        a.times(weights.x).plus(b.times(weights.y)).plus(c.times(weights.z))
    }
}
// ANCHOR_END: varying

// ANCHOR: varying_nothing
impl Varying for () {
    #[inline]
    fn times(self, _: f32) {}

    #[inline]
    fn plus(self, (): ()) {}
}
// ANCHOR_END: varying_nothing

impl Varying for f32 {
    #[inline]
    fn times(self, weight: f32) -> f32 {
        self * weight
    }

    #[inline]
    fn plus(self, other: f32) -> f32 {
        self + other
    }
}

impl Varying for Vec2 {
    #[inline]
    fn times(self, weight: f32) -> Vec2 {
        self * weight
    }

    #[inline]
    fn plus(self, other: Vec2) -> Vec2 {
        self + other
    }
}

impl Varying for Vec3 {
    #[inline]
    fn times(self, weight: f32) -> Vec3 {
        self * weight
    }

    #[inline]
    fn plus(self, other: Vec3) -> Vec3 {
        self + other
    }
}

// ANCHOR: varying_pair
impl<A: Varying, B: Varying> Varying for (A, B) {
    #[inline]
    fn times(self, weight: f32) -> (A, B) {
        (self.0.times(weight), self.1.times(weight))
    }

    #[inline]
    fn plus(self, other: (A, B)) -> (A, B) {
        (self.0.plus(other.0), self.1.plus(other.1))
    }
}
// ANCHOR_END: varying_pair

/// Draws triangles, whose corners are numbers of vertices from 0 to `vertices` − 1. Returns how many were left out
/// since a corner is at the eye's height or behind it, where w ≤ 1e-6.
///
/// # Panics
/// Where a triangle has a vertex beyond the last.
// ANCHOR: render
pub fn render<S: Shader + ?Sized>(
    shader: &S,
    vertices: usize,
    triangles: &[[u32; 3]],
    target: &mut impl Target<S::Output>,
) -> usize {
    // 1. The vertices, each once: the division by w, and the place in the picture.
    let bounds = target.bounds();
    let size = (bounds.max + 1).as_vec2();
    let place = |p: Vec4| (p.w > 1e-6).then(|| to_screen(p.xyz() / p.w, size));
    let places: Vec<Option<Vec3>> = (0..vertices).map(|vertex| place(shader.position(vertex))).collect();
    let mut left_out = 0;
    for (face, triangle) in triangles.iter().enumerate() {
        // 2. The triangle's own step, which may reject it before anything else is computed.
        let Some(constant) = shader.triangle(face) else { continue };
        let [Some(a), Some(b), Some(c)] = triangle.map(|vertex| places[vertex as usize]) else {
            left_out += 1;
            continue;
        };
        // 3. The corners.
        let varyings = [shader.corner(face, 0), shader.corner(face, 1), shader.corner(face, 2)];
        // 4. The pixels: the test, what is seen, and only then the writing. What is the same all over the triangle
        // moves into the closure, where the compiler sees that no pixel changes it.
        let target = &mut *target;
        fill_depths([a, b, c], bounds, move |x, y, depth, weights| {
            if target.test(x, y, depth) {
                let varying = S::Varying::interpolate(varyings, weights);
                if let Some(output) = shader.fragment(constant, Fragment { x, y, depth, varying }) {
                    target.write(x, y, depth, output);
                }
            }
        });
    }
    left_out
}
// ANCHOR_END: render
