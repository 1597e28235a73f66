//! The generalized trigonometric (GT) Bézier basis (GT §2.2).

use std::f64::consts::{FRAC_PI_2, PI};

use crate::bernstein::{self, BinomialRows, binomials};
use crate::{Basis, BasisError, Matrix};

const MAX_DEGREE: usize = 1000;

/// The GT–Bézier functions `G_{0,n} … G_{n,n}` of degree n ≥ 2 with shape θ = (θ1, θ2), on [0, 1].
///
/// Degree 2 is trigonometric (GT (2.3)), each further degree is raised by (GT (2.4)); in closed form
/// `G_{k,n} = Σ_{j=0..2} B_{k−j,n−2}(t) G_{j,2}(t)`, which is what is evaluated here. θ1 acts at t = 0, θ2 at
/// t = 1: a curve leaves with tangent `F'(0) = (n − 2 + θ1 π/4)(b₁ − b₀)`.
///
/// Nonnegative for 0 ≤ θ ≤ 4, at degree 2 for no other shape ([`nonnegative_shapes`](crate::nonnegative_shapes())); independent unless both are 0. Accuracy: values within 8u absolutely
/// (u = 2⁻⁵³), derivatives within 80u of the largest function of that order on the interval. Values at 0 and 1 are exact.
///
/// ```
/// use bases::{Basis, Gt};
/// let cubic = Gt::new(3, [1.0, 2.0])?;
/// let d1 = cubic.evaluate(0.0, 1).row(1).to_vec();
/// assert!((d1[1] - (1.0 + std::f64::consts::FRAC_PI_4)).abs() < 1e-15);
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Gt {
    degree: usize,
    /// Of degree n − 2.
    rows: BinomialRows,
    shape: [f64; 2],
}

impl Gt {
    /// Least and largest shape parameter: the functions of degree 2 are nonnegative exactly within (GT §2).
    pub const SHAPES: (f64, f64) = (0.0, 4.0);

    /// The family of degree `degree` with shape parameters `[θ1, θ2]`.
    ///
    /// # Errors
    /// [`BasisError::Degree`] below 2 or above 1000, [`BasisError::Shape`] outside of [`Self::SHAPES`],
    /// [`BasisError::Dependent`] for (0, 0).
    pub fn new(degree: usize, shape: [f64; 2]) -> Result<Self, BasisError> {
        check_degree(degree)?;
        Self::check_shape(shape)?;
        Ok(Self { degree, rows: BinomialRows::new(degree - 2), shape })
    }

    /// Whether there is a family with shape parameters `[θ1, θ2]`, of whatever degree.
    ///
    /// # Errors
    /// [`BasisError::Shape`] outside of [`Self::SHAPES`], [`BasisError::Dependent`] for (0, 0).
    pub fn check_shape(shape: [f64; 2]) -> Result<(), BasisError> {
        for (i, &value) in shape.iter().enumerate() {
            if !(Self::SHAPES.0..=Self::SHAPES.1).contains(&value) {
                return Err(BasisError::Shape { index: i + 1, value, range: Self::SHAPES });
            }
        }
        if shape == [0.0, 0.0] { Err(BasisError::Dependent) } else { Ok(()) }
    }

    /// The degree n; there are n + 1 functions.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The shape parameters `[θ1, θ2]`.
    pub fn shape(&self) -> [f64; 2] {
        self.shape
    }
}

impl Basis for Gt {
    fn count(&self) -> usize {
        self.degree + 1
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        assert_eq!(out.len(), (order + 1) * self.count(), "length of the output");
        let seed = quadratic(t, self.shape, order);
        raise(&self.rows, t, order, &seed, out);
    }
}

/// The affine parts of the GT basis: `G_k = a_k + θ1 b_k + θ2 c_k`, as one family of 3(n+1) functions in the
/// order a₀ … a_n, b₀ … b_n, c₀ … c_n.
///
/// Independent of θ: what is assembled from it once (Gram matrices, samples) serves every shape. Dependent
/// as a family (b₀ = −b₁ and so on), so never a basis to solve in.
#[derive(Debug, Clone, PartialEq)]
pub struct GtParts {
    degree: usize,
    /// Of degree n − 2.
    rows: BinomialRows,
}

impl GtParts {
    /// The parts of the family of degree `degree` ≥ 2.
    ///
    /// # Errors
    /// [`BasisError::Degree`] below 2 or above 1000.
    pub fn new(degree: usize) -> Result<Self, BasisError> {
        check_degree(degree)?;
        Ok(Self { degree, rows: BinomialRows::new(degree - 2) })
    }
}

impl Basis for GtParts {
    fn count(&self) -> usize {
        3 * (self.degree + 1)
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        let (n, count) = (self.degree, self.count());
        assert_eq!(out.len(), (order + 1) * count, "length of the output");
        let origin = quadratic(t, [0.0, 0.0], order);
        let mut part = Matrix::zeros(order + 1, n + 1);
        for (p, mut seed) in
            [origin.clone(), quadratic(t, [1.0, 0.0], order), quadratic(t, [0.0, 1.0], order)]
                .into_iter()
                .enumerate()
        {
            if p > 0 {
                for (s, o) in seed.as_mut_slice().iter_mut().zip(origin.as_slice()) {
                    *s -= o;
                }
            }
            raise(&self.rows, t, order, &seed, part.as_mut_slice());
            for r in 0..=order {
                out[r * count + p * (n + 1)..][..n + 1].copy_from_slice(part.row(r));
            }
        }
    }
}

pub(crate) fn check_degree(degree: usize) -> Result<(), BasisError> {
    if (2..=MAX_DEGREE).contains(&degree) {
        Ok(())
    } else {
        Err(BasisError::Degree { family: "GT", degree, min: 2, max: MAX_DEGREE })
    }
}

/// The three functions of degree 2 and their derivatives: row r, column j holds `G^{(r)}_{j,2}(t)`.
///
/// With s = sin(πt/2), c = cos(πt/2) and `1 − s = c²/(1 + s)`, `1 − c = s²/(1 + c)` no digit cancels; c is the
/// sine of the reversed parameter, so both halves of the interval share their bits. The derivatives come from
/// `G₀ = c² + θ1 (s² − s)/2`, where s² and c² are `(1 ∓ cos πt)/2`.
pub(crate) fn quadratic(t: f64, [t1, t2]: [f64; 2], order: usize) -> Matrix {
    let s = libm::sin(FRAC_PI_2 * t);
    let c = libm::sin(FRAC_PI_2 * (1.0 - t));
    let (not_s, not_c) = (c * c / (1.0 + s), s * s / (1.0 + c));
    let mut table = Matrix::zeros(order + 1, 3);
    table.row_mut(0).copy_from_slice(&[
        not_s * ((1.0 + s) - 0.5 * t1 * s),
        0.5 * t1 * (s * not_s) + 0.5 * t2 * (c * not_c),
        not_c * ((1.0 + c) - 0.5 * t2 * c),
    ]);
    let sines = [s, c, -s, -c]; // derivatives of s, up to powers of π/2
    let cosines = [(c - s) * (c + s), -2.0 * (s * c)]; // of cos πt, up to sign and powers of π
    let (mut half_pi_r, mut pi_r) = (1.0, 1.0);
    for r in 1..=order {
        half_pi_r *= FRAC_PI_2;
        pi_r *= PI;
        let double = pi_r * if r % 4 < 2 { cosines[r % 2] } else { -cosines[r % 2] };
        let (ds, dc) = (half_pi_r * sines[r % 4], half_pi_r * sines[(r + 1) % 4]);
        let g0 = (0.5 - 0.25 * t1) * double - 0.5 * t1 * ds;
        let g2 = (0.25 * t2 - 0.5) * double - 0.5 * t2 * dc;
        let g1 = 0.5 * (t1 * ds + t2 * dc) + 0.25 * (t1 - t2) * double;
        table.row_mut(r).copy_from_slice(&[g0, g1, g2]);
    }
    table
}

/// `G^{(r)}_{k,n} = Σ_q C(r,q) Σ_j B^{(r−q)}_{k−j,n−2} G^{(q)}_{j,2}`; the outer functions are added before the middle one,
/// so that reversal keeps every bit.
fn raise(rows: &BinomialRows, t: f64, order: usize, seed: &Matrix, out: &mut [f64]) {
    let (m, n) = (rows.degree(), rows.degree() + 2);
    let mut bernstein = Matrix::zeros(order + 1, m + 1);
    bernstein::fill(rows, t, order, bernstein.as_mut_slice());
    out.fill(0.0);
    for r in 0..=order {
        let row = &mut out[r * (n + 1)..(r + 1) * (n + 1)];
        for (q, leibniz) in binomials(r).into_iter().enumerate() {
            let (b, g) = (bernstein.row(r - q), seed.row(q));
            let at = |k: usize, j: usize| if k >= j && k - j <= m { b[k - j] } else { 0.0 };
            for (k, value) in row.iter_mut().enumerate() {
                *value += leibniz * ((at(k, 0) * g[0] + at(k, 2) * g[2]) + at(k, 1) * g[1]);
            }
        }
    }
}
