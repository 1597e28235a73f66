//! Integrated Legendre polynomials.

use crate::{Basis, BasisError, Matrix};

/// The polynomials `φ_k(t) = ∫ P_k` from the start of an interval, k = 1 … n: degree k + 1, zero at both ends.
///
/// Their derivatives are the Legendre polynomials, orthogonal, so that sampled tables of them stay well
/// conditioned at any size: the functions of choice to fill a square whose boundary is given. On `[start, end]` with
/// x ∈ [−1, 1]: `φ_k = (P_{k+1}(x) − P_{k−1}(x)) (end − start) / (2 (2k + 1))`.
///
/// Accuracy: a few ulp of the largest value for values and first derivatives, growing like n² with the order.
#[derive(Debug, Clone, PartialEq)]
pub struct Lobatto {
    count: usize,
    domain: (f64, f64),
}

impl Lobatto {
    /// Largest number of functions offered.
    pub const MAX_COUNT: usize = 1000;

    /// The first `count` functions on `[start, end]`.
    ///
    /// # Errors
    /// [`BasisError::Degree`] above [`Self::MAX_COUNT`], or for none; [`BasisError::Interval`] for an interval that is
    /// empty or not finite.
    pub fn new(count: usize, (start, end): (f64, f64)) -> Result<Self, BasisError> {
        if !(1..=Self::MAX_COUNT).contains(&count) {
            return Err(BasisError::Degree {
                family: "Lobatto",
                degree: count,
                min: 1,
                max: Self::MAX_COUNT,
            });
        }
        if !(start < end && (end - start).is_finite()) {
            return Err(BasisError::Interval { start, end });
        }
        Ok(Self { count, domain: (start, end) })
    }

    /// Largest degree of [`Self::bernstein_coefficients`]: beyond it their numerators leave 128 bits.
    pub const MAX_BERNSTEIN_DEGREE: usize = 64;

    /// The Bernstein coefficients of degree n of the n − 1 functions of degree at most n on [0, 1]: (n+1) × (n−1), column
    /// k − 1 holds those of φ_k, the first and the last row are zero.
    ///
    /// They are quotients of integers, formed exactly and rounded once. The largest grows like 2ⁿ: a polynomial with
    /// well-determined coefficients here may need control points that doubles cannot hold.
    ///
    /// # Errors
    /// [`BasisError::Degree`] below 2 or above [`Self::MAX_BERNSTEIN_DEGREE`].
    pub fn bernstein_coefficients(degree: usize) -> Result<Matrix, BasisError> {
        let (min, max) = (2, Self::MAX_BERNSTEIN_DEGREE);
        if !(min..=max).contains(&degree) {
            return Err(BasisError::Degree { family: "Lobatto", degree, min, max });
        }
        let binomials = pascal(degree);
        let legendre: Vec<Vec<i128>> =
            (0..=degree).map(|k| legendre_numerators(&binomials, degree, k)).collect();
        Ok(Matrix::from_fn(degree + 1, degree - 1, |i, column| {
            let k = column + 1;
            let numerator = legendre[k + 1][i] - legendre[k - 1][i];
            numerator as f64 / (binomials[degree][i] as f64 * (4 * k + 2) as f64)
        }))
    }
}

/// The binomials C(r, i) for r = 0 … n.
fn pascal(n: usize) -> Vec<Vec<i128>> {
    let mut rows = vec![vec![1]];
    for r in 1..=n {
        let above = &rows[r - 1];
        let row = (0..=r).map(|i| if i == 0 || i == r { 1 } else { above[i - 1] + above[i] }).collect();
        rows.push(row);
    }
    rows
}

/// C(n, i) times the Bernstein coefficients of degree n of `P_k(2t − 1)`: `P_k = Σ_j (−1)^{k+j} C(k,j) B_{j,k}`, raised n − k times.
fn legendre_numerators(binomials: &[Vec<i128>], n: usize, k: usize) -> Vec<i128> {
    let raise = n - k;
    let term = |i: usize, j: usize| {
        let product = binomials[k][j] * binomials[k][j] * binomials[raise][i - j];
        if (k + j).is_multiple_of(2) { product } else { -product }
    };
    (0..=n).map(|i| (i.saturating_sub(raise)..=k.min(i)).map(|j| term(i, j)).sum()).collect()
}

impl Basis for Lobatto {
    fn count(&self) -> usize {
        self.count
    }

    fn domain(&self) -> (f64, f64) {
        self.domain
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        let n = self.count;
        assert_eq!(out.len(), (order + 1) * n, "length of the output");
        let (start, end) = self.domain;
        let scale = 2.0 / (end - start);
        // From the nearer end: x keeps its digits there.
        let x = if t - start < end - t { (t - start) * scale - 1.0 } else { 1.0 - (end - t) * scale };
        // legendre[r][k] = P_k^{(r)}(x), by the recursion (k+1) P_{k+1} = (2k+1) x P_k − k P_{k−1} differentiated r times.
        let mut legendre = vec![vec![0.0; n + 2]; order.max(1)];
        for r in 0..legendre.len() {
            for k in 0..=n + 1 {
                legendre[r][k] = match (r, k) {
                    (0, 0) => 1.0,
                    (_, 0) => 0.0,
                    _ => {
                        let kf = k as f64;
                        let below = if k >= 2 { legendre[r][k - 2] } else { 0.0 };
                        let lower = if r > 0 { r as f64 * legendre[r - 1][k - 1] } else { 0.0 };
                        ((2.0 * kf - 1.0) * (x * legendre[r][k - 1] + lower) - (kf - 1.0) * below) / kf
                    }
                };
            }
        }
        for k in 1..=n {
            let difference = legendre[0][k + 1] - legendre[0][k - 1];
            out[k - 1] = difference / ((2 * k + 1) as f64 * scale);
            let mut factor = 1.0;
            for r in 1..=order {
                out[r * n + k - 1] = factor * legendre[r - 1][k];
                factor *= scale;
            }
        }
    }
}
