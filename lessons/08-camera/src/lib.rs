//! Lesson 8: looking at a point.
//!
//! **You will see** lesson 7's head from the right and from above. **New:** a change of basis, which brings the
//! world in front of the eye instead of moving the eye.
//!
//! The job: given the eye, the point in the middle of the picture, and what is up, build the view matrix.
//! [`METHODS`] holds the slides' listing, which is wrong but for a centre at the origin, the right matrix, and one for
//! centres far away.
//!
//! The eye's basis: z' points from the centre to the eye, x' is at right angles to up and z', y' to both. A
//! point P has the coordinates (x'·(P − C), y'·(P − C), z'·(P − C)) in it: subtract the centre, then multiply
//! by the matrix whose **rows** are the basis, which is the inverse of the one whose columns they are.
//!
//! Conventions: the view's origin is the **centre**, so the eye stands at (0, 0, D), with D the distance from
//! eye to centre, and [`transforms::projection`] of D follows. Light and normals stay in world space.

pub mod flags;
pub mod turntable;

use common::direction::unit;
use common::{Lesson, Mat3, Mat4, Method, Table, Vec3};
use transforms::translate;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 8,
    name: "camera",
    title: "The camera",
    job: "looking at a point",
    tables: &[Table { name: "", job: "Look at a point", rows: || Method::rows(METHODS) }],
};

/// How the world comes before an eye: the point that is subtracted from every other, and the matrix for what is
/// left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Subtracted first; the origin where the matrix does all.
    pub origin: Vec3,
    /// Multiplied by what is left of a point.
    pub matrix: Mat4,
}

impl From<Mat4> for View {
    fn from(matrix: Mat4) -> Self {
        Self { origin: Vec3::ZERO, matrix }
    }
}

/// The view of an eye that looks at a centre, given eye, centre and up; `None` where there is no direction from one
/// to the other, as in [`basis`].
pub type Look = fn(Vec3, Vec3, Vec3) -> Option<View>;

/// The ways to look at a point.
pub const METHODS: &[Method<Look>] = &[
    Method {
        name: "listing",
        run: |eye, center, up| listing(eye, center, up).map(View::from),
        promise: "right for a centre at the origin (the slides' version, as printed)",
        failure: "subtracts the centre after turning, unturned: any other centre misses the middle",
    },
    Method {
        name: "lookat",
        run: |eye, center, up| lookat(eye, center, up).map(View::from),
        promise: "right for any centre; any other up where up is along the view",
        failure: "up within an angle θ of the view costs digits: the basis is off by about 10⁻⁷/θ; and so does a centre far away",
    },
    Method {
        name: "relative",
        run: relative,
        promise: "right for any centre, however far from the origin",
        failure: "a subtraction more for each point; up near the view as for lookat",
    },
];

/// The right view matrix: R·(P − C).
// ANCHOR: lookat
#[must_use]
pub fn lookat(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat4> {
    let rows = basis(eye, center, up)?;
    Some(Mat4::from_mat3(rows) * translate(-center))
}
// ANCHOR_END: lookat

/// The same in two steps, so that nothing large is ever rounded: points near the centre lose their common part first,
/// and only what is left is turned. R·P and R·C, whose difference [`lookat`] forms, are as large as the centre is
/// far, and each is rounded. (The field calls it camera-relative rendering.)
// ANCHOR: relative
#[must_use]
pub fn relative(eye: Vec3, center: Vec3, up: Vec3) -> Option<View> {
    let rows = basis(eye, center, up)?;
    Some(View { origin: center, matrix: Mat4::from_mat3(rows) })
}
// ANCHOR_END: relative

/// The slides' view matrix, as printed: R·P − C.
// ANCHOR: listing
#[must_use]
pub fn listing(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat4> {
    let rows = basis(eye, center, up)?;
    Some(translate(-center) * Mat4::from_mat3(rows))
}
// ANCHOR_END: listing

/// The matrix whose rows are the eye's basis. Where up is along the view to within 1e-6, or 0, the world axis
/// farthest from the view stands in for it. `None` where eye and centre are one point, or so far apart that the
/// distance is no f32.
// ANCHOR: basis
#[must_use]
pub fn basis(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat3> {
    let z = unit(eye - center)?;
    let sideways = |up: Vec3| unit(up).unwrap_or_default().cross(z);
    let x = Some(sideways(up)).filter(|x| x.length() > 1e-6).unwrap_or_else(|| sideways(farthest_axis(z)));
    // What is left of an up near the view is rounded, and at right angles to z only nearly: once more.
    let x = x.reject_from_normalized(z).normalize();
    Some(Mat3::from_cols(x, z.cross(x), z).transpose())
}
// ANCHOR_END: basis

// ANCHOR: farthest_axis
/// The axis that makes the largest angle with a direction: y before z before x where they are equal.
fn farthest_axis(direction: Vec3) -> Vec3 {
    let along = |axis: &Vec3| axis.dot(direction).abs();
    [Vec3::Y, Vec3::Z, Vec3::X].into_iter().min_by(|a, b| along(a).total_cmp(&along(b))).unwrap_or(Vec3::Y)
}
// ANCHOR_END: farthest_axis
