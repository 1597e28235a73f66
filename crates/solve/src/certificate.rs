//! A proof of positive definiteness in floating point.

use crate::dense::factor_plain;
use crate::memory::zeros;
use crate::scale::by_power;
use crate::{SolveError, check};

/// Half the distance from 1 to the next number: the unit roundoff u.
const U: f64 = f64::EPSILON / 2.0;

/// Whether `matrix` (`n × n`, row-major) is *proved* positive definite: `true` is a theorem about the numbers as they
/// stand, `false` only says that no proof was found.
///
/// What is proved: `xᵀ A x > 0` for every real x ≠ 0, with A exactly the matrix of the given doubles. Where A is not
/// symmetric bit for bit this is about its symmetric part ½ (A + Aᵀ), which is all that an energy sees.
///
/// How (Rump, *Verification of positive definiteness*, BIT 46, 2006): A is scaled by powers of two to a diagonal within
/// [½, 2), which is exact; `c ≥ ((n+1)/(1 − 2(n+1)u) + 1) u·tr A + ‖D‖∞` is subtracted from the diagonal, with u = 2⁻⁵³ and
/// D the difference of the lower triangle from the symmetric part; then Cholesky's algorithm is run in floating point. If
/// it ends, its factor is that of a matrix at most `γ/(1 − γ) · tr A` away in the 2-norm, `γ = (n+1)u / (1 − (n+1)u)`
/// (Demmel's bound; Higham, *Accuracy and Stability*, theorems 10.3 and 10.5), and `L Lᵀ` has no negative eigenvalue, so
/// that the least of A is above 0 by what was subtracted. The constant that is used, n + 3 for n + 2, pays for the
/// roundings of the trace, the shift and D, and for all underflows: they stay below 2⁻¹⁰⁰⁰ n² where u/4 is to spare.
///
/// A bare Cholesky factorisation that ends proves nothing near singular matrices. The proof succeeds while the condition
/// of the scaled matrix is below about 1/(n² u) at worst, ten to a hundred times more for most matrices. O(n³), plain loops.
///
/// ```
/// // Definite by 5e-15; singular.
/// assert!(solve::proves_positive_definite(2, &[1.0, 1.0, 1.0, 1.0 + 1e-14])?);
/// assert!(!solve::proves_positive_definite(2, &[1.0, 1.0, 1.0, 1.0])?);
/// # Ok::<(), solve::SolveError>(())
/// ```
///
/// # Errors
/// [`SolveError::WrongShape`], [`SolveError::NotFinite`], [`SolveError::TooLarge`], [`SolveError::OutOfMemory`]. Never
/// because the matrix is not positive definite or not symmetric.
pub fn proves_positive_definite(n: usize, matrix: &[f64]) -> Result<bool, SolveError> {
    check::square(n, matrix)?;
    if (0..n).any(|k| matrix[k * n + k] <= 0.0) {
        return Ok(false);
    }
    // 2^-e with 2^(2e) within a factor 2 of the diagonal entry.
    let exponents: Vec<i32> = (0..n).map(|k| half_exponent(matrix[k * n + k])).collect();
    let scaled = |i: usize, j: usize| by_power(matrix[i * n + j], -exponents[i] - exponents[j]);
    let mut lower = zeros(n * n)?;
    let mut defects = zeros(n)?;
    for j in 0..n {
        for i in j..n {
            let (a, mirrored) = (scaled(i, j), scaled(j, i));
            lower[j * n + i] = a;
            let defect = 0.5 * (a - mirrored).abs();
            defects[i] += defect;
            defects[j] += defect;
        }
    }
    let trace: f64 = (0..n).map(|k| lower[k * n + k]).sum();
    // Twice the norm of D: its roundings are covered many times over.
    let defect = defects.iter().fold(0.0f64, |max, d| max.max(*d));
    let shift = (n + 3) as f64 * U * trace + 2.0 * defect;
    (0..n).for_each(|k| lower[k * n + k] -= shift);
    // An overflow on the way, of a matrix far from definite, ends at a pivot that is not a positive number.
    Ok(factor_plain(n, &mut lower).is_ok())
}

/// The e with a / 2^(2e) within [½, 2) for a > 0; subnormal numbers included.
fn half_exponent(a: f64) -> i32 {
    let exponent = |a: f64| ((a.to_bits() >> 52) & 0x7ff) as i32 - 1023;
    let e = if a < f64::MIN_POSITIVE { exponent(by_power(a, 128)) - 128 } else { exponent(a) };
    (e + 1).div_euclid(2)
}
