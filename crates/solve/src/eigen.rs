use crate::error::{from_evd, from_llt};
use crate::memory::{copy, scratch, transposed, zeros};
use crate::{SolveError, check};
use faer::diag::Diag;
use faer::dyn_stack::MemStack;
use faer::linalg::cholesky::llt;
use faer::linalg::{evd, triangular_solve};
use faer::{MatMut, MatRef, Par, Spec};

/// The eigenvalues and eigenvectors of a symmetric matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricEigen {
    /// The eigenvalues, increasing. Absolute error about `n ε ‖A‖`.
    pub values: Vec<f64>,
    /// The eigenvectors, orthonormal: `n × n`, row-major, one **column** an eigenvector.
    pub vectors: Vec<f64>,
}

/// All eigenvalues and eigenvectors of a symmetric `n × n` matrix.
///
/// # Errors
/// [`SolveError::NotSymmetric`], [`SolveError::NotFinite`], [`SolveError::WrongShape`],
/// [`SolveError::TooLarge`], [`SolveError::OutOfMemory`], [`SolveError::NoConvergence`].
pub fn eigen_symmetric(n: usize, matrix: &[f64]) -> Result<SymmetricEigen, SolveError> {
    let mut vectors = zeros(check::product("size of the matrix", n, n)?.min(matrix.len()))?;
    let values = eigen(n, matrix, Some(&mut vectors))?;
    Ok(SymmetricEigen { values, vectors: transposed(n, n, &vectors)? })
}

/// The smallest eigenvalue of a symmetric `n × n` matrix; `None` for `n = 0`.
///
/// # Errors
/// As [`eigen_symmetric`].
pub fn smallest_eigenvalue(n: usize, matrix: &[f64]) -> Result<Option<f64>, SolveError> {
    Ok(eigen(n, matrix, None)?.first().copied())
}

/// The smallest λ with `A x = λ B x` for symmetric A and symmetric positive definite B, both `n × n`: the smallest value of
/// `xᵀA x / xᵀB x`; `None` for `n = 0`.
///
/// # Errors
/// As [`eigen_symmetric`]; [`SolveError::NotPositiveDefinite`] if B is not.
pub fn smallest_relative_eigenvalue(n: usize, a: &[f64], b: &[f64]) -> Result<Option<f64>, SolveError> {
    check::square(n, a)?;
    check::symmetric(n, a)?;
    check::square(n, b)?;
    check::symmetric(n, b)?;
    let mut factor = copy(b)?;
    let parameters = Spec::default();
    let mut memory = scratch(llt::factor::cholesky_in_place_scratch::<f64>(n, Par::Seq, parameters))?;
    let lower = MatMut::from_column_major_slice_mut(&mut factor, n, n);
    let stack = MemStack::new(&mut memory);
    llt::factor::cholesky_in_place(lower, Default::default(), Par::Seq, stack, parameters)
        .map_err(|error| from_llt(error, n))?;
    // L⁻¹ A L⁻ᵀ, with B = L Lᵀ.
    let lower = MatRef::from_column_major_slice(&factor, n, n);
    let mut reduced = copy(a)?;
    let mut columns = MatMut::from_column_major_slice_mut(&mut reduced, n, n);
    triangular_solve::solve_lower_triangular_in_place(lower, columns.as_mut(), Par::Seq);
    triangular_solve::solve_lower_triangular_in_place(lower, columns.transpose_mut(), Par::Seq);
    // Rounding is not symmetric; the law that A and B are has been checked.
    for i in 0..n {
        for j in 0..i {
            let mean = 0.5 * (reduced[i * n + j] + reduced[j * n + i]);
            (reduced[i * n + j], reduced[j * n + i]) = (mean, mean);
        }
    }
    smallest_eigenvalue(n, &reduced)
}

fn eigen(n: usize, matrix: &[f64], vectors: Option<&mut [f64]>) -> Result<Vec<f64>, SolveError> {
    check::square(n, matrix)?;
    check::symmetric(n, matrix)?;
    let mut values = Diag::<f64>::zeros(n);
    let parameters = Spec::default();
    let wanted = match vectors {
        Some(_) => evd::ComputeEigenvectors::Yes,
        None => evd::ComputeEigenvectors::No,
    };
    let mut memory = scratch(evd::self_adjoint_evd_scratch::<f64>(n, wanted, Par::Seq, parameters))?;
    evd::self_adjoint_evd(
        MatRef::from_row_major_slice(matrix, n, n),
        values.as_mut(),
        vectors.map(|v| MatMut::from_column_major_slice_mut(v, n, n)),
        Par::Seq,
        MemStack::new(&mut memory),
        parameters,
    )
    .map_err(|error| from_evd(error, n))?;
    Ok(values.column_vector().iter().copied().collect())
}
