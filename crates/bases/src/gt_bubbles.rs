//! GT functions with the control points of Lobatto polynomials: well conditioned at degrees where control points are not.

use crate::gt::{check_degree, quadratic};
use crate::{Basis, BasisError, Lobatto, Matrix};

/// The n − 1 combinations `Σ_i M_ik G_{i,n}` of GT functions whose control points `M_ik` are those of the Lobatto polynomials
/// φ_k ([`Lobatto::bernstein_coefficients`]), on [0, 1].
///
/// They span the GT functions of degree n that vanish at both ends. Scaled to length 1 their condition is about n/4 at every
/// shape, where that of the GT functions themselves is 2ⁿ: systems are solved for in these. No control point is
/// formed to evaluate them: with φ = φ_k, `a = 1/n` and `b = 1/(n(n−1))` the three polynomials of degree n − 2 whose control
/// points are n − 1 successive ones of φ are
///
/// ```text
/// p_0 = φ − 2at φ' + bt² φ'',  p_1 = φ + a(1−2t) φ' − bt(1−t) φ'',  p_2 = φ + 2a(1−t) φ' + b(1−t)² φ'',
/// ```
///
/// and the function is `Σ_j p_j G_{j,2}`, since `G_{k,n} = Σ_j B_{k−j,n−2} G_{j,2}` (GT (2.4)).
///
/// Accuracy: some ulp of the largest value, growing like n² with each order.
///
/// ```
/// use bases::{Basis, Gt, GtBubbles, Lobatto};
/// let (gt, bubbles) = (Gt::new(5, [1.0, 2.0])?, GtBubbles::new(5, [1.0, 2.0])?);
/// let (g, b) = (gt.evaluate(0.3, 0), bubbles.evaluate(0.3, 0));
/// let points = Lobatto::bernstein_coefficients(5)?;
/// for k in 0..4 {
///     let combined: f64 = (0..=5).map(|i| points[(i, k)] * g[(0, i)]).sum();
///     assert!((combined - b[(0, k)]).abs() < 1e-15);
/// }
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct GtBubbles {
    degree: usize,
    shape: [f64; 2],
}

impl GtBubbles {
    /// The functions of degree `degree` with shape parameters `[θ1, θ2]`.
    ///
    /// # Errors
    /// As [`Gt::new`](crate::Gt::new).
    pub fn new(degree: usize, shape: [f64; 2]) -> Result<Self, BasisError> {
        crate::Gt::new(degree, shape)?;
        Ok(Self { degree, shape })
    }
}

impl Basis for GtBubbles {
    fn count(&self) -> usize {
        self.degree - 1
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        assert_eq!(out.len(), (order + 1) * self.count(), "length of the output");
        out.fill(0.0);
        add_products(
            &blossoms(self.degree, t, order),
            &quadratic(t, self.shape, order),
            self.count(),
            0,
            out,
        );
    }
}

/// The affine parts of [`GtBubbles`]: `a_k + θ1 b_k + θ2 c_k`, as one family of 3(n−1) functions in the order a, b, c.
#[derive(Debug, Clone, PartialEq)]
pub struct GtBubbleParts {
    degree: usize,
}

impl GtBubbleParts {
    /// The parts of the functions of degree `degree` ≥ 2.
    ///
    /// # Errors
    /// [`BasisError::Degree`] below 2 or above 1000.
    pub fn new(degree: usize) -> Result<Self, BasisError> {
        check_degree(degree)?;
        Ok(Self { degree })
    }
}

impl Basis for GtBubbleParts {
    fn count(&self) -> usize {
        3 * (self.degree - 1)
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        assert_eq!(out.len(), (order + 1) * self.count(), "length of the output");
        out.fill(0.0);
        let polynomials = blossoms(self.degree, t, order);
        let origin = quadratic(t, [0.0, 0.0], order);
        let mut add = |part: usize, seed: &Matrix| {
            add_products(&polynomials, seed, self.count(), part * (self.degree - 1), out);
        };
        add(0, &origin);
        for (part, shape) in [(1, [1.0, 0.0]), (2, [0.0, 1.0])] {
            let mut seed = quadratic(t, shape, order);
            seed.as_mut_slice().iter_mut().zip(origin.as_slice()).for_each(|(s, o)| *s -= o);
            add(part, &seed);
        }
    }
}

/// `p_0, p_1, p_2` of every φ_k with their derivatives: entry (r, k) of each.
fn blossoms(n: usize, t: f64, order: usize) -> [Matrix; 3] {
    let count = n - 1;
    let mut phi = Matrix::zeros(order + 3, count);
    if let Ok(lobatto) = Lobatto::new(count, (0.0, 1.0)) {
        lobatto.evaluate_into(t, order + 2, phi.as_mut_slice());
    }
    let (a, b, s) = (1.0 / n as f64, 1.0 / (n * (n - 1)) as f64, 1.0 - t);
    // Value, first and second derivative of the factors of φ' and of φ''.
    let factors = [
        ([-2.0 * a * t, -2.0 * a, 0.0], [b * t * t, 2.0 * b * t, 2.0 * b]),
        ([a * (s - t), -2.0 * a, 0.0], [-b * t * s, b * (t - s), 2.0 * b]),
        ([2.0 * a * s, -2.0 * a, 0.0], [b * s * s, -2.0 * b * s, 2.0 * b]),
    ];
    factors.map(|(first, second)| {
        Matrix::from_fn(order + 1, count, |r, k| {
            let product = |factor: [f64; 3], of: usize| -> f64 {
                let choose = [1.0, r as f64, 0.5 * (r * r.saturating_sub(1)) as f64];
                (0..=r.min(2)).map(|q| choose[q] * factor[q] * phi[(r - q + of, k)]).sum()
            };
            phi[(r, k)] + product(first, 1) + product(second, 2)
        })
    })
}

/// Adds `Σ_j p_j G_{j,2}` and its derivatives to the columns from `first` of a table with `count` columns.
fn add_products(polynomials: &[Matrix; 3], seed: &Matrix, count: usize, first: usize, out: &mut [f64]) {
    let [p0, p1, p2] = polynomials;
    for r in 0..p0.rows() {
        for (q, leibniz) in crate::bernstein::binomials(r).into_iter().enumerate() {
            let g = seed.row(q);
            for k in 0..p0.cols() {
                let sum = p0[(r - q, k)] * g[0] + p1[(r - q, k)] * g[1] + p2[(r - q, k)] * g[2];
                out[r * count + first + k] += leibniz * sum;
            }
        }
    }
}
