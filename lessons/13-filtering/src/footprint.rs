//! How much of a texture a pixel sees.
//!
//! A pixel is a square of the picture. What is seen in it of a texture is, to first order, a parallelogram: its sides are
//! how far (u, v) move from the pixel's centre to the next one on the right, and to the one above, ∂(u, v)/∂x and
//! ∂(u, v)/∂y.
//!
//! **Exact derivatives.** As lesson 11's `homogeneous` has it, for a triangle whose corners (x, y, w) in homogeneous pixels
//! are the columns of a matrix M, c = M⁻¹·(X, Y, 1) are the weights on the triangle in space, divided by w, of what is
//! seen at the pixel (X, Y). So 1/w = Σcᵢ, u/w = Σuᵢcᵢ and v/w = Σvᵢcᵢ are linear functions of X and Y, also where a corner
//! is behind the eye and the triangle is cut: nine numbers a triangle. And u = (u/w)/(1/w), so
//! ∂u/∂x = (∂(u/w)/∂x − u·∂(1/w)/∂x) / (1/w). Only a quotient of these is asked for, so that a common factor, such as 1/det M,
//! may be left out, and of u/w and v/w only the derivatives are needed (P. Heckbert, *Fundamentals of texture mapping and
//! image warping*, 1989, has the same of a plane). Graphics interfaces let hardware take differences between the pixels of
//! a 2×2 square instead (Vulkan 1.3, *Derivative Operations*).

use common::{DVec2, DVec3, Vec2, Vec4};

/// How far (u, v) move from a pixel to its neighbours; a texture is 1 wide and 1 high.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Footprint {
    /// To the next one on the right.
    pub x: Vec2,
    /// To the one above.
    pub y: Vec2,
}

/// The long and the short axis of a footprint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// The direction of the long one, of length 1.
    pub direction: Vec2,
    /// Its length.
    pub major: f32,
    /// The length of the short one.
    pub minor: f32,
}

/// The level of a texture of that size, in texels, whose texels are as large as the footprint is long: the logarithm to the
/// base 2 of the longer of its two sides, in texels. 0 where a pixel moves by one texel, negative where the texture is
/// enlarged, −∞ where it stands still. (Vulkan 1.3, *Scale Factor Operation* and *Level-of-Detail Operation*.)
// ANCHOR: level
#[inline]
#[must_use]
pub fn level(footprint: Footprint, size: Vec2) -> f32 {
    level_of(footprint.longer_squared(size))
}

/// The same from the square of the longer side in texels: half its logarithm, and no root. libm's is the same on every
/// platform.
#[inline]
pub(crate) fn level_of(longer_squared: f32) -> f32 {
    0.5 * libm::log2f(longer_squared)
}
// ANCHOR_END: level

impl Footprint {
    /// The same of a texture of that size, in texels.
    #[inline]
    #[must_use]
    pub fn texels(self, size: Vec2) -> Self {
        Self { x: self.x * size, y: self.y * size }
    }

    // ANCHOR: longer_squared
    /// The square of the longer side, in texels of a texture of that size.
    #[inline]
    #[must_use]
    pub fn longer_squared(self, size: Vec2) -> f32 {
        let Self { x, y } = self.texels(size);
        x.length_squared().max(y.length_squared())
    }
    // ANCHOR_END: longer_squared

    /// The axes of the ellipse into which the footprint's two sides, as the columns of a matrix J, take the circle of
    /// diameter 1: lengths are J's singular values, the roots of the eigenvalues of J·Jᵀ, and the direction is the
    /// eigenvector of the larger one.
    ///
    /// The two sides themselves will not do: of a floor seen with the head tilted, both are long and nearly parallel.
    // ANCHOR: axes
    #[inline]
    #[must_use]
    pub fn axes(self) -> Axes {
        let Self { x, y } = self;
        let (across, up) = (x.x * x.x + y.x * y.x, x.y * x.y + y.y * y.y);
        let mixed = x.x * x.y + y.x * y.y;
        let half = (across - up) / 2.0;
        let root = (half * half + mixed * mixed).sqrt();
        let major = ((across + up) / 2.0 + root).sqrt();
        // Of two forms of the eigenvector that in which nothing cancels; a circle has no direction, and any will do.
        let along = if half >= 0.0 { Vec2::new(half + root, mixed) } else { Vec2::new(mixed, root - half) };
        let direction = along.try_normalize().unwrap_or(Vec2::X);
        // The product of the two is the determinant, the parallelogram's area.
        Axes { direction, major, minor: if major > 0.0 { x.perp_dot(y).abs() / major } else { 0.0 } }
    }
    // ANCHOR_END: axes
}

/// How u and v change over a triangle in the picture: what must be known of it for all its footprints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradients {
    /// 1/w, but for a factor that all here have: its coefficients for X, Y and 1, in pixels.
    pub inverse_w: DVec3,
    /// Those of u/w for X and Y.
    pub u: DVec2,
    /// Those of v/w for X and Y.
    pub v: DVec2,
}

// ANCHOR: gradients
impl Gradients {
    /// Of a triangle with these corners in clip space, in a picture of that size in pixels. Any corners will do, behind the
    /// eye too; of a triangle that is seen edge-on there are no footprints.
    #[must_use]
    pub fn new(corners: [Vec4; 3], uvs: [Vec2; 3], size: Vec2) -> Self {
        // Pixels times w: at x = −w is the picture's left border, at x = w its right one.
        let [a, b, c] = corners.map(|corner| {
            let corner = corner.as_dvec4();
            let half = size.as_dvec2() / 2.0;
            DVec3::new((corner.x + corner.w) * half.x, (corner.y + corner.w) * half.y, corner.w)
        });
        // The rows of M's adjugate, its inverse times the determinant.
        let rows = [b.cross(c), c.cross(a), a.cross(b)];
        let sum = |weights: DVec3| rows[0] * weights.x + rows[1] * weights.y + rows[2] * weights.z;
        let [u, v] = [0, 1].map(|axis| DVec3::from_array(uvs.map(|uv| uv[axis].into())));
        Self { inverse_w: sum(DVec3::ONE), u: sum(u).truncate(), v: sum(v).truncate() }
    }

    /// The footprint of the pixel (x, y), at whose centre (u, v) are these.
    #[inline]
    #[must_use]
    pub fn footprint(&self, x: i32, y: i32, uv: Vec2) -> Footprint {
        let &Self { inverse_w, u, v } = self;
        let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let w = 1.0 / (inverse_w.x * x + inverse_w.y * y + inverse_w.z);
        let (slope, uv) = (inverse_w.truncate(), uv.as_dvec2());
        let [along_u, along_v] = [(u - slope * uv.x) * w, (v - slope * uv.y) * w];
        Footprint {
            x: DVec2::new(along_u.x, along_v.x).as_vec2(),
            y: DVec2::new(along_u.y, along_v.y).as_vec2(),
        }
    }
}
// ANCHOR_END: gradients

/// What a filter asks for at each pixel besides (u, v): nothing, `()`, or its [`Footprint`]. What it does not ask for is
/// computed for no triangle and no pixel.
// ANCHOR: asked
pub trait Asked: Copy {
    /// What must be known of a triangle.
    type Constant: Copy;

    /// Once a triangle: what must be known of it, of its gradients if need be.
    fn triangle(gradients: impl FnOnce() -> Gradients) -> Self::Constant;

    /// At the pixel (x, y), at whose centre (u, v) are these.
    fn at(constant: Self::Constant, x: i32, y: i32, uv: Vec2) -> Self;

    /// Where the footprint is known.
    fn of(footprint: Footprint) -> Self;
}

impl Asked for () {
    type Constant = ();

    #[inline]
    fn triangle(_: impl FnOnce() -> Gradients) {}

    #[inline]
    fn at((): (), _: i32, _: i32, _: Vec2) {}

    #[inline]
    fn of(_: Footprint) {}
}

impl Asked for Footprint {
    type Constant = Gradients;

    #[inline]
    fn triangle(gradients: impl FnOnce() -> Gradients) -> Gradients {
        gradients()
    }

    #[inline]
    fn at(gradients: Gradients, x: i32, y: i32, uv: Vec2) -> Self {
        gradients.footprint(x, y, uv)
    }

    #[inline]
    fn of(footprint: Footprint) -> Self {
        footprint
    }
}
// ANCHOR_END: asked
