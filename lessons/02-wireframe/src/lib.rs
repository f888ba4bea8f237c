//! Lesson 2: a model's edges.
//!
//! **You will see** a model of 5,000 triangles as if it were bent from wire. **New:** a model is a list of
//! points and a list of triangles that share them; and points in space become pixels.
//!
//! The job: draw the sides of every triangle. From lesson 1 comes [`lines::line`]. Nothing is hidden yet, and
//! z is dropped: this is a parallel projection along the z axis.
//!
//! [`METHODS`] holds two ways. Both draw the same pixels, since a line is the same from either end; the
//! second draws each line once.
//!
//! Conventions: the model fits in [−1, 1]³, x to the right and y up; the picture's origin is bottom-left.

use common::{Color, IVec2, Image, Method, Model, Vec3};
use lines::line;

/// Draws a model's edges into a picture, in one colour.
pub type Draw = fn(&Model, &mut Image, Color);

/// The ways to draw a model's edges.
pub const METHODS: &[Method<Draw>] = &[
    Method {
        name: "three-per-triangle",
        run: three_per_triangle,
        promise: "every side of every triangle; no memory",
        failure: "draws an edge once for each triangle at it: twice the work on a closed surface",
    },
    Method {
        name: "unique-edges",
        run: wireframe,
        promise: "every edge once; the same pixels",
        failure: "needs 24 bytes a triangle and a sort",
    },
];

/// Draws three lines for each triangle.
// ANCHOR: three_per_triangle
pub fn three_per_triangle(model: &Model, image: &mut Image, color: Color) {
    for corners in model.faces() {
        let [a, b, c] = corners.map(|corner| to_pixel(corner, image));
        for (from, to) in [(a, b), (b, c), (c, a)] {
            line(from, to, image, color);
        }
    }
}
// ANCHOR_END: three_per_triangle

/// Draws each edge of the model once.
// ANCHOR: wireframe
pub fn wireframe(model: &Model, image: &mut Image, color: Color) {
    for edge in edges(model) {
        let [from, to] = edge.map(|i| to_pixel(model.positions()[i as usize], image));
        line(from, to, image, color);
    }
}
// ANCHOR_END: wireframe

/// The model's edges, each once, as two indices into its positions, the smaller first; sorted.
// ANCHOR: edges
#[must_use]
pub fn edges(model: &Model) -> Vec<[u32; 2]> {
    let sides = model.triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}
// ANCHOR_END: edges

/// The pixel in which a point of the model lies: x from −1 to 1 becomes a column from 0 to width − 1.
///
/// The column is ⌊(x + 1)·width/2⌋. Exactly at x = 1 that is `width`, one too many; the right border belongs
/// to the last column. y likewise. What lies beyond ±1 lies beyond the picture. In f64, where no x + 1 is
/// rounded up to the next pixel (but for |x| below 2⁻³⁰, where a pixel's border is as good as either side).
// ANCHOR: to_pixel
#[must_use]
pub fn to_pixel(point: Vec3, image: &Image) -> IVec2 {
    let pixel = |coordinate: f32, size: i32| {
        let exact = (f64::from(coordinate) + 1.0) * f64::from(size) / 2.0;
        if coordinate == 1.0 { size - 1 } else { exact.floor() as i32 }
    };
    IVec2::new(pixel(point.x, image.width()), pixel(point.y, image.height()))
}
// ANCHOR_END: to_pixel
