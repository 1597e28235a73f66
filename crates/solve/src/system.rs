use crate::memory::{copy, transposed};
use crate::scale::{by_power, exponent};
use crate::{Place, SolveError, check, condition};

/// The answer of a linear system, with the figures that say how far it can be trusted.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The unknowns, row-major, one row an unknown.
    pub x: Vec<f64>,
    /// The largest of `‖b − A x‖₁ / (‖A‖₁ ‖x‖₁ n ε)` over the right-hand columns: at most about 1 when
    /// all is well, never above 30 (the threshold of LAPACK's tests), which is [`SolveError::Residual`]. 0 for no
    /// unknowns.
    pub residual: f64,
    /// Estimate from below of `‖A‖₁ ‖A⁻¹‖₁`, almost always within a factor 3. 1 for no unknowns.
    pub condition: f64,
}

/// What is known of a square matrix that is factored in units in which its largest entry is near 1.
#[derive(Debug, Clone)]
pub(crate) struct System {
    pub(crate) n: usize,
    /// The matrix is `2^exponent` times the factored one.
    exponent: i32,
    /// ‖A‖₁ in those units.
    norm: f64,
    pub(crate) condition: f64,
}

impl System {
    pub(crate) fn new(n: usize, exponent: i32, norm: f64) -> Self {
        Self { n, exponent, norm, condition: 1.0 }
    }

    /// Keeps the condition number and says whether it leaves the solution a meaning.
    pub(crate) fn accept(&mut self, inverse_norm: f64, limit: f64) -> bool {
        if self.n > 0 {
            self.condition = self.norm * inverse_norm;
        }
        self.condition <= limit
    }

    /// 0 where the inverse overflowed.
    pub(crate) fn reciprocal_condition(&self) -> f64 {
        if self.condition.is_nan() { 0.0 } else { 1.0 / self.condition }
    }

    /// Solves for right-hand sides brought near 1, measures the residual there, and scales back.
    ///
    /// `solve_in_place` takes the columns one after the other; `subtract_product(x, b)` is `b ← b − A x` of one.
    pub(crate) fn solve(
        &self,
        columns: usize,
        rhs: &[f64],
        solve_in_place: impl FnOnce(&mut [f64]) -> Result<(), SolveError>,
        subtract_product: impl Fn(&[f64], &mut [f64]),
    ) -> Result<Solution, SolveError> {
        let n = self.n;
        check::right_hand_side(n, columns, rhs)?;
        let mut b = transposed(n, columns, rhs)?;
        let exponents: Vec<i32> = (0..columns).map(|c| exponent(&b[c * n..(c + 1) * n])).collect();
        for c in 0..columns {
            b[c * n..(c + 1) * n].iter_mut().for_each(|a| *a = by_power(*a, -exponents[c]));
        }
        let mut x = copy(&b)?;
        solve_in_place(&mut x)?;
        let mut residual = 0.0f64;
        for c in 0..columns {
            let (b, x) = (&mut b[c * n..(c + 1) * n], &mut x[c * n..(c + 1) * n]);
            subtract_product(x, b);
            let ratio = condition::scaled_residual(n, self.norm, b, x);
            // What is not a number is kept, to be refused.
            residual = if ratio <= residual { residual } else { ratio };
            x.iter_mut().for_each(|a| *a = by_power(*a, exponents[c] - self.exponent));
        }
        let x = transposed(columns, n, &x)?;
        check::finite(Place::Solution, columns.max(1), &x)?;
        Ok(Solution { x, residual: condition::accepted(n, residual)?, condition: self.condition })
    }
}
