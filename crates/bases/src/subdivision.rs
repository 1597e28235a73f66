//! Cutting the domain of a family in two.

use std::sync::Arc;

use crate::order_six::COUNT;
use crate::{Basis, BasisError, Bernstein, Matrix};

/// The two sides of a cut, see [`Basis::subdivide`]: what a de Casteljau algorithm needs. Control points on the two sides
/// are linear combinations of those on the whole, with nonnegative weights that sum to 1.
///
/// A side's own parameter starts at 0: the right one at t is the whole at `cut + t`
/// (for [`Bernstein`], whose domain is always [0, 1], both are rescaled).
#[derive(Debug, Clone)]
pub struct Subdivision {
    /// The family left of the cut.
    pub left: Arc<dyn Basis>,
    /// The family right of the cut.
    pub right: Arc<dyn Basis>,
    /// Square matrix whose row i holds the weights of the left control point i; rows sum to 1.
    pub left_map: Matrix,
    /// The same to the right. Its first row is the last row of `left_map`, bit for bit.
    pub right_map: Matrix,
}

impl Subdivision {
    /// The cut of a translation-invariant family of order 6: the endpoint rule of each side applied to every function
    /// of the whole.
    pub(crate) fn of_translation_invariant<B: Basis + 'static>(
        whole: &B,
        t: f64,
        family: impl Fn(f64) -> Result<B, BasisError>,
        control_values: impl Fn(&B, [[f64; 3]; 2]) -> [f64; COUNT],
    ) -> Result<Self, BasisError> {
        let (start, end) = check_cut(whole, t)?;
        let (left, right) = (family(t - start)?, family(end - t)?);
        let jets = [start, t, end].map(|t| whole.evaluate(t, 2));
        let jet = |at: usize, k: usize| [jets[at][(0, k)], jets[at][(1, k)], jets[at][(2, k)]];
        let map = |part: &B, first: usize| {
            let columns: Vec<_> =
                (0..COUNT).map(|k| control_values(part, [jet(first, k), jet(first + 1, k)])).collect();
            Matrix::from_fn(COUNT, COUNT, |i, j| columns[j][i])
        };
        let (left_map, right_map) = (map(&left, 0), map(&right, 1));
        Ok(Self { left: Arc::new(left), right: Arc::new(right), left_map, right_map })
    }

    /// De Casteljau's algorithm: left weights `B_{j,i}(t)`, right weights `B_{j−i,n−i}(t)`.
    pub(crate) fn of_bernstein(whole: &Bernstein, t: f64) -> Result<Self, BasisError> {
        check_cut(whole, t)?;
        let n = whole.degree();
        let rows: Vec<Matrix> =
            (0..=n).map(|i| Bernstein::new(i).map(|b| b.evaluate(t, 0))).collect::<Result<_, _>>()?;
        let left_map = Matrix::from_fn(n + 1, n + 1, |i, j| if j <= i { rows[i][(0, j)] } else { 0.0 });
        let right_map =
            Matrix::from_fn(n + 1, n + 1, |i, j| if j >= i { rows[n - i][(0, j - i)] } else { 0.0 });
        let (left, right) = (Arc::new(whole.clone()), Arc::new(whole.clone()));
        Ok(Self { left, right, left_map, right_map })
    }
}

fn check_cut(basis: &dyn Basis, t: f64) -> Result<(f64, f64), BasisError> {
    let (start, end) = basis.domain();
    if start < t && t < end { Ok((start, end)) } else { Err(BasisError::Cut { cut: t, start, end }) }
}
