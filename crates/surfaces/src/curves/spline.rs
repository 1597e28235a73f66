use super::{CurveError, check_points};
use crate::net::extent;
use crate::{Bezier, CurveJet, Point};

/// A B-spline curve, polynomial or rational, over its domain `[t_d, t_n]` of knots t, n control points and degree d.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineCurve {
    degree: usize,
    knots: Vec<f64>,
    points: Vec<Point>,
    weights: Option<Vec<f64>>,
    spans: Vec<Span>,
}

/// A non-empty knot interval and the Bézier form of the curve over it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Span {
    pub(super) from: f64,
    pub(super) to: f64,
    /// Control points, times their weights where it is rational.
    pub(super) points: Vec<Point>,
    /// Empty for a polynomial.
    pub(super) weights: Vec<f64>,
}

impl SplineCurve {
    /// Highest degree offered.
    pub const MAX_DEGREE: usize = 30;

    /// The curve with as many knots as control points and degree + 1 together, the first and the last knot among them
    /// (they stand degree + 1 times where the curve is clamped, which it need not be), and a weight for each point where it
    /// is rational.
    ///
    /// # Errors
    /// [`CurveError`], of the kinds that speak of degree, points, knots and weights.
    pub fn new(
        degree: usize,
        knots: Vec<f64>,
        points: Vec<Point>,
        weights: Option<Vec<f64>>,
    ) -> Result<Self, CurveError> {
        if !(1..=Self::MAX_DEGREE).contains(&degree) {
            return Err(CurveError::Degree { degree, max: Self::MAX_DEGREE });
        }
        check_points("spline", degree + 1, &points)?;
        check_knots(degree, &knots, points.len())?;
        if let Some(weights) = &weights {
            check_weights(weights, points.len())?;
        }
        let spans = spans(degree, &knots, &points, weights.as_deref());
        Ok(Self { degree, knots, points, weights, spans })
    }

    /// The degree d.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The knots.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The control points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The weights of a rational curve.
    pub fn weights(&self) -> Option<&[f64]> {
        self.weights.as_deref()
    }

    /// The diagonal of the bounding box of the control points.
    pub fn size(&self) -> f64 {
        extent(&self.points)
    }

    /// The polynomial pieces between the knots, exact but for rounding: every inner knot inserted until it stands d
    /// times. None for a rational curve.
    pub fn bezier_pieces(&self) -> Option<Vec<Bezier>> {
        let piece = |span: &Span| Bezier::new(span.points.clone()).ok();
        if self.weights.is_some() { None } else { self.spans.iter().map(piece).collect() }
    }

    /// The parameters t ∈ [0, 1] of the inner knots, ascending, each once.
    pub fn breaks(&self) -> Vec<f64> {
        let [from, to] = self.domain();
        self.spans[1..].iter().map(|span| (span.from - from) / (to - from)).collect()
    }

    /// Point and derivatives by t ∈ [0, 1], which runs evenly over the domain of the knots.
    pub fn jet(&self, t: f64) -> CurveJet {
        let [from, to] = self.domain();
        let knot = from * (1.0 - t) + to * t;
        let place = self.spans.partition_point(|span| span.to <= knot).min(self.spans.len() - 1);
        let span = &self.spans[place];
        let length = span.to - span.from;
        let jet = span.jet((knot - span.from) / length);
        let factor = (to - from) / length;
        CurveJet { point: jet.point, d1: jet.d1 * factor, d2: jet.d2 * (factor * factor) }
    }

    /// The curve moved.
    pub(super) fn moved(&self, by: Point) -> Self {
        let points: Vec<Point> = self.points.iter().map(|&p| p + by).collect();
        let spans = spans(self.degree, &self.knots, &points, self.weights.as_deref());
        Self { points, spans, ..self.clone() }
    }

    /// The same curve run the other way.
    pub fn reversed(&self) -> Self {
        let [from, to] = [self.knots[0], self.knots[self.knots.len() - 1]];
        let knots: Vec<f64> = self.knots.iter().rev().map(|knot| from + (to - knot)).collect();
        let points: Vec<Point> = self.points.iter().rev().copied().collect();
        let weights = self.weights.as_ref().map(|weights| weights.iter().rev().copied().collect());
        let turned = |span: &Span| Span {
            from: from + (to - span.to),
            to: from + (to - span.from),
            points: span.points.iter().rev().copied().collect(),
            weights: span.weights.iter().rev().copied().collect(),
        };
        let spans = self.spans.iter().rev().map(turned).collect();
        Self { degree: self.degree, knots, points, weights, spans }
    }

    fn domain(&self) -> [f64; 2] {
        [self.spans[0].from, self.spans[self.spans.len() - 1].to]
    }
}

impl Span {
    /// Point and derivatives at s ∈ [0, 1] of the span.
    fn jet(&self, s: f64) -> CurveJet {
        let [point, d1, d2] = bezier_jet(&self.points, s);
        if self.weights.is_empty() {
            return CurveJet { point, d1, d2 };
        }
        let [w, w1, w2] = bezier_jet(&self.weights, s);
        // c w = p, differentiated twice.
        let c = point * (1.0 / w);
        let c1 = (d1 - c * w1) * (1.0 / w);
        let c2 = (d2 - c1 * (2.0 * w1) - c * w2) * (1.0 / w);
        CurveJet { point: c, d1: c1, d2: c2 }
    }
}

/// Value and two derivatives of a Bézier function by de Casteljau's algorithm.
fn bezier_jet<T>(control: &[T], s: f64) -> [T; 3]
where
    T: Copy
        + Default
        + std::ops::Add<Output = T>
        + std::ops::Sub<Output = T>
        + std::ops::Mul<f64, Output = T>,
{
    let n = control.len() - 1;
    let mut row = control.to_vec();
    let mut jet = [T::default(); 3];
    while row.len() > 1 {
        let order = row.len() - 1;
        if order == 2 && n >= 2 {
            jet[2] = (row[2] - row[1] * 2.0 + row[0]) * (n * (n - 1)) as f64;
        }
        if order == 1 {
            jet[1] = (row[1] - row[0]) * n as f64;
        }
        row = row.windows(2).map(|ends| ends[0] * (1.0 - s) + ends[1] * s).collect();
    }
    jet[0] = row[0];
    jet
}

fn check_knots(degree: usize, knots: &[f64], points: usize) -> Result<(), CurveError> {
    let (expected, found) = (points + degree + 1, knots.len());
    if found != expected {
        return Err(CurveError::KnotCount { degree, points, expected, found });
    }
    for (index, &knot) in knots.iter().enumerate() {
        if !knot.is_finite() || (index > 0 && knot < knots[index - 1]) {
            return Err(CurveError::KnotOrder { index, knot });
        }
    }
    if !(knots[found - 1] - knots[0]).is_finite() {
        return Err(CurveError::KnotOrder { index: found - 1, knot: knots[found - 1] });
    }
    // d + 1 times at an end of the domain, d times inside: then every function has a support and the curve hangs together.
    let (from, to) = (knots[degree], knots[points]);
    for index in 0..points {
        let knot = knots[index];
        let inside = knot > from && knot < to;
        let past = if inside { degree } else { degree + 1 };
        if knots[index + past] == knot {
            return Err(CurveError::KnotMultiplicity { knot, degree });
        }
    }
    Ok(())
}

fn check_weights(weights: &[f64], points: usize) -> Result<(), CurveError> {
    if weights.len() != points {
        return Err(CurveError::WeightCount { points, found: weights.len() });
    }
    let largest = weights.iter().fold(0.0, |m, w| f64::max(m, *w));
    let sound = |weight: f64| weight > 1e-9 * largest && weight > 0.0 && weight.is_finite();
    match weights.iter().position(|&weight| !sound(weight)) {
        Some(index) => Err(CurveError::Weight { index, weight: weights[index] }),
        None => Ok(()),
    }
}

/// The Bézier forms over the non-empty knot intervals of the domain; each begins where the one before ends, bit for bit.
fn spans(degree: usize, knots: &[f64], points: &[Point], weights: Option<&[f64]>) -> Vec<Span> {
    // Weights of order 1, so that products stay as large as the points.
    let scale = weights.map_or(1.0, |weights| weights.iter().fold(0.0, |m, w| f64::max(m, *w)));
    let mut spans: Vec<Span> = Vec::new();
    for k in degree..points.len() {
        if knots[k] == knots[k + 1] {
            continue;
        }
        let local = k - degree..=k;
        let mut span = Span { from: knots[k], to: knots[k + 1], points: Vec::new(), weights: Vec::new() };
        match weights {
            None => span.points = bezier_form(degree, knots, k, &points[local]),
            Some(weights) => {
                let weights: Vec<f64> = weights[local.clone()].iter().map(|w| w / scale).collect();
                let weighted: Vec<Point> = points[local].iter().zip(&weights).map(|(&p, &w)| p * w).collect();
                span.points = bezier_form(degree, knots, k, &weighted);
                span.weights = bezier_form(degree, knots, k, &weights);
            }
        }
        if let Some(before) = spans.last() {
            span.points[0] = before.points[degree];
            if let (Some(first), Some(&last)) = (span.weights.first_mut(), before.weights.last()) {
                *first = last;
            }
        }
        spans.push(span);
    }
    spans
}

/// The control points of the polynomial pieces between the knots of a clamped spline, one after the other, those where two meet once.
pub(crate) fn joined_pieces(degree: usize, knots: &[f64], points: &[Point]) -> Vec<Point> {
    let spans = spans(degree, knots, points, None);
    spans
        .into_iter()
        .enumerate()
        .flat_map(|(k, span)| span.points.into_iter().skip(usize::from(k > 0)))
        .collect()
}

/// Control values of the polynomial over knot interval k: its blossom at d − j times the start and j times the end.
fn bezier_form<T>(degree: usize, knots: &[f64], k: usize, local: &[T]) -> Vec<T>
where
    T: Copy + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    let blossom = |j: usize| {
        let mut row = local.to_vec();
        for r in 1..=degree {
            let argument = if r <= degree - j { knots[k] } else { knots[k + 1] };
            for i in (r..=degree).rev() {
                let (low, high) = (knots[i + k - degree], knots[i + 1 + k - r]);
                let share = (argument - low) / (high - low);
                row[i] = row[i - 1] * (1.0 - share) + row[i] * share;
            }
        }
        row[degree]
    };
    (0..=degree).map(blossom).collect()
}
