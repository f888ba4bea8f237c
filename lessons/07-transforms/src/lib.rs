//! Lesson 7: matrices, viewport and projection.
//!
//! **You will see** lesson 6's head in perspective, from a distance of 2. **New:** a point is placed by a
//! product of matrices; a fourth coordinate w makes moving and projecting products as well.
//!
//! The job: place a model. [`affine`] builds the matrices one by one, [`rotation`] has three ways to turn about
//! an axis, [`inverse`] three ways to undo a matrix, and this file the viewport, the projection, and what
//! happens when many rotations are composed: [`METHODS`]. The lesson's program turns the head by 30° twelve
//! times by one of them, and so back to where it was.
//!
//! Conventions: column vectors, `M * v`, so the rightmost matrix acts first. A point has w = 1, a vector w = 0.
//! The eye is at (0, 0, d) and looks along −z. Matrices are glam's types; the functions are ours.

pub mod affine;
pub mod inverse;
pub mod rotation;

use common::{DMat3, Lesson, Mat3, Mat4, Method, Table, Vec3, Vec4Swizzles};
use rotation::{rodrigues, rodrigues_f64};

pub use affine::{normal_matrix, scale, translate};

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 7,
    name: "transforms",
    title: "Transforms",
    job: "matrices, viewport and projection",
    tables: &[
        Table { name: "", job: "Compose many rotations", rows: || Method::rows(METHODS) },
        Table { name: "rotations", job: "Turn about an axis", rows: || Method::rows(rotation::ROTATIONS) },
        Table { name: "inverses", job: "Undo a matrix", rows: || Method::rows(inverse::INVERSES) },
    ],
};

/// Composes `count` rotations by an angle (in radians) about an axis of length 1.
pub type Compose = fn(Vec3, f32, u32) -> Mat3;

/// The ways to compose many rotations, from the first idea to the last.
pub const METHODS: &[Method<Compose>] = &[
    Method {
        name: "f32",
        run: |axis, angle, count| {
            let step = rodrigues(axis, angle);
            (0..count).fold(Mat3::IDENTITY, |product, _| step * product)
        },
        promise: "9 multiplications and 18 sums a product; right for a few thousand",
        failure: "rounding adds up: after a million, the model has shrunk or grown and is askew",
    },
    Method {
        name: "f32-renormalised",
        run: |axis, angle, count| {
            let step = rodrigues(axis, angle);
            (0..count).fold(Mat3::IDENTITY, |product, _| orthonormal(step * product))
        },
        promise: "always a rotation: no shrinking, no shear",
        failure: "the angle still drifts; three roots a product",
    },
    Method {
        name: "f64",
        run: |axis, angle, count| {
            // An axis of f32 is 1 long to 7 digits only: a million times, that is an error in the second.
            let step = rodrigues_f64(axis.as_dvec3().normalize(), f64::from(angle));
            (0..count).fold(DMat3::IDENTITY, |product, _| step * product).as_mat3()
        },
        promise: "after a million as good as f32 can store",
        failure: "twice the memory; drifts too, a billion times later",
    },
];

// ANCHOR: orthonormal
/// A rotation near to a matrix that is nearly one, by Gram and Schmidt: the first column keeps its direction,
/// the second its plane with the first.
#[must_use]
pub fn orthonormal(m: Mat3) -> Mat3 {
    let x = m.x_axis.normalize();
    let y = (m.y_axis - x * x.dot(m.y_axis)).normalize();
    Mat3::from_cols(x, y, x.cross(y))
}
// ANCHOR_END: orthonormal

/// Stretches [−1, 1]² over a picture of that size in pixels: the middle goes to the middle, and a length of 1
/// becomes `zoom` times the side. With `zoom` ½ the square fills the picture. Depth stays.
// ANCHOR: viewport
#[must_use]
pub fn viewport(width: f32, height: f32, zoom: f32) -> Mat4 {
    translate(Vec3::new(width / 2.0, height / 2.0, 0.0)) * scale(Vec3::new(width * zoom, height * zoom, 1.0))
}
// ANCHOR_END: viewport

/// Projects onto the plane z = 0 as seen from (0, 0, d): by similar triangles x' = x / (1 − z/d), so that
/// w = 1 − z/d. For d = ∞ this is the identity, the parallel projection.
// ANCHOR: projection
#[must_use]
pub fn projection(d: f32) -> Mat4 {
    let mut m = Mat4::IDENTITY;
    m.z_axis.w = -1.0 / d;
    m
}
// ANCHOR_END: projection

/// The place of a point under a matrix, after division by w; `None` at the eye's height and behind it, where
/// w ≤ 1e-6.
// ANCHOR: place
#[inline]
#[must_use]
pub fn place(m: &Mat4, point: Vec3) -> Option<Vec3> {
    let p = *m * point.extend(1.0);
    (p.w > 1e-6).then(|| p.xyz() / p.w)
}
// ANCHOR_END: place
