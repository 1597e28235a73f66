use crate::error::{from_creation, from_faer, from_sparse_lu};
use crate::memory::{filled, scratch, zeros};
use crate::scale::{by_power, exponent};
use crate::system::{Solution, System};
use crate::{Place, SolveError, check, condition};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::sparse::linalg::{cholesky, lu};
use faer::sparse::{CreationError, SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side, Spec};
use std::cell::RefCell;

/// Largest order of a sparse system.
const LARGEST_ORDER: usize = 1 << 24;

/// Conditions beyond this are a singular matrix, as is 1/(n ε).
const LARGEST_CONDITION: f64 = 1e13;

/// One entry of a sparse matrix; entries of the same place add up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triplet {
    /// Row of the entry.
    pub row: usize,
    /// Column of the entry.
    pub column: usize,
    /// Its value.
    pub value: f64,
}

/// A square matrix by compressed columns, in units in which its largest entry is near 1.
#[derive(Debug, Clone)]
struct SparseMatrix {
    n: usize,
    starts: Vec<usize>,
    rows: Vec<usize>,
    values: Vec<f64>,
}

impl SparseMatrix {
    fn new(n: usize, triplets: &[Triplet]) -> Result<(System, Self), SolveError> {
        check::limit("order of the sparse system", n, LARGEST_ORDER)?;
        for triplet in triplets {
            let (row, col) = (triplet.row, triplet.column);
            if row >= n || col >= n {
                let bytes = size_of_val(triplets);
                return Err(from_creation(CreationError::OutOfBounds { row, col }, n, bytes));
            }
            if !triplet.value.is_finite() {
                return Err(SolveError::NotFinite { place: Place::Matrix, row, column: col });
            }
        }
        // Sorted by column, then row: equal places stand side by side, and rows within a column are increasing, as `entry` needs.
        let mut order = filled(triplets.len(), 0usize)?;
        order.iter_mut().enumerate().for_each(|(k, at)| *at = k);
        order.sort_by_key(|&k| (triplets[k].column, triplets[k].row));

        // Scaling by a power of 2 rounds nothing, and keeps sums and squares away from overflow and underflow.
        let exponent = exponent(triplets.iter().map(|t| &t.value));
        let mut matrix = Self { n, starts: filled(n + 1, 0)?, rows: Vec::new(), values: Vec::new() };
        let mut last = None;
        for k in order {
            let Triplet { row, column, value } = triplets[k];
            let value = by_power(value, -exponent);
            if last == Some((column, row)) {
                // Summed in the order given (the sort is stable): the same triplets give the same bits.
                *matrix.values.last_mut().expect("an entry of this place was pushed before") += value;
            } else {
                last = Some((column, row));
                matrix.rows.push(row);
                matrix.values.push(value);
                matrix.starts[column + 1] += 1;
            }
        }
        for j in 0..n {
            matrix.starts[j + 1] += matrix.starts[j];
        }
        let norm = (0..n).map(|j| matrix.column(j).map(|(_, a)| a.abs()).sum::<f64>()).fold(0.0, f64::max);
        Ok((System::new(n, exponent, norm), matrix))
    }

    fn column(&self, j: usize) -> impl Iterator<Item = (usize, f64)> {
        let range = self.starts[j]..self.starts[j + 1];
        self.rows[range.clone()].iter().copied().zip(self.values[range].iter().copied())
    }

    fn entry(&self, row: usize, column: usize) -> f64 {
        let range = self.starts[column]..self.starts[column + 1];
        match self.rows[range.clone()].binary_search(&row) {
            Ok(k) => self.values[range.start + k],
            Err(_) => 0.0,
        }
    }

    fn check_symmetric(&self) -> Result<(), SolveError> {
        // An assembled matrix is symmetric but for the order of its sums: a few roundings of its largest entry.
        let bound = 16.0 * f64::EPSILON * self.values.iter().fold(0.0f64, |max, a| max.max(a.abs()));
        for j in 0..self.n {
            for (i, a) in self.column(j) {
                let difference = (a - self.entry(j, i)).abs();
                if difference > bound {
                    return Err(SolveError::NotSymmetric { row: i.max(j), column: i.min(j), difference });
                }
            }
        }
        Ok(())
    }

    /// `b ← b − A x`.
    fn subtract_product(&self, x: &[f64], b: &mut [f64]) {
        for (j, x) in x.iter().enumerate() {
            for (i, a) in self.column(j) {
                b[i] -= a * x;
            }
        }
    }

    fn view(&self) -> SparseColMatRef<'_, usize, f64> {
        let symbolic = SymbolicSparseColMatRef::new_checked(self.n, self.n, &self.starts, None, &self.rows);
        SparseColMatRef::new(symbolic, &self.values)
    }

    fn bytes(&self) -> usize {
        self.values.len().saturating_mul(size_of::<(usize, f64)>())
    }
}

fn limit(n: usize) -> f64 {
    condition::limit(n).min(LARGEST_CONDITION)
}

/// `P A Pᵀ = L Lᵀ` of a sparse symmetric positive definite matrix, with an ordering that keeps L sparse.
#[derive(Debug)]
pub struct SparseCholesky {
    system: System,
    matrix: SparseMatrix,
    symbolic: cholesky::SymbolicCholesky<usize>,
    values: Vec<f64>,
}

impl SparseCholesky {
    /// Factors the `n × n` matrix of `triplets`; both triangles are given.
    ///
    /// # Errors
    /// [`SolveError::NotPositiveDefinite`] if a pivot is not positive or the condition estimate is beyond
    /// `1/(n ε)` or 10¹³; [`SolveError::NotSymmetric`], [`SolveError::NotFinite`], [`SolveError::WrongIndex`],
    /// [`SolveError::TooLarge`], [`SolveError::OutOfMemory`].
    pub fn new(n: usize, triplets: &[Triplet]) -> Result<Self, SolveError> {
        let (system, matrix) = SparseMatrix::new(n, triplets)?;
        matrix.check_symmetric()?;
        let view = matrix.view();
        let symbolic = cholesky::factorize_symbolic_cholesky(
            view.symbolic(),
            Side::Lower,
            Default::default(),
            Default::default(),
        )
        .map_err(|error| from_faer(error, matrix.bytes()))?;
        let mut values = zeros(symbolic.len_val())?;
        let mut memory = scratch(symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default()))?;
        symbolic
            .factorize_numeric_llt(
                &mut values,
                view,
                Side::Lower,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Spec::default(),
            )
            .map_err(|LltError::NonPositivePivot { index }| {
                // faer counts from 1 when it works entry by entry, and in its own order of the unknowns.
                let index = match symbolic.raw() {
                    cholesky::SymbolicCholeskyRaw::Simplicial(_) => index.saturating_sub(1),
                    cholesky::SymbolicCholeskyRaw::Supernodal(_) => index,
                };
                let pivot = symbolic.perm().map_or(Some(index), |order| order.arrays().0.get(index).copied());
                SolveError::NotPositiveDefinite { order: n, pivot, condition: None }
            })?;
        let mut cholesky = Self { system, matrix, symbolic, values };
        // A factor alone proves little: pivots of a nearly singular matrix can come out positive by rounding.
        let memory = RefCell::new(cholesky.memory(1)?);
        let solve = |x: &mut [f64]| cholesky.solve_in_place(x, 1, &mut memory.borrow_mut());
        let inverse_norm = condition::inverse_norm(n, solve, solve);
        if cholesky.system.accept(inverse_norm, limit(n)) {
            Ok(cholesky)
        } else {
            let condition = Some(cholesky.system.condition);
            Err(SolveError::NotPositiveDefinite { order: n, pivot: None, condition })
        }
    }

    /// Estimate of `‖A‖₁ ‖A⁻¹‖₁`, see [`Solution::condition`].
    pub fn condition(&self) -> f64 {
        self.system.condition
    }

    /// Solves `A X = B` for `B` of `n × columns`, row-major.
    ///
    /// # Errors
    /// As [`Cholesky::solve`](crate::Cholesky::solve).
    pub fn solve(&self, columns: usize, rhs: &[f64]) -> Result<Solution, SolveError> {
        let solve = |x: &mut [f64]| {
            self.solve_in_place(x, columns, &mut self.memory(columns)?);
            Ok(())
        };
        self.system.solve(columns, rhs, solve, |x, b| self.matrix.subtract_product(x, b))
    }

    fn memory(&self, columns: usize) -> Result<MemBuffer, SolveError> {
        scratch(self.symbolic.solve_in_place_scratch::<f64>(columns, Par::Seq))
    }

    fn solve_in_place(&self, rhs: &mut [f64], columns: usize, memory: &mut MemBuffer) {
        let rhs = MatMut::from_column_major_slice_mut(rhs, self.matrix.n, columns);
        cholesky::LltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            rhs,
            Par::Seq,
            MemStack::new(memory),
        );
    }
}

/// `P A Q = L U` of a sparse invertible matrix.
#[derive(Debug)]
pub struct SparseLu {
    system: System,
    matrix: SparseMatrix,
    symbolic: lu::SymbolicLu<usize>,
    numeric: lu::NumericLu<usize, f64>,
}

impl SparseLu {
    /// Factors the `n × n` matrix of `triplets`.
    ///
    /// # Errors
    /// [`SolveError::Singular`] if a pivot is missing or the condition estimate is beyond `1/(n ε)` or 10¹³;
    /// [`SolveError::NotFinite`], [`SolveError::WrongIndex`], [`SolveError::TooLarge`],
    /// [`SolveError::OutOfMemory`].
    pub fn new(n: usize, triplets: &[Triplet]) -> Result<Self, SolveError> {
        let (system, matrix) = SparseMatrix::new(n, triplets)?;
        // A column or row without any entry is singular by structure: no ordering is sought for it.
        let empty = SolveError::Singular { order: n, reciprocal_condition: 0.0 };
        let mut hit = filled(n, false)?;
        matrix.rows.iter().for_each(|&i| hit[i] = true);
        if (0..n).any(|j| !hit[j] || matrix.starts[j] == matrix.starts[j + 1]) {
            return Err(empty);
        }
        let view = matrix.view();
        let symbolic = lu::factorize_symbolic_lu(view.symbolic(), Default::default())
            .map_err(|error| from_faer(error, matrix.bytes()))?;
        let mut numeric = lu::NumericLu::new();
        let mut memory = scratch(symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Spec::default()))?;
        symbolic
            .factorize_numeric_lu(&mut numeric, view, Par::Seq, MemStack::new(&mut memory), Spec::default())
            .map_err(|error| from_sparse_lu(error, n, matrix.bytes()))?;
        let mut lu = Self { system, matrix, symbolic, numeric };
        let memory = RefCell::new(lu.memory(1)?);
        let inverse_norm = condition::inverse_norm(
            n,
            |x| lu.solve_in_place(x, 1, &mut memory.borrow_mut()),
            |x| lu.solve_transposed_in_place(x, &mut memory.borrow_mut()),
        );
        if lu.system.accept(inverse_norm, limit(n)) {
            Ok(lu)
        } else {
            Err(SolveError::Singular { order: n, reciprocal_condition: lu.system.reciprocal_condition() })
        }
    }

    /// Estimate of `‖A‖₁ ‖A⁻¹‖₁`, see [`Solution::condition`].
    pub fn condition(&self) -> f64 {
        self.system.condition
    }

    /// Solves `A X = B` for `B` of `n × columns`, row-major.
    ///
    /// # Errors
    /// As [`Cholesky::solve`](crate::Cholesky::solve).
    pub fn solve(&self, columns: usize, rhs: &[f64]) -> Result<Solution, SolveError> {
        let solve = |x: &mut [f64]| {
            self.solve_in_place(x, columns, &mut self.memory(columns)?);
            Ok(())
        };
        self.system.solve(columns, rhs, solve, |x, b| self.matrix.subtract_product(x, b))
    }

    fn memory(&self, columns: usize) -> Result<MemBuffer, SolveError> {
        let forward = self.symbolic.solve_in_place_scratch::<f64>(columns, Par::Seq);
        scratch(forward.or(self.symbolic.solve_transpose_in_place_scratch::<f64>(columns, Par::Seq)))
    }

    fn solve_in_place(&self, rhs: &mut [f64], columns: usize, memory: &mut MemBuffer) {
        let rhs = MatMut::from_column_major_slice_mut(rhs, self.matrix.n, columns);
        let factor = lu::LuRef::new_unchecked(&self.symbolic, &self.numeric);
        factor.solve_in_place_with_conj(Conj::No, rhs, Par::Seq, MemStack::new(memory));
    }

    fn solve_transposed_in_place(&self, rhs: &mut [f64], memory: &mut MemBuffer) {
        let rhs = MatMut::from_column_major_slice_mut(rhs, self.matrix.n, 1);
        let factor = lu::LuRef::new_unchecked(&self.symbolic, &self.numeric);
        factor.solve_transpose_in_place_with_conj(Conj::No, rhs, Par::Seq, MemStack::new(memory));
    }
}

/// Solves `A X = B` for a sparse symmetric positive definite `A` (both triangles given) and `B` of `n × columns`.
///
/// # Errors
/// As [`SparseCholesky::new`] and [`SparseCholesky::solve`].
pub fn solve_sparse_spd(
    n: usize,
    triplets: &[Triplet],
    columns: usize,
    rhs: &[f64],
) -> Result<Solution, SolveError> {
    SparseCholesky::new(n, triplets)?.solve(columns, rhs)
}

/// Solves `A X = B` for a sparse invertible `A` and `B` of `n × columns`, row-major.
///
/// ```
/// use solve::{SolveError, Triplet, solve_sparse};
///
/// let entry = |row, column, value| Triplet { row, column, value };
/// let solution = solve_sparse(2, &[entry(0, 1, 2.0), entry(1, 0, 4.0)], 1, &[6.0, 4.0])?;
/// assert_eq!(solution.x, [1.0, 3.0]);
/// let singular = solve_sparse(2, &[entry(0, 0, 1.0), entry(1, 0, 1.0)], 1, &[1.0, 1.0]);
/// assert!(matches!(singular, Err(SolveError::Singular { .. })));
/// # Ok::<(), SolveError>(())
/// ```
///
/// # Errors
/// As [`SparseLu::new`] and [`SparseLu::solve`].
pub fn solve_sparse(
    n: usize,
    triplets: &[Triplet],
    columns: usize,
    rhs: &[f64],
) -> Result<Solution, SolveError> {
    SparseLu::new(n, triplets)?.solve(columns, rhs)
}
