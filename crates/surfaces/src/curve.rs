use std::sync::Arc;

use bases::{At, Basis};

use crate::{Point, SurfaceError};

/// The curve `c(t) = Σ_i P_i φ_i(t)` of control points `P_i` in a family of functions φ_i.
///
/// ```
/// use surfaces::Curve;
/// // A half circle of radius 2, exact in the AT basis.
/// let arc = Curve::circular_arc(2.0, 0.0, std::f64::consts::PI)?;
/// assert!((arc.jet(1.0).signed_curvature().unwrap() - 0.5).abs() < 1e-14);
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Curve {
    basis: Arc<dyn Basis>,
    points: Vec<Point>,
}

/// Position and derivatives of a curve at one parameter, to second order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CurveJet {
    /// The point c(t).
    pub point: Point,
    /// c'(t).
    pub d1: Point,
    /// c''(t).
    pub d2: Point,
}

impl Curve {
    /// The curve of `points` in `basis`.
    ///
    /// # Errors
    /// [`SurfaceError::PolygonLength`] unless there is one point for each function, [`SurfaceError::NotFinite`].
    pub fn new(basis: Arc<dyn Basis>, points: Vec<Point>) -> Result<Self, SurfaceError> {
        if points.len() != basis.count() {
            return Err(SurfaceError::PolygonLength { expected: basis.count(), found: points.len() });
        }
        if let Some(index) = points.iter().position(|p| !p.is_finite()) {
            return Err(SurfaceError::NotFinite { index });
        }
        Ok(Self { basis, points })
    }

    /// The curve `c(start + t)`, t ∈ [0, `span`], in the AT basis, of a `jet(v)` whose three coordinates lie in the space of
    /// that basis; other curves are met in position and two derivatives at both ends.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] for a span the AT basis does not admit, [`SurfaceError::NotFinite`].
    pub fn at(start: f64, span: f64, jet: impl Fn(f64) -> CurveJet) -> Result<Self, SurfaceError> {
        let basis = At::new(span)?;
        let points = Self::at_between(&basis, [start, start + span], jet);
        Self::new(Arc::new(basis), points.into())
    }

    /// The control points in `basis`, over `ends[1] − ends[0]`, of the curve with the given jets.
    pub(crate) fn at_between(basis: &At, ends: [f64; 2], jet: impl Fn(f64) -> CurveJet) -> [Point; 6] {
        let jets = ends.map(jet);
        let control = |coordinate: fn(Point) -> f64| {
            basis.control_values(jets.map(|j| [j.point, j.d1, j.d2].map(coordinate)))
        };
        let (x, y, z) = (control(|p| p.x), control(|p| p.y), control(|p| p.z));
        std::array::from_fn(|i| Point::new(x[i], y[i], z[i]))
    }

    /// The circular arc `radius · (cos v, sin v, 0)`, v from `start` over `span` < 2π, in the AT basis (AT (0.3)).
    ///
    /// # Errors
    /// As for [`Self::at`].
    pub fn circular_arc(radius: f64, start: f64, span: f64) -> Result<Self, SurfaceError> {
        Self::at(start, span, |v| CurveJet::on_spiral([radius, 0.0], 0.0, v))
    }

    /// The piece of the conical spiral `(v cos v, v sin v, v)`, v from `start` over `span` < 2π, in the AT basis (AT (0.2)).
    ///
    /// # Errors
    /// As for [`Self::at`].
    pub fn conical_spiral(start: f64, span: f64) -> Result<Self, SurfaceError> {
        Self::at(start, span, |v| CurveJet::on_spiral([0.0, 1.0], 1.0, v))
    }

    /// The family of functions.
    pub fn basis(&self) -> &Arc<dyn Basis> {
        &self.basis
    }

    /// The control points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Point and derivatives at `t`.
    pub fn jet(&self, t: f64) -> CurveJet {
        let table = self.basis.evaluate(t, 2);
        let sum = |r: usize| {
            let mut sum = Point::ZERO;
            for (&p, &f) in self.points.iter().zip(table.row(r)) {
                sum += p * f;
            }
            sum
        };
        CurveJet { point: sum(0), d1: sum(1), d2: sum(2) }
    }

    /// Points and derivatives at `count` equally spaced parameters, both ends included; 1 gives the start alone.
    pub fn samples(&self, count: usize) -> Vec<(f64, CurveJet)> {
        let (start, end) = self.basis.domain();
        let last = count.saturating_sub(1);
        let parameter = |k: usize| match k {
            0 => start,
            _ if k == last => end,
            _ => start + (end - start) * (k as f64 / last as f64),
        };
        (0..count).map(parameter).map(|t| (t, self.jet(t))).collect()
    }
}

impl CurveJet {
    /// The spiral `((γ + βv) cos v, (γ + βv) sin v, ζv)` at v: the rulings of a helicoid end on such curves.
    pub(crate) fn on_spiral([gamma, beta]: [f64; 2], zeta: f64, v: f64) -> Self {
        let (s, c, w) = (libm::sin(v), libm::cos(v), gamma + beta * v);
        Self {
            point: Point::new(w * c, w * s, zeta * v),
            d1: Point::new(beta * c - w * s, beta * s + w * c, zeta),
            d2: Point::new(-2.0 * beta * s - w * c, 2.0 * beta * c - w * s, 0.0),
        }
    }

    /// Signed curvature `det(c', c'')/‖c'‖³` of a planar curve, in 1/length: positive where it turns to the left in the
    /// x–y plane (GT (2.6)). z is not looked at. None where c' vanishes.
    pub fn signed_curvature(&self) -> Option<f64> {
        let flat = |p: Point| Point::new(p.x, p.y, 0.0);
        Self { point: self.point, d1: flat(self.d1), d2: flat(self.d2) }.binormal().map(|b| b.z)
    }

    /// Curvature `‖c' × c''‖/‖c'‖³` ≥ 0 of a curve in space, in 1/length. None where c' vanishes.
    pub fn curvature(&self) -> Option<f64> {
        self.binormal().map(Point::norm)
    }

    /// `c' × c''/‖c'‖³`; divided one length at a time, so that small curves do not underflow.
    fn binormal(&self) -> Option<Point> {
        let speed = self.d1.norm();
        let direction = self.d1.unit()?;
        Some(direction.cross(self.d2 * (1.0 / speed)) * (1.0 / speed))
    }
}
