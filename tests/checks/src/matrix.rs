//! Matrices of 4×4 whole numbers, and their inverse without any rounding.

use common::Mat4;

/// Rows of whole numbers.
pub type Whole = [[i128; 4]; 4];

/// The inverse as a matrix over a common denominator, or `None` where the determinant is 0.
///
/// By Leibniz's formula, a sum over all orders of the columns; entries up to 2²⁸ are safe.
#[must_use]
pub fn inverse(m: &Whole) -> Option<(Whole, i128)> {
    let determinant = leibniz(m);
    // By Cramer's rule: entry (i, j) is the determinant with column i replaced by the unit vector j.
    let entry = |i: usize, j: usize| {
        let mut replaced = *m;
        (0..4).for_each(|row| replaced[row][i] = i128::from(row == j));
        leibniz(&replaced)
    };
    let adjugate = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    (determinant != 0).then_some((adjugate, determinant))
}

/// The determinant: over all orders of the columns, the signed product of the entries.
fn leibniz(m: &Whole) -> i128 {
    let mut sum = 0;
    for order in (0..256).map(|n| [n >> 6, n >> 4 & 3, n >> 2 & 3, n & 3]) {
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        if pairs.iter().all(|&(i, j)| order[i] != order[j]) {
            let inversions = pairs.iter().filter(|&&(i, j)| order[i] > order[j]).count();
            let product: i128 = (0..4).map(|row| m[row][order[row]]).product();
            sum += if inversions % 2 == 0 { product } else { -product };
        }
    }
    sum
}

/// The largest error of an entry of `got`, as a share of the largest entry of the exact inverse.
#[must_use]
pub fn error(got: &Mat4, (adjugate, determinant): &(Whole, i128)) -> f64 {
    let exact = |row: usize, column: usize| adjugate[row][column] as f64 / *determinant as f64;
    let places = || (0..4).flat_map(|row| (0..4).map(move |column| (row, column)));
    let size = places().map(|(row, column)| exact(row, column).abs()).fold(0.0, f64::max);
    let off = places().map(|(row, column)| (f64::from(got.row(row)[column]) - exact(row, column)).abs());
    // Unlike `f64::max` this keeps a NaN.
    off.fold(0.0, |worst: f64, off| if off <= worst { worst } else { off }) / size
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inverse_times_its_matrix_is_the_identity() {
        let m = [[2, 0, 1, 5], [0, 3, -1, 7], [4, 1, 1, 0], [0, 0, 2, 1]];
        let (adjugate, determinant) = inverse(&m).unwrap();
        for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
            let sum: i128 = (0..4).map(|k| adjugate[i][k] * m[k][j]).sum();
            assert_eq!(sum, if i == j { determinant } else { 0 });
        }
        assert_eq!(inverse(&[[1, 2, 3, 4]; 4]), None);
    }
}
