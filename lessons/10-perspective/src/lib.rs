//! Lesson 10: a true camera.
//!
//! **You will see** the head of lesson 9 on a checkered floor that reaches to the horizon, and its squares are straight:
//! lesson 9's floor warped. **New:** the frustum's matrix and the spaces after it; 1/w as a window's fourth coordinate;
//! attributes interpolated in perspective; and what a depth buffer should keep, now that depth is no longer even.
//!
//! The job: draw what a camera sees. [`frustum`](mod@frustum) makes the matrix to clip space, [`window`](mod@window)
//! divides by w and goes to the picture, [`interpolation`] has the ways to interpolate between corners ([`METHODS`]),
//! [`depth`] what is kept of a distance ([`DEPTHS`]), [`division`] how 1/w is computed ([`DIVISIONS`]), and
//! [`render`](mod@render) is the loop. From lesson 8 comes the basis of the view, from lesson 9 the shaders, which are
//! drawn unchanged, from lessons 3 and 4 the pixels and their weights.
//!
//! Conventions, from here on: eye space has its origin **at the eye** and looks along −z. Clip space is −w ≤ x, y, z ≤ w,
//! with w the depth before the eye; NDC are x/w, y/w, z/w from −1 to 1; window space is x and y in pixels, z from 0 on
//! the near plane to 1 on the far one, and 1/w. **A smaller depth is nearer**, the buffer starts at 1, so that nothing
//! beyond the far plane is drawn; of equal depths the first drawn stays. No fragment is dropped for being dark. A
//! triangle that reaches behind the eye is left out whole and counted; lesson 11 cuts it instead.

pub mod depth;
pub mod division;
pub mod flags;
pub mod frustum;
pub mod interpolation;
pub mod lighting;
pub mod render;
pub mod scene;
pub mod target;
pub mod window;

use std::ops::RangeInclusive;

use camera::basis;
use common::{Bounds, Image, Lesson, Mat4, Method, Table, Vec2, Vec3, Vec4};
use shaders::source::Texture;
use shaders::{Lit, Uniforms};
use transforms::translate;
use zbuffer::DepthBuffer;

use depth::{Depth, Logarithmic, ReversedZF32, W, Z24, ZF32};
use division::Exact;
use interpolation::{Affine, Every, Interpolation, PerPixel};
use lighting::Clamped;

pub use division::DIVISIONS;
pub use frustum::{FrustumError, Planes, frustum, perspective};
pub use interpolation::perspective_weights;
pub use render::{draw_triangle, render};
pub use target::Framebuffer;
pub use window::window;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 10,
    name: "perspective",
    title: "Perspective",
    job: "a true camera",
    tables: &[
        Table { name: "", job: "Interpolate in perspective", rows: || Method::rows(METHODS) },
        Table { name: "depths", job: "Keep depths", rows: || Method::rows(DEPTHS) },
        Table { name: "divisions", job: "Divide by w", rows: || Method::rows(DIVISIONS) },
    ],
};

/// The model of the floor, and its texture, which is to be repeated.
pub const FLOOR: [&str; 2] = [
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/floor.obj"),
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/checks.png"),
];

/// From the world to eye space: R·(P − E), with the eye E at the origin (notes, I.1, *From world space to eye space*).
/// Lesson 8's basis, another origin: its own, the centre, lies at (0, 0, −D) now. `None` where eye and centre are one
/// point.
// ANCHOR: view
#[must_use]
pub fn view(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat4> {
    Some(Mat4::from_mat3(basis(eye, center, up)?) * translate(-eye))
}
// ANCHOR_END: view

/// What a drawing leaves behind besides the picture.
pub struct Drawn {
    /// What is kept of the nearest depth in each pixel.
    pub depths: DepthBuffer<f32>,
    /// Whether a larger one of these is nearer.
    pub larger_is_nearer: bool,
    /// How many triangles were left out since they reach behind the eye.
    pub left_out: usize,
}

impl Drawn {
    /// The depths in grey: the nearest is white, where nothing is stays black.
    #[must_use]
    pub fn picture(&self) -> Image {
        let sign = if self.larger_is_nearer { 1.0 } else { -1.0 };
        self.depths.picture_by(|depth| sign * f64::from(depth))
    }
}

/// Draws models, each with its texture and smoothly lit, as a camera with these planes sees them.
pub type Draw = fn(&[Uniforms], Planes, &mut Image) -> Drawn;

// ANCHOR: draw
/// Draws models, interpolated in one way, their depths kept in one way.
pub fn draw<I: Interpolation, D: Depth>(models: &[Uniforms], planes: Planes, image: &mut Image) -> Drawn {
    let mut target = Framebuffer::new(image, D::new(planes));
    let mut left_out = 0;
    for uniforms in models {
        let (vertices, triangles) = (uniforms.model.positions().len(), uniforms.model.triangles());
        let shader = Lit::new(*uniforms, Texture, Clamped);
        left_out += render(&shader, vertices, triangles, I::default(), target.depth, &mut target);
    }
    Drawn { depths: target.depths, larger_is_nearer: D::LARGER_IS_NEARER, left_out }
}
// ANCHOR_END: draw

/// One way to keep depths.
pub struct Keep {
    /// Draws by each way to interpolate.
    draw: [Draw; 4],
    /// What is kept of a distance: see [`depth::kept`].
    pub kept: fn(Planes, f64) -> f32,
    /// The distances that are not told apart from one: see [`depth::alike`].
    pub alike: fn(Planes, f64) -> RangeInclusive<f64>,
    /// Whether the far plane must be finite.
    pub needs_far: bool,
}

impl Keep {
    const fn new<D: Depth>(needs_far: bool) -> Self {
        Self {
            draw: [draw::<Affine, D>, draw::<Every<16>, D>, draw::<Every<8>, D>, draw::<PerPixel, D>],
            kept: depth::kept::<D>,
            alike: depth::alike::<D>,
            needs_far,
        }
    }
}

/// The ways to keep depths.
pub const DEPTHS: &[Method<Keep>] = &[
    Method {
        name: "z24",
        run: Keep::new::<Z24>(false),
        promise: "the window's z in 2²⁴ levels; half of them before twice the near plane",
        failure: "gaps grow as the square of the distance: far away to 6·10⁻⁸ f/n of it, a twentieth where f/n = 10⁶",
    },
    Method {
        name: "z-f32",
        run: Keep::new::<ZF32>(false),
        promise: "the window's z as it is; nothing to convert",
        failure: "no finer than z24 where it matters: floats are fine near 0, and there z never is",
    },
    Method {
        name: "reversed-z-f32",
        run: Keep::new::<ReversedZF32>(false),
        promise: "gaps of at most 2.4·10⁻⁷ of the distance everywhere; needs no far plane, and no division",
        failure: "only if it is computed from 1/w; turned round after z was rounded it is z-f32 again",
    },
    Method {
        name: "logarithmic",
        run: Keep::new::<Logarithmic>(true),
        promise: "equal shares of the distance in equal steps",
        failure: "a logarithm and the depth of a pixel that is not linear; the far plane must be finite",
    },
    Method {
        name: "w",
        run: Keep::new::<W>(false),
        promise: "the distance itself, as fine as an f32; needs neither plane",
        failure: "a division at each pixel, seen or not",
    },
];

/// One way to interpolate.
pub struct Interpolate {
    /// Draws, with depths kept in one way.
    pub draw: fn(&Keep) -> Draw,
    /// Calls `visit(x, y, depth, varying)` for the pixels of a triangle in the window; tests look at it this way.
    pub visit: Visit,
}

/// Corners in the window, what they have, bounds, and `visit(x, y, depth, varying)`.
pub type Visit = fn([Vec4; 3], [Vec2; 3], Bounds, &mut dyn FnMut(i32, i32, f32, Vec2));

/// The ways to interpolate over a triangle in perspective, from the first idea to the last.
pub const METHODS: &[Method<Interpolate>] = &[
    Method {
        name: "affine",
        run: Interpolate {
            draw: |keep| keep.draw[0],
            visit: |corners, varyings, bounds, visit| Affine.fill(corners, varyings, bounds, visit),
        },
        promise: "linear in the picture: right where all corners are equally far",
        failure: "warps, each triangle in its own way: of a side, up to the share (√r − 1)/(√r + 1), r the ratio of its ends' depths",
    },
    Method {
        name: "every-16",
        run: Interpolate {
            draw: |keep| keep.draw[1],
            visit: |corners, varyings, bounds, visit| Every::<16>.fill(corners, varyings, bounds, visit),
        },
        promise: "right at every 16th pixel of a row and its last; a division for 16 pixels, as Quake had it",
        failure: "warps in each 16 pixels where depth changes fast along a row",
    },
    Method {
        name: "every-8",
        run: Interpolate {
            draw: |keep| keep.draw[2],
            visit: |corners, varyings, bounds, visit| Every::<8>.fill(corners, varyings, bounds, visit),
        },
        promise: "right at every 8th pixel of a row and its last; up to 4 times closer than every-16",
        failure: "the same, in each 8 pixels",
    },
    Method {
        name: "per-pixel",
        run: Interpolate {
            draw: |keep| keep.draw[3],
            visit: |corners, varyings, bounds, visit| PerPixel(Exact).fill(corners, varyings, bounds, visit),
        },
        promise: "right at every pixel, to f32's rounding",
        failure: "a division at each pixel that is seen",
    },
];
