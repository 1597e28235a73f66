//! Lagrange polynomials at the Gauss–Lobatto points.

use crate::{Basis, BasisError, Matrix};

/// The Lagrange polynomials `ℓ_0 … ℓ_n` of degree n ≥ 1 at the n + 1 Gauss–Lobatto points of [0, 1]: `ℓ_j(t_i) = δ_ij`.
///
/// Coefficients in them are values, bounded by those of the function at any degree, where the control points of a Bernstein
/// polynomial may be 2ⁿ times as large: the functions to compute in at high degree. [`Self::inner_bernstein`] leads back to
/// control points.
///
/// Accuracy: a few n ulp of 1 for values, n² times as much for each derivative.
///
/// ```
/// use bases::{Basis, Nodal};
/// let quadratic = Nodal::new(2)?;
/// assert_eq!(quadratic.nodes(), [0.0, 0.5, 1.0]);
/// assert!((quadratic.evaluate(0.25, 0).row(0)[1] - 0.75).abs() < 1e-15);
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Nodal {
    nodes: Vec<f64>,
    weights: Vec<f64>,
    /// Coefficient of P_k(2t − 1) in ℓ_j at (j, k).
    legendre: Matrix,
}

impl Nodal {
    /// Largest degree offered.
    pub const MAX_DEGREE: usize = 1000;

    /// The family of degree `degree`, 1 … 1000.
    ///
    /// # Errors
    /// [`BasisError::Degree`] for another degree.
    pub fn new(degree: usize) -> Result<Self, BasisError> {
        if !(1..=Self::MAX_DEGREE).contains(&degree) {
            return Err(BasisError::Degree { family: "nodal", degree, min: 1, max: Self::MAX_DEGREE });
        }
        let p = degree as f64;
        let right: Vec<f64> = (0..=degree / 2).map(|k| node(degree, k)).collect();
        let x = |k: usize| if k <= degree / 2 { -right[k] } else { right[degree - k] };
        let tables: Vec<Vec<f64>> = (0..=degree).map(|k| legendre(degree, x(k), 0).swap_remove(0)).collect();
        let nodes =
            (0..=degree).map(|k| if 2 * k <= degree { 0.5 * (1.0 + x(k)) } else { 1.0 - 0.5 * (1.0 - x(k)) });
        // Weights of the Gauss–Lobatto rule on [−1, 1]; it is exact for P_k P_l unless k = l = n, where it gives 2/n.
        let weight = |j: usize| 2.0 / (p * (p + 1.0) * tables[j][degree].powi(2));
        let norm = |k: usize| if k < degree { 2.0 / (2 * k + 1) as f64 } else { 2.0 / p };
        let map = Matrix::from_fn(degree + 1, degree + 1, |j, k| weight(j) * tables[j][k] / norm(k));
        Ok(Self {
            nodes: nodes.collect(),
            weights: (0..=degree).map(|j| 0.5 * weight(j)).collect(),
            legendre: map,
        })
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.nodes.len() - 1
    }

    /// The points `t_0 = 0 < … < t_n = 1`, symmetric about ½.
    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// The coefficients of a polynomial of degree n that vanishes at both ends in the functions of
    /// [`Lobatto`](crate::Lobatto), from its values at the inner nodes: (n − 1)², functions by rows.
    ///
    /// `c_k = (2k + 1) ∫ f' P_k = −(2k + 1) ∫ f P_k'`, which the Gauss–Lobatto rule integrates exactly.
    pub fn inner_lobatto(&self) -> Matrix {
        let n = self.degree();
        let slopes: Vec<Vec<f64>> =
            (1..n).map(|j| legendre(n, 2.0 * self.nodes[j] - 1.0, 1).swap_remove(1)).collect();
        Matrix::from_fn(n - 1, n - 1, |k, j| {
            let factor = (2 * k + 3) as f64;
            -factor * self.weights[j + 1] * 2.0 * slopes[j][k + 1]
        })
    }

    /// The inner Bernstein coefficients 1 … n − 1 of the functions φ_1 … φ_{n−1} of [`Lobatto`](crate::Lobatto) on [0, 1],
    /// as polynomials of degree n: (n − 1)², coefficients by rows, functions by columns. The outer coefficients are 0.
    ///
    /// Of degree k + 1, φ_k has the coefficients `(−1)^{k+i−1} C(k − 1, i − 1)/(k + 1)`, i = 1 … k; the degree is raised from
    /// there. Up to 2ⁿ in size.
    pub fn inner_bernstein(&self) -> Matrix {
        let n = self.degree();
        let mut map = Matrix::zeros(n - 1, n - 1);
        for k in 1..n {
            let low = crate::bernstein::binomials(k - 1);
            let mut coefficients = vec![0.0; k + 2];
            for i in 1..=k {
                let sign = if (k + i - 1).is_multiple_of(2) { 1.0 } else { -1.0 };
                coefficients[i] = sign * low[i - 1] / (k + 1) as f64;
            }
            for degree in k + 2..=n {
                let share = |i: usize| i as f64 / degree as f64;
                coefficients = (0..=degree)
                    .map(|i| {
                        let below = if i > 0 { share(i) * coefficients[i - 1] } else { 0.0 };
                        let here = if i < degree { (1.0 - share(i)) * coefficients[i] } else { 0.0 };
                        below + here
                    })
                    .collect();
            }
            (1..n).for_each(|i| map[(i - 1, k - 1)] = coefficients[i]);
        }
        map
    }
}

impl Basis for Nodal {
    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        let count = self.count();
        assert_eq!(out.len(), (order + 1) * count, "length of the output");
        let x = if t < 0.5 { 2.0 * t - 1.0 } else { 1.0 - 2.0 * (1.0 - t) };
        let tables = legendre(self.degree(), x, order);
        let mut scale = 1.0;
        for (table, row) in tables.iter().zip(out.chunks_exact_mut(count)) {
            for (j, value) in row.iter_mut().enumerate() {
                *value = scale * self.legendre.row(j).iter().zip(table).map(|(c, p)| c * p).sum::<f64>();
            }
            scale *= 2.0;
        }
    }
}

/// `P_0^{(r)} … P_n^{(r)}` at x for r = 0 … order, by the three-term recursion differentiated r times.
fn legendre(n: usize, x: f64, order: usize) -> Vec<Vec<f64>> {
    let mut tables = vec![vec![0.0; n + 1]; order + 1];
    for r in 0..=order {
        if r == 0 {
            tables[0][0] = 1.0;
        }
        for k in 1..=n {
            let kf = k as f64;
            let below = if k >= 2 { tables[r][k - 2] } else { 0.0 };
            let lower = if r > 0 { r as f64 * tables[r - 1][k - 1] } else { 0.0 };
            tables[r][k] = ((2.0 * kf - 1.0) * (x * tables[r][k - 1] + lower) - (kf - 1.0) * below) / kf;
        }
    }
    tables
}

/// The k-th largest of the n + 1 Gauss–Lobatto points on [−1, 1], k ≤ n/2: 1 and the zeros of P_n'.
fn node(n: usize, k: usize) -> f64 {
    if k == 0 {
        return 1.0;
    }
    if 2 * k == n {
        return 0.0;
    }
    let nf = n as f64;
    // Newton on (1 − x²) P_n' = n (P_{n−1} − x P_n), whose derivative is −n (n + 1) P_n.
    let mut x = libm::cos(std::f64::consts::PI * k as f64 / nf);
    for _ in 0..50 {
        let p = legendre(n, x, 0).swap_remove(0);
        let step = (p[n - 1] - x * p[n]) / ((nf + 1.0) * p[n]);
        x += step;
        if step.abs() <= 2.0 * f64::EPSILON * x.abs() {
            break;
        }
    }
    x
}
