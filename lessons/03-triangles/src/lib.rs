//! Lesson 3: the pixels that a triangle covers.
//!
//! **You will see** three filled triangles; then a model, each of its triangles in a random colour; then the
//! model lit from the front. **New:** barycentric weights, the edge function, and which of two neighbours a
//! pixel on their common side belongs to.
//!
//! The job: call a closure for each pixel that a triangle covers, with the pixel's barycentric weights: how
//! much each corner counts there. This is the seam of the whole course: depth, texture and shading will be
//! closures over [`fill`], which is the last of the methods in [`METHODS`].
//!
//! What the slides hope for: simple, fast, symmetric, independent of the corners' order, no hole between
//! neighbours. Each method has some of these, the last one all.
//!
//! Conventions: coordinates are real numbers of pixels, origin bottom-left, y up. A pixel is covered when its
//! centre, at +½, is inside. A centre exactly on a side is covered if the side is a top or a left one, as
//! seen in the picture, so that it belongs to one of the two triangles at that side. Light points from the
//! surface to the light.

pub mod barycentric;
pub mod edges;
pub mod slides;

use common::direction::{scaled, unit};
use common::{Bounds, Color, Image, Lesson, Method, Model, Table, Vec2, Vec3};

pub use barycentric::barycentric;
pub use edges::fill;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 3,
    name: "triangles",
    title: "Triangles",
    job: "the pixels that a triangle covers",
    tables: &[Table { name: "", job: "Find the pixels of a triangle", rows: || Method::rows(METHODS) }],
};

/// One method as two functions that share their code.
#[derive(Clone, Copy)]
pub struct Triangle {
    /// Colours the triangle's pixels; compiled for just this, it is what gets timed.
    pub draw: fn([Vec2; 3], &mut Image, Color),
    /// Calls `visit(x, y, weights)` for the triangle's pixels in the bounds; tests look at it this way.
    pub visit: Visit,
}

/// Three corners, bounds, and `visit(x, y, weights)`.
pub type Visit = fn([Vec2; 3], Bounds, &mut dyn FnMut(i32, i32, Vec3));

/// Colours pixels of a picture.
fn paint(image: &mut Image, color: Color) -> impl FnMut(i32, i32, Vec3) {
    move |x, y, _| image.set(x, y, color)
}

/// The ways to find a triangle's pixels, from the first idea to the last.
pub const METHODS: &[Method<Triangle>] = &[
    Method {
        name: "outline",
        run: Triangle {
            draw: |corners, image, color| slides::outline(corners, image.bounds(), paint(image, color)),
            visit: |corners, bounds, visit| slides::outline(corners, bounds, visit),
        },
        promise: "the three sides, from corners in whole pixels",
        failure: "leaves the inside out; visits corners twice; pixels of the sides lie up to 1 px outside",
    },
    Method {
        name: "sweep",
        run: Triangle {
            draw: |corners, image, color| slides::sweep(corners, image.bounds(), paint(image, color)),
            visit: |corners, bounds, visit| slides::sweep(corners, bounds, visit),
        },
        promise: "filled, row by row, from corners in whole pixels",
        failure: "neighbours share the pixels of their side; the middle row is visited twice; up to 1 px outside",
    },
    Method {
        name: "barycentric",
        run: Triangle {
            draw: |corners, image, color| barycentric(corners, image.bounds(), paint(image, color)),
            visit: |corners, bounds, visit| barycentric(corners, bounds, visit),
        },
        promise: "right but for pixel centres on or within rounding of a side; real corners",
        failure: "neighbours share centres on their side; holes and doubles far out, nothing beyond 10¹⁹; tests the whole box",
    },
    Method {
        name: "edges",
        run: Triangle {
            draw: |corners, image, color| fill(corners, image.bounds(), paint(image, color)),
            visit: |corners, bounds, visit| fill(corners, bounds, visit),
        },
        promise: "exact for corners rounded to 1/256 px: neighbours leave no hole and share no pixel",
        failure: "corners beyond ±2¹⁶ px take a slower path, triangles with one beyond ±2⁵² px are left out",
    },
];

/// How bright a triangle is under a light, by Lambert's cosine law: the cosine of the angle between its
/// normal and the direction to the light.
///
/// 1 means that it faces the light, 0 that it lies along it, below 0 that it faces away. Corners run
/// counterclockwise seen from outside. `light` has length 1. A triangle without area has intensity 0, one of any
/// size has its own: its sides are scaled first, as the product of two may be no f32.
// ANCHOR: flat_intensity
#[must_use]
pub fn flat_intensity([a, b, c]: [Vec3; 3], light: Vec3) -> f32 {
    let normal = scaled(b - a).cross(scaled(c - a));
    unit(normal).map_or(0.0, |normal| normal.dot(light))
}
// ANCHOR_END: flat_intensity

/// A point of the model in pixels of a picture of that size: x and y from −1 to 1 become 0 to width and height.
// ANCHOR: to_screen
#[must_use]
pub fn to_screen(point: Vec3, size: Vec2) -> Vec2 {
    let half = size / 2.0;
    point.truncate() * half + half
}
// ANCHOR_END: to_screen

/// Draws each triangle of a model in the colour that `color` gives it by its number and corners; one
/// without a colour is left out. The later ones cover the earlier ones: what is far may hide what is near.
// ANCHOR: draw_model
pub fn draw_model(
    model: &Model,
    method: &Triangle,
    image: &mut Image,
    color: impl Fn(usize, [Vec3; 3]) -> Option<Color>,
) {
    for (n, corners) in model.faces().enumerate() {
        if let Some(color) = color(n, corners) {
            let screen = corners.map(|corner| to_screen(corner, image.size()));
            (method.draw)(screen, image, color);
        }
    }
}
// ANCHOR_END: draw_model
