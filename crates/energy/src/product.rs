//! Sums of products of sampled functions: the one kernel of all dense assemblies.

use bases::Matrix;

const BLOCK: usize = 4;

/// `sum += leftᵀ right`: rows of the factors are points of a rule, columns are functions.
pub(crate) fn add_product(sum: &mut Matrix, left: &Matrix, right: &Matrix) {
    add_blocks(sum, left, right, |_, _| true);
}

/// As [`add_product`] for a product known to be symmetric, of which only the entries on and above the diagonal are
/// formed; [`mirrored`] completes the sum.
pub(crate) fn add_upper_product(sum: &mut Matrix, left: &Matrix, right: &Matrix) {
    add_blocks(sum, left, right, |i, j| i <= j);
}

/// The symmetric matrix with the upper triangle of `upper`.
pub(crate) fn mirrored(mut upper: Matrix) -> Matrix {
    for i in 0..upper.rows() {
        for j in 0..i {
            upper[(i, j)] = upper[(j, i)];
        }
    }
    upper
}

/// Blocks of 4 × 4 entries are summed in registers, over factors packed so that they are read in order.
fn add_blocks(sum: &mut Matrix, left: &Matrix, right: &Matrix, wanted: impl Fn(usize, usize) -> bool) {
    assert_eq!(left.rows(), right.rows(), "points of both factors");
    let (points, rows, cols) = (left.rows(), left.cols(), right.cols());
    let (left, right) = (packed(left), packed(right));
    for (bi, a) in left.chunks_exact((BLOCK * points).max(1)).enumerate() {
        for (bj, b) in right.chunks_exact((BLOCK * points).max(1)).enumerate() {
            if !wanted(bi, bj) {
                continue;
            }
            let mut block = [[0.0; BLOCK]; BLOCK];
            for (x, y) in a.chunks_exact(BLOCK).zip(b.chunks_exact(BLOCK)) {
                for i in 0..BLOCK {
                    for j in 0..BLOCK {
                        block[i][j] += x[i] * y[j];
                    }
                }
            }
            for i in 0..BLOCK.min(rows - bi * BLOCK) {
                for j in 0..BLOCK.min(cols - bj * BLOCK) {
                    sum[(bi * BLOCK + i, bj * BLOCK + j)] += block[i][j];
                }
            }
        }
    }
}

/// Columns in groups of four, each group point by point, filled up with zeros.
fn packed(factor: &Matrix) -> Vec<f64> {
    let mut out = Vec::with_capacity(factor.rows() * factor.cols().next_multiple_of(BLOCK));
    for group in (0..factor.cols()).step_by(BLOCK) {
        for p in 0..factor.rows() {
            let row = factor.row(p);
            out.extend((0..BLOCK).map(|k| row.get(group + k).copied().unwrap_or(0.0)));
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
