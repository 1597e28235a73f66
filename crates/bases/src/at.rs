//! The algebraic–trigonometric (AT) basis of order 6 (AT §2).

use std::f64::consts::TAU;

use crate::order_six::{COUNT, OrderSix};
use crate::{Basis, BasisError, Matrix, Subdivision};

/// The AT functions `b₀ … b₅`: the Bernstein-like basis of span{1, t, cos t, sin t, t sin t, t cos t} on [0, α].
///
/// b_i has an i-fold zero at 0 and a (5 − i)-fold zero at α; they are nonnegative and sum to 1, `b_i(t) = b_{5−i}(α − t)`,
/// and as α → 0 they become the quintic Bernstein polynomials in t/α. From `F = 3(t − sin t) − t(1 − cos t)` as in
/// AT §2.1 (there `u₄ = (f₁/e)(F' − f₁u₅)` is misprinted). The space is invariant under translation and contains
/// circles, Archimedean spirals and helices of linearly growing radius.
///
/// **Spans.** Admissible are [`Self::MIN_SPAN`] ≤ α < [`Self::SUPREMUM`] = 2π, where b₁ and b₄ vanish. Beside the bound the
/// functions stay accurate, but control points grow like (1 − α/2π)⁻¹: see [`Self::is_ill_conditioned`].
///
/// **Accuracy.** While 1 − α/α* ≥ 10⁻⁹, values within 8u absolutely and 16u relatively (u = 2⁻⁵³), derivatives up to order
/// 5 within 32u of the largest function of that order at the same t; nearer to the bound within 256u/(1 − α/α*) and
/// ten times that. Never negative on [0, α]; exact at 0 and α; reversal keeps every bit wherever `α − t` is exact.
///
/// ```
/// use bases::{At, Basis};
/// let basis = At::new(3.9)?;
/// let sum: f64 = basis.evaluate(1.0, 0).row(0).iter().sum();
/// assert!((sum - 1.0).abs() < 1e-15);
/// assert!(At::new(6.3).is_err());
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct At {
    construction: OrderSix,
}

impl At {
    /// The sharp bound α* = 2π of admissible spans, not itself admissible.
    pub const SUPREMUM: f64 = TAU;

    /// The smallest span offered; third derivatives, of size α⁻³, are still finite.
    pub const MIN_SPAN: f64 = 1e-100;

    /// The family on [0, `span`].
    ///
    /// # Errors
    /// [`BasisError::Span`] unless [`Self::MIN_SPAN`] ≤ `span` < [`Self::SUPREMUM`].
    pub fn new(span: f64) -> Result<Self, BasisError> {
        if !(Self::MIN_SPAN..Self::SUPREMUM).contains(&span) {
            return Err(BasisError::Span {
                family: "AT",
                span,
                min: Self::MIN_SPAN,
                supremum: Self::SUPREMUM,
                meaning: "2π",
            });
        }
        // F = Σ_{m ≥ 2} (−1)^m (2m − 2) t^{2m+1}/(2m+1)!.
        let coefficient = |k: usize| match k % 4 {
            1 => k as f64 - 3.0,
            3 => 3.0 - k as f64,
            _ => 0.0,
        };
        Ok(Self { construction: OrderSix::new(span, coefficient) })
    }

    /// The right end α of the domain.
    pub fn span(&self) -> f64 {
        self.construction.span()
    }

    /// `1 − α/2π`, in (0, 1]: what the size and the conditioning of control points depend on.
    pub fn margin(&self) -> f64 {
        (Self::SUPREMUM - self.span()) / Self::SUPREMUM
    }

    /// Whether α > 0.95 · 2π: control points are then large and a curve loses digits in proportion to 1/(1 − α/2π).
    pub fn is_ill_conditioned(&self) -> bool {
        self.span() > 0.95 * Self::SUPREMUM
    }

    /// The control values `P₀ … P₅` of a function φ of the space, `φ = Σ P_i b_i`, from `[φ, φ', φ'']` at 0 and at α:
    /// `P₀ = φ(0)`, `P₁ = φ(0) + δφ'(0)`, `P₂ = φ(0) + Mφ'(0) + εφ''(0)`, and mirrored at α with −δ, −M.
    ///
    /// For a function outside the space: those of the only one of the space with the same end jets.
    /// Replaces the closed forms of AT (0.2), (0.3).
    pub fn control_values(&self, end_jets: [[f64; 3]; 2]) -> [f64; 6] {
        self.construction.rule().control_values(end_jets)
    }

    /// `[δ, M, ε] = [f₀/f₁, −g/h, e/h]` of the endpoint rule, all positive, within 2u relatively while
    /// 1 − α/α* ≥ 10⁻⁶; as α → 0 they tend to α/5, 2α/5, α²/20.
    pub fn endpoint_rule(&self) -> [f64; 3] {
        self.construction.rule().values()
    }

    /// The 6 × 6 matrix S of control values of the monomials: row i holds those of the i-th of 1, t, cos t, sin t,
    /// t sin t, t cos t. Regular, not symmetric; its condition (1-norm) grows like
    /// about 1.2·10⁴ α⁻⁵ as α → 0
    /// and is about 180 at α = 3.
    pub fn monomials(&self) -> Matrix {
        let a = self.span();
        let (s, c) = (libm::sin(a), libm::cos(a));
        self.construction.rule().control_matrix([
            [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
            [[0.0, 1.0, 0.0], [a, 1.0, 0.0]],
            [[1.0, 0.0, -1.0], [c, -s, -c]],
            [[0.0, 1.0, 0.0], [s, c, -s]],
            [[0.0, 0.0, 2.0], [a * s, s + a * c, 2.0 * c - a * s]],
            [[0.0, 1.0, 0.0], [a * c, c - a * s, -2.0 * s - a * c]],
        ])
    }

    /// The 6 × 6 transform matrix T = S⁻¹: row i holds the coefficients of b_i in 1, t, cos t, sin t, t sin t, t cos t, read off
    /// its derivatives at 0. Entries grow like α⁻⁵: a sum of monomials with these coefficients cancels in
    /// proportion to the condition of [`Self::monomials`] and is no way to evaluate. AT §2.1, matrix A.
    pub fn transform(&self) -> Matrix {
        let d = self.evaluate(0.0, 5);
        Matrix::from_fn(COUNT, COUNT, |i, k| {
            let cos = -(2.0 * d[(2, i)] + d[(4, i)]);
            let sin = -0.5 * (5.0 * d[(3, i)] + 3.0 * d[(5, i)]);
            let t_cos = 0.5 * (d[(3, i)] + d[(5, i)]);
            match k {
                0 => d[(0, i)] - cos,
                1 => d[(1, i)] - sin - t_cos,
                2 => cos,
                3 => sin,
                4 => -0.5 * (d[(2, i)] + d[(4, i)]),
                _ => t_cos,
            }
        })
    }
}

impl Basis for At {
    fn count(&self) -> usize {
        COUNT
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, self.span())
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        // The second derivatives of the space lie in span{cos, sin, t sin, t cos}: φ'''''' = −2φ'''' − φ''.
        self.construction.evaluate_into(t, order, out, |r, out| {
            for i in 0..COUNT {
                out[r * COUNT + i] = -2.0 * out[(r - 2) * COUNT + i] - out[(r - 4) * COUNT + i];
            }
        });
    }

    fn subdivide(&self, t: f64) -> Result<Subdivision, BasisError> {
        Subdivision::of_translation_invariant(self, t, Self::new, |part, jets| part.control_values(jets))
    }
}
