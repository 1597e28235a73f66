//! The algebraic–hyperbolic–trigonometric (AHT) basis of order 6 (AHT §3).

use crate::order_six::{COUNT, OrderSix};
use crate::{Basis, BasisError, Matrix, Subdivision};

/// The AHT functions `b₀ … b₅`: the Bernstein-like basis of span{1, t, sin t, cos t, sinh t, cosh t} on [0, α].
///
/// b_i has an i-fold zero at 0 and a (5 − i)-fold zero at α; they are nonnegative and sum to 1, `b_i(t) = b_{5−i}(α − t)`,
/// and as α → 0 they become the quintic Bernstein polynomials in t/α. From `F = (sinh t + sin t)/2 − t` as in
/// AHT §3. The space is invariant under translation and contains the factors of the generalized helicoid.
///
/// **Spans.** Admissible are [`Self::MIN_SPAN`] ≤ α < [`Self::SUPREMUM`], where b₂ and b₃ vanish (AHT prints 5π/2; they are
/// negative there). Beside the bound the functions stay accurate, but control points grow like (1 − α/α*)⁻²:
/// see [`Self::is_ill_conditioned`].
///
/// **Accuracy.** While 1 − α/α* ≥ 10⁻⁹, values within 8u absolutely and 16u relatively (u = 2⁻⁵³), derivatives up to order
/// 5 within 32u of the largest function of that order at the same t; nearer to the bound within 256u/(1 − α/α*) and
/// ten times that. Never negative on [0, α]; exact at 0 and α; reversal keeps every bit wherever `α − t` is exact.
///
/// ```
/// use bases::{Aht, Basis};
/// let basis = Aht::new(1.5)?;
/// // Control values of sinh t, from its value and two derivatives at both ends.
/// let (s, c) = (1.5f64.sinh(), 1.5f64.cosh());
/// let p = basis.control_values([[0.0, 1.0, 0.0], [s, c, s]]);
/// let sinh: f64 = basis.evaluate(0.7, 0).row(0).iter().zip(p).map(|(b, p)| b * p).sum();
/// assert!((sinh - 0.7f64.sinh()).abs() < 1e-15);
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Aht {
    construction: OrderSix,
}

impl Aht {
    /// The sharp bound α* of admissible spans, not itself admissible: the second positive root of cos α cosh α = 1.
    pub const SUPREMUM: f64 = 7.853_204_624_095_837;

    /// The smallest span offered; third derivatives, of size α⁻³, are still finite.
    pub const MIN_SPAN: f64 = 1e-100;

    /// The family on [0, `span`].
    ///
    /// # Errors
    /// [`BasisError::Span`] unless [`Self::MIN_SPAN`] ≤ `span` < [`Self::SUPREMUM`].
    pub fn new(span: f64) -> Result<Self, BasisError> {
        if !(Self::MIN_SPAN..Self::SUPREMUM).contains(&span) {
            return Err(BasisError::Span {
                family: "AHT",
                span,
                min: Self::MIN_SPAN,
                supremum: Self::SUPREMUM,
                meaning: "the second positive root of cos α cosh α = 1",
            });
        }
        // F = t⁵/5! + t⁹/9! + …: all terms positive.
        Ok(Self { construction: OrderSix::new(span, |k| if k % 4 == 1 { 1.0 } else { 0.0 }) })
    }

    /// The right end α of the domain.
    pub fn span(&self) -> f64 {
        self.construction.span()
    }

    /// `1 − α/α*`, in (0, 1]: what the size and the conditioning of control points depend on.
    pub fn margin(&self) -> f64 {
        (Self::SUPREMUM - self.span()) / Self::SUPREMUM
    }

    /// Whether α > 0.95 α*: control points are then large and a curve loses digits in proportion to 1/(1 − α/α*).
    pub fn is_ill_conditioned(&self) -> bool {
        self.span() > 0.95 * Self::SUPREMUM
    }

    /// The control values `P₀ … P₅` of a function φ of the space, `φ = Σ P_i b_i`, from `[φ, φ', φ'']` at 0 and at α:
    /// `P₀ = φ(0)`, `P₁ = φ(0) + δφ'(0)`, `P₂ = φ(0) + Mφ'(0) + εφ''(0)`, and mirrored at α with −δ, −M.
    ///
    /// For a function outside the space: those of the only one of the space with the same end jets.
    /// Replaces the closed forms of AHT (2), (3), where M and L, N are misprinted.
    pub fn control_values(&self, end_jets: [[f64; 3]; 2]) -> [f64; 6] {
        self.construction.rule().control_values(end_jets)
    }

    /// `[δ, M, ε] = [f₀/f₁, −g/h, e/h]` of the endpoint rule, all positive, within 2u relatively while
    /// 1 − α/α* ≥ 10⁻⁶; as α → 0 they tend to α/5, 2α/5, α²/20.
    pub fn endpoint_rule(&self) -> [f64; 3] {
        self.construction.rule().values()
    }

    /// The 6 × 6 matrix S of control values of the monomials: row i holds those of the i-th of 1, t, sin t, cos t,
    /// sinh t, cosh t. Regular, not symmetric; its condition (1-norm) grows like
    /// about 1.2·10⁴ α⁻⁵ as α → 0
    /// and is about 600 at α = 3. AHT (2), corrected.
    pub fn monomials(&self) -> Matrix {
        let a = self.span();
        let (s, c, sh, ch) = (libm::sin(a), libm::cos(a), libm::sinh(a), libm::cosh(a));
        self.construction.rule().control_matrix([
            [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
            [[0.0, 1.0, 0.0], [a, 1.0, 0.0]],
            [[0.0, 1.0, 0.0], [s, c, -s]],
            [[1.0, 0.0, -1.0], [c, -s, -c]],
            [[0.0, 1.0, 0.0], [sh, ch, sh]],
            [[1.0, 0.0, 1.0], [ch, sh, ch]],
        ])
    }

    /// The 6 × 6 transform matrix T = S⁻¹: row i holds the coefficients of b_i in 1, t, sin t, cos t, sinh t, cosh t, read off
    /// its derivatives at 0. Entries grow like α⁻⁵: a sum of monomials with these coefficients cancels in
    /// proportion to the condition of [`Self::monomials`] and is no way to evaluate. AHT Appendix A.
    pub fn transform(&self) -> Matrix {
        let d = self.evaluate(0.0, 5);
        Matrix::from_fn(COUNT, COUNT, |i, k| match k {
            0 => d[(0, i)] - d[(4, i)],
            1 => d[(1, i)] - d[(5, i)],
            2 => 0.5 * (d[(5, i)] - d[(3, i)]),
            3 => 0.5 * (d[(4, i)] - d[(2, i)]),
            4 => 0.5 * (d[(5, i)] + d[(3, i)]),
            _ => 0.5 * (d[(4, i)] + d[(2, i)]),
        })
    }
}

impl Basis for Aht {
    fn count(&self) -> usize {
        COUNT
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, self.span())
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        // The second derivatives of the space lie in span{sin, cos, sinh, cosh}: φ'''''' = φ''.
        self.construction.evaluate_into(t, order, out, |r, out| {
            out.copy_within((r - 4) * COUNT..(r - 3) * COUNT, r * COUNT);
        });
    }

    fn subdivide(&self, t: f64) -> Result<Subdivision, BasisError> {
        Subdivision::of_translation_invariant(self, t, Self::new, |part, jets| part.control_values(jets))
    }
}
