//! Sums of products of sampled functions: the one kernel of all dense assemblies.

use bases::Matrix;
use pulp::{Arch, WithSimd};

/// Rows and columns of the blocks that are summed in registers.
const ROWS: usize = 4;
const COLUMNS: usize = 8;

/// Side of the squares in which a matrix is mirrored.
const SQUARE: usize = 16;

/// `sum += leftᵀ right`: rows of the factors are points of a rule, columns are functions.
pub(crate) fn add_product(sum: &mut Matrix, left: &Matrix, right: &Matrix) {
    add_blocks(sum, left, right, false);
}

/// As [`add_product`] for a product known to be symmetric, of which only the entries on and above the diagonal need be
/// formed; [`mirrored`] completes the sum.
pub(crate) fn add_upper_product(sum: &mut Matrix, left: &Matrix, right: &Matrix) {
    add_blocks(sum, left, right, true);
}

/// The symmetric matrix with the upper triangle of `upper`.
pub(crate) fn mirrored(mut upper: Matrix) -> Matrix {
    mirror(&mut upper);
    upper
}

/// [`mirrored`], in place.
pub(crate) fn mirror(upper: &mut Matrix) {
    let n = upper.rows();
    let entries = upper.as_mut_slice();
    // Square by square: what is read down a column is then still at hand for the next.
    for first in (0..n).step_by(SQUARE) {
        for start in (0..=first).step_by(SQUARE) {
            for i in first..(first + SQUARE).min(n) {
                for j in start..(start + SQUARE).min(i) {
                    entries[i * n + j] = entries[j * n + i];
                }
            }
        }
    }
}

fn add_blocks(sum: &mut Matrix, left: &Matrix, right: &Matrix, upper: bool) {
    assert_eq!(left.rows(), right.rows(), "points of both factors");
    Arch::new().dispatch(Blocks { sum, left, right, upper });
}

/// The sum over blocks of entries held in registers, over factors packed so that they are read in order. Every entry is
/// summed over the points in their order, one product after the other: the same bits whatever the width of the arithmetic.
struct Blocks<'a> {
    sum: &'a mut Matrix,
    left: &'a Matrix,
    right: &'a Matrix,
    upper: bool,
}

impl WithSimd for Blocks<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let Self { sum, left, right, upper } = self;
        let (points, rows, cols) = (left.rows(), left.cols(), right.cols());
        let (left, right) = (packed::<ROWS>(left), packed::<COLUMNS>(right));
        for (bi, a) in left.chunks_exact((ROWS * points).max(1)).enumerate() {
            for (bj, b) in right.chunks_exact((COLUMNS * points).max(1)).enumerate() {
                let (row, column) = (bi * ROWS, bj * COLUMNS);
                if upper && column + COLUMNS <= row {
                    continue;
                }
                let mut block = [[0.0; COLUMNS]; ROWS];
                for (x, y) in a.as_chunks::<ROWS>().0.iter().zip(b.as_chunks::<COLUMNS>().0) {
                    for i in 0..ROWS {
                        for j in 0..COLUMNS {
                            block[i][j] += x[i] * y[j];
                        }
                    }
                }
                for (i, line) in block.iter().enumerate().take(rows - row) {
                    let width = COLUMNS.min(cols - column);
                    let entries = &mut sum.row_mut(row + i)[column..column + width];
                    entries.iter_mut().zip(line).for_each(|(s, b)| *s += b);
                }
            }
        }
    }
}

/// Columns in groups of W, each group point by point, filled up with zeros.
fn packed<const W: usize>(factor: &Matrix) -> Vec<f64> {
    let mut out = Vec::with_capacity(factor.rows() * factor.cols().next_multiple_of(W));
    for group in (0..factor.cols()).step_by(W) {
        for p in 0..factor.rows() {
            let row = &factor.row(p)[group..(group + W).min(factor.cols())];
            out.extend_from_slice(row);
            out.extend(std::iter::repeat_n(0.0, W - row.len()));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_of_every_size_sum_to_the_product() {
        for (points, rows, cols) in [(0, 3, 2), (1, 1, 1), (3, 4, 4), (5, 7, 9), (2, 8, 3)] {
            let left = Matrix::from_fn(points, rows, |p, k| (p + 2 * k) as f64);
            let right = Matrix::from_fn(points, cols, |p, k| (3 * p) as f64 - k as f64);
            let mut sum = Matrix::from_fn(rows, cols, |_, _| 1.0);
            add_product(&mut sum, &left, &right);
            let expected = left.transpose().times(&right);
            for i in 0..rows {
                for j in 0..cols {
                    assert_eq!(sum[(i, j)], 1.0 + expected[(i, j)]);
                }
            }
            let mut square = Matrix::zeros(rows, rows);
            add_upper_product(&mut square, &left, &left);
            assert_eq!(mirrored(square), left.transpose().times(&left));
        }
    }
}
