//! What mission 7 gives: two matrices. Nothing of lesson 7 is in it, so that the program in which a submission runs has nothing of
//! it either.

use common::{Mat4, Vec3};

/// Moves points by a vector.
#[must_use]
pub fn translate(by: Vec3) -> Mat4 {
    Mat4::from_cols(Vec3::X.extend(0.0), Vec3::Y.extend(0.0), Vec3::Z.extend(0.0), by.extend(1.0))
}

/// Stretches along the axes, the origin staying where it is.
#[must_use]
pub fn scale(by: Vec3) -> Mat4 {
    Mat4::from_diagonal(by.extend(1.0))
}
