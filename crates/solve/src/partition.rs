use crate::SolveError;
use crate::check;

/// The unknowns of a linear system, parted into free and fixed ones.
///
/// With the unknowns ordered free first, `Q X = B` reads
///
/// ```text
/// ⎡ Q_ff  Q_fb ⎤ ⎡ p   ⎤   ⎡ B_f ⎤
/// ⎢            ⎥ ⎢     ⎥ = ⎢     ⎥
/// ⎣ Q_bf  Q_bb ⎦ ⎣ P_b ⎦   ⎣ B_b ⎦
/// ```
///
/// and the minimiser of `Σ_d X_dᵀ Q X_d` with `P_b` held is `Q_ff p = −Q_fb P_b`.
/// Arrays are row-major, one row an unknown, `columns` numbers a row.
///
/// ```
/// use solve::Partition;
///
/// // The middle one of three springs in a row hangs free between 1 and 5.
/// let q = [2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 2.0];
/// let partition = Partition::new(&[true, false, true]);
/// assert_eq!((partition.free(), partition.fixed()), (&[1][..], &[0, 2][..]));
///
/// let x = solve::solve_partitioned(3, &q, &partition, 1, &[1.0, 0.0, 5.0])?.x;
/// assert_eq!(x, [1.0, 3.0, 5.0]);
///
/// // The block equation itself: q_ff p = −q_fb P_b.
/// let coupling = q[1 * 3 + 0] * x[0] + q[1 * 3 + 2] * x[2];
/// assert_eq!(q[1 * 3 + 1] * x[1], -coupling);
/// # Ok::<(), solve::SolveError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Partition {
    free: Vec<usize>,
    fixed: Vec<usize>,
}

impl Partition {
    /// The partition of `fixed.len()` unknowns by a mask: `true` is fixed.
    pub fn new(fixed: &[bool]) -> Self {
        let with = |state: bool| (0..fixed.len()).filter(|&i| fixed[i] == state).collect();
        Self { free: with(false), fixed: with(true) }
    }

    /// The partition of an `rows × cols` net (index `i·cols + j`) whose free unknowns are `free_rows × free_cols`.
    ///
    /// # Errors
    /// [`SolveError::WrongIndex`] if a list is not strictly increasing or leaves the net.
    pub fn of_net(
        rows: usize,
        cols: usize,
        free_rows: &[usize],
        free_cols: &[usize],
    ) -> Result<Self, SolveError> {
        check::indices("free rows", free_rows, rows)?;
        check::indices("free columns", free_cols, cols)?;
        let order = check::product("number of unknowns", rows, cols)?;
        let mut fixed = crate::memory::filled(order, true)?;
        for &i in free_rows {
            for &j in free_cols {
                fixed[i * cols + j] = false;
            }
        }
        Ok(Self::new(&fixed))
    }

    /// Number of unknowns, free and fixed.
    pub fn order(&self) -> usize {
        self.free.len() + self.fixed.len()
    }

    /// The free unknowns, increasing.
    pub fn free(&self) -> &[usize] {
        &self.free
    }

    /// The fixed unknowns, increasing.
    pub fn fixed(&self) -> &[usize] {
        &self.fixed
    }

    /// The rows of the free unknowns, in order.
    ///
    /// # Errors
    /// [`SolveError::WrongShape`] unless `values` is `order × columns`; [`SolveError::TooLarge`] if nothing can be.
    pub fn gather_free(&self, columns: usize, values: &[f64]) -> Result<Vec<f64>, SolveError> {
        self.gather(&self.free, columns, values)
    }

    /// The block `Q_ff` of a square matrix over all unknowns: `free × free`, row-major.
    ///
    /// # Errors
    /// [`SolveError::WrongShape`] unless `matrix` is `order × order`; [`SolveError::OutOfMemory`].
    pub fn free_block(&self, matrix: &[f64]) -> Result<Vec<f64>, SolveError> {
        let (n, order) = (self.order(), self.free.len());
        check::length("length of the matrix", check::product("size of the matrix", n, n)?, matrix.len())?;
        let mut block = crate::memory::zeros(order * order)?;
        for (row, &i) in block.chunks_exact_mut(order.max(1)).zip(&self.free) {
            row.iter_mut().zip(&self.free).for_each(|(a, &j)| *a = matrix[i * n + j]);
        }
        Ok(block)
    }

    /// The rows of the fixed unknowns, in order.
    ///
    /// # Errors
    /// [`SolveError::WrongShape`] unless `values` is `order × columns`; [`SolveError::TooLarge`] if nothing can be.
    pub fn gather_fixed(&self, columns: usize, values: &[f64]) -> Result<Vec<f64>, SolveError> {
        self.gather(&self.fixed, columns, values)
    }

    /// Writes the rows of `free` to where the free unknowns stand in `values`; the fixed rows stay as they are.
    ///
    /// # Errors
    /// [`SolveError::WrongShape`] unless `free` is `free × columns` and `values` is `order × columns`;
    /// [`SolveError::TooLarge`] if nothing can be.
    pub fn scatter_free(&self, columns: usize, free: &[f64], values: &mut [f64]) -> Result<(), SolveError> {
        let size = |rows| check::product("size of the values", rows, columns);
        check::length("length of the free values", size(self.free.len())?, free.len())?;
        check::length("length of the values", size(self.order())?, values.len())?;
        for (k, &i) in self.free.iter().enumerate() {
            values[i * columns..(i + 1) * columns].copy_from_slice(&free[k * columns..(k + 1) * columns]);
        }
        Ok(())
    }

    fn gather(&self, rows: &[usize], columns: usize, values: &[f64]) -> Result<Vec<f64>, SolveError> {
        let size = check::product("size of the values", self.order(), columns)?;
        check::length("length of the values", size, values.len())?;
        Ok(rows.iter().flat_map(|&i| &values[i * columns..(i + 1) * columns]).copied().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::Partition;
    use crate::SolveError;

    #[test]
    fn a_product_of_sizes_that_overflows_is_an_error() {
        let partition = Partition::new(&[false, false, true, true]);
        // Twice and four times that is 0 modulo 2^64.
        let columns = 1 << (usize::BITS - 1);
        let errors = [
            partition.gather_free(columns, &[]).err(),
            partition.gather_fixed(columns, &[]).err(),
            partition.scatter_free(columns, &[], &mut []).err(),
        ];
        assert!(errors.iter().all(|e| matches!(e, Some(SolveError::TooLarge { .. }))), "{errors:?}");
    }
}
