use super::{CurveError, EllipseArc, Polyline, Samples, SplineCurve};
use crate::{Bezier, Point};

/// A curve of a boundary, as people and files give them.
///
/// ```
/// use surfaces::{EllipseArc, BoundaryCurve, Point};
/// let ring: BoundaryCurve = EllipseArc::circle(Point::ZERO, Point::new(0., 0., 1.), 2.0)?.into();
/// assert!(ring.is_closed());
/// assert!((ring.point(0.25).norm() - 2.0).abs() < 1e-15);
/// # Ok::<(), surfaces::CurveError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum BoundaryCurve {
    /// A polynomial by its Bézier points.
    Bezier(Bezier),
    /// Straight segments, kept exactly.
    Polyline(Polyline),
    /// A B-spline, polynomial or rational.
    Spline(SplineCurve),
    /// A smooth curve through samples.
    Through(Samples),
    /// An arc of a circle or an ellipse, or all of it.
    Arc(EllipseArc),
}

impl BoundaryCurve {
    /// The Bézier curve of the given control points.
    ///
    /// # Errors
    /// [`CurveError::Count`], [`CurveError::NotFinite`], [`CurveError::Point`].
    pub fn bezier(points: Vec<Point>) -> Result<Self, CurveError> {
        super::check_points("Bézier curve", 2, &points)?;
        let found = points.len();
        let (min, max) = (2, Bezier::MAX_DEGREE + 1);
        let count = CurveError::Count { kind: "Bézier curve", found, min, max };
        Bezier::new(points).map(Self::Bezier).map_err(|_| count)
    }

    /// Straight segments through `points`, see [`Polyline::new`].
    ///
    /// # Errors
    /// As there.
    pub fn polyline(points: Vec<Point>) -> Result<Self, CurveError> {
        Polyline::new(points).map(Self::Polyline)
    }

    /// A B-spline, see [`SplineCurve::new`].
    ///
    /// # Errors
    /// As there.
    pub fn spline(
        degree: usize,
        knots: Vec<f64>,
        points: Vec<Point>,
        weights: Option<Vec<f64>>,
    ) -> Result<Self, CurveError> {
        SplineCurve::new(degree, knots, points, weights).map(Self::Spline)
    }

    /// A smooth curve through samples, see [`Samples::new`].
    ///
    /// # Errors
    /// As there.
    pub fn through(points: Vec<Point>, tolerance: f64) -> Result<Self, CurveError> {
        Samples::new(points, tolerance).map(Self::Through)
    }

    /// An arc, see [`EllipseArc::new`].
    ///
    /// # Errors
    /// As there.
    pub fn arc(
        center: Point,
        axes: [Point; 2],
        radii: [f64; 2],
        from: f64,
        to: f64,
    ) -> Result<Self, CurveError> {
        EllipseArc::new(center, axes, radii, from, to).map(Self::Arc)
    }

    /// Where it begins.
    pub fn start(&self) -> Point {
        self.point(0.0)
    }

    /// Where it ends.
    pub fn end(&self) -> Point {
        if self.is_closed() { self.start() } else { self.point(1.0) }
    }

    /// Whether it ends where it begins: an arc by its angles, a spline to within rounding, others exactly.
    pub fn is_closed(&self) -> bool {
        match self {
            Self::Bezier(curve) => curve.start() == curve.end(),
            Self::Polyline(chain) => is_closed(chain),
            Self::Spline(curve) => {
                curve.jet(0.0).point.distance(curve.jet(1.0).point) <= 1e-12 * curve.size()
            }
            Self::Through(samples) => is_closed(samples.chain()),
            Self::Arc(arc) => arc.is_closed(),
        }
    }

    /// The point at t ∈ [0, 1]: the curve's own parameter, the share of the length for polylines and samples (between
    /// which it is straight).
    pub fn point(&self, t: f64) -> Point {
        match self {
            Self::Bezier(curve) => curve.point(t),
            Self::Polyline(chain) => chain.point(t),
            Self::Spline(curve) => curve.jet(t).point,
            Self::Through(samples) => samples.chain().point(t),
            Self::Arc(arc) => arc.jet(t).point,
        }
    }

    /// The curve run the other way.
    pub fn reversed(&self) -> Self {
        match self {
            Self::Bezier(curve) => Self::Bezier(curve.clone().reversed()),
            Self::Polyline(chain) => Self::Polyline(chain.reversed()),
            Self::Spline(curve) => Self::Spline(curve.reversed()),
            Self::Through(samples) => Self::Through(samples.reversed()),
            Self::Arc(arc) => Self::Arc(arc.reversed()),
        }
    }

    /// The curve moved.
    #[must_use]
    pub fn moved(&self, by: Point) -> Self {
        match self {
            Self::Bezier(curve) => Self::Bezier(curve.moved(by)),
            Self::Polyline(chain) => Self::Polyline(chain.moved(by)),
            Self::Spline(curve) => Self::Spline(curve.moved(by)),
            Self::Through(samples) => Self::Through(samples.moved(by)),
            Self::Arc(arc) => Self::Arc(arc.moved(by)),
        }
    }

    /// The points it is given by: control points, vertices, samples; of an arc its centre and the ends of its half axes.
    pub fn given_points(&self) -> Vec<Point> {
        match self {
            Self::Bezier(curve) => curve.points().to_vec(),
            Self::Polyline(chain) => chain.points().to_vec(),
            Self::Spline(curve) => curve.points().to_vec(),
            Self::Through(samples) => samples.points().to_vec(),
            Self::Arc(arc) => {
                let ([a, b], [r, s]) = (arc.axes(), arc.radii());
                vec![arc.center(), arc.center() + a * r, arc.center() + b * s]
            }
        }
    }

    /// The diagonal of a box around it, not much larger than the curve.
    pub fn size(&self) -> f64 {
        match self {
            Self::Bezier(curve) => curve.size(),
            Self::Polyline(chain) => chain.size(),
            Self::Spline(curve) => curve.size(),
            Self::Through(samples) => samples.chain().size(),
            Self::Arc(arc) => {
                let points: Vec<Point> = (0..=16).map(|k| arc.jet(f64::from(k) / 16.0).point).collect();
                crate::net::extent(&points)
            }
        }
    }
}

fn is_closed(chain: &Polyline) -> bool {
    chain.points().first() == chain.points().last()
}

impl From<Bezier> for BoundaryCurve {
    fn from(curve: Bezier) -> Self {
        Self::Bezier(curve)
    }
}

impl From<Polyline> for BoundaryCurve {
    fn from(chain: Polyline) -> Self {
        Self::Polyline(chain)
    }
}

impl From<SplineCurve> for BoundaryCurve {
    fn from(curve: SplineCurve) -> Self {
        Self::Spline(curve)
    }
}

impl From<Samples> for BoundaryCurve {
    fn from(samples: Samples) -> Self {
        Self::Through(samples)
    }
}

impl From<EllipseArc> for BoundaryCurve {
    fn from(arc: EllipseArc) -> Self {
        Self::Arc(arc)
    }
}
