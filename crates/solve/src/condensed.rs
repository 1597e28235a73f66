//! Symmetric positive definite systems of cells that share unknowns on their rims.

use std::sync::Mutex;

use crate::dense::factor_plain;
use crate::error::from_llt;
use crate::memory::{filled, scratch, zeros};
use crate::{SolveError, SparseCholesky, Triplet, check};
use faer::dyn_stack::MemStack;
use faer::linalg::cholesky::llt;
use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::linalg::triangular_solve;
use faer::{Accum, MatMut, MatRef, Par, Spec};

/// Skeletons of this many unknowns and more are factored as sparse matrices.
const SPARSE_FROM: usize = 2000;

/// Which unknown of a system is which of its cells: the symbolic part of a factorisation.
///
/// The system is the sum of one matrix a cell. Its unknowns are numbered so that the leading ones, the *skeleton*, may belong
/// to several cells, and every other belongs to one alone.
#[derive(Debug, Clone)]
pub struct Condensation {
    unknowns: usize,
    skeleton: usize,
    cells: Vec<CellUnknowns>,
    spare: Spare,
}

/// Memory of factors that are gone, for those to come: a system is factored many times, and fresh memory costs more than to fill it.
#[derive(Debug, Default)]
struct Spare(Mutex<Vec<Vec<f64>>>);

impl Clone for Spare {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Spare {
    /// Room for `length` numbers, which are any.
    fn take(&self, length: usize) -> Result<Vec<f64>, SolveError> {
        let kept = self.0.lock().ok().and_then(|mut kept| {
            let fitting = kept.iter().position(|array| array.len() == length)?;
            Some(kept.swap_remove(fitting))
        });
        kept.map_or_else(|| zeros(length), Ok)
    }

    fn keep(&self, array: Vec<f64>) {
        if let Ok(mut kept) = self.0.lock()
            && !array.is_empty()
        {
            kept.push(array);
        }
    }
}

/// (Place in the matrix of the cell, unknown).
#[derive(Debug, Clone)]
struct CellUnknowns {
    size: usize,
    inner: Vec<(usize, usize)>,
    rim: Vec<(usize, usize)>,
}

impl Condensation {
    /// A system of `unknowns`, the first `skeleton` of which are shared; `cells` lists the unknowns of each cell in the order
    /// of its matrix.
    ///
    /// # Errors
    /// [`SolveError::WrongIndex`] for an unknown that does not exist, [`SolveError::WrongShape`] if one beyond the skeleton
    /// does not belong to exactly one cell.
    pub fn new(unknowns: usize, skeleton: usize, cells: &[Vec<usize>]) -> Result<Self, SolveError> {
        let mut owners = filled(unknowns, 0usize)?;
        let mut split = Vec::with_capacity(cells.len());
        for cell in cells {
            for &index in cell {
                let Some(owner) = owners.get_mut(index) else {
                    return Err(SolveError::WrongIndex { what: "unknown of a cell", index, bound: unknowns });
                };
                *owner += 1;
            }
            let (rim, inner) = cell.iter().copied().enumerate().partition(|&(_, k)| k < skeleton);
            split.push(CellUnknowns { size: cell.len(), inner, rim });
        }
        if let Some(owners) = owners.iter().skip(skeleton).find(|owners| **owners != 1) {
            let what = "cells of an unknown beyond the skeleton";
            return Err(SolveError::WrongShape { what, expected: 1, found: *owners });
        }
        Ok(Self { unknowns, skeleton: skeleton.min(unknowns), cells: split, spare: Spare::default() })
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// `A = L Lᵀ` of the sum of `matrices`, one a cell, row-major, symmetric: the interior of each cell by itself, then what
    /// is left on the skeleton, `S = Σ (K_rr − Yᵀ Y)` with `Y = L⁻¹ K_ir`.
    ///
    /// # Errors
    /// [`SolveError::NotPositiveDefinite`] if the sum is not; [`SolveError::WrongShape`], [`SolveError::TooLarge`],
    /// [`SolveError::OutOfMemory`]; entries that are not finite are not positive definite.
    pub fn factor(&self, matrices: &[impl AsRef<[f64]>]) -> Result<Condensed<'_>, SolveError> {
        check::length("number of matrices of cells", self.cells.len(), matrices.len())?;
        let sparse = self.skeleton >= SPARSE_FROM;
        let mut triplets = Vec::new();
        let mut schur = zeros(if sparse { 0 } else { self.skeleton * self.skeleton })?;
        let mut inner = Vec::with_capacity(self.cells.len());
        for (cell, matrix) in self.cells.iter().zip(matrices) {
            let matrix = matrix.as_ref();
            check::length("length of the matrix of a cell", cell.size * cell.size, matrix.len())?;
            let factor = Interior::new(cell, matrix, &self.spare)?;
            let r = cell.rim.len();
            // The part of the cell's matrix on its rim, lower triangle, column-major: what the square is taken from.
            let mut rest = zeros(r * r)?;
            for (b, &(q, _)) in cell.rim.iter().enumerate() {
                for (a, &(p, _)) in cell.rim.iter().enumerate().skip(b) {
                    rest[b * r + a] = matrix[p * cell.size + q];
                }
            }
            factor.subtract_square(&mut rest);
            for (b, &(_, l)) in cell.rim.iter().enumerate() {
                for (a, &(_, k)) in cell.rim.iter().enumerate().skip(b) {
                    let value = rest[b * r + a];
                    // The skeleton may number the unknowns of a rim in another order than the cell does: only what falls below the
                    // diagonal of the skeleton counts, so the pair is turned if need be.
                    let (row, column) = (k.max(l), k.min(l));
                    if sparse {
                        triplets.push(Triplet { row, column, value });
                        if row != column {
                            triplets.push(Triplet { row: column, column: row, value });
                        }
                    } else {
                        schur[column * self.skeleton + row] += value;
                    }
                }
            }
            inner.push(factor);
        }
        let skeleton = if sparse {
            // The positive definiteness of the whole is that of all interiors and of S: a shift that is too small fails here or above.
            Skeleton::Sparse(Box::new(SparseCholesky::new(self.skeleton, &triplets)?))
        } else {
            factor_in_place(self.skeleton, &mut schur)?;
            Skeleton::Dense(schur)
        };
        Ok(Condensed { of: self, inner, skeleton })
    }
}

/// A factored system of cells.
#[derive(Debug)]
pub struct Condensed<'a> {
    of: &'a Condensation,
    inner: Vec<Interior>,
    skeleton: Skeleton,
}

#[derive(Debug)]
enum Skeleton {
    /// Column-major, lower triangle.
    Dense(Vec<f64>),
    Sparse(Box<SparseCholesky>),
}

/// The interior of one cell: L (column-major, lower triangle) and Y = L⁻¹ K_ir (column-major, a column a rim unknown).
#[derive(Debug)]
struct Interior {
    order: usize,
    rim: usize,
    factor: Vec<f64>,
    coupling: Vec<f64>,
}

impl Interior {
    // L and K_ir are gathered from rows in place of columns: the matrix is symmetric, and rows are contiguous.
    fn new(cell: &CellUnknowns, matrix: &[f64], spare: &Spare) -> Result<Self, SolveError> {
        let (order, rim) = (cell.inner.len(), cell.rim.len());
        let gather = |columns: &[(usize, usize)]| -> Result<Vec<f64>, SolveError> {
            // Length tells apart what is kept, so that a cell finds the arrays of its own kind again.
            let mut out = spare.take(order * columns.len())?;
            for (column, &(q, _)) in out.chunks_exact_mut(order.max(1)).zip(columns) {
                let row = &matrix[q * cell.size..(q + 1) * cell.size];
                if order == cell.size {
                    column.copy_from_slice(row);
                } else {
                    column.iter_mut().zip(&cell.inner).for_each(|(out, &(p, _))| *out = row[p]);
                }
            }
            Ok(out)
        };
        let (mut factor, mut coupling) = (gather(&cell.inner)?, gather(&cell.rim)?);
        factor_in_place(order, &mut factor)?;
        if order > 0 && rim > 0 {
            let lower = MatRef::from_column_major_slice(&factor, order, order);
            let columns = MatMut::from_column_major_slice_mut(&mut coupling, order, rim);
            triangular_solve::solve_lower_triangular_in_place(lower, columns, Par::Seq);
        }
        Ok(Self { order, rim, factor, coupling })
    }

    /// `rest − Yᵀ Y` in the lower triangle of the column-major `rest`.
    fn subtract_square(&self, rest: &mut [f64]) {
        if self.order == 0 || self.rim == 0 {
            return;
        }
        let y = MatRef::from_column_major_slice(&self.coupling, self.order, self.rim);
        let rest = MatMut::from_column_major_slice_mut(rest, self.rim, self.rim);
        let (lower, full) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
        matmul(rest, lower, Accum::Add, y.transpose(), full, y, full, -1.0, Par::Seq);
    }

    /// `L⁻¹ x` or `L⁻ᵀ x`.
    fn apply(&self, x: &mut [f64], transposed: bool) {
        triangular(self.order, &self.factor, x, transposed);
    }
}

impl Drop for Condensed<'_> {
    fn drop(&mut self) {
        for Interior { factor, coupling, .. } in self.inner.drain(..) {
            self.of.spare.keep(factor);
            self.of.spare.keep(coupling);
        }
    }
}

impl Condensed<'_> {
    /// Solves for `columns` right-hand sides: `rhs` is unknowns × columns, row-major, and becomes the solution.
    ///
    /// # Errors
    /// [`SolveError::WrongShape`]; of a sparse skeleton as [`SparseCholesky::solve`].
    pub fn solve(&self, columns: usize, rhs: &mut [f64]) -> Result<(), SolveError> {
        let of = self.of;
        check::length("length of the right-hand side", of.unknowns * columns, rhs.len())?;
        let mut scratch = Vec::new();
        // Forward through the interiors to the skeleton, the skeleton solved whole, and back: block elimination with
        // z = L⁻¹ b_i, S x_r = b_r − Yᵀ z, x_i = L⁻ᵀ (z − Y x_r). K_ir itself is not needed any more.
        for column in 0..columns {
            let entry = |k: usize| k * columns + column;
            let mut skeleton: Vec<f64> = (0..of.skeleton).map(|k| rhs[entry(k)]).collect();
            for (cell, inner) in of.cells.iter().zip(&self.inner) {
                scratch.clear();
                scratch.extend(cell.inner.iter().map(|&(_, k)| rhs[entry(k)]));
                inner.apply(&mut scratch, false);
                for (y, &(_, k)) in inner.coupling.chunks_exact(inner.order.max(1)).zip(&cell.rim) {
                    skeleton[k] -= dot(y, &scratch);
                }
                // z waits in the place of the right-hand side until x_r is known.
                scratch.iter().zip(&cell.inner).for_each(|(z, &(_, k))| rhs[entry(k)] = *z);
            }
            match &self.skeleton {
                Skeleton::Dense(factor) => {
                    triangular(of.skeleton, factor, &mut skeleton, false);
                    triangular(of.skeleton, factor, &mut skeleton, true);
                }
                Skeleton::Sparse(factor) => skeleton = factor.solve(1, &skeleton)?.x,
            }
            for (k, x) in skeleton.iter().enumerate() {
                rhs[entry(k)] = *x;
            }
            for (cell, inner) in of.cells.iter().zip(&self.inner) {
                scratch.clear();
                scratch.extend(cell.inner.iter().map(|&(_, k)| rhs[entry(k)]));
                for (y, &(_, k)) in inner.coupling.chunks_exact(inner.order.max(1)).zip(&cell.rim) {
                    let x = skeleton[k];
                    scratch.iter_mut().zip(y).for_each(|(z, y)| *z -= y * x);
                }
                inner.apply(&mut scratch, true);
                scratch.iter().zip(&cell.inner).for_each(|(x, &(_, k))| rhs[entry(k)] = *x);
            }
        }
        Ok(())
    }
}

/// Order up to which plain loops are quicker than blocks.
const SMALL: usize = 8;

fn factor_in_place(n: usize, a: &mut [f64]) -> Result<(), SolveError> {
    if n <= SMALL {
        return factor_plain(n, a);
    }
    let parameters = Spec::default();
    let mut memory = scratch(llt::factor::cholesky_in_place_scratch::<f64>(n, Par::Seq, parameters))?;
    let stack = MemStack::new(&mut memory);
    let lower = MatMut::from_column_major_slice_mut(a, n, n);
    llt::factor::cholesky_in_place(lower, Default::default(), Par::Seq, stack, parameters)
        .map_err(|error| from_llt(error, n))?;
    // A pivot that is not a number passes for positive.
    match (0..n).find(|k| !a[k * n + k].is_finite()) {
        Some(pivot) => Err(SolveError::NotPositiveDefinite { order: n, pivot: Some(pivot), condition: None }),
        None => Ok(()),
    }
}

/// `L⁻¹ x` or `L⁻ᵀ x` for the lower triangle of the column-major `factor`.
fn triangular(n: usize, factor: &[f64], x: &mut [f64], transposed: bool) {
    if transposed {
        for k in (0..n).rev() {
            let column = &factor[k * n..(k + 1) * n];
            x[k] = (x[k] - dot(&column[k + 1..], &x[k + 1..])) / column[k];
        }
    } else {
        for k in 0..n {
            let column = &factor[k * n..(k + 1) * n];
            let value = x[k] / column[k];
            x[k] = value;
            x[k + 1..].iter_mut().zip(&column[k + 1..]).for_each(|(x, l)| *x -= l * value);
        }
    }
}

/// `Σ a b` in eight sums side by side, as vectors of the processor add.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, rest_a), (b, rest_b)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (a, b) in a.iter().zip(b) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}
