use std::fmt::Debug;

use crate::{BasisError, Matrix, Subdivision};

/// A finite family of smooth functions φ₀ … φ_{count−1} of one variable on a closed interval.
///
/// Dyn-compatible and small on purpose: everything else (Gram matrices, curves, patches, energies) is
/// built from these three questions.
pub trait Basis: Debug + Send + Sync {
    /// Number of functions.
    fn count(&self) -> usize;

    /// The interval `(start, end)` the functions are meant for, `start < end`.
    ///
    /// Outside it the defining formulas are continued; no accuracy is promised there.
    fn domain(&self) -> (f64, f64);

    /// Fills `out[r · count + k] = φ_k^{(r)}(t)` for r = 0 … `order`.
    ///
    /// A `t` that is not a number gives values that are not numbers.
    ///
    /// # Panics
    /// If `out` is not `(order + 1) · count` long.
    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]);

    /// Values and derivatives as a matrix: row r holds the r-th derivatives of all functions at `t`.
    fn evaluate(&self, t: f64, order: usize) -> Matrix {
        let mut table = Matrix::zeros(order + 1, self.count());
        self.evaluate_into(t, order, table.as_mut_slice());
        table
    }

    /// The families of the two sides of `t` and the maps that take control points on the whole to theirs, for a
    /// family whose functions, restricted to either side, are combinations of a family of the same kind.
    ///
    /// # Errors
    /// [`BasisError::NotSubdivisible`] for a family that has no such sides (the default; GT is one),
    /// [`BasisError::Cut`] unless `t` lies strictly inside the domain, [`BasisError::Span`] if a side is shorter than
    /// the family allows.
    fn subdivide(&self, _t: f64) -> Result<Subdivision, BasisError> {
        Err(BasisError::NotSubdivisible)
    }
}
