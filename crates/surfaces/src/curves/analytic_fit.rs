//! Pieces that interpolate a curve known at every parameter.

use super::interpolation::Interpolation;
use super::{Bezier, CurveError, CurveFit, Deviation, EllipseArc, SplineCurve};
use crate::{CurveJet, Point};

/// A curve with its derivatives over [0, 1].
pub(super) trait Analytic {
    /// Point and derivatives at t.
    fn jet(&self, t: f64) -> CurveJet;
}

impl Analytic for EllipseArc {
    fn jet(&self, t: f64) -> CurveJet {
        Self::jet(self, t)
    }
}

impl Analytic for SplineCurve {
    fn jet(&self, t: f64) -> CurveJet {
        Self::jet(self, t)
    }
}

/// What the pieces may be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    pub(super) degree: usize,
    pub(super) tolerance: f64,
}

/// Most halvings of a piece.
const MOST_HALVINGS: usize = 8;

impl Limits {
    /// Interpolants between the parameters `cuts`, halved until they are within the tolerance.
    pub(super) fn fit(self, curve: &impl Analytic, cuts: &[f64]) -> Result<CurveFit, CurveError> {
        let interpolation = Interpolation::new(self.degree)?;
        let mut fit = CurveFit { pieces: Vec::new(), deviation: Deviation::default() };
        // A stack with the first interval on top: pieces come out in the order of the curve, whatever is halved.
        let mut open: Vec<([f64; 2], usize)> = cuts.windows(2).map(|w| ([w[0], w[1]], 0)).rev().collect();
        while let Some(([from, to], halvings)) = open.pop() {
            let piece = piece(curve, &interpolation, [from, to], fit.pieces.last());
            let deviation = deviation(curve, &piece, [from, to]);
            if deviation.largest <= self.tolerance {
                fit.pieces.push(piece);
                fit.deviation = fit.deviation.and(deviation);
                continue;
            }
            // Rounding, where the tolerance asks for less than it.
            let middle = 0.5 * (from + to);
            if halvings == MOST_HALVINGS || middle <= from || middle >= to {
                let Self { degree, tolerance } = self;
                return Err(CurveError::NotMet { degree, tolerance, deviation: deviation.largest });
            }
            open.push(([middle, to], halvings + 1));
            open.push(([from, middle], halvings + 1));
        }
        Ok(fit)
    }

    /// Fewer than `many` pieces of equal parameter intervals within the tolerance, if there are.
    pub(super) fn fewer(self, curve: &impl Analytic, many: usize) -> Option<CurveFit> {
        let interpolation = Interpolation::new(self.degree).ok()?;
        // One by one while few are enough, then in strides: an attempt costs as much as its pieces.
        let counts = (1..many).filter(|count| *count <= 16 || count % 8 == 0);
        counts.into_iter().find_map(|count| {
            let mut fit = CurveFit { pieces: Vec::new(), deviation: Deviation::default() };
            for k in 0..count {
                let ends = [k, k + 1].map(|k| k as f64 / count as f64);
                let piece = piece(curve, &interpolation, ends, fit.pieces.last());
                let deviation = deviation(curve, &piece, ends);
                if deviation.largest > self.tolerance {
                    return None;
                }
                fit.pieces.push(piece);
                fit.deviation = fit.deviation.and(deviation);
            }
            Some(fit)
        })
    }
}

/// The interpolant at the Gauss–Lobatto points of an interval, from where the piece before ends.
///
/// A curve at the least distance would be nearer, but not better as a rim: at these points the distances left and right
/// cancel, and the area between curve and interpolant vanishes like the 2n-th power of the length (a circle in four arcs has
/// its area to 1.7e-6, 4.4e-11, 5e-16 for n = 4, 6, 8).
fn piece(
    curve: &impl Analytic,
    interpolation: &Interpolation,
    [from, to]: [f64; 2],
    before: Option<&Bezier>,
) -> Bezier {
    let at = |t: f64| curve.jet(from * (1.0 - t) + to * t).point;
    let start = before.map_or_else(|| at(0.0), Bezier::end);
    interpolation.curve(start, at(1.0), at)
}

/// How far a piece is from the curve over an interval: at four times as many points as nodes, each against the nearest point of
/// the curve that Newton's method finds from its own parameter.
fn deviation(curve: &impl Analytic, piece: &Bezier, [from, to]: [f64; 2]) -> Deviation {
    let count = 4 * piece.degree() + 5;
    let mut sum = Deviation::default();
    for k in 0..count {
        let t = (k as f64 + 0.5) / count as f64;
        let distance = distance(curve, piece.point(t), from * (1.0 - t) + to * t);
        sum.largest = sum.largest.max(distance);
        sum.area += distance * piece.derivative(t).norm() / count as f64;
    }
    sum
}

/// The distance of `point` from the curve: an upper bound in any case, because a point of the curve lies that far.
fn distance(curve: &impl Analytic, point: Point, start: f64) -> f64 {
    let (mut t, mut nearest) = (start, f64::INFINITY);
    for _ in 0..4 {
        let CurveJet { point: here, d1, d2 } = curve.jet(t);
        let off = here - point;
        nearest = nearest.min(off.norm());
        // Half of the second derivative of the squared distance: where it is not positive Newton's step would climb.
        let bend = d1.dot(d1) + off.dot(d2);
        if bend.is_nan() || bend <= 0.0 {
            break;
        }
        t = (t - off.dot(d1) / bend).clamp(0.0, 1.0);
    }
    nearest
}
