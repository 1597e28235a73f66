//! Pieces near samples.

use super::interpolation::Interpolation;
use super::refinement::Paired;
use super::{Bezier, CurveError, CurveFit, Deviation, Samples};
use crate::Point;

/// Most Gauss–Newton steps in one degree.
const STEPS: usize = 12;

/// The fewest pieces of degree at most `degree` within the samples' tolerance; see [`BoundaryCurve::fit`](super::BoundaryCurve::fit).
pub(super) fn fit(samples: &Samples, degree: usize) -> Result<CurveFit, CurveError> {
    let interpolations = (1..=degree).map(Interpolation::new).collect::<Result<Vec<_>, _>>()?;
    let points = samples.points();
    let is_closed = points[0] == points[points.len() - 1];
    // Four sides are the least that a closed curve is cut into.
    let mut count = if is_closed { 4 } else { 1 };
    // With fewer than two samples a piece there is nothing left to smooth.
    while 2 * count < points.len() {
        if let Some(fit) = in_pieces(samples, count, &interpolations) {
            return Ok(fit);
        }
        // Few pieces one by one, many by a quarter more: the work stays within a few times that of the last attempt.
        count += 1 + count / 4;
    }
    let segment = |ends: &[Point]| Bezier { points: ends.to_vec() };
    Ok(CurveFit { pieces: points.windows(2).map(segment).collect(), deviation: Deviation::default() })
}

/// `count` pieces of about the same length, if each is within the tolerance.
fn in_pieces(samples: &Samples, count: usize, interpolations: &[Interpolation]) -> Option<CurveFit> {
    let (points, lengths) = (samples.points(), samples.chain().lengths());
    let last = points.len() - 1;
    let cut = |k: usize| {
        let length = samples.chain().length() * (k as f64 / count as f64);
        let above = lengths.partition_point(|l| *l < length).min(last);
        let below = above.saturating_sub(1);
        // The sample nearest to this share of the length: pieces begin and end at samples.
        if length - lengths[below] < lengths[above] - length { below } else { above }
    };
    let mut cuts: Vec<usize> = (0..=count).map(cut).collect();
    cuts[count] = last;
    // Two cuts at one sample would be a piece of no length.
    cuts.dedup();
    let mut fit = CurveFit { pieces: Vec::new(), deviation: Deviation::default() };
    for ends in cuts.windows(2) {
        let part = Part { points: &points[ends[0]..=ends[1]], tolerance: samples.tolerance() };
        let (piece, deviation) = part.fit(interpolations)?;
        fit.pieces.push(piece);
        fit.deviation = fit.deviation.and(deviation);
    }
    Some(fit)
}

/// The samples of one piece.
struct Part<'a> {
    points: &'a [Point],
    tolerance: f64,
}

impl Part<'_> {
    /// The piece of the least degree within the tolerance that does not turn back, if there is one.
    ///
    /// Least squares at parameters in proportion to the chords, then of the distances across the curve.
    fn fit(&self, interpolations: &[Interpolation]) -> Option<(Bezier, Deviation)> {
        let chords = self.chords();
        // Least squares in more than about 2√m coefficients for m samples swing between them.
        let count = self.points.len();
        let most = (count - 1).min(3.max((2.0 * (count as f64).sqrt()) as usize));
        for interpolation in interpolations.iter().take(most) {
            let curve = self.nearest(&chords, interpolation);
            let mut paired = Paired { curve, parameters: chords.clone() };
            let mut largest = paired.largest(self.points);
            for _ in 0..STEPS {
                if largest <= self.tolerance {
                    break;
                }
                let Some(next) = paired.stepped(self.points, interpolation) else { break };
                let reached = next.largest(self.points);
                // What falls by less than a fifth a step, or not at all, waits for the next degree.
                if reached.is_nan() || reached >= 0.8 * largest {
                    break;
                }
                (paired, largest) = (next, reached);
            }
            if largest <= self.tolerance && !self.turns_back(&paired) {
                let deviation = self.deviation(&paired);
                return Some((paired.curve, deviation));
            }
        }
        None
    }

    /// Parameters in proportion to the chords, from 0 to 1.
    fn chords(&self) -> Vec<f64> {
        let mut lengths = vec![0.0];
        let mut length = 0.0;
        for ends in self.points.windows(2) {
            length += ends[0].distance(ends[1]);
            lengths.push(length);
        }
        lengths.into_iter().map(|l| l / length).collect()
    }

    /// The curve of the degree of `interpolation` with the ends of the samples and the least sum of squared distances at the
    /// parameters: chord + t(1 − t) q(t), q by polynomials orthogonal over the samples with weights (t(1 − t))², which
    /// their three-term recursion gives one after the other.
    fn nearest(&self, parameters: &[f64], interpolation: &Interpolation) -> Bezier {
        let last = self.points.len() - 1;
        let (start, end) = (self.points[0], self.points[last]);
        let inner = 1..last;
        let bump: Vec<f64> = inner.clone().map(|k| parameters[k] * (1.0 - parameters[k])).collect();
        let t: Vec<f64> = parameters[inner.clone()].to_vec();
        // What is left to fit. Each term is taken off as soon as it is known, so that the next one sees its rounding, too.
        let mut off: Vec<Point> =
            inner.map(|k| self.points[k] - (start * (1.0 - parameters[k]) + end * parameters[k])).collect();
        let mut terms: Vec<Term> = Vec::new();
        let (mut q, mut before) = (vec![1.0; t.len()], vec![0.0; t.len()]);
        let mut last_norm = 1.0;
        for k in 0..interpolation.degree().saturating_sub(1).min(t.len()) {
            let weigh = |f: &dyn Fn(usize) -> f64| -> f64 {
                (0..t.len()).map(|i| bump[i] * bump[i] * q[i] * q[i] * f(i)).sum()
            };
            let norm = weigh(&|_| 1.0);
            // Samples that coincide in parameter leave no further polynomial.
            if norm <= f64::MIN_POSITIVE {
                break;
            }
            let center = weigh(&|i| t[i]) / norm;
            // Monic orthogonal polynomials: the factor of the one before the last is the quotient of their squared norms.
            let back = if k == 0 { 0.0 } else { norm / last_norm };
            let mut coefficient = Point::ZERO;
            for i in 0..t.len() {
                coefficient += off[i] * (bump[i] * q[i] / norm);
            }
            for i in 0..t.len() {
                off[i] += coefficient * (-bump[i] * q[i]);
                (q[i], before[i]) = ((t[i] - center) * q[i] - back * before[i], q[i]);
            }
            terms.push(Term { center, back, coefficient });
            last_norm = norm;
        }
        interpolation.curve(start, end, |t| start * (1.0 - t) + end * t + sum(&terms, t) * (t * (1.0 - t)))
    }

    /// Distances of the samples from the curve, and their integral along the chords.
    fn deviation(&self, paired: &Paired) -> Deviation {
        let mut sum = Deviation::default();
        // The ends are met exactly.
        for k in 1..self.points.len() - 1 {
            let [before, here, next] = [k - 1, k, k + 1].map(|k| self.points[k]);
            let distance = here.distance(paired.curve.point(paired.parameters[k]));
            sum.largest = sum.largest.max(distance);
            sum.area += distance * 0.5 * (before.distance(here) + here.distance(next));
        }
        sum
    }

    /// Whether the curve somewhere runs against the samples: between two that are farther apart than the noise the
    /// tolerance grants.
    fn turns_back(&self, Paired { curve, parameters }: &Paired) -> bool {
        let (mut a, mut b) = (0, 1);
        while b < self.points.len() {
            // Between samples within the noise the chord has no direction worth a test: they are passed over until it has.
            let chord = self.points[b] - self.points[a];
            if chord.norm() > 4.0 * self.tolerance || b + 1 == self.points.len() {
                let (from, to) = (parameters[a], parameters[b]);
                let against = |s: f64| curve.derivative(from + (to - from) * s).dot(chord) < 0.0;
                if [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().any(against) {
                    return true;
                }
                a = b;
            }
            b += 1;
        }
        false
    }
}

/// A term of a sum of orthogonal polynomials, `q_{k+1} = (t − center) q_k − back q_{k−1}`.
struct Term {
    center: f64,
    back: f64,
    coefficient: Point,
}

fn sum(terms: &[Term], t: f64) -> Point {
    let (mut q, mut before, mut sum) = (1.0, 0.0, Point::ZERO);
    for term in terms {
        sum += term.coefficient * q;
        (q, before) = ((t - term.center) * q - term.back * before, q);
    }
    sum
}
