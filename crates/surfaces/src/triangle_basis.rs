//! Bernstein polynomials of the triangle.

use bases::{BasisError, Matrix};

/// The Bernstein polynomials `B^n_ijk(u, v) = n!/(i! j! k!) uⁱ vʲ wᵏ`, i + j + k = n, w = 1 − u − v, of the triangle
/// u, v ≥ 0, u + v ≤ 1 (TRI §2.1).
///
/// Multi-indices (i, j, k) belong to (u, v, w). Their linear order, here and in [`crate::TriangleNet`]: i ascending, and
/// j ascending within each i, so (0,0,n) comes first, (0,n,0) at position n and (n,0,0) last.
///
/// Accuracy: values within 8u of themselves (u = 2⁻⁵³) at every degree offered, with w taken as the exact 1 − u − v;
/// measured 4.6u relatively and 0.7u absolutely. Derivatives within 4nu of the largest derivative of the same kind at that
/// point. Values at the corners are exactly 0 and 1, and where 1 − u − v is exact, exchanging parameters
/// together with indices changes values by roundings only.
///
/// ```
/// let quadratic = surfaces::TriangleBasis::new(2)?;
/// assert_eq!(quadratic.indices().nth(1), Some([0, 1, 1]));
/// assert_eq!(quadratic.evaluate(0.25, 0.5, 0).row(0), [0.0625, 0.25, 0.25, 0.125, 0.25, 0.0625]);
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TriangleBasis {
    degree: usize,
    /// `n!/(i! j! k!)` for the degrees n, n − 1, n − 2 (as far as they exist), in linear order.
    multinomials: Vec<Vec<f64>>,
}

impl TriangleBasis {
    /// Largest degree offered, with 2145 functions; up to it all multinomials are correctly rounded.
    pub const MAX_DEGREE: usize = 64;

    /// The family of degree `degree`.
    ///
    /// # Errors
    /// [`BasisError::Degree`] above [`Self::MAX_DEGREE`].
    pub fn new(degree: usize) -> Result<Self, BasisError> {
        check_degree(degree, 0)?;
        let multinomials = (0..=degree.min(2)).map(|r| multinomials(degree - r)).collect();
        Ok(Self { degree, multinomials })
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Number of functions, (n + 1)(n + 2)/2.
    pub fn count(&self) -> usize {
        count(self.degree)
    }

    /// The multi-indices (i, j, k) in linear order.
    pub fn indices(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        indices(self.degree)
    }

    /// Position of (i, j, n − i − j) in the linear order.
    pub fn position(&self, i: usize, j: usize) -> usize {
        position(self.degree, i, j)
    }

    /// Fills `out` with rows of [`Self::count`] entries each: the values; for `order` ≥ 1 then ∂u and ∂v; for `order` = 2
    /// then ∂uu, ∂uv and ∂vv.
    ///
    /// Outside the triangle the polynomials are continued. Parameters that are not finite give values that are not
    /// numbers.
    ///
    /// # Panics
    /// If `order` > 2 or `out` is not `(order + 1)(order + 2)/2 · count` long.
    pub fn evaluate_into(&self, u: f64, v: f64, order: usize, out: &mut [f64]) {
        assert!(order <= 2, "derivatives of order {order} of the triangular basis; at most 2 are offered");
        assert_eq!(out.len(), count(order) * self.count(), "length of the output");
        if !(u.is_finite() && v.is_finite()) {
            out.fill(f64::NAN);
            return;
        }
        let powers = Powers::new(u, v, self.degree);
        let (n, size) = (self.degree, self.count());
        let (values, first) = out.split_at_mut(size);
        self.for_each(&powers, |p, _, b| values[p] = b);
        first.fill(0.0);
        if order >= 1 && n >= 1 {
            // ∂u B^n_I = n (B^{n−1}_{I−e1} − B^{n−1}_{I−e3}), read from the lower degree upwards; ∂v with e2.
            let (du, dv) = first.split_at_mut(size);
            powers.for_each(n - 1, &self.multinomials[1], |_, [i, j], b| {
                let b = n as f64 * b;
                du[position(n, i + 1, j)] += b;
                du[position(n, i, j)] -= b;
                dv[position(n, i, j + 1)] += b;
                dv[position(n, i, j)] -= b;
            });
        }
        if order == 2 && n >= 2 {
            let (duu, rest) = first[2 * size..].split_at_mut(size);
            let (duv, dvv) = rest.split_at_mut(size);
            powers.for_each(n - 2, &self.multinomials[2], |_, [i, j], b| {
                let b = (n * (n - 1)) as f64 * b;
                let [p200, p110, p101] =
                    [position(n, i + 2, j), position(n, i + 1, j + 1), position(n, i + 1, j)];
                let [p020, p011, p002] = [position(n, i, j + 2), position(n, i, j + 1), position(n, i, j)];
                duu[p200] += b;
                duu[p101] -= 2.0 * b;
                duu[p002] += b;
                duv[p110] += b;
                duv[p101] -= b;
                duv[p011] -= b;
                duv[p002] += b;
                dvv[p020] += b;
                dvv[p011] -= 2.0 * b;
                dvv[p002] += b;
            });
        }
    }

    /// Values and derivatives as a matrix with the rows of [`Self::evaluate_into`].
    ///
    /// # Panics
    /// If `order` > 2.
    pub fn evaluate(&self, u: f64, v: f64, order: usize) -> Matrix {
        let mut table = Matrix::zeros(count(order.min(2)), self.count());
        self.evaluate_into(u, v, order, table.as_mut_slice());
        table
    }

    /// Calls `take(position, [i, j], value)` for all functions in linear order.
    pub(crate) fn for_each(&self, powers: &Powers, take: impl FnMut(usize, [usize; 2], f64)) {
        powers.for_each(self.degree, &self.multinomials[0], take);
    }
}

/// A degree between `min` and [`TriangleBasis::MAX_DEGREE`].
pub(crate) fn check_degree(degree: usize, min: usize) -> Result<(), BasisError> {
    let max = TriangleBasis::MAX_DEGREE;
    if (min..=max).contains(&degree) {
        Ok(())
    } else {
        Err(BasisError::Degree { family: "triangular Bernstein", degree, min, max })
    }
}

/// Number of multi-indices of degree `n`.
pub(crate) fn count(n: usize) -> usize {
    (n + 1) * (n + 2) / 2
}

/// Position of (i, j, n − i − j): the rows before row i hold n + 1, n, … points.
pub(crate) fn position(n: usize, i: usize, j: usize) -> usize {
    debug_assert!(i + j <= n);
    i * (2 * n + 3 - i) / 2 + j
}

/// The multi-indices of degree `n` in linear order.
pub(crate) fn indices(n: usize) -> impl Iterator<Item = [usize; 3]> + use<> {
    (0..=n).flat_map(move |i| (0..=n - i).map(move |j| [i, j, n - i - j]))
}

/// `n!/(i! j! k!) = C(n, i) C(n−i, j)`, exact in 128 bits (below 3⁶⁴) and rounded once.
fn multinomials(n: usize) -> Vec<f64> {
    let binomials = |n: usize| {
        let mut c: u128 = 1;
        (0..=n)
            .map(|k| {
                if k > 0 {
                    c = c * (n + 1 - k) as u128 / k as u128;
                }
                c
            })
            .collect::<Vec<u128>>()
    };
    let outer = binomials(n);
    (0..=n)
        .flat_map(|i| {
            let c = outer[i];
            binomials(n - i).into_iter().map(move |d| (c * d) as f64)
        })
        .collect()
}

const POWERS: usize = TriangleBasis::MAX_DEGREE + 1;

/// The powers of u, v and w = 1 − u − v, each rounded once.
pub(crate) struct Powers {
    u: [f64; POWERS],
    v: [f64; POWERS],
    w: [f64; POWERS],
}

impl Powers {
    pub(crate) fn new(u: f64, v: f64, degree: usize) -> Self {
        let (rest, low) = two_sum(1.0, -u);
        let (rest, lower) = two_sum(rest, -v);
        let (w, w_low) = two_sum(rest, low + lower);
        Self { u: powers(u, 0.0, degree), v: powers(v, 0.0, degree), w: powers(w, w_low, degree) }
    }

    /// `B^n_ijk` in linear order with their positions, for any n up to the degree of the powers.
    fn for_each(&self, n: usize, multinomials: &[f64], mut take: impl FnMut(usize, [usize; 2], f64)) {
        let mut p = 0;
        for i in 0..=n {
            for j in 0..=n - i {
                take(p, [i, j], multinomials[p] * self.u[i] * (self.v[j] * self.w[n - i - j]));
                p += 1;
            }
        }
    }
}

/// `x⁰ … x^degree` for x = `hi + lo`: the rounding error of each product is carried to the end, so that the power
/// itself is rounded once.
fn powers(hi: f64, lo: f64, degree: usize) -> [f64; POWERS] {
    let mut out = [1.0; POWERS];
    let (mut p, mut error) = (1.0, 0.0);
    for power in &mut out[1..=degree] {
        let (product, rounding) = two_product(p, hi);
        error = error * hi + (rounding + p * lo);
        p = product;
        *power = p + error;
    }
    out
}

/// `a + b` as rounded sum and exact error (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// `a · b` as rounded product and exact error (Dekker), splitting instead of a fused multiply-add, which the
/// default x86-64 target does not have.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let c = 134_217_729.0 * x; // 2²⁷ + 1
        let high = c - (c - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    (product, a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_the_indices() {
        for n in 0..=12 {
            for (p, [i, j, k]) in indices(n).enumerate() {
                assert_eq!((position(n, i, j), i + j + k), (p, n));
            }
            assert_eq!(indices(n).count(), count(n));
        }
    }

    #[test]
    fn the_largest_multinomials_are_exact() {
        // 64!/(21! 21! 22!) from integer arithmetic.
        let table = multinomials(64);
        assert_eq!(table[position(64, 21, 21)], 43_247_646_815_734_729_810_406_764_800.0);
    }

    #[test]
    fn the_rest_of_two_parameters_keeps_every_digit_near_the_far_side() {
        // The doubles 0.1 and 0.9 exceed 1 by 2⁻⁵⁵, which 1.0 − 0.1 − 0.9 in doubles does not see.
        assert_eq!(1.0 - 0.1 - 0.9, 0.0);
        assert_eq!(Powers::new(0.1, 0.9, 1).w[1], -2f64.powi(-55));
    }
}
