//! Lesson 4: the nearest surface.
//!
//! **You will see** lesson 3's head, mended: its far side no longer covers its near side. **New:** a depth for
//! each pixel, interpolated from the corners by their barycentric weights, and a test against what is there.
//!
//! The job: draw triangles so that at each pixel the nearest one is seen. [`triangles::fill`] finds the
//! pixels and the weights, [`triangles::flat_intensity`] the brightness.
//!
//! [`METHODS`] holds the painter's way, which sorts whole triangles from far to near, and three depth buffers
//! that differ in what they store.
//!
//! Conventions: x and y in pixels, depth in the model's units; **a larger depth is nearer**, the buffer starts
//! at −∞. Of equal depths the first one drawn stays. A triangle with a corner at an infinite depth, or at NaN,
//! has no plane and is left out.

pub mod depth;
pub mod painter;

use common::{Color, Image, Lesson, Method, Model, Table, Vec2, Vec3};
use triangles::flat_intensity;

pub use depth::{DepthBuffer, depth_at, fill_depths, fill_nearest};
pub use painter::painter;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 4,
    name: "zbuffer",
    title: "Depth",
    job: "the nearest surface",
    tables: &[Table { name: "", job: "Show the nearest surface", rows: || Method::rows(METHODS) }],
};

/// A triangle as it will be seen, in one colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Its corners: x and y in pixels, z the depth.
    pub corners: [Vec3; 3],
    /// Its colour.
    pub color: Color,
}

/// One method.
#[derive(Clone, Copy)]
pub struct Visibility {
    /// Draws the surfaces.
    pub draw: fn(&[Surface], &mut Image),
    /// The depths that it leaves behind, as a grey picture of the size of the one given.
    pub depth: Option<fn(&[Surface], &Image) -> Image>,
}

/// The ways to see the nearest surface, from the first idea to the last.
pub const METHODS: &[Method<Visibility>] = &[
    Method {
        name: "painter",
        run: Visibility { draw: painter, depth: None },
        promise: "no memory for depths; right where triangles can be put in order",
        failure: "triangles that cut each other or cover each other in a circle; must see all before it draws",
    },
    Method {
        name: "z16",
        run: Visibility {
            draw: |surfaces, image| drop(z16(surfaces, image)),
            depth: Some(|surfaces, image| z16(surfaces, &mut image.clone()).picture()),
        },
        promise: "any triangles in any order; 2 bytes a pixel",
        failure: "surfaces closer than 1/65534 of the scene's depth are one: the first drawn wins",
    },
    Method {
        name: "z24",
        run: Visibility {
            draw: |surfaces, image| drop(z24(surfaces, image)),
            depth: Some(|surfaces, image| z24(surfaces, &mut image.clone()).picture()),
        },
        promise: "any triangles in any order; 256 times finer than z16",
        failure: "surfaces closer than 1/16777214 of the scene's depth; interpolation in f32 is no finer",
    },
    Method {
        name: "z-f32",
        run: Visibility {
            draw: |surfaces, image| drop(z_f32(surfaces, image)),
            depth: Some(|surfaces, image| z_f32(surfaces, &mut image.clone()).picture()),
        },
        promise: "any triangles in any order; needs no near and far; finest near 0",
        failure: "surfaces closer than f32's rounding, about 10⁻⁷ of their depth",
    },
];

/// Draws with a buffer of real depths.
pub fn z_f32(surfaces: &[Surface], image: &mut Image) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
    draw_nearest(surfaces, image, &mut depths, |depth| depth);
    depths
}

/// Draws with a buffer of 2¹⁶ levels from the scene's farthest depth to its nearest.
pub fn z16(surfaces: &[Surface], image: &mut Image) -> DepthBuffer<u16> {
    let mut depths = DepthBuffer::new(image, 0);
    let level = levels(surfaces, f32::from(u16::MAX));
    draw_nearest(surfaces, image, &mut depths, |depth| level(depth) as u16);
    depths
}

/// Draws with a buffer of 2²⁴ levels from the scene's farthest depth to its nearest.
pub fn z24(surfaces: &[Surface], image: &mut Image) -> DepthBuffer<u32> {
    let mut depths = DepthBuffer::new(image, 0);
    let level = levels(surfaces, ((1 << 24) - 1) as f32);
    draw_nearest(surfaces, image, &mut depths, |depth| level(depth) as u32);
    depths
}

/// The level of a depth, rounded to nearest: 1 for the farthest of the scene, `top` for the nearest. Level 0
/// is left for pixels in which nothing was drawn.
fn levels(surfaces: &[Surface], top: f32) -> impl Fn(f32) -> f32 {
    let depths = || surfaces.iter().flat_map(|surface| surface.corners.map(|corner| corner.z));
    let depths = || depths().filter(|depth| depth.is_finite());
    let far = depths().fold(f32::INFINITY, f32::min);
    let near = depths().fold(f32::NEG_INFINITY, f32::max);
    // A scene without depth has one level.
    let per_depth = if near > far { (top - 1.0) / (near - far) } else { 0.0 };
    move |depth| (1.0 + (depth - far) * per_depth).round().clamp(1.0, top)
}

/// Draws each surface where it is nearer than what was drawn before it.
// ANCHOR: draw_nearest
fn draw_nearest<D: Copy + PartialOrd>(
    surfaces: &[Surface],
    image: &mut Image,
    depths: &mut DepthBuffer<D>,
    store: impl Fn(f32) -> D,
) {
    for Surface { corners, color } in surfaces {
        fill_nearest(*corners, depths, &store, |x, y, _| image.set(x, y, *color));
    }
}
// ANCHOR_END: draw_nearest

/// The triangles of a flat-shaded model in the picture; those that face away from the light are left out.
#[must_use]
pub fn surfaces(model: &Model, light: Vec3, image: &Image) -> Vec<Surface> {
    let lit = model.faces().map(|corners| (corners, flat_intensity(corners, light)));
    lit.filter(|&(_, intensity)| intensity >= 0.0)
        .map(|(corners, intensity)| Surface {
            corners: corners.map(|corner| to_screen(corner, image.size())),
            color: Color::gray(intensity),
        })
        .collect()
}

/// A point of the model in a picture of that size: x and y in pixels as in lesson 3, z as the depth.
#[inline]
#[must_use]
pub fn to_screen(point: Vec3, size: Vec2) -> Vec3 {
    triangles::to_screen(point, size).extend(point.z)
}
