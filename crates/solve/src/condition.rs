//! Condition numbers in the 1-norm from a factorisation, by Hager's iteration with Higham's safeguards
//! (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., algorithm 15.1), and the
//! residual of a solution as LAPACK's tests scale it.

use crate::SolveError;

/// A lower bound of ‖A⁻¹‖₁, almost always within a factor 3 of it.
///
/// `solve` and `solve_transposed` replace a vector by `A⁻¹` and `A⁻ᵀ` times it. About five solves.
pub(crate) fn inverse_norm(
    n: usize,
    mut solve: impl FnMut(&mut [f64]),
    mut solve_transposed: impl FnMut(&mut [f64]),
) -> f64 {
    if n == 0 {
        return 0.0;
    }
    let norm = |x: &[f64]| x.iter().map(|a| a.abs()).sum::<f64>();
    let mut x = vec![1.0 / n as f64; n];
    solve(&mut x);
    let mut estimate = norm(&x);
    if n == 1 || !estimate.is_finite() {
        return estimate;
    }
    let mut sign: Vec<f64> = x.iter().map(|a| 1f64.copysign(*a)).collect();
    let mut previous = usize::MAX;
    for _ in 0..5 {
        let mut z = sign.clone();
        solve_transposed(&mut z);
        let (j, _) = z
            .iter()
            .enumerate()
            .fold((0, -1.0), |best, (i, a)| if a.abs() > best.1 { (i, a.abs()) } else { best });
        if j == previous {
            break;
        }
        previous = j;
        x.fill(0.0);
        x[j] = 1.0;
        solve(&mut x);
        let found = norm(&x);
        let unchanged = x.iter().zip(&sign).all(|(a, s)| 1f64.copysign(*a) == *s);
        if !found.is_finite() {
            return found;
        }
        if found <= estimate || unchanged {
            estimate = estimate.max(found);
            break;
        }
        estimate = found;
        sign.iter_mut().zip(&x).for_each(|(s, a)| *s = 1f64.copysign(*a));
    }
    // Alternating and growing: catches the matrices built to defeat the iteration above.
    for (i, a) in x.iter_mut().enumerate() {
        *a = (1.0 + i as f64 / (n - 1) as f64) * if i % 2 == 0 { 1.0 } else { -1.0 };
    }
    solve(&mut x);
    let found = 2.0 * norm(&x) / (3.0 * n as f64);
    if found.is_finite() { estimate.max(found) } else { found }
}

/// Conditions beyond this prove nothing: 1/(n ε), and never above 10¹⁵.
pub(crate) fn limit(n: usize) -> f64 {
    1.0 / (n.max(5) as f64 * f64::EPSILON)
}

/// The scaled residual above which LAPACK's tests call a solution wrong.
const RESIDUAL_THRESHOLD: f64 = 30.0;

/// The residual of a solution, if it is one.
pub(crate) fn accepted(order: usize, ratio: f64) -> Result<f64, SolveError> {
    if ratio <= RESIDUAL_THRESHOLD { Ok(ratio) } else { Err(SolveError::Residual { order, ratio }) }
}

/// ‖b − A x‖₁ / (‖A‖₁ ‖x‖₁ n ε) of one column.
pub(crate) fn scaled_residual(n: usize, norm: f64, defect: &[f64], x: &[f64]) -> f64 {
    let one_norm = |column: &[f64]| column.iter().map(|a| a.abs()).sum::<f64>();
    let defect = one_norm(defect);
    if defect == 0.0 { 0.0 } else { defect / (norm * one_norm(x) * n as f64 * f64::EPSILON) }
}
