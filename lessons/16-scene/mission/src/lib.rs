//! Mission 16: a sphere of triangles, and a camera that goes round it.
//!
//! Write the bodies of [`sphere`] and [`orbit`], then see what is right: `cargo run -p my-scene`.
//!
//! What you need:
//!
//! - [`Vertex`]` { position, normal, uv }`, and [`Shape`]` { vertices, triangles }`: a `Vec` of vertices, and for each triangle the
//!   numbers of its three vertices, `[u32; 3]`, counterclockwise as seen from outside. [`cube`] is a shape that is made already.
//! - `Vec3::new(x, y, z)`, `Vec2::new(u, v)`; `angle.sin()`, `angle.cos()` of an `f32` in radians; `std::f32::consts::{PI, TAU}`.
//! - `n as f32` makes a number of a count, `n as u32` one that a triangle may have.
//! - [`translate`]`(by: Vec3) -> Mat4` moves; [`rotate_x`], [`rotate_y`] and [`rotate_z`] take degrees and turn from y to z, from z
//!   to x and from x to y. They give a `Mat3`; `Mat4::from_mat3(turn)` can be multiplied with a `Mat4`. Of a product the rightmost
//!   matrix acts first.

use common::Mat4;

// Given: vertices, shapes and a cube, the matrices, what keys do to a camera, and a loop that draws.
pub use scene_given::{Shape, Vertex, after, cube, draw, rotate_x, rotate_y, rotate_z, translate};

/// A sphere of radius 1 about the origin, of so many rows from pole to pole and so many columns all the way round, at least 2 and
/// 3.
///
/// Its vertices stand in rows from the north pole, (0, 1, 0), to the south pole: row i, from 0 to `latitudes`, at an angle of
/// θ = πi/latitudes from the north. A row has `longitudes` + 1 of them: column j at φ = 2πj/longitudes, where φ = 0 faces +z and
/// grows towards +x. The first and the last are at one place, but have another u: u = j/longitudes, v = 1 − i/latitudes. A pole
/// has a vertex for each column alone, `longitudes` of them, with u = (j + ½)/longitudes.
///
/// Its triangles stand in the same order. Between two rows each column has two of them: (upper left, lower left, lower right)
/// and (upper left, lower right, upper right), as seen from outside. At a pole it has one: (pole, lower left, lower right) in the
/// north, (upper left, pole, upper right) in the south.
#[must_use]
pub fn sphere(latitudes: usize, longitudes: usize) -> Shape {
    let _ = (latitudes, longitudes);
    todo!("the vertices, row by row; then the triangles between each row and the next")
}

/// The matrix of a camera that looks at the origin from a distance: it places the camera in the world, as an entity's matrix
/// places an entity.
///
/// Without turns the camera stands at (0, 0, `distance`) and looks along −z. Angles are in degrees: `elevation`
/// lifts it; `azimuth` then carries it round the y axis, from +z towards +x.
#[must_use]
pub fn orbit(azimuth: f32, elevation: f32, distance: f32) -> Mat4 {
    let _ = (azimuth, elevation, distance);
    todo!("a product of three matrices: away from the origin, up, and round it")
}
