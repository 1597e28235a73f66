use crate::error::{from_evd, from_llt, from_svd};
use crate::memory::{copy, filled, scratch, transposed, zeros};
use crate::scale::{by_power, exponent};
use crate::system::{Solution, System};
use crate::{Partition, Place, SolveError, check, condition};
use faer::diag::{Diag, DiagMut};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::linalg::lu::partial_pivoting as lu;
use faer::linalg::svd::ComputeSvdVectors;
use faer::linalg::{evd, svd};
use faer::perm::PermRef;
use faer::{Conj, MatMut, MatRef, Par, Spec};
use std::cell::RefCell;

/// Largest order that is factored by plain loops; a blocked factorisation costs more than it saves there.
const SMALL: usize = 8;

/// `A = L Lᵀ` of a symmetric positive definite matrix.
///
/// ```
/// let cholesky = solve::Cholesky::new(2, &[4.0, 2.0, 2.0, 5.0])?;
/// let solution = cholesky.solve(1, &[8.0, 8.0])?;
/// assert_eq!(solution.x, [1.5, 1.0]);
/// assert!(solution.residual < 30.0 && cholesky.condition() < 10.0);
/// # Ok::<(), solve::SolveError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Cholesky {
    system: System,
    /// In the units of the system, row-major.
    matrix: Vec<f64>,
    /// Column-major, the lower triangle counts.
    factor: Vec<f64>,
}

impl Cholesky {
    /// Factors `matrix`: `n × n`, row-major, symmetric, positive definite.
    ///
    /// # Errors
    /// [`SolveError::NotPositiveDefinite`] if a pivot is not positive or the condition estimate is beyond
    /// `1/(n ε)`; [`SolveError::NotSymmetric`], [`SolveError::NotFinite`], [`SolveError::WrongShape`],
    /// [`SolveError::TooLarge`], [`SolveError::OutOfMemory`].
    pub fn new(n: usize, matrix: &[f64]) -> Result<Self, SolveError> {
        check::square(n, matrix)?;
        check::symmetric(n, matrix)?;
        let (system, matrix) = in_units(n, matrix)?;
        let mut factor = copy(&matrix)?;
        if n <= SMALL {
            factor_small(n, &mut factor)?;
        } else {
            factor_blocked(n, &mut factor)?;
        }
        let mut cholesky = Self { system, matrix, factor };
        let solve = |x: &mut [f64]| cholesky.solve_in_place(x, 1);
        let inverse_norm = condition::inverse_norm(n, solve, solve);
        if cholesky.system.accept(inverse_norm, condition::limit(n)) {
            Ok(cholesky)
        } else {
            let condition = Some(cholesky.system.condition);
            Err(SolveError::NotPositiveDefinite { order: n, pivot: None, condition })
        }
    }

    /// Order of the matrix.
    pub fn order(&self) -> usize {
        self.system.n
    }

    /// Estimate of `‖A‖₁ ‖A⁻¹‖₁`, see [`Solution::condition`].
    pub fn condition(&self) -> f64 {
        self.system.condition
    }

    /// Solves `A X = B` for `B` of `n × columns`, row-major.
    ///
    /// # Errors
    /// [`SolveError::WrongShape`], [`SolveError::NotFinite`] (right-hand side, or a solution that overflows),
    /// [`SolveError::OutOfMemory`].
    pub fn solve(&self, columns: usize, rhs: &[f64]) -> Result<Solution, SolveError> {
        let solve = |x: &mut [f64]| {
            self.solve_in_place(x, columns);
            Ok(())
        };
        self.system.solve(columns, rhs, solve, |x, b| subtract_product(&self.matrix, x, b))
    }

    /// `rhs` column-major.
    fn solve_in_place(&self, rhs: &mut [f64], columns: usize) {
        let n = self.system.n;
        if n <= SMALL {
            for column in rhs.chunks_exact_mut(n.max(1)) {
                solve_small(n, &self.factor, column);
            }
        } else {
            let factor = MatRef::from_column_major_slice(&self.factor, n, n);
            let rhs = MatMut::from_column_major_slice_mut(rhs, n, columns);
            llt::solve::solve_in_place(factor, rhs, Par::Seq, MemStack::new(&mut []));
        }
    }
}

fn factor_small(n: usize, a: &mut [f64]) -> Result<(), SolveError> {
    for k in 0..n {
        let pivot = a[k * n + k];
        if pivot <= 0.0 || !pivot.is_finite() {
            return Err(SolveError::NotPositiveDefinite { order: n, pivot: Some(k), condition: None });
        }
        let root = pivot.sqrt();
        a[k * n + k] = root;
        for i in k + 1..n {
            a[k * n + i] /= root;
        }
        for j in k + 1..n {
            let l = a[k * n + j];
            for i in j..n {
                a[j * n + i] -= a[k * n + i] * l;
            }
        }
    }
    Ok(())
}

fn solve_small(n: usize, l: &[f64], x: &mut [f64]) {
    for k in 0..n {
        x[k] /= l[k * n + k];
        for i in k + 1..n {
            x[i] -= l[k * n + i] * x[k];
        }
    }
    for k in (0..n).rev() {
        for i in k + 1..n {
            x[k] -= l[k * n + i] * x[i];
        }
        x[k] /= l[k * n + k];
    }
}

fn factor_blocked(n: usize, a: &mut [f64]) -> Result<(), SolveError> {
    let parameters = Spec::default();
    let mut memory = scratch(llt::factor::cholesky_in_place_scratch::<f64>(n, Par::Seq, parameters))?;
    let stack = MemStack::new(&mut memory);
    let a = MatMut::from_column_major_slice_mut(a, n, n);
    llt::factor::cholesky_in_place(a, Default::default(), Par::Seq, stack, parameters)
        .map_err(|error| from_llt(error, n))?;
    Ok(())
}

/// `P A = L U` of a square matrix, with partial pivoting.
#[derive(Debug, Clone)]
pub struct Lu {
    system: System,
    matrix: Vec<f64>,
    factor: Vec<f64>,
    permutation: Vec<usize>,
    inverse_permutation: Vec<usize>,
}

impl Lu {
    /// Factors `matrix`: `n × n`, row-major, invertible.
    ///
    /// # Errors
    /// [`SolveError::Singular`] if a pivot vanishes or the condition estimate is beyond `1/(n ε)`;
    /// [`SolveError::NotFinite`], [`SolveError::WrongShape`], [`SolveError::TooLarge`],
    /// [`SolveError::OutOfMemory`].
    pub fn new(n: usize, matrix: &[f64]) -> Result<Self, SolveError> {
        check::square(n, matrix)?;
        let (system, matrix) = in_units(n, matrix)?;
        let mut factor = transposed(n, n, &matrix)?;
        let (mut permutation, mut inverse_permutation) = (filled(n, 0)?, filled(n, 0)?);
        if n > 0 {
            let parameters = Spec::default();
            let mut memory =
                scratch(lu::factor::lu_in_place_scratch::<usize, f64>(n, n, Par::Seq, parameters))?;
            let stack = MemStack::new(&mut memory);
            let a = MatMut::from_column_major_slice_mut(&mut factor, n, n);
            lu::factor::lu_in_place(
                a,
                &mut permutation,
                &mut inverse_permutation,
                Par::Seq,
                stack,
                parameters,
            );
        }
        if (0..n).any(|k| factor[k * n + k] == 0.0 || !factor[k * n + k].is_finite()) {
            return Err(SolveError::Singular { order: n, reciprocal_condition: 0.0 });
        }
        let mut lu = Self { system, matrix, factor, permutation, inverse_permutation };
        let memory = RefCell::new(lu.memory(1)?);
        let inverse_norm = condition::inverse_norm(
            n,
            |x| lu.solve_in_place(x, 1, &mut memory.borrow_mut()),
            |x| lu.solve_transposed_in_place(x, &mut memory.borrow_mut()),
        );
        if lu.system.accept(inverse_norm, condition::limit(n)) {
            Ok(lu)
        } else {
            Err(SolveError::Singular { order: n, reciprocal_condition: lu.system.reciprocal_condition() })
        }
    }

    /// Order of the matrix.
    pub fn order(&self) -> usize {
        self.system.n
    }

    /// Estimate of `‖A‖₁ ‖A⁻¹‖₁`, see [`Solution::condition`].
    pub fn condition(&self) -> f64 {
        self.system.condition
    }

    /// Solves `A X = B` for `B` of `n × columns`, row-major.
    ///
    /// # Errors
    /// As [`Cholesky::solve`].
    pub fn solve(&self, columns: usize, rhs: &[f64]) -> Result<Solution, SolveError> {
        let solve = |x: &mut [f64]| {
            self.solve_in_place(x, columns, &mut self.memory(columns)?);
            Ok(())
        };
        self.system.solve(columns, rhs, solve, |x, b| subtract_product(&self.matrix, x, b))
    }

    fn memory(&self, columns: usize) -> Result<MemBuffer, SolveError> {
        let forward = lu::solve::solve_in_place_scratch::<usize, f64>(self.system.n, columns, Par::Seq);
        let backward =
            lu::solve::solve_transpose_in_place_scratch::<usize, f64>(self.system.n, columns, Par::Seq);
        scratch(forward.or(backward))
    }

    fn solve_in_place(&self, rhs: &mut [f64], columns: usize, memory: &mut MemBuffer) {
        let factor = MatRef::from_column_major_slice(&self.factor, self.system.n, self.system.n);
        let rows = PermRef::new_checked(&self.permutation, &self.inverse_permutation, self.system.n);
        let rhs = MatMut::from_column_major_slice_mut(rhs, self.system.n, columns);
        let stack = MemStack::new(memory);
        lu::solve::solve_in_place_with_conj(factor, factor, rows, Conj::No, rhs, Par::Seq, stack);
    }

    fn solve_transposed_in_place(&self, rhs: &mut [f64], memory: &mut MemBuffer) {
        let factor = MatRef::from_column_major_slice(&self.factor, self.system.n, self.system.n);
        let rows = PermRef::new_checked(&self.permutation, &self.inverse_permutation, self.system.n);
        let rhs = MatMut::from_column_major_slice_mut(rhs, self.system.n, 1);
        let stack = MemStack::new(memory);
        lu::solve::solve_transpose_in_place_with_conj(factor, factor, rows, Conj::No, rhs, Par::Seq, stack);
    }
}

/// Solves `A X = B` for a symmetric positive definite `A` of `n × n` and `B` of `n × columns`, both row-major.
///
/// # Errors
/// As [`Cholesky::new`] and [`Cholesky::solve`].
pub fn solve_spd(n: usize, matrix: &[f64], columns: usize, rhs: &[f64]) -> Result<Solution, SolveError> {
    Cholesky::new(n, matrix)?.solve(columns, rhs)
}

/// Solves `A X = B` for an invertible `A` of `n × n` and `B` of `n × columns`, both row-major.
///
/// # Errors
/// As [`Lu::new`] and [`Lu::solve`].
pub fn solve_general(n: usize, matrix: &[f64], columns: usize, rhs: &[f64]) -> Result<Solution, SolveError> {
    Lu::new(n, matrix)?.solve(columns, rhs)
}

/// The extremal of `Σ_d X_dᵀ Q X_d` with some unknowns fixed: `Q_ff p = −Q_fb P_b`.
///
/// `matrix` is `Q` (`n × n`, symmetric, positive definite on the free unknowns); `values` is `n × columns`,
/// its free rows are not read. [`Solution::x`] is the whole array, `n × columns`; residual and condition
/// are those of the free block.
///
/// # Errors
/// As [`solve_spd`]; [`SolveError::WrongShape`] if the partition does not part `n` unknowns.
pub fn solve_partitioned(
    n: usize,
    matrix: &[f64],
    partition: &Partition,
    columns: usize,
    values: &[f64],
) -> Result<Solution, SolveError> {
    check::square(n, matrix)?;
    check::symmetric(n, matrix)?;
    check::length("number of parted unknowns", n, partition.order())?;
    check::length("length of the values", check::product("size of the values", n, columns)?, values.len())?;
    let (free, fixed) = (partition.free(), partition.fixed());
    for &i in fixed {
        if let Some(column) = values[i * columns..(i + 1) * columns].iter().position(|a| !a.is_finite()) {
            return Err(SolveError::NotFinite { place: Place::RightHandSide, row: i, column });
        }
    }
    let order = free.len();
    let mut block = zeros(order * order)?;
    let mut rhs = zeros(order * columns)?;
    for (k, &i) in free.iter().enumerate() {
        for (l, &j) in free.iter().enumerate() {
            block[k * order + l] = matrix[i * n + j];
        }
        for &j in fixed {
            for c in 0..columns {
                rhs[k * columns + c] -= matrix[i * n + j] * values[j * columns + c];
            }
        }
    }
    let solution = solve_spd(order, &block, columns, &rhs)?;
    let mut x = copy(values)?;
    partition.scatter_free(columns, &solution.x, &mut x)?;
    Ok(Solution { x, ..solution })
}

/// The matrix in units in which its largest entry is near 1.
fn in_units(n: usize, matrix: &[f64]) -> Result<(System, Vec<f64>), SolveError> {
    let exponent = exponent(matrix);
    let mut scaled = copy(matrix)?;
    scaled.iter_mut().for_each(|a| *a = by_power(*a, -exponent));
    Ok((System::new(n, exponent, one_norm(n, &scaled)), scaled))
}

/// `b ← b − A x`.
fn subtract_product(matrix: &[f64], x: &[f64], b: &mut [f64]) {
    for (b, row) in b.iter_mut().zip(matrix.chunks_exact(x.len().max(1))) {
        *b -= row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
    }
}

fn one_norm(n: usize, matrix: &[f64]) -> f64 {
    let mut sums = vec![0.0; n];
    for row in matrix.chunks_exact(n.max(1)) {
        sums.iter_mut().zip(row).for_each(|(sum, a)| *sum += a.abs());
    }
    sums.into_iter().fold(0.0, f64::max)
}

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
    let (mut inconsistent, mut residual) = (0, 0.0f64);
    let scale: Vec<f64> = (0..columns)
        .map(|c| {
            let length = (0..cols).map(|j| x[j * columns + c].powi(2)).sum::<f64>().sqrt();
            first * length + (0..rows).fold(0.0f64, |b, i| b.max(rhs[i * columns + c].abs()))
        })
        .collect();
    for i in 0..rows {
        let mut miss = 0.0f64;
        for c in 0..columns {
            let product: f64 = (0..cols).map(|j| matrix[i * cols + j] * x[j * columns + c]).sum();
            let defect = (product - rhs[i * columns + c]).abs();
            miss = miss.max(if defect == 0.0 { 0.0 } else { defect / scale[c] });
        }
        inconsistent += usize::from(miss > tolerance);
        residual = residual.max(miss);
    }
    Ok(RankSolution { x, rank, nullity: cols - rank, inconsistent, residual, singular_values: s })
}

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
