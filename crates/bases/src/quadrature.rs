//! Gauss–Legendre quadrature.

use std::f64::consts::PI;

use crate::BasisError;
use crate::double_double::{DoubleDouble, two_sum};

/// The Gauss–Legendre rule of n points on an interval: exact for polynomials of degree 2n − 1.
///
/// Nodes are within one ulp on [0, 1], also close to 0, and weights within one ulp, at every size: Newton's iteration on
/// the Legendre polynomial in doubles, then one step and the weight in twice the precision. Nodes ascend,
/// weights are symmetric bit for bit. Making a rule costs O(n²).
///
/// ```
/// let rule = bases::GaussLegendre::new(5)?.on(0.0, 2.0);
/// let integral: f64 = rule.iter().map(|(t, w)| w * t.powi(9)).sum();
/// assert!((integral - 102.4).abs() < 1e-13);
/// # Ok::<(), bases::BasisError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct GaussLegendre {
    start: f64,
    end: f64,
    /// Relative distance of each node of the left half (centre included) from its end, in (0, ½].
    gaps: Vec<f64>,
    /// Weights of the left half (centre included), summing with their mirror images to 1.
    half_weights: Vec<f64>,
    points: usize,
}

impl GaussLegendre {
    /// Largest rule offered.
    pub const MAX_POINTS: usize = 10_000;

    /// The rule of `points` points on [0, 1].
    ///
    /// # Errors
    /// [`BasisError::Points`] for 0 points or more than [`Self::MAX_POINTS`].
    pub fn new(points: usize) -> Result<Self, BasisError> {
        if !(1..=Self::MAX_POINTS).contains(&points) {
            return Err(BasisError::Points { points, max: Self::MAX_POINTS });
        }
        let (gaps, half_weights) = (0..points.div_ceil(2)).map(|k| left_node(points, k)).unzip();
        Ok(Self { start: 0.0, end: 1.0, gaps, half_weights, points })
    }

    /// The same rule on `[start, end]`.
    pub fn on(mut self, start: f64, end: f64) -> Self {
        (self.start, self.end) = (start, end);
        self
    }

    /// Number of points n ≥ 1.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Node `k`, counted from the start.
    pub fn node(&self, k: usize) -> f64 {
        let length = self.end - self.start;
        let mirror = self.points - 1 - k;
        match k.cmp(&mirror) {
            std::cmp::Ordering::Less => self.start + length * self.gaps[k],
            std::cmp::Ordering::Equal => 0.5 * (self.start + self.end),
            std::cmp::Ordering::Greater => self.end - length * self.gaps[mirror],
        }
    }

    /// Weight `k`, positive; the weights sum to the length of the interval.
    pub fn weight(&self, k: usize) -> f64 {
        (self.end - self.start) * self.half_weights[k.min(self.points - 1 - k)]
    }

    /// Nodes with their weights, ascending.
    pub fn iter(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        (0..self.points).map(|k| (self.node(k), self.weight(k)))
    }
}

/// Node k of the left half of the n-point rule on [0, 1] and its weight `1 / ((1 − x²) P_n′(x)²)`, x the root on [−1, 1].
fn left_node(n: usize, k: usize) -> (f64, f64) {
    if 2 * k + 1 == n {
        let (_, below) = legendre(n, DoubleDouble::from(0.0));
        // There P′ = n P_{n−1}.
        let slope = below * n as f64;
        return (0.5, (DoubleDouble::from(1.0) / (slope * slope)).value());
    }
    // On [−1, 1] the k-th largest root; Tricomi's estimate lies in Newton's basin for every n.
    let nf = n as f64;
    let angle = PI * (k as f64 + 0.75) / (nf + 0.5);
    let mut x = (1.0 - 1.0 / (8.0 * nf * nf) + 1.0 / (8.0 * nf * nf * nf)) * libm::cos(angle);
    for _ in 0..8 {
        let (p, below) = legendre_double(n, x);
        let step = p * (x * x - 1.0) / (nf * (x * p - below));
        x -= step;
        // Newton converges quadratically: after this step x is the root to rounding.
        if step.abs() < 1e-9 * (1.0 - x.abs()).max(1e-8) {
            break;
        }
    }
    // One step in twice the precision: x is the root to rounding, so the slope at the root is the slope at x and a first
    // correction by (1 − x²) P″ = 2x P′ − n(n+1) P.
    let at = DoubleDouble::from(x);
    let (p, below) = legendre(n, at);
    let slope = (at * p - below) * nf / (at * at - DoubleDouble::from(1.0));
    let step = -p.value() / slope.value();
    let root = two_sum(x, step);
    let bend = (2.0 * x * slope.value() - nf * (nf + 1.0) * p.value()) / ((1.0 - x) * (1.0 + x));
    let slope = slope + DoubleDouble::from(step * bend);
    let gap = DoubleDouble::from(1.0) - root;
    let weight = DoubleDouble::from(1.0) / (gap * (DoubleDouble::from(1.0) + root) * slope * slope);
    ((gap * 0.5).value(), weight.value())
}

/// `(P_n(x), P_{n−1}(x))` by the three-term recursion.
fn legendre(n: usize, x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let (mut p, mut below) = (DoubleDouble::from(1.0), DoubleDouble::from(0.0));
    for k in 0..n {
        let kf = k as f64;
        let next = (x * p * (2.0 * kf + 1.0) - below * kf) / (kf + 1.0);
        (below, p) = (p, next);
    }
    (p, below)
}

fn legendre_double(n: usize, x: f64) -> (f64, f64) {
    let (mut p, mut below) = (1.0, 0.0);
    for k in 0..n {
        let kf = k as f64;
        (below, p) = (p, ((2.0 * kf + 1.0) * x * p - kf * below) / (kf + 1.0));
    }
    (p, below)
}
