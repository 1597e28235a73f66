//! The construction shared by the AHT and AT bases: six functions from one function with a fivefold zero.
//!
//! Both papers build their basis on [0, α] from one F with a fivefold zero at 0 and `f_i = F^{(i)}(α)`:
//! `e = f₁² − f₀f₂`, `g = f₀f₃ − f₁f₂`, `h = f₂² − f₁f₃`, `b₅ = F/f₀`, `b₄ = (f₁/e)(F' − f₁F/f₀)`,
//! `b₃ = H(hF + gF' + eF'')` with `H = h/((f₂h + f₃g + f₄e)e)`, and `b_i(t) = b_{5−i}(α − t)`. In doubles these formulas
//! lose every digit for small α. Here only their *coefficients* are computed, once for each α, in
//! double-double arithmetic: with t = ατ the power series of F in τ gives those of b₃, b₄, b₅, and these are
//! rewritten in Bernstein polynomials `C(N,j) τʲ σᴺ⁻ʲ`, σ = 1 − τ, of a degree N ≤ 60 at which the series has
//! converged far below rounding. All coefficients of b₃, b₄, b₅ then turn out to be ≥ 0, so that values are sums
//! without cancellation, at every α up to the bound and also beside the zeros at the ends.

use crate::Matrix;
use crate::bernstein::binomials;
use crate::double_double::{DoubleDouble, two_sum};

/// Number of functions of both families.
pub(crate) const COUNT: usize = 6;

/// Derivatives up to this order are tabulated; higher ones follow from the differential equation of the space.
const TABULATED: usize = 5;

/// Largest degree of the Bernstein form: α < 7.86 needs 58.
const MAX_DEGREE: usize = 60;

/// The Bernstein forms of b₃, b₄, b₅ and of their derivatives, and the endpoint rule.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct OrderSix {
    span: f64,
    degree: usize,
    /// `forms[r][k − 3][j]`: coefficient of `τʲ σᴺ⁻ʳ⁻ʲ` in `d^r b_k / dτ^r`.
    forms: Vec<[Vec<f64>; 3]>,
    rule: EndpointRule,
}

/// δ, M, ε of the rule that reads control points off the ends of a function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EndpointRule {
    delta: f64,
    m: f64,
    epsilon: f64,
}

impl OrderSix {
    /// The construction on [0, `span`] from the series `F = Σ_k c_k t^k`, k ≥ 5, `coefficient(k) = k! c_k` (an integer).
    pub(crate) fn new(span: f64, coefficient: impl Fn(usize) -> f64) -> Self {
        let degree = degree_for(span);
        let f = series(span, degree, coefficient);
        let at_end: Vec<DoubleDouble> = (0..=4).map(|r| derivative_at_one(&f, r)).collect();
        let [f0, f1, f2, f3, f4] = [at_end[0], at_end[1], at_end[2], at_end[3], at_end[4]];
        let e = f1 * f1 - f0 * f2;
        let g = f0 * f3 - f1 * f2;
        let h = f2 * f2 - f1 * f3;
        let norm = h / ((f2 * h + f3 * g + f4 * e) * e);

        let (d1, d2) = (derivative(&f), derivative(&derivative(&f)));
        let combine = |x: DoubleDouble, y: DoubleDouble, z: DoubleDouble| {
            (0..=degree).map(|k| x * f[k] + y * d1[k] + z * d2[k]).collect::<Vec<_>>()
        };
        let zero = DoubleDouble::from(0.0);
        let functions = [
            combine(norm * h, norm * g, norm * e),
            combine(-(f1 * f1 / (e * f0)), f1 / e, zero),
            combine(DoubleDouble::from(1.0) / f0, zero, zero),
        ];
        // Function k has a k-fold zero at 0 and a (5 − k)-fold zero at the end: what the sums leave there is rounding.
        let mut forms: [Vec<DoubleDouble>; 3] = functions.map(to_bernstein);
        for (form, k) in forms.iter_mut().zip(3..) {
            form[..k].fill(zero);
            form[degree + 1 - (5 - k)..].fill(zero);
        }
        // M = −g/h in a form without cancellation: g f₁ + h f₀ = −e f₂.
        let rule = EndpointRule {
            delta: (f0 / f1 * span).value(),
            m: ((f0 / f1 + f2 * e / (f1 * h)) * span).value(),
            epsilon: (e / h * span * span).value(),
        };
        Self { span, degree, forms: derivative_forms(forms), rule }
    }

    /// The right end α of the domain.
    pub(crate) fn span(&self) -> f64 {
        self.span
    }

    /// The endpoint rule.
    pub(crate) fn rule(&self) -> &EndpointRule {
        &self.rule
    }

    /// Fills `out[r · 6 + i] = b_i^{(r)}(t)` for r = 0 … `order`; `next(r, out)` fills a row above the tabulated ones.
    pub(crate) fn evaluate_into(
        &self,
        t: f64,
        order: usize,
        out: &mut [f64],
        next: impl Fn(usize, &mut [f64]),
    ) {
        assert_eq!(out.len(), (order + 1) * COUNT, "length of the output");
        let span = DoubleDouble::from(self.span);
        let tau = powers(DoubleDouble::from(t) / span, self.degree);
        // α − t exactly: both halves of the interval then share their bits.
        let sigma = powers(two_sum(self.span, -t) / span, self.degree);
        for r in 0..=order.min(TABULATED) {
            let n = self.degree - r;
            let row = &mut out[r * COUNT..(r + 1) * COUNT];
            let scale = |mut value: f64| {
                for _ in 0..r {
                    value /= self.span;
                }
                value
            };
            for (form, k) in self.forms[r].iter().zip(3..COUNT) {
                let (mut there, mut back) = (0.0, 0.0);
                for (j, c) in form.iter().enumerate() {
                    there += c * (tau[j] * sigma[n - j]);
                    back += c * (sigma[j] * tau[n - j]);
                }
                row[k] = scale(there);
                row[5 - k] = scale(if r.is_multiple_of(2) { back } else { -back });
            }
        }
        for r in TABULATED + 1..=order {
            next(r, out);
        }
    }
}

impl EndpointRule {
    /// The control values of φ from `[φ, φ', φ'']` at 0 and at α.
    pub(crate) fn control_values(&self, [start, end]: [[f64; 3]; 2]) -> [f64; COUNT] {
        let Self { delta, m, epsilon } = *self;
        [
            start[0],
            start[0] + delta * start[1],
            start[0] + (m * start[1] + epsilon * start[2]),
            end[0] + (epsilon * end[2] - m * end[1]),
            end[0] - delta * end[1],
            end[0],
        ]
    }

    /// δ, M, ε.
    pub(crate) fn values(&self) -> [f64; 3] {
        [self.delta, self.m, self.epsilon]
    }

    /// The 6 × 6 matrix whose row i holds the control values of the i-th of six functions, given by their end jets.
    pub(crate) fn control_matrix(&self, jets: [[[f64; 3]; 2]; COUNT]) -> Matrix {
        let rows = jets.map(|jet| self.control_values(jet));
        Matrix::from_fn(COUNT, COUNT, |i, j| rows[i][j])
    }
}

/// The least degree at which the series of a function of the space, and of its fifth derivative, has converged
/// to 10⁻²²: 5 + the first m with αᵐ/m! below.
fn degree_for(span: f64) -> usize {
    let (mut m, mut term) = (1, span);
    while term > 1e-22 && TABULATED + m < MAX_DEGREE {
        m += 1;
        term *= span / m as f64;
    }
    TABULATED + m
}

/// `F(ατ)/α⁵` as a power series in τ up to τ^degree: dividing by α⁵ keeps it in range for every α.
fn series(span: f64, degree: usize, coefficient: impl Fn(usize) -> f64) -> Vec<DoubleDouble> {
    let mut power = DoubleDouble::from(1.0); // α^{k−5}/k!
    let mut f = vec![DoubleDouble::from(0.0); degree + 1];
    for k in 1..=degree {
        if k > 5 {
            power = power * span;
        }
        power = power / DoubleDouble::from(k as f64);
        if k >= 5 {
            f[k] = power * coefficient(k);
        }
    }
    f
}

/// The derivative of a power series, of the same length.
fn derivative(f: &[DoubleDouble]) -> Vec<DoubleDouble> {
    let mut d: Vec<DoubleDouble> = f.iter().enumerate().skip(1).map(|(k, c)| *c * k as f64).collect();
    d.push(DoubleDouble::from(0.0));
    d
}

/// The r-th derivative of a power series at 1; added from the small end.
fn derivative_at_one(f: &[DoubleDouble], r: usize) -> DoubleDouble {
    let falling = |k: usize| (0..r).map(|i| k.saturating_sub(i) as f64).product::<f64>();
    f.iter().enumerate().rev().fold(DoubleDouble::from(0.0), |sum, (k, c)| sum + *c * falling(k))
}

/// Power coefficients `a_k` → Bernstein coefficients `c_j = Σ_k C(j,k)/C(N,k) a_k`, by the difference table of the c_j.
fn to_bernstein(a: Vec<DoubleDouble>) -> Vec<DoubleDouble> {
    let n = a.len() - 1;
    let mut c = a;
    let mut binomial = DoubleDouble::from(1.0);
    for (k, c) in c.iter_mut().enumerate() {
        *c = *c / binomial;
        binomial = binomial * ((n - k) as f64) / DoubleDouble::from((k + 1) as f64);
    }
    for i in 1..=n {
        for k in (i..=n).rev() {
            c[k] = c[k] + c[k - 1];
        }
    }
    c
}

/// From Bernstein coefficients the forms of the derivatives of order 0 … 5, the binomials multiplied in.
fn derivative_forms(mut forms: [Vec<DoubleDouble>; 3]) -> Vec<[Vec<f64>; 3]> {
    let degree = forms[0].len() - 1;
    let mut table = Vec::with_capacity(TABULATED + 1);
    for r in 0..=TABULATED {
        let weights = binomials(degree - r);
        table.push(
            forms
                .each_ref()
                .map(|form| form.iter().zip(&weights).map(|(c, w)| (*c * *w).value()).collect::<Vec<f64>>()),
        );
        let n = (degree - r) as f64;
        forms = forms.map(|form| form.windows(2).map(|pair| (pair[1] - pair[0]) * n).collect());
    }
    table
}

/// `x⁰ … xⁿ`, each rounded once.
fn powers(x: DoubleDouble, n: usize) -> [f64; MAX_DEGREE + 1] {
    let mut powers = [0.0; MAX_DEGREE + 1];
    let mut p = DoubleDouble::from(1.0);
    for power in powers.iter_mut().take(n + 1) {
        *power = p.value();
        p = p * x;
    }
    powers
}
