//! Orthonormal combinations of sampled functions.

use crate::memory::{scratch, zeros};
use crate::{Place, SolveError, check};
use faer::dyn_stack::MemStack;
use faer::linalg::qr::no_pivoting::factor as qr;
use faer::linalg::triangular_solve;
use faer::{Mat, MatMut, Par, Spec};

/// The combinations of the columns of `samples` (`rows × cols`, row-major) that are orthonormal: `map` (`cols × cols`,
/// row-major, upper triangular) such that the columns of `samples · map` are.
///
/// By Householder's QR of the samples; the Gram matrix, whose condition is the square of theirs, is never formed. The
/// columns of the product are orthonormal to about the condition of the samples times ε.
///
/// ```
/// let map = solve::orthonormalise(2, 2, &[3.0, 1.0, 4.0, 1.0])?;
/// assert!((map[0].abs() - 0.2).abs() < 1e-15 && map[2] == 0.0);
/// # Ok::<(), solve::SolveError>(())
/// ```
///
/// # Errors
/// [`SolveError::NotPositiveDefinite`] if a column depends on those before it to working precision (its index is the
/// pivot); [`SolveError::WrongShape`] if there are fewer rows than columns, [`SolveError::NotFinite`],
/// [`SolveError::TooLarge`], [`SolveError::OutOfMemory`].
pub fn orthonormalise(rows: usize, cols: usize, samples: &[f64]) -> Result<Vec<f64>, SolveError> {
    check::limit("number of functions", cols, check::LARGEST_DENSE_ORDER)?;
    check::length(
        "length of the samples",
        check::product("size of the samples", rows, cols)?,
        samples.len(),
    )?;
    check::finite(Place::Matrix, cols.max(1), samples)?;
    if rows < cols {
        let what = "number of samples, at least the functions";
        return Err(SolveError::WrongShape { what, expected: cols, found: rows });
    }
    let mut map = zeros(cols * cols)?;
    if cols == 0 {
        return Ok(map);
    }
    // One allocation that may fail stands for the matrices below.
    drop(zeros(rows * cols)?);
    let block = qr::recommended_block_size::<f64>(rows, cols);
    let mut factor = Mat::from_fn(rows, cols, |i, j| samples[i * cols + j]);
    let mut coefficients = Mat::zeros(block, cols);
    let request = qr::qr_in_place_scratch::<f64>(rows, cols, block, Par::Seq, Spec::default());
    let mut memory = scratch(request)?;
    let stack = MemStack::new(&mut memory);
    qr::qr_in_place(factor.as_mut(), coefficients.as_mut(), Par::Seq, stack, Spec::default());
    for k in 0..cols {
        let length = (0..=k).map(|i| factor[(i, k)].powi(2)).sum::<f64>().sqrt();
        let pivot = factor[(k, k)].abs();
        if pivot <= cols as f64 * f64::EPSILON * length || !length.is_finite() {
            return Err(SolveError::NotPositiveDefinite { order: cols, pivot: Some(k), condition: None });
        }
    }
    map.iter_mut().step_by(cols + 1).for_each(|a| *a = 1.0);
    let inverse = MatMut::from_row_major_slice_mut(&mut map, cols, cols);
    triangular_solve::solve_upper_triangular_in_place(factor.submatrix(0, 0, cols, cols), inverse, Par::Seq);
    check::finite(Place::Solution, cols, &map)?;
    Ok(map)
}
