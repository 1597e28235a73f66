use surfaces::{EllipseArc, Point, SplineCurve};

/// A curve of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Points joined by straight lines, or samples of a curve: a file does not say which. Two or more, equal ones among them as
    /// the file has them.
    Polyline(Vec<Point>),
    /// A spline, polynomial or rational; a Bézier curve where it has no inner knots.
    Spline(SplineCurve),
    /// An arc of a circle or an ellipse.
    Arc(EllipseArc),
}

impl Shape {
    /// Its first and its last point.
    pub fn ends(&self) -> [Point; 2] {
        match self {
            Self::Polyline(points) => [points.first(), points.last()].map(|p| p.copied().unwrap_or_default()),
            Self::Spline(spline) => [0.0, 1.0].map(|t| spline.jet(t).point),
            Self::Arc(arc) => {
                let start = arc.jet(0.0).point;
                [start, if arc.is_closed() { start } else { arc.jet(1.0).point }]
            }
        }
    }

    /// The same points in the other sense.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::Polyline(mut points) => {
                points.reverse();
                Self::Polyline(points)
            }
            Self::Spline(spline) => Self::Spline(spline.reversed()),
            Self::Arc(arc) => Self::Arc(arc.reversed()),
        }
    }

    /// A spline as it is, an arc as a rational quadratic one, exact; none for polylines.
    pub fn as_spline(&self) -> Option<SplineCurve> {
        match self {
            Self::Polyline(_) => None,
            Self::Spline(spline) => Some(spline.clone()),
            Self::Arc(arc) => arc_as_spline(arc),
        }
    }

    /// Points on it, its ends among them, close enough for lengths to a few per cent: those of a polyline, 8 a span of a spline
    /// (at most some hundreds), 33 of an arc.
    pub fn sampled(&self) -> Vec<Point> {
        match self {
            Self::Polyline(points) => points.clone(),
            Self::Spline(spline) => {
                let count = (8 * (spline.points().len() - spline.degree())).min(800);
                (0..=count).map(|k| spline.jet(k as f64 / count as f64).point).collect()
            }
            Self::Arc(arc) => (0..=32).map(|k| arc.jet(f64::from(k) / 32.0).point).collect(),
        }
    }
}

/// An arc as a rational quadratic spline, exact: `w = cos(h/2)` at the middle points of pieces of angle h, at most a right angle
/// each. None for one too small for its place.
pub(crate) fn arc_as_spline(arc: &EllipseArc) -> Option<SplineCurve> {
    let [from, to] = arc.angles();
    let pieces = libm::ceil((to - from).abs() / std::f64::consts::FRAC_PI_2 - 1e-9).max(1.0);
    let weight = libm::cos(0.5 * (to - from) / pieces);
    let at = |k: f64| arc.jet((k / pieces).min(1.0)).point;
    let (mut points, mut weights, mut knots) = (vec![at(0.0)], vec![1.0], vec![0.0; 3]);
    for k in 0..pieces as usize {
        let k = k as f64;
        points.push(arc.center() + (at(k + 0.5) - arc.center()) * (1.0 / weight));
        points.push(if k + 1.0 == pieces && arc.is_closed() { points[0] } else { at(k + 1.0) });
        weights.extend([weight, 1.0]);
        knots.extend([k + 1.0; 2]);
    }
    knots.push(pieces);
    SplineCurve::new(2, knots, points, Some(weights)).ok()
}
