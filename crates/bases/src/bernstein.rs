//! Bernstein polynomials.

use std::borrow::Cow;

use crate::double_double::{DoubleDouble, two_sum};
use crate::{Basis, BasisError, Subdivision};

/// The Bernstein polynomials `B_{k,n}(t) = C(n,k) tᵏ (1−t)ⁿ⁻ᵏ`, k = 0 … n, on [0, 1] (GT (2.1)).
///
/// Accuracy: values within 4u absolutely (u = 2⁻⁵³) at every degree; derivatives of order r within 40u of the
/// largest function of that order. Values at 0 and 1 are exact, and `B_{k,n}(t)` equals `B_{n−k,n}(1−t)` bit for
/// bit wherever `1 − t` is exact. The powers are formed with their rounding errors carried along, so
/// that high degrees cost no digits.
///
/// ```
/// use bases::{Basis, Bernstein};
/// let cubic = Bernstein::new(3)?;
/// assert_eq!(cubic.evaluate(0.5, 0).row(0), [0.125, 0.375, 0.375, 0.125]);
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Bernstein {
    rows: BinomialRows,
}

impl Bernstein {
    /// Largest degree offered; beyond it the binomials leave the range of `f64`.
    pub const MAX_DEGREE: usize = 1000;

    /// The family of degree `degree` ≥ 0.
    ///
    /// # Errors
    /// [`BasisError::Degree`] above [`Self::MAX_DEGREE`].
    pub fn new(degree: usize) -> Result<Self, BasisError> {
        if degree > Self::MAX_DEGREE {
            return Err(BasisError::Degree { family: "Bernstein", degree, min: 0, max: Self::MAX_DEGREE });
        }
        Ok(Self { rows: BinomialRows::new(degree) })
    }

    /// The degree n; there are n + 1 functions.
    pub fn degree(&self) -> usize {
        self.rows.degree
    }
}

impl Basis for Bernstein {
    fn count(&self) -> usize {
        self.rows.degree + 1
    }

    fn domain(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn evaluate_into(&self, t: f64, order: usize, out: &mut [f64]) {
        assert_eq!(out.len(), (order + 1) * self.count(), "length of the output");
        fill(&self.rows, t, order, out);
    }

    fn subdivide(&self, t: f64) -> Result<Subdivision, BasisError> {
        Subdivision::of_bernstein(self, t)
    }
}

/// Fills `out[r (n+1) + k] = B^{(r)}_{k,n}(t)` for r = 0 … order.
///
/// `B^{(r)}_{k,n} = n!/(n−r)! Σ_j (−1)^{r−j} C(r,j) B_{k−j,n−r}`.
pub(crate) fn fill(rows: &BinomialRows, t: f64, order: usize, out: &mut [f64]) {
    let n = rows.degree;
    // Nothing is allocated at the degrees of patches: they are evaluated at very many points.
    let (mut small, mut large) = ([[DoubleDouble::ZERO; SMALL]; 2], [Vec::new(), Vec::new()]);
    let [left, right] = if n < SMALL {
        small.each_mut().map(|row| &mut row[..=n])
    } else {
        large.each_mut().map(|row| {
            row.resize(n + 1, DoubleDouble::ZERO);
            &mut row[..]
        })
    };
    powers(DoubleDouble::from(t), left);
    powers(two_sum(1.0, -t), right);
    for r in 0..=order {
        let row = &mut out[r * (n + 1)..(r + 1) * (n + 1)];
        row.fill(0.0);
        if r > n {
            continue;
        }
        let factor: f64 = (0..r).map(|i| (n - i) as f64).product();
        for (k, c) in rows.row(r).iter().enumerate() {
            let (p, q) = (left[k], right[n - r - k]);
            let b = factor * (c * (p.hi * q.hi) + c * (p.lo * q.hi + p.hi * q.lo));
            // (−1)^{r−j} C(r, j), exact.
            let mut change = if r.is_multiple_of(2) { 1.0 } else { -1.0 };
            for j in 0..=r {
                row[k + j] += change * b;
                change *= -((r - j) as f64);
                change /= (j + 1) as f64;
            }
        }
    }
}

/// Powers of at most this many exponents stand on the stack.
const SMALL: usize = 65;

/// `x⁰, x¹, …` with their rounding errors.
fn powers(x: DoubleDouble, out: &mut [DoubleDouble]) {
    let mut p = DoubleDouble::from(1.0);
    for power in out {
        *power = p;
        p = p * x;
    }
}

/// The binomials of a degree and of the two below it, which derivatives to order 2 need.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BinomialRows {
    degree: usize,
    rows: [Vec<f64>; 3],
}

impl BinomialRows {
    pub(crate) fn new(degree: usize) -> Self {
        Self { degree, rows: [0, 1, 2].map(|r| binomials(degree.saturating_sub(r))) }
    }

    pub(crate) fn degree(&self) -> usize {
        self.degree
    }

    /// C(n − r, k) for k = 0 … n − r, r at most n.
    fn row(&self, r: usize) -> Cow<'_, [f64]> {
        match self.rows.get(r) {
            Some(row) => Cow::Borrowed(row),
            None => Cow::Owned(binomials(self.degree - r)),
        }
    }
}

/// The binomial coefficients C(n, 0) … C(n, n), each correctly rounded or within one ulp.
pub(crate) fn binomials(n: usize) -> Vec<f64> {
    let mut row = vec![1.0; n + 1];
    let mut c = DoubleDouble::from(1.0);
    for k in 1..=n / 2 {
        c = c * ((n + 1 - k) as f64) / DoubleDouble::from(k as f64);
        // Below 2⁵³ the quotient is an integer that the two parts hold up to rounding.
        let value = if c.hi < 9e15 { c.value().round() } else { c.value() };
        if c.hi < 9e15 {
            c = DoubleDouble::from(value);
        }
        row[k] = value;
        row[n - k] = value;
    }
    row
}
