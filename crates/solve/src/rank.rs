use crate::error::from_svd;
use crate::memory::{scratch, zeros};
use crate::{Place, SolveError, check};
use faer::diag::DiagMut;
use faer::dyn_stack::MemStack;
use faer::linalg::svd::{self, ComputeSvdVectors};
use faer::{MatMut, MatRef, Par, Spec};

/// The least-squares answer of a system that may have too few, too many or conflicting conditions.
#[derive(Debug, Clone, PartialEq)]
pub struct RankSolution {
    /// Of all minimisers of `‖A X − B‖` the shortest: `cols × columns`, row-major.
    pub x: Vec<f64>,
    /// Number of singular values above `tolerance` times the largest.
    pub rank: usize,
    /// Number of unknowns the conditions leave undetermined: `cols − rank`.
    pub nullity: usize,
    /// Number of conditions (rows) that the least-squares answer misses: `max_d |A x − b|` of the row
    /// above `tolerance · (σ₁ ‖x‖₂ + ‖b‖∞)`. 0 exactly when the data are consistent to the tolerance.
    pub inconsistent: usize,
    /// The largest such miss, divided by `σ₁ ‖x‖₂ + ‖b‖∞`.
    pub residual: f64,
    /// The singular values of `A`, decreasing.
    pub singular_values: Vec<f64>,
}

/// Solves `A X = B` in the sense of least squares by a singular value decomposition that reveals the rank.
///
/// `matrix` is `rows × cols`, `rhs` is `rows × columns`, both row-major. Singular values up to `tolerance`
/// times the largest count as 0; the tolerance is not taken below `max(rows, cols) ε`.
///
/// # Errors
/// [`SolveError::NotFinite`], [`SolveError::WrongShape`], [`SolveError::TooLarge`],
/// [`SolveError::OutOfMemory`], [`SolveError::NoConvergence`].
pub fn solve_rank(
    rows: usize,
    cols: usize,
    matrix: &[f64],
    columns: usize,
    rhs: &[f64],
    tolerance: f64,
) -> Result<RankSolution, SolveError> {
    let largest = rows.max(cols);
    check::limit("order of the dense system", largest, check::LARGEST_DENSE_ORDER)?;
    check::length("length of the matrix", rows * cols, matrix.len())?;
    check::finite(Place::Matrix, cols.max(1), matrix)?;
    check::right_hand_side(rows, columns, rhs)?;
    let size = rows.min(cols);
    let tolerance = tolerance.max(largest as f64 * f64::EPSILON);
    let (mut u, mut s, mut v) = (zeros(rows * size)?, zeros(size)?, zeros(cols * size)?);
    if size > 0 {
        let parameters = Spec::default();
        let thin = ComputeSvdVectors::Thin;
        let mut memory = scratch(svd::svd_scratch::<f64>(rows, cols, thin, thin, Par::Seq, parameters))?;
        svd::svd(
            MatRef::from_row_major_slice(matrix, rows, cols),
            DiagMut::from_slice_mut(&mut s),
            Some(MatMut::from_column_major_slice_mut(&mut u, rows, size)),
            Some(MatMut::from_column_major_slice_mut(&mut v, cols, size)),
            Par::Seq,
            MemStack::new(&mut memory),
            parameters,
        )
        .map_err(|error| from_svd(error, largest))?;
    }
    let first = s.first().copied().unwrap_or(0.0);
    let rank = s.iter().take_while(|&&sigma| sigma > tolerance * first).count();
    let mut x = zeros(cols * columns)?;
    for c in 0..columns {
        for k in 0..rank {
            let projection: f64 = (0..rows).map(|i| u[k * rows + i] * rhs[i * columns + c]).sum();
            for j in 0..cols {
                x[j * columns + c] += v[k * cols + j] * (projection / s[k]);
            }
        }
    }
    check::finite(Place::Solution, columns.max(1), &x)?;
    let misses = misses((rows, cols, matrix), columns, rhs, &x, first);
    let inconsistent = misses.iter().filter(|&&miss| miss > tolerance).count();
    let residual = misses.into_iter().fold(0.0, f64::max);
    Ok(RankSolution { x, rank, nullity: cols - rank, inconsistent, residual, singular_values: s })
}

/// By how much each row of `A` misses its right-hand sides, as a share of `σ₁ ‖x‖₂ + ‖b‖∞`: the largest over the columns.
fn misses(
    (rows, cols, matrix): (usize, usize, &[f64]),
    columns: usize,
    rhs: &[f64],
    x: &[f64],
    first: f64,
) -> Vec<f64> {
    let scale = |c: usize| {
        let length = (0..cols).map(|j| x[j * columns + c].powi(2)).sum::<f64>().sqrt();
        first * length + (0..rows).fold(0.0f64, |b, i| b.max(rhs[i * columns + c].abs()))
    };
    let scales: Vec<f64> = (0..columns).map(scale).collect();
    let miss = |i: usize, c: usize| {
        let product: f64 = (0..cols).map(|j| matrix[i * cols + j] * x[j * columns + c]).sum();
        let defect = (product - rhs[i * columns + c]).abs();
        if defect == 0.0 { 0.0 } else { defect / scales[c] }
    };
    (0..rows).map(|i| (0..columns).map(|c| miss(i, c)).fold(0.0, f64::max)).collect()
}
