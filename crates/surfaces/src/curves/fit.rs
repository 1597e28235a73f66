//! Any curve of a boundary as Bézier pieces of bounded degree.

use super::analytic_fit::{Analytic, Limits};
use super::{Bezier, BoundaryCurve, CurveError, Polyline, SplineCurve, sample_fit};

/// How far pieces are from the curve they stand for.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviation {
    /// The largest distance of a point of the pieces from the curve, or of a sample from the pieces (a length).
    pub largest: f64,
    /// `∫ |δ| ds` along the curve, δ the distance: to first order, the most the area of a surface with this rim can change
    /// (an area).
    pub area: f64,
}

impl Deviation {
    /// Both curves together.
    pub fn and(self, other: Self) -> Self {
        Self { largest: self.largest.max(other.largest), area: self.area + other.area }
    }
}

/// A curve of a boundary as Bézier pieces, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveFit {
    pub(super) pieces: Vec<Bezier>,
    pub(super) deviation: Deviation,
}

impl CurveFit {
    /// The pieces; each begins where the one before ends, bit for bit, and the last ends where the first begins if the
    /// curve is closed.
    pub fn pieces(&self) -> &[Bezier] {
        &self.pieces
    }

    /// How far they are from the curve, as measured.
    pub fn deviation(&self) -> Deviation {
        self.deviation
    }

    /// Pieces that are the curve.
    fn exact(pieces: Vec<Bezier>) -> Self {
        Self { pieces, deviation: Deviation::default() }
    }
}

/// Knot spans of a spline above which fewer pieces within the tolerance are looked for.
const MANY_SPANS: usize = 12;

impl BoundaryCurve {
    /// The curve as Bézier pieces of degree at most `degree`, as few as `tolerance` (a length) admits.
    ///
    /// - A Bézier curve, a polyline and a polynomial spline of no higher degree are met exactly; a spline of more than
    ///   twelve spans by fewer pieces where some within the tolerance are found.
    /// - Arcs, rational splines and curves of higher degree are interpolated at Gauss–Lobatto points: arcs in pieces of at
    ///   most 90°, splines between their knots, all halved until they are within the tolerance.
    /// - Samples are met in the sense of least squares by polynomials of the least degree that passes all of them within
    ///   their own tolerance; where none does, or it turns back between samples, in more pieces. Samples that no piece
    ///   meets are joined by segments.
    ///
    /// A closed arc and closed samples give at least four pieces.
    ///
    /// # Errors
    /// [`CurveError::Degree`], [`CurveError::Tolerance`] for one that is not positive (∞ is admitted), and
    /// [`CurveError::NotMet`] where pieces of the degree stay farther away than the tolerance.
    pub fn fit(&self, degree: usize, tolerance: f64) -> Result<CurveFit, CurveError> {
        if !(1..=Bezier::MAX_DEGREE).contains(&degree) {
            return Err(CurveError::Degree { degree, max: Bezier::MAX_DEGREE });
        }
        if tolerance.is_nan() || tolerance <= 0.0 {
            return Err(CurveError::Tolerance { tolerance });
        }
        let limits = Limits { degree, tolerance };
        let mut fit = match self {
            Self::Bezier(curve) if curve.degree() <= degree => CurveFit::exact(vec![curve.clone()]),
            Self::Bezier(curve) => limits.fit(curve, &[0.0, 1.0])?,
            Self::Polyline(chain) => CurveFit::exact(segments(chain)),
            Self::Spline(curve) => spline(curve, limits)?,
            Self::Through(samples) => sample_fit::fit(samples, degree)?,
            Self::Arc(arc) => {
                let [from, to] = arc.angles();
                // An angle of 90° or a multiple of it takes no further piece because of its rounding.
                let quarters = ((to - from).abs() / std::f64::consts::FRAC_PI_2 - 1e-9).ceil().max(1.0);
                let cuts: Vec<f64> = (0..=quarters as usize).map(|k| k as f64 / quarters).collect();
                limits.fit(arc, &cuts)?
            }
        };
        if self.is_closed() {
            // The last point is that of the curve at its end, equal to the first only to rounding.
            let start = fit.pieces[0].start();
            if let Some(last) = fit.pieces.last_mut().and_then(|piece| piece.points.last_mut()) {
                *last = start;
            }
        }
        Ok(fit)
    }
}

/// The segments of a chain; points between two that lie on a straight line to rounding are left out.
fn segments(chain: &Polyline) -> Vec<Bezier> {
    let points = chain.points();
    let rounding = 4.0 * f64::EPSILON * chain.size();
    let mut kept = vec![points[0]];
    for k in 1..points.len() - 1 {
        // Against the last point kept, not against the one before: else a slow bend would pass point by point.
        let (before, here, next) = (kept[kept.len() - 1], points[k], points[k + 1]);
        let forward = (here - before).dot(next - here) > 0.0;
        let direction = (next - before).unit().unwrap_or_default();
        let off = here - before;
        let is_straight = forward && (off - direction * off.dot(direction)).norm() <= rounding;
        if !is_straight {
            kept.push(here);
        }
    }
    kept.push(points[points.len() - 1]);
    kept.windows(2).map(|ends| Bezier { points: ends.to_vec() }).collect()
}

fn spline(curve: &SplineCurve, limits: Limits) -> Result<CurveFit, CurveError> {
    let mut cuts = curve.breaks();
    cuts.insert(0, 0.0);
    cuts.push(1.0);
    let by_spans = match curve.bezier_pieces() {
        Some(pieces) if curve.degree() <= limits.degree => CurveFit::exact(pieces),
        Some(_) | None => limits.fit(curve, &cuts)?,
    };
    if by_spans.pieces.len() <= MANY_SPANS {
        return Ok(by_spans);
    }
    Ok(limits.fewer(curve, by_spans.pieces.len()).unwrap_or(by_spans))
}

/// What a deviation is measured against.
impl Analytic for Bezier {
    fn jet(&self, t: f64) -> crate::CurveJet {
        crate::CurveJet { point: self.point(t), d1: self.derivative(t), d2: self.second_derivative(t) }
    }
}
