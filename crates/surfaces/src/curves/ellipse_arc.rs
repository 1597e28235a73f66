use std::f64::consts::TAU;

use super::CurveError;
use crate::{CurveJet, Point};

/// An arc of an ellipse or circle: `center + r₀ cos θ e₀ + r₁ sin θ e₁`, θ from `from` to `to` in radians.
#[derive(Debug, Clone, PartialEq)]
pub struct EllipseArc {
    center: Point,
    axes: [Point; 2],
    radii: [f64; 2],
    from: f64,
    to: f64,
}

impl EllipseArc {
    /// How far axes may be from perpendicular unit vectors, and a turn from a full one.
    const ROUNDING: f64 = 1e-9;

    /// The arc with perpendicular unit vectors `axes` and the radii along them. It runs from angle `from` to `to`, backwards
    /// where `to` is the smaller one; a full turn is a closed curve.
    ///
    /// # Errors
    /// [`CurveError::NotFinite`], [`CurveError::Radius`], [`CurveError::Axes`], [`CurveError::Angles`].
    pub fn new(
        center: Point,
        axes: [Point; 2],
        radii: [f64; 2],
        from: f64,
        to: f64,
    ) -> Result<Self, CurveError> {
        if !(center.is_finite() && center.norm().is_finite()) {
            return Err(CurveError::NotFinite { index: 0 });
        }
        if let Some(&radius) = radii.iter().find(|r| !(**r > 0.0 && r.is_finite())) {
            return Err(CurveError::Radius { radius });
        }
        let [first, second] = axes;
        let off = [first.norm() - 1.0, second.norm() - 1.0, first.dot(second)];
        if !off.iter().all(|off| off.abs() <= Self::ROUNDING) {
            return Err(CurveError::Axes { first: first.into(), second: second.into() });
        }
        let turn = (to - from).abs();
        if !(turn > 0.0 && turn <= TAU * (1.0 + Self::ROUNDING) && from.abs().max(to.abs()) < 1e6) {
            return Err(CurveError::Angles { from, to });
        }
        // A full turn is one to the last digit.
        let to = if turn >= TAU * (1.0 - Self::ROUNDING) { from + TAU.copysign(to - from) } else { to };
        Ok(Self { center, axes, radii, from, to })
    }

    /// The circle of a radius around `center` in the plane with the given normal (of any length), counter-clockwise seen
    /// against it.
    ///
    /// # Errors
    /// As [`Self::new`]; [`CurveError::Axes`] for a normal that is zero or not finite.
    pub fn circle(center: Point, normal: Point, radius: f64) -> Result<Self, CurveError> {
        let bad = || CurveError::Axes { first: normal.into(), second: normal.into() };
        let normal = normal.unit().ok_or_else(bad)?;
        // The coordinate axis farthest from the normal, made perpendicular to it.
        let near = [normal.x, normal.y, normal.z].map(f64::abs);
        let axis = if near[0] <= near[1].min(near[2]) {
            Point::new(1.0, 0.0, 0.0)
        } else if near[1] <= near[2] {
            Point::new(0.0, 1.0, 0.0)
        } else {
            Point::new(0.0, 0.0, 1.0)
        };
        let first = (axis - normal * normal.dot(axis)).unit().ok_or_else(bad)?;
        Self::new(center, [first, normal.cross(first)], [radius; 2], 0.0, TAU)
    }

    /// The part of the whole ellipse between two angles in radians.
    ///
    /// # Errors
    /// [`CurveError::Angles`].
    pub fn between(&self, from: f64, to: f64) -> Result<Self, CurveError> {
        Self::new(self.center, self.axes, self.radii, from, to)
    }

    /// The center.
    pub fn center(&self) -> Point {
        self.center
    }

    /// The two perpendicular unit vectors.
    pub fn axes(&self) -> [Point; 2] {
        self.axes
    }

    /// The radii along the axes.
    pub fn radii(&self) -> [f64; 2] {
        self.radii
    }

    /// The angles of start and end in radians.
    pub fn angles(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// Whether it is a full turn.
    pub fn is_closed(&self) -> bool {
        (self.to - self.from).abs() >= TAU * (1.0 - f64::EPSILON)
    }

    /// Point and derivatives by t ∈ [0, 1], the angle growing evenly.
    pub fn jet(&self, t: f64) -> CurveJet {
        let span = self.to - self.from;
        let angle = self.from * (1.0 - t) + self.to * t;
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        let [a, b] = [self.axes[0] * self.radii[0], self.axes[1] * self.radii[1]];
        CurveJet {
            point: self.center + a * c + b * s,
            d1: (b * c - a * s) * span,
            d2: (a * c + b * s) * -(span * span),
        }
    }

    /// The arc moved.
    pub(super) fn moved(&self, by: Point) -> Self {
        Self { center: self.center + by, ..self.clone() }
    }

    /// The same arc run the other way.
    pub fn reversed(&self) -> Self {
        Self { from: self.to, to: self.from, ..self.clone() }
    }
}
