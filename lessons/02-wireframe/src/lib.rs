//! Lesson 2: a model's edges.
//!
//! **You will see** a head of 5,888 triangles as if it were bent from wire. **New:** a model is a list of
//! points and a list of triangles that share them; and points in space become pixels.
//!
//! The job: draw the sides of every triangle. From lesson 1 comes [`lines::line`]. Nothing is hidden yet, and
//! z is dropped: this is a parallel projection along the z axis.
//!
//! [`METHODS`] holds two ways. Both draw the same pixels, since a line is the same from either end; the
//! second draws each line once.
//!
//! Conventions: the model fits in [−1, 1]³, x to the right and y up; the picture's origin is bottom-left.

use common::{Color, IVec2, Image, Lesson, Method, Model, Table, Vec3};
use lines::line;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 2,
    name: "wireframe",
    title: "Wireframe",
    job: "a model's edges",
    tables: &[Table { name: "", job: "Draw a model's edges", rows: || Method::rows(METHODS) }],
};

/// One method as two functions that share their code.
#[derive(Clone, Copy)]
pub struct Wireframe {
    /// Draws a model's edges into a picture, in one colour.
    pub draw: fn(&Model, &mut Image, Color),
    /// Calls `visit` for each line that is drawn, with its ends as indices into the model's positions; tests
    /// look at it this way.
    pub visit: fn(&Model, &mut dyn FnMut([u32; 2])),
}

/// The ways to draw a model's edges.
pub const METHODS: &[Method<Wireframe>] = &[
    Method {
        name: "three-per-triangle",
        run: Wireframe {
            draw: |model, image, color| {
                three_per_triangle(model, |edge| draw_edge(model, edge, image, color));
            },
            visit: |model, visit| three_per_triangle(model, visit),
        },
        promise: "every side of every triangle; no memory",
        failure: "draws an edge once for each triangle at it: twice the work on a closed surface",
    },
    Method {
        name: "unique-edges",
        run: Wireframe {
            draw: |model, image, color| unique_edges(model, |edge| draw_edge(model, edge, image, color)),
            visit: |model, visit| unique_edges(model, visit),
        },
        promise: "every edge once; the same pixels",
        failure: "needs 24 bytes a triangle and a sort",
    },
];

/// Visits the three sides of each triangle, and the model's lines.
// ANCHOR: three_per_triangle
pub fn three_per_triangle(model: &Model, mut visit: impl FnMut([u32; 2])) {
    for &[a, b, c] in model.triangles() {
        [[a, b], [b, c], [c, a]].into_iter().for_each(&mut visit);
    }
    model.lines().iter().copied().for_each(visit);
}
// ANCHOR_END: three_per_triangle

/// Visits each edge of the model once.
pub fn unique_edges(model: &Model, visit: impl FnMut([u32; 2])) {
    edges(model).into_iter().for_each(visit);
}

/// Draws each edge of the model once.
// ANCHOR: wireframe
pub fn wireframe(model: &Model, image: &mut Image, color: Color) {
    unique_edges(model, |edge| draw_edge(model, edge, image, color));
}

fn draw_edge(model: &Model, edge: [u32; 2], image: &mut Image, color: Color) {
    let [from, to] = edge.map(|i| to_pixel(model.positions()[i as usize], image));
    line(from, to, image, color);
}
// ANCHOR_END: wireframe

/// The model's edges and lines, each once, as two indices into its positions, the smaller first; sorted.
// ANCHOR: edges
#[must_use]
pub fn edges(model: &Model) -> Vec<[u32; 2]> {
    let sides = model.triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let all = sides.chain(model.lines().iter().copied());
    let mut edges: Vec<[u32; 2]> = all.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}
// ANCHOR_END: edges

/// The pixel in which a point of the model lies: x from −1 to 1 becomes a column from 0 to width − 1.
///
/// The column is ⌊(x + 1)·width/2⌋. Exactly at x = 1 that is `width`, one too many; the right border belongs
/// to the last column. y likewise. What lies beyond ±1 lies beyond the picture. In f64: in pictures of up to
/// 16384 px no rounding leads to another pixel, but that x from −2⁻⁵⁴ up counts as 0.
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
