//! The smallest eigenvalue of a form against another, by Lanczos' method.

use crate::SolveError;
use crate::eigen::eigen_symmetric;
use crate::memory::copy;

/// An eigenvalue with its vector.
#[derive(Debug, Clone, PartialEq)]
pub struct Eigenpair {
    /// The eigenvalue.
    pub value: f64,
    /// The vector x, xᵀ B x = 1.
    pub vector: Vec<f64>,
}

/// Relative accuracy of the eigenvalue, against the largest size of one.
const TOLERANCE: f64 = 1e-12;

/// The smallest eigenvalue of `A x = λ B x`, A symmetric, B symmetric positive definite, both n × n and known by what they do:
/// `apply` gives (A x, B x) and `invert` B⁻¹ x. None for n = 0.
///
/// Lanczos' method from the fixed vector `start`, orthogonalised twice, at most `steps` steps: quick where the smallest
/// eigenvalues lie apart, as those of compact perturbations of the identity do. An upper bound of the smallest eigenvalue in
/// any case. O(n steps²) beside the products.
///
/// # Errors
/// Those of `apply` and `invert`; as [`eigen_symmetric`].
pub fn smallest_eigenpair(
    start: &[f64],
    steps: usize,
    mut apply: impl FnMut(&[f64]) -> Result<[Vec<f64>; 2], SolveError>,
    mut invert: impl FnMut(Vec<f64>) -> Result<Vec<f64>, SolveError>,
) -> Result<Option<Eigenpair>, SolveError> {
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    // The vectors q, B-orthonormal, with B q beside them.
    let (mut basis, mut images): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    let (mut diagonal, mut beside): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let mut next = copy(start)?;
    let mut found: Option<(f64, Vec<f64>)> = None;
    // In exact arithmetic n steps exhaust the space.
    for step in 0..steps.min(start.len()) {
        let [mut image, mut weighed] = apply(&next)?;
        let length = dot(&next, &weighed).sqrt();
        // Length 0: what is spanned is invariant, and its smallest eigenvalue is exact. NaN or a negative square: B is not positive there.
        if !(length > 0.0 && length.is_finite()) {
            break;
        }
        for vector in [&mut next, &mut image, &mut weighed] {
            vector.iter_mut().for_each(|x| *x /= length);
        }
        if step > 0 {
            beside.push(length);
        }
        // In this basis the form A is tridiagonal: here is its next diagonal entry, and `beside` holds those beside the diagonal.
        diagonal.push(dot(&next, &image));
        basis.push(std::mem::take(&mut next));
        images.push(weighed);
        let (value, vector) = smallest_of_tridiagonal(&diagonal, &beside)?;
        let size = diagonal.iter().chain(&beside).fold(0.0f64, |m, x| m.max(x.abs()));
        next = invert(image)?;
        // The three-term recurrence in full: against all vectors, and twice, because rounding lets lost directions grow again and then
        // the smallest eigenvalue would appear several times.
        for _ in 0..2 {
            for (q, b) in basis.iter().zip(&images) {
                let share = dot(&next, b);
                next.iter_mut().zip(q).for_each(|(x, q)| *x -= share * q);
            }
        }
        // Residual of the Ritz pair in the norm of B: the length of the next vector times the last component of the eigenvector.
        let [_, weighed] = apply(&next)?;
        let residual = dot(&next, &weighed).max(0.0).sqrt() * vector[step].abs();
        // A Ritz value is off by about the square of the residual over the gap; the first step knows no gap and may not use that.
        let settled = residual * residual <= TOLERANCE * size * size.max(residual);
        found = Some((value, vector));
        if settled && step > 0 || residual <= TOLERANCE * size {
            break;
        }
    }
    Ok(found.map(|(value, shares)| {
        let mut vector = vec![0.0; start.len()];
        for (share, q) in shares.iter().zip(&basis) {
            vector.iter_mut().zip(q).for_each(|(x, q)| *x += share * q);
        }
        Eigenpair { value, vector }
    }))
}

fn smallest_of_tridiagonal(diagonal: &[f64], beside: &[f64]) -> Result<(f64, Vec<f64>), SolveError> {
    let n = diagonal.len();
    let mut matrix = vec![0.0; n * n];
    for k in 0..n {
        matrix[k * n + k] = diagonal[k];
        if k + 1 < n {
            (matrix[k * n + k + 1], matrix[(k + 1) * n + k]) = (beside[k], beside[k]);
        }
    }
    // Small (as many rows as steps), so the dense solver is good enough.
    let eigen = eigen_symmetric(n, &matrix)?;
    Ok((eigen.values[0], (0..n).map(|k| eigen.vectors[k * n]).collect()))
}
