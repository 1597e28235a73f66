use crate::error::from_llt;
use crate::memory::{copy, filled, scratch, transposed, zeros};
use crate::scale::{by_power, exponent};
use crate::system::{Solution, System};
use crate::{Partition, Place, SolveError, check, condition};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::linalg::lu::partial_pivoting as lu;
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
        // In these units the products of entries neither overflow nor vanish; a power of 2 rounds nothing.
        let (system, matrix) = in_units(n, matrix)?;
        let mut factor = copy(&matrix)?;
        if n <= SMALL {
            factor_plain(n, &mut factor)?;
        } else {
            factor_blocked(n, &mut factor)?;
        }
        let mut cholesky = Self { system, matrix, factor };
        // Positive pivots can be rounding alone: the condition decides whether they mean anything.
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
    /// [`SolveError::Residual`], [`SolveError::OutOfMemory`].
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

/// Cholesky's algorithm as it stands in the books, on the lower triangle of the column-major `a`: every entry loses its
/// products one by one and is divided by the root of its pivot.
pub(crate) fn factor_plain(n: usize, a: &mut [f64]) -> Result<(), SolveError> {
    for k in 0..n {
        let pivot = a[k * n + k];
        if pivot <= 0.0 || !pivot.is_finite() {
            return Err(SolveError::NotPositiveDefinite { order: n, pivot: Some(k), condition: None });
        }
        let root = pivot.sqrt();
        a[k * n + k] = root;
        let (done, rest) = a.split_at_mut((k + 1) * n);
        let column = &mut done[k * n..];
        column[k + 1..].iter_mut().for_each(|l| *l /= root);
        // Right-looking: column k is taken from all later columns, below their diagonals, before the next pivot is read.
        for (j, other) in rest.chunks_exact_mut(n).enumerate() {
            let j = k + 1 + j;
            let l = column[j];
            other[j..].iter_mut().zip(&column[j..]).for_each(|(a, c)| *a -= c * l);
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
        // By columns, as faer wants it: unlike in Cholesky's case this matrix is not its own transpose.
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
        // lu_in_place has no error of its own: a zero on the diagonal of U is how a singular matrix shows.
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
    let block = partition.free_block(matrix)?;
    // b = −Q_fb P_b: only the rows of free and the columns of fixed unknowns are read, so free rows of `values` may be NaN.
    let mut rhs = zeros(order * columns)?;
    for (k, &i) in free.iter().enumerate() {
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
