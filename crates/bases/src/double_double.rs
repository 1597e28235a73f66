//! Unevaluated sums of two doubles: about 106 bits, for the few places where one rounding must be all.
//!
//! The products split by Veltkamp's constant instead of a fused multiply-add: the fused instruction is
//! missing on the default x86-64 target, where `mul_add` is a slow library call.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `hi + lo` with `|lo| ≤ ½ ulp(hi)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DoubleDouble {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

impl DoubleDouble {
    pub(crate) const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
}

/// `a + b` as rounded sum and exact error (Knuth).
pub(crate) fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let b_part = hi - a;
    DoubleDouble { hi, lo: (a - (hi - b_part)) + (b - b_part) }
}

/// `a · b` as rounded product and exact error (Dekker); exact while no part over- or underflows.
pub(crate) fn two_product(a: f64, b: f64) -> DoubleDouble {
    let hi = a * b;
    let (a1, a2) = split(a);
    let (b1, b2) = split(b);
    DoubleDouble { hi, lo: a2 * b2 - (((hi - a1 * b1) - a2 * b1) - a1 * b2) }
}

fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let c = SPLITTER * a;
    let high = c - (c - a);
    (high, a - high)
}

fn quick(hi: f64, lo: f64) -> DoubleDouble {
    let sum = hi + lo;
    DoubleDouble { hi: sum, lo: lo - (sum - hi) }
}

impl DoubleDouble {
    pub(crate) fn value(self) -> f64 {
        self.hi + self.lo
    }
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let s = quick(high.hi, high.lo + low.hi);
        quick(s.hi, s.lo + low.lo)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let p = two_product(self.hi, other.hi);
        quick(p.hi, p.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Mul<f64> for DoubleDouble {
    type Output = Self;

    fn mul(self, other: f64) -> Self {
        let p = two_product(self.hi, other);
        quick(p.hi, p.lo + self.lo * other)
    }
}

impl Div<f64> for DoubleDouble {
    type Output = Self;

    fn div(self, other: f64) -> Self {
        let q1 = self.hi / other;
        let p = two_product(q1, other);
        let rest = ((self.hi - p.hi) - p.lo) + self.lo;
        quick(q1, rest / other)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let q1 = self.hi / other.hi;
        let r = self - other * q1;
        let q2 = r.hi / other.hi;
        let r = r - other * q2;
        let q3 = r.hi / other.hi;
        let q = quick(q1, q2);
        q + Self::from(q3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn product_and_sum_carry_the_rounding_error() {
        let a = 1.0 + f64::EPSILON;
        let p = two_product(a, a);
        // (1 + ε)² = 1 + 2ε + ε²: the last term does not fit one double.
        assert_eq!(p, DoubleDouble { hi: 1.0 + 2.0 * f64::EPSILON, lo: f64::EPSILON * f64::EPSILON });
        let s = two_sum(1.0, 1e-30);
        assert_eq!(s, DoubleDouble { hi: 1.0, lo: 1e-30 });
    }

    #[test]
    fn quotient_by_a_double() {
        let a = two_sum(3.0, 1e-17);
        assert!((a / 7.0 - a / DoubleDouble::from(7.0)).value().abs() < 1e-31);
    }

    #[test]
    fn quotient_times_divisor_is_the_dividend() {
        let a = two_sum(3.0, 1e-17);
        let b = two_sum(7.0, -3e-16);
        let back = (a / b) * b - a;
        assert!(back.value().abs() < 1e-30, "{back:?}");
    }
}
