//! Three ways to undo a matrix.

use common::{Mat3, Mat4, Method, Vec4};

/// The inverse, or `None` where there is none.
pub type Invert = fn(&Mat4) -> Option<Mat4>;

/// The ways to invert a matrix.
pub const INVERSES: &[Method<Invert>] = &[
    Method {
        name: "cofactors",
        run: cofactors,
        promise: "Cramer's rule: no branches, the same work for every matrix",
        failure: "ill-conditioned matrices: 16 small determinants, each a difference of large products",
    },
    Method {
        name: "elimination",
        run: elimination,
        promise: "Gauss and Jordan with the largest pivot: errors no larger than they must be",
        failure: "slower; ill-conditioned matrices, as any method in f32",
    },
    Method {
        name: "transpose",
        run: |m| Some(rigid(m)),
        promise: "exact but for one product, and nearly free, for a rotation with a move",
        failure: "anything that scales or shears: the result is no inverse, and nothing says so",
    },
];

// ANCHOR: cofactors
/// The inverse by cofactors: the transposed signed minors over the determinant.
#[must_use]
pub fn cofactors(m: &Mat4) -> Option<Mat4> {
    let minor = |column: usize, row: usize| determinant(Mat3::from_mat4_minor(*m, column, row));
    let sign = |n: usize| if n.is_multiple_of(2) { 1.0 } else { -1.0 };
    let mut adjugate = Mat4::ZERO;
    for column in 0..4 {
        for row in 0..4 {
            adjugate.col_mut(row)[column] = sign(column + row) * minor(column, row);
        }
    }
    // Along the first column: its elements times their cofactors, which are the adjugate's first row.
    let det = m.x_axis.dot(adjugate.row(0));
    let inverse = adjugate * (1.0 / det);
    inverse.is_finite().then_some(inverse)
}
// ANCHOR_END: cofactors

/// The determinant of a 3×3 matrix: the volume that its columns span.
fn determinant(m: Mat3) -> f32 {
    m.x_axis.dot(m.y_axis.cross(m.z_axis))
}

// ANCHOR: elimination
/// The inverse by elimination: what turns M into the identity turns the identity into M⁻¹.
#[must_use]
pub fn elimination(m: &Mat4) -> Option<Mat4> {
    let mut left: [Vec4; 4] = std::array::from_fn(|row| m.row(row));
    let mut right: [Vec4; 4] = std::array::from_fn(|row| Mat4::IDENTITY.row(row));
    for column in 0..4 {
        // With the largest pivot, no more than 1 times the pivot's row, as it was, is subtracted from a row below it, so
        // that rounding errors do not grow there.
        let pivot = (column..4).max_by(|&a, &b| left[a][column].abs().total_cmp(&left[b][column].abs()))?;
        left.swap(column, pivot);
        right.swap(column, pivot);
        let factor = 1.0 / left[column][column];
        left[column] *= factor;
        right[column] *= factor;
        for row in (0..4).filter(|&row| row != column) {
            let factor = left[row][column];
            left[row] -= factor * left[column];
            right[row] -= factor * right[column];
        }
    }
    let inverse = Mat4::from_cols(right[0], right[1], right[2], right[3]).transpose();
    inverse.is_finite().then_some(inverse)
}
// ANCHOR_END: elimination

// ANCHOR: rigid
/// The inverse of a rotation followed by a move: Rᵀ·(p − t).
#[must_use]
pub fn rigid(m: &Mat4) -> Mat4 {
    let back = Mat3::from_mat4(*m).transpose();
    let mut inverse = Mat4::from_mat3(back);
    inverse.w_axis = (-(back * m.w_axis.truncate())).extend(1.0);
    inverse
}
// ANCHOR_END: rigid
