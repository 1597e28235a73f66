//! Arithmetic of about 31 digits for references, and the functions of the papers in it: written from the formulas and
//! recursions, not from the forms that the crate evaluates.
#![allow(dead_code)] // every test file takes what it needs

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `hi + lo` with `|lo| ≤ ½ ulp(hi)`; sums and products are within some 2⁻¹⁰³ of the exact ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extended {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

pub(crate) const ZERO: Extended = Extended { hi: 0.0, lo: 0.0 };
pub(crate) const ONE: Extended = Extended { hi: 1.0, lo: 0.0 };
pub(crate) const HALF_PI: Extended =
    Extended { hi: std::f64::consts::FRAC_PI_2, lo: 6.123_233_995_736_766e-17 };

/// `a + b` as its rounded value and the rest.
pub(crate) fn exact_sum(a: f64, b: f64) -> Extended {
    let hi = a + b;
    let b_seen = hi - a;
    Extended { hi, lo: (a - (hi - b_seen)) + (b - b_seen) }
}

fn exact_product(a: f64, b: f64) -> Extended {
    let split = |a: f64| {
        let c = 134_217_729.0 * a;
        let high = c - (c - a);
        (high, a - high)
    };
    let (hi, (a1, a2), (b1, b2)) = (a * b, split(a), split(b));
    Extended { hi, lo: ((a1 * b1 - hi) + a1 * b2 + a2 * b1) + a2 * b2 }
}

impl Extended {
    pub(crate) fn of(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }

    /// An integer below 2¹⁰⁰.
    pub(crate) fn integer(n: u128) -> Self {
        let hi = n as f64;
        let lo = if hi as u128 >= n { -((hi as u128 - n) as f64) } else { (n - hi as u128) as f64 };
        exact_sum(hi, lo)
    }

    /// A decimal number of up to 30 digits.
    pub(crate) fn parse(text: &str) -> Self {
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let negative = mantissa.starts_with('-');
        let mantissa = mantissa.trim_start_matches('-');
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: u128 = format!("{whole}{part}").parse().expect("digits");
        let power = exponent.parse::<i32>().expect("an exponent") - part.len() as i32;
        let ten = |k: i32| (0..k).fold(ONE, |p, _| p * Self::of(10.0));
        let value =
            if power < 0 { Self::integer(digits) / ten(-power) } else { Self::integer(digits) * ten(power) };
        if negative { -value } else { value }
    }

    pub(crate) fn value(self) -> f64 {
        self.hi + self.lo
    }

    /// How far a double is from this number.
    pub(crate) fn distance(self, from: f64) -> f64 {
        (Self::of(from) - self).value().abs()
    }

    pub(crate) fn powi(self, n: usize) -> Self {
        (0..n).fold(ONE, |p, _| p * self)
    }
}

impl Add for Extended {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (exact_sum(self.hi, other.hi), exact_sum(self.lo, other.lo));
        let middle = exact_sum(high.hi, high.lo + low.hi);
        exact_sum(middle.hi, middle.lo + low.lo)
    }
}

impl Neg for Extended {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Extended {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Extended {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let high = exact_product(self.hi, other.hi);
        exact_sum(high.hi, high.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for Extended {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let mut quotient = Self::of(self.hi / other.hi);
        for _ in 0..2 {
            let rest = self - quotient * other;
            quotient = quotient + Self::of(rest.hi / other.hi);
        }
        quotient
    }
}

/// `Σ xᵏ/k! · sign(k)` over the k for which there is a sign, from k = 0, until nothing changes.
fn series(x: Extended, sign: impl Fn(usize) -> f64) -> Extended {
    let (mut term, mut sum) = (ONE, ZERO);
    for k in 0..200 {
        if k > 0 {
            term = term * x / Extended::of(k as f64);
        }
        sum = sum + term * Extended::of(sign(k));
        if k > 8 && term.hi.abs() < 1e-34 * sum.hi.abs() {
            break;
        }
    }
    sum
}

/// sin and cos of πt/2 for t in [0, 1].
fn quarter_wave(t: f64) -> [Extended; 2] {
    let both = |x: Extended| {
        [series(x, |k| [0.0, 1.0, 0.0, -1.0][k % 4]), series(x, |k| [1.0, 0.0, -1.0, 0.0][k % 4])]
    };
    if t <= 0.5 {
        both(HALF_PI * Extended::of(t))
    } else {
        let [s, c] = both(HALF_PI * exact_sum(1.0, -t));
        [c, s]
    }
}

/// Values and the first two derivatives of a family, function by function.
pub(crate) type Table = Vec<[Extended; 3]>;

/// `φ_k = (1 − t) φ_k + t φ_{k−1}` (GT (2.4), de Casteljau), with derivatives by Leibniz's rule.
fn raised(low: &Table, t: f64) -> Table {
    let at = |k: usize, r: usize| low.get(k).map_or(ZERO, |f| f[r]);
    let (t, rest) = (Extended::of(t), exact_sum(1.0, -t));
    (0..=low.len())
        .map(|k| {
            let before = |r: usize| if k == 0 { ZERO } else { at(k - 1, r) };
            std::array::from_fn(|r| {
                let mixed = rest * at(k, r) + t * before(r);
                if r == 0 { mixed } else { mixed + Extended::of(r as f64) * (before(r - 1) - at(k, r - 1)) }
            })
        })
        .collect()
}

/// The Bernstein families of all degrees up to `degree` at t.
pub(crate) fn bernstein(degree: usize, t: f64) -> Vec<Table> {
    let mut families = vec![vec![[ONE, ZERO, ZERO]]];
    for n in 0..degree {
        families.push(raised(&families[n], t));
    }
    families
}

/// The GT families of the degrees 2 to `degree` at t (GT (2.3), (2.4)).
pub(crate) fn gt(degree: usize, [t1, t2]: [f64; 2], t: f64) -> Vec<Table> {
    let [s, c] = quarter_wave(t);
    // Derivatives of sine and cosine up to order 2.
    let sine = [s, HALF_PI * c, -(HALF_PI * HALF_PI * s)];
    let cosine = [c, -(HALF_PI * s), -(HALF_PI * HALF_PI * c)];
    // x² and its derivatives.
    let square = |x: [Extended; 3]| {
        let two = Extended::of(2.0);
        [x[0] * x[0], two * x[0] * x[1], two * (x[1] * x[1] + x[0] * x[2])]
    };
    let (sines, cosines) = (square(sine), square(cosine));
    let unit = |r: usize| if r == 0 { ONE } else { ZERO };
    let bump = |x: [Extended; 3], xx: [Extended; 3], theta: f64, r: usize| {
        Extended::of(0.5 * theta) * (x[r] - xx[r])
    };
    let end =
        |x: [Extended; 3], xx: [Extended; 3], theta: f64, r: usize| unit(r) - xx[r] - bump(x, xx, theta, r);
    let first: [Extended; 3] = std::array::from_fn(|r| end(sine, sines, t1, r));
    let last: [Extended; 3] = std::array::from_fn(|r| end(cosine, cosines, t2, r));
    let middle = std::array::from_fn(|r| bump(sine, sines, t1, r) + bump(cosine, cosines, t2, r));
    let mut families = vec![vec![first, middle, last]];
    for n in 2..degree {
        families.push(raised(&families[n - 2], t));
    }
    families
}

/// `F^{(r)}(t)` of AHT §3 or AT §2, by its power series.
fn generator(hyperbolic: bool, t: Extended, r: usize) -> Extended {
    if hyperbolic {
        // (sinh t + sin t)/2 − t: the terms t^{4k+1} with k ≥ 1.
        let derivative = series(t, |k| if (k + r) % 4 == 1 && k + r > 1 { 1.0 } else { 0.0 });
        return derivative;
    }
    // 3(t − sin t) − t(1 − cos t): odd powers, (−1)^{(k+1)/2 + 1} (k − 3) t^k/k!.
    series(t, |k| match k + r {
        m if m % 2 == 0 || m < 5 => 0.0,
        m if m % 4 == 1 => m as f64 - 3.0,
        m => 3.0 - m as f64,
    })
}

/// The six AHT or AT functions on [0, span] at t.
pub(crate) fn order_six(hyperbolic: bool, span: f64, t: f64) -> Table {
    let at_end: [Extended; 5] = std::array::from_fn(|r| generator(hyperbolic, Extended::of(span), r));
    let [f0, f1, f2, f3, f4] = at_end;
    let (e, g, h) = (f1 * f1 - f0 * f2, f0 * f3 - f1 * f2, f2 * f2 - f1 * f3);
    let norm = h / ((f2 * h + f3 * g + f4 * e) * e);
    let upper = |t: Extended| -> [[Extended; 3]; 3] {
        let f: [Extended; 5] = std::array::from_fn(|r| generator(hyperbolic, t, r));
        [
            std::array::from_fn(|r| norm * (h * f[r] + g * f[r + 1] + e * f[r + 2])),
            std::array::from_fn(|r| f1 / e * (f[r + 1] - f1 * f[r] / f0)),
            std::array::from_fn(|r| f[r] / f0),
        ]
    };
    let ([b3, b4, b5], lower) = (upper(Extended::of(t)), upper(exact_sum(span, -t)));
    let [b2, b1, b0] = lower.map(|[value, first, second]| [value, -first, second]);
    vec![b0, b1, b2, b3, b4, b5]
}
