//! Polynomials of two variables whose coefficients are known to within a bound.

use surfaces::Side;

/// Half the distance from 1 to the next number: the relative error of one rounding.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// A polynomial `Σ_ij c_ij B_{i,m}(u) B_{j,n}(v)` over the unit square in Bernstein form, known to within `error`: the true
/// coefficients differ from those held by at most that.
///
/// On the square the values lie between the least and the largest coefficient, so that signs are *proved* by coefficients.
/// Products and cuts are convex combinations of what they are made from, which keeps the bounds short: the error of every
/// operation is that of its inputs plus its own rounding, bounded by the number of its terms times the unit roundoff.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BernsteinForm {
    degrees: [usize; 2],
    coefficients: Vec<f64>,
    error: f64,
}

impl BernsteinForm {
    /// The polynomial of (m + 1)(n + 1) coefficients, those of j first, each within `error` of the true one.
    pub(crate) fn new(degrees: [usize; 2], coefficients: Vec<f64>, error: f64) -> Self {
        assert_eq!(coefficients.len(), (degrees[0] + 1) * (degrees[1] + 1), "one coefficient a pair");
        Self { degrees, coefficients, error }
    }

    /// The degrees (m, n).
    pub(crate) fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    /// The polynomial along a side of the square, as one of degrees (n, 0).
    pub(crate) fn side(&self, side: Side) -> Self {
        let [m, n] = self.degrees;
        let (along, at): (usize, Box<dyn Fn(usize) -> usize>) = match side {
            Side::V0 => (m, Box::new(|k| k * (n + 1))),
            Side::V1 => (m, Box::new(|k| k * (n + 1) + n)),
            Side::U0 => (n, Box::new(|k| k)),
            Side::U1 => (n, Box::new(|k| m * (n + 1) + k)),
        };
        Self::new([along, 0], (0..=along).map(|k| self.coefficients[at(k)]).collect(), self.error)
    }

    /// The constant 1 as a polynomial of these degrees: a factor that raises degrees.
    pub(crate) fn one(degrees: [usize; 2]) -> Self {
        Self::new(degrees, vec![1.0; (degrees[0] + 1) * (degrees[1] + 1)], 0.0)
    }

    /// A lower bound of all its values on the square.
    pub(crate) fn least(&self) -> f64 {
        self.coefficients.iter().copied().fold(f64::INFINITY, f64::min) - self.error
    }

    /// An upper bound of all its values on the square.
    pub(crate) fn largest(&self) -> f64 {
        self.coefficients.iter().copied().fold(f64::NEG_INFINITY, f64::max) + self.error
    }

    /// An upper bound of the absolute value of every true coefficient.
    fn size(&self) -> f64 {
        self.coefficients.iter().fold(0.0_f64, |size, c| size.max(c.abs())) + self.error
    }

    /// The value at (u, v), without a bound of its error.
    pub(crate) fn value(&self, u: f64, v: f64) -> f64 {
        let n = self.degrees[1] + 1;
        let column: Vec<f64> = self.coefficients.chunks_exact(n).map(|row| de_casteljau(row, v)).collect();
        de_casteljau(&column, u)
    }

    /// The derivative by u (`direction` 0) or v (1); the constant 0 if it is constant in that direction.
    pub(crate) fn derivative(&self, direction: usize) -> Self {
        let [m, n] = self.degrees;
        let degree = self.degrees[direction];
        if degree == 0 {
            return Self { coefficients: vec![0.0; self.coefficients.len()], error: 0.0, ..self.clone() };
        }
        let mut degrees = self.degrees;
        degrees[direction] -= 1;
        let step = if direction == 0 { n + 1 } else { 1 };
        let at = |i: usize, j: usize| i * (n + 1) + j;
        let (rows, cols) = if direction == 0 { (m, n + 1) } else { (m + 1, n) };
        let factor = degree as f64;
        let coefficients = (0..rows)
            .flat_map(|i| (0..cols).map(move |j| at(i, j)))
            .map(|k| factor * (self.coefficients[k + step] - self.coefficients[k]))
            .collect();
        let error = factor * (2.0 * self.error + 4.0 * UNIT * self.size());
        Self { degrees, coefficients, error }
    }

    /// The product.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let degrees = [self.degrees[0] + other.degrees[0], self.degrees[1] + other.degrees[1]];
        let weights: [Vec<f64>; 2] =
            std::array::from_fn(|d| product_weights(self.degrees[d], other.degrees[d]));
        let (own, its) = (self.degrees[1] + 1, other.degrees[1] + 1);
        let cols = degrees[1] + 1;
        let mut coefficients = vec![0.0; (degrees[0] + 1) * cols];
        for (i, row) in self.coefficients.chunks_exact(own).enumerate() {
            for (k, factor) in other.coefficients.chunks_exact(its).enumerate() {
                let along_u = weights[0][i * (other.degrees[0] + 1) + k];
                let sums = &mut coefficients[(i + k) * cols..(i + k + 1) * cols];
                for (j, c) in row.iter().enumerate() {
                    let scale = along_u * c;
                    let along_v = &weights[1][j * its..(j + 1) * its];
                    for (l, (w, f)) in along_v.iter().zip(factor).enumerate() {
                        sums[j + l] += scale * (w * f);
                    }
                }
            }
        }
        // A coefficient is a convex combination of at most (m + 1)(n + 1) products, its weights rounded a few times per binomial.
        let terms = (self.degrees[0].min(other.degrees[0]) + 1) * (self.degrees[1].min(other.degrees[1]) + 1);
        let rounding = (terms + 8 * (degrees[0] + degrees[1]) + 16) as f64 * UNIT;
        let (a, b) = (self.size(), other.size());
        let error = 1.01 * (a * other.error + b * self.error + rounding * a * b);
        Self { degrees, coefficients, error }
    }

    /// The negative, or the polynomial itself.
    pub(crate) fn signed(mut self, negative: bool) -> Self {
        if negative {
            self.coefficients.iter_mut().for_each(|c| *c = -*c);
        }
        self
    }

    /// `self + factor · other`; both have the same degrees.
    pub(crate) fn plus(&self, factor: f64, other: &Self) -> Self {
        assert_eq!(self.degrees, other.degrees, "sums of polynomials of the same degrees");
        let coefficients =
            self.coefficients.iter().zip(&other.coefficients).map(|(a, b)| a + factor * b).collect();
        let rounding = 3.0 * UNIT * (self.size() + factor.abs() * other.size());
        let error = 1.01 * (self.error + factor.abs() * other.error + rounding);
        Self { degrees: self.degrees, coefficients, error }
    }

    /// The same polynomial with degrees raised to `degrees`, at least its own.
    pub(crate) fn raised(&self, degrees: [usize; 2]) -> Self {
        let by = [degrees[0] - self.degrees[0], degrees[1] - self.degrees[1]];
        if by == [0, 0] { self.clone() } else { self.times(&Self::one(by)) }
    }

    /// A lower bound of the integral over the square: the mean of the coefficients less its error.
    pub(crate) fn least_integral(&self) -> f64 {
        let count = self.coefficients.len() as f64;
        let mean = self.coefficients.iter().sum::<f64>() / count;
        mean - 1.01 * (self.error + count * UNIT * self.size())
    }

    /// The four quarters, each over the unit square again.
    pub(crate) fn quarters(&self) -> [Self; 4] {
        let [low, high] = self.halves(0);
        let ([a, b], [c, d]) = (low.halves(1), high.halves(1));
        [a, b, c, d]
    }

    fn halves(&self, direction: usize) -> [Self; 2] {
        let [m, n] = self.degrees;
        let (mut low, mut high) = (self.coefficients.clone(), self.coefficients.clone());
        let (lines, degree, stride, start) =
            if direction == 0 { (n + 1, m, n + 1, 1) } else { (m + 1, n, 1, n + 1) };
        for line in 0..lines {
            let at = |k: usize| line * start + k * stride;
            let mut row: Vec<f64> = (0..=degree).map(|k| self.coefficients[at(k)]).collect();
            for k in 0..=degree {
                (low[at(k)], high[at(degree - k)]) = (row[0], row[degree - k]);
                for i in 0..degree - k {
                    row[i] = 0.5 * (row[i] + row[i + 1]);
                }
            }
        }
        // Halving is exact; each of the sums rounds once.
        let error = self.error + 1.01 * degree as f64 * UNIT * self.size();
        [low, high].map(|coefficients| Self { degrees: self.degrees, coefficients, error })
    }
}

/// The polynomial that takes `values` at the Chebyshev points of degree (n, n), `values[i][j]` row by row. Any polynomial
/// does for what it is used for, so it has no error of its own.
pub(crate) fn interpolate(degree: usize, values: impl Fn(f64, f64) -> f64) -> BernsteinForm {
    let points: Vec<f64> = (0..=degree)
        .map(|k| 0.5 - 0.5 * ((2 * k + 1) as f64 * std::f64::consts::PI / (2 * degree + 2) as f64).cos())
        .collect();
    let mut table: Vec<f64> =
        points.iter().flat_map(|&u| points.iter().map(move |&v| (u, v))).map(|(u, v)| values(u, v)).collect();
    let n = degree + 1;
    for row in table.chunks_exact_mut(n) {
        let solved = bernstein_interpolant(&points, row);
        row.copy_from_slice(&solved);
    }
    for j in 0..n {
        let column: Vec<f64> = (0..n).map(|i| table[i * n + j]).collect();
        for (i, c) in bernstein_interpolant(&points, &column).into_iter().enumerate() {
            table[i * n + j] = c;
        }
    }
    BernsteinForm::new([degree, degree], table, 0.0)
}

/// Bernstein coefficients of the polynomial through (points, values), by Newton's form summed from the highest term: `c ← c (t − t_k)
/// + a_k`, each step a product in Bernstein form.
fn bernstein_interpolant(points: &[f64], values: &[f64]) -> Vec<f64> {
    let n = points.len();
    let mut differences = values.to_vec();
    for k in 1..n {
        for i in (k..n).rev() {
            differences[i] = (differences[i] - differences[i - 1]) / (points[i] - points[i - k]);
        }
    }
    let mut c = vec![differences[n - 1]];
    for k in (0..n - 1).rev() {
        let degree = c.len();
        let (at_0, at_1) = (-points[k], 1.0 - points[k]);
        let share = |i: usize| i as f64 / degree as f64;
        c = (0..=degree)
            .map(|i| {
                let below = if i > 0 { share(i) * at_1 * c[i - 1] } else { 0.0 };
                let above = if i < degree { (1.0 - share(i)) * at_0 * c[i] } else { 0.0 };
                below + above + differences[k]
            })
            .collect();
    }
    c
}

/// `C(m, i) C(n, k) / C(m + n, i + k)` at i (n + 1) + k: what the product of two coefficients counts in the product.
fn product_weights(m: usize, n: usize) -> Vec<f64> {
    let binomials = |n: usize| -> Vec<f64> {
        let next = |c: &mut f64, k: usize| {
            let here = *c;
            *c *= (n - k) as f64 / (k + 1) as f64;
            Some(here)
        };
        (0..=n).scan(1.0, next).collect()
    };
    let (first, second, both) = (binomials(m), binomials(n), binomials(m + n));
    (0..=m)
        .flat_map(|i| (0..=n).map(move |k| (i, k)))
        .map(|(i, k)| first[i] * (second[k] / both[i + k]))
        .collect()
}

fn de_casteljau(coefficients: &[f64], t: f64) -> f64 {
    let mut row = coefficients.to_vec();
    for k in (1..row.len()).rev() {
        for i in 0..k {
            row[i] += t * (row[i + 1] - row[i]);
        }
    }
    row[0]
}
