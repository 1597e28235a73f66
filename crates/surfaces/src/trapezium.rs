//! Right helicoids over a trapezium (AT §3–4).

use std::sync::Arc;

use bases::{At, Bernstein};

use crate::helicoid::largest_distance;
use crate::pieces::equal_cuts;
use crate::{Curve, CurveJet, Domain, Jet, Net, Patch, Pieces, Point, Product, SurfaceError, TensorPatch};

/// The right helicoid `(w cos v, w sin v, v)` over the trapezium `0 ≤ v ≤ span`, `γ₀ + β₀v ≤ w ≤ γ₁ + β₁v` (AT §3),
/// with `w = (1 − u)(γ₀ + β₀v) + u(γ₁ + β₁v)`, u ∈ [0, 1].
///
/// As a [`Patch`] it is this closed form; [`Self::patch`] and [`Self::pieces`] are the same surface from control points,
/// degree 1 in u ⊗ AT in v. Not isothermal in (u, v): a minimal surface, but no minimum of the Dirichlet energy.
///
/// ```
/// use surfaces::{Patch, TrapeziumHelicoid};
/// let helicoid = TrapeziumHelicoid::new(3.9, [6.2, 12.5], [1.0, 0.5])?;
/// let patch = helicoid.patch()?;
/// assert!(patch.point(0.5, 2.0).distance(helicoid.point(0.5, 2.0)) < 1e-13);
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrapeziumHelicoid {
    span: f64,
    /// (γ, β) of the two sides.
    sides: [[f64; 2]; 2],
}

impl TrapeziumHelicoid {
    /// Largest span of one piece: 0.9 · 2π, see [`crate::Helicoid::LARGEST_PIECE`].
    pub const LARGEST_PIECE: f64 = 0.9 * At::SUPREMUM;

    /// A span up to here stays one patch: 0.99 · 2π, see [`crate::Helicoid::LARGEST_WHOLE`].
    pub const LARGEST_WHOLE: f64 = 0.99 * At::SUPREMUM;

    /// The helicoid over the trapezium with offsets `gamma` = (γ₀, γ₁) and slopes `beta` = (β₀, β₁).
    ///
    /// # Errors
    /// [`SurfaceError::Interval`] for a span that is not positive and finite, [`SurfaceError::Side`] for an offset or slope
    /// that is not finite, [`SurfaceError::Crossing`] if the sides meet anywhere but at one end.
    pub fn new(span: f64, gamma: [f64; 2], beta: [f64; 2]) -> Result<Self, SurfaceError> {
        if !(span > 0.0 && span.is_finite()) {
            return Err(SurfaceError::Interval { name: "v", start: 0.0, end: span });
        }
        for side in 0..2 {
            let (gamma, beta) = (gamma[side], beta[side]);
            if !(gamma + beta * span).is_finite() {
                return Err(SurfaceError::Side { side, gamma, beta });
            }
        }
        let (start, slope) = (gamma[1] - gamma[0], beta[1] - beta[0]);
        let end = start + slope * span;
        let crossed = (start < 0.0 && end > 0.0) || (start > 0.0 && end < 0.0);
        if crossed || (start == 0.0 && end == 0.0) {
            let v = if slope == 0.0 { 0.0 } else { -start / slope };
            return Err(SurfaceError::Crossing { v });
        }
        Ok(Self { span, sides: [[gamma[0], beta[0]], [gamma[1], beta[1]]] })
    }

    /// The length of the interval of v.
    pub fn span(&self) -> f64 {
        self.span
    }

    /// The helicoid as one patch, degree 1 ⊗ AT, on its 2 × 6 net, all points fixed. Row i has x, y from
    /// `γ_i · (net of the circle) + β_i · (net of Archimedes' spiral)`, z from the net of v, not multiplied by β_i as AT (0.4)
    /// prints: that is right for β_i = 1 only.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] if the span reaches 2π (take [`Self::pieces`]); [`SurfaceError::NotFinite`] on overflow.
    pub fn patch(&self) -> Result<TensorPatch, SurfaceError> {
        self.piece(0.0, self.span)
    }

    /// The helicoid as one patch if its span is at most [`Self::LARGEST_WHOLE`], otherwise in the least number of equal patches
    /// with spans up to [`Self::LARGEST_PIECE`].
    ///
    /// # Errors
    /// [`SurfaceError::TooManyPieces`] beyond [`Pieces::MAX_PIECES`]; [`SurfaceError::NotFinite`] on overflow.
    pub fn pieces(&self) -> Result<Pieces, SurfaceError> {
        self.cut(|start, end| self.piece(start, end))
    }

    fn cut(
        &self,
        piece: impl Fn(f64, f64) -> Result<TensorPatch, SurfaceError>,
    ) -> Result<Pieces, SurfaceError> {
        let cuts = equal_cuts("v", (0.0, self.span), Self::LARGEST_WHOLE, Self::LARGEST_PIECE)?;
        Pieces::new(vec![0.0, 1.0], cuts.clone(), |_, j| piece(cuts[j], cuts[j + 1]))
    }

    /// The largest distance between `patch` (with these parameters) and this surface on a grid of `subdivisions` steps in
    /// each parameter.
    pub fn deviation(&self, patch: &dyn Patch, subdivisions: usize) -> f64 {
        largest_distance(self, patch, subdivisions)
    }

    /// The net of [`Self::patch`] by the construction of AT Theorems 1–3: tangents from right-angle rotations in the
    /// plane z = 0, control points along them, then each lifted to its height. Equal to the net of the patch up
    /// to rounding.
    ///
    /// The theorems have β = 1; for other slopes the segment O₁P₁ has length |β|, O₂P₂ length 2|β|. The direction of OP is
    /// that of the ruling, so that it exists at the axis too. [`Self::construction`] has the points in the plane.
    ///
    /// # Errors
    /// As for [`Self::patch`].
    pub fn constructed_net(&self) -> Result<Net, SurfaceError> {
        self.construct(&At::new(self.span)?, 0.0, self.span)
    }

    /// As [`Self::pieces`], every net by the construction of [`Self::constructed_net`].
    ///
    /// # Errors
    /// As for [`Self::pieces`].
    pub fn constructed_pieces(&self) -> Result<Pieces, SurfaceError> {
        self.cut(|start, end| {
            let basis = At::new(end - start)?;
            let net = self.construct(&basis, start, end)?;
            on_net(basis, net)
        })
    }

    /// The points and segments of the construction in the plane z = 0, for either side.
    ///
    /// # Errors
    /// As for [`Self::patch`].
    pub fn construction(&self) -> Result<[PlaneConstruction; 2], SurfaceError> {
        let basis = At::new(self.span)?;
        Ok(self.sides.map(|side| PlaneConstruction::new(&basis, side, [0.0, self.span])))
    }

    /// The net over `start ≤ v ≤ end` by AT Theorems 1–3.
    fn construct(&self, basis: &At, start: f64, end: f64) -> Result<Net, SurfaceError> {
        let heights = basis.control_values([[start, 1.0, 0.0], [end, 1.0, 0.0]]);
        let lifted = |side| {
            let flat = PlaneConstruction::new(basis, side, [start, end]).points;
            flat.into_iter().zip(heights).map(|(q, z)| Point::new(q.x, q.y, z))
        };
        Net::new(2, 6, self.sides.into_iter().flat_map(lifted).collect())
    }

    fn piece(&self, start: f64, end: f64) -> Result<TensorPatch, SurfaceError> {
        let basis = At::new(end - start)?;
        let rows = self
            .sides
            .map(|side| Curve::at_between(&basis, [start, end], |v| CurveJet::on_spiral(side, 1.0, v)));
        on_net(basis, Net::new(2, 6, rows.concat())?)
    }
}

/// The construction of the control points of a spiral `(γ + βv)(cos v, sin v)` in its plane (AT Theorems 1 and 2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneConstruction {
    /// Theorem 1 at both ends.
    pub ends: [SpiralEnd; 2],
    /// The points T³ of Theorem 2: on the tangents, from where the second derivative leads to Q₂ and Q₃.
    pub on_tangents: [Point; 2],
    /// The control points Q₀ … Q₅.
    pub points: [Point; 6],
}

/// The derivatives of a spiral at a point by right angles and lengths (AT Theorem 1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpiralEnd {
    /// The point P.
    pub point: Point,
    /// O₁, the centre O turned clockwise about P by a right angle.
    pub o1: Point,
    /// P₁, β from O₁ along OP: PP₁ is the first derivative.
    pub p1: Point,
    /// O₂, P mirrored in O.
    pub o2: Point,
    /// P₂, 2β from O₂ along PO₁: OP₂ is the second derivative.
    pub p2: Point,
}

impl SpiralEnd {
    fn new([gamma, beta]: [f64; 2], v: f64) -> Self {
        // The direction of OP is that of the ruling, so that it exists at the axis too.
        let ruling = Point::new(libm::cos(v), libm::sin(v), 0.0);
        let p = ruling * (gamma + beta * v);
        let o1 = p + clockwise(-p);
        Self { point: p, o1, p1: o1 + ruling * beta, o2: -p, p2: -p + clockwise(-ruling) * (2.0 * beta) }
    }
}

impl PlaneConstruction {
    fn new(basis: &At, side: [f64; 2], ends: [f64; 2]) -> Self {
        let [delta, m, epsilon] = basis.endpoint_rule();
        let [start, end] = ends.map(|v| SpiralEnd::new(side, v));
        let (first, last) = (start.p1 - start.point, end.p1 - end.point);
        // Q₁T³ is M − δ times the tangent.
        let (q1, q4) = (start.point + first * delta, end.point - last * delta);
        let on_tangents = [q1 + first * (m - delta), q4 - last * (m - delta)];
        let (q2, q3) = (on_tangents[0] + start.p2 * epsilon, on_tangents[1] + end.p2 * epsilon);
        Self { ends: [start, end], on_tangents, points: [start.point, q1, q2, q3, q4, end.point] }
    }
}

/// The patch of degree 1 ⊗ AT on a net of 2 × 6 points.
fn on_net(basis: At, net: Net) -> Result<TensorPatch, SurfaceError> {
    let product = Product { u: Arc::new(Bernstein::new(1)?), v: Arc::new(basis) };
    TensorPatch::new(vec![product], net)
}

/// A vector of the plane turned by a right angle, clockwise.
fn clockwise(p: Point) -> Point {
    Point::new(p.y, -p.x, p.z)
}

impl Patch for TrapeziumHelicoid {
    fn domain(&self) -> Domain {
        Domain::Rectangle { u: (0.0, 1.0), v: (0.0, self.span) }
    }

    fn jet(&self, u: f64, v: f64) -> Jet {
        let [[g0, b0], [g1, b1]] = self.sides;
        // On a line u = constant the surface is a spiral; it is linear in u.
        let along = CurveJet::on_spiral([g0 + (g1 - g0) * u, b0 + (b1 - b0) * u], 1.0, v);
        let across = CurveJet::on_spiral([g1 - g0, b1 - b0], 0.0, v);
        Jet { point: along.point, u: across.point, v: along.d1, uu: Point::ZERO, uv: across.d1, vv: along.d2 }
    }
}
