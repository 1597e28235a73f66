//! Generalized helicoids (AHT §2–4).

use std::sync::Arc;

use bases::{Aht, Basis};

use crate::pieces::equal_cuts;
use crate::{Domain, Jet, Net, Patch, Pieces, Point, Product, SurfaceError, TensorPatch};

/// The generalized helicoid `x = a sinh u cos v − b cosh u sin v`, `y = a sinh u sin v + b cosh u cos v`, `z = av + bu` over a
/// rectangle (AHT §2): a minimal surface in isothermal parameters, `E = G = (a² + b²) cosh² u`, `F = 0`.
///
/// b = 0 is the right helicoid of pitch a, a = 0 the catenoid of neck b. As a [`Patch`] it is this closed form, with u, v
/// as they stand there; [`Self::patch`] and [`Self::pieces`] are the same surface from control points.
///
/// ```
/// use surfaces::{Helicoid, Patch};
/// let helicoid = Helicoid::new(1.0, 2.0, 1.5, 6.0)?;
/// let patch = helicoid.patch()?;
/// assert_eq!(patch.net().points().len(), 36);
/// assert!(patch.point(0.4, 5.0).distance(helicoid.point(0.4, 5.0)) < 1e-14);
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helicoid {
    weights: [f64; 2],
    u: (f64, f64),
    v: (f64, f64),
}

impl Helicoid {
    /// Largest span of one piece: 0.9 of the bound of the AHT basis. Up to there a patch keeps all but one digit; beyond,
    /// its control points grow without limit.
    pub const LARGEST_PIECE: f64 = 0.9 * Aht::SUPREMUM;

    /// A span up to here, 0.99 of the bound, stays one patch if nothing else makes pieces necessary: two digits are lost.
    pub const LARGEST_WHOLE: f64 = 0.99 * Aht::SUPREMUM;

    /// The helicoid (a, b) over `[0, u_span] × [0, v_span]`, as in AHT.
    ///
    /// # Errors
    /// As for [`Self::over`].
    pub fn new(a: f64, b: f64, u_span: f64, v_span: f64) -> Result<Self, SurfaceError> {
        Self::over(a, b, (0.0, u_span), (0.0, v_span))
    }

    /// The helicoid (a, b) over any rectangle `u × v`, of any size.
    ///
    /// # Errors
    /// [`SurfaceError::Weights`] for (0, 0) and what is not finite; [`SurfaceError::Interval`] for an empty or infinite
    /// interval.
    pub fn over(a: f64, b: f64, u: (f64, f64), v: (f64, f64)) -> Result<Self, SurfaceError> {
        if !(a.is_finite() && b.is_finite()) || (a == 0.0 && b == 0.0) {
            return Err(SurfaceError::Weights { a, b });
        }
        for (name, (start, end)) in [("u", u), ("v", v)] {
            let span = end - start;
            if !(span > 0.0 && span.is_finite()) {
                return Err(SurfaceError::Interval { name, start, end });
            }
        }
        Ok(Self { weights: [a, b], u, v })
    }

    /// The weights (a, b) of the right helicoid and of the catenoid.
    pub fn weights(&self) -> [f64; 2] {
        self.weights
    }

    /// The lengths of the intervals of u and v.
    pub fn spans(&self) -> [f64; 2] {
        [self.u, self.v].map(|(start, end)| end - start)
    }

    /// The helicoid as one patch AHT ⊗ AHT on its 6 × 6 net, all points fixed, with parameters from 0: the patch at (u, v)
    /// is the helicoid at `(u.0 + u, v.0 + v)` (AHT §4, with the corrected control points).
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] if a span reaches the bound of the AHT basis (take [`Self::pieces`]);
    /// [`SurfaceError::NotFinite`] where cosh u overflows.
    pub fn patch(&self) -> Result<TensorPatch, SurfaceError> {
        Factor::on(self.u)?.times(&Factor::on(self.v)?, self.weights)
    }

    /// The helicoid as one patch if its spans are at most [`Self::LARGEST_WHOLE`]; a longer span is cut into the least number
    /// of equal ones of at most [`Self::LARGEST_PIECE`].
    ///
    /// # Errors
    /// [`SurfaceError::TooManyPieces`] beyond [`Pieces::MAX_PIECES`] in a direction; [`SurfaceError::NotFinite`] where
    /// cosh u overflows.
    pub fn pieces(&self) -> Result<Pieces, SurfaceError> {
        let u = equal_cuts("u", self.u, Self::LARGEST_WHOLE, Self::LARGEST_PIECE)?;
        let v = equal_cuts("v", self.v, Self::LARGEST_WHOLE, Self::LARGEST_PIECE)?;
        let factors = |cuts: &[f64]| {
            cuts.windows(2).map(|ends| Factor::on((ends[0], ends[1]))).collect::<Result<Vec<_>, _>>()
        };
        let (in_u, in_v) = (factors(&u)?, factors(&v)?);
        Pieces::new(u, v, |i, j| in_u[i].times(&in_v[j], self.weights))
    }

    /// The largest distance between `patch` (with parameters as in this closed form) and this surface on a grid of
    /// `subdivisions` steps in each parameter.
    pub fn deviation(&self, patch: &dyn Patch, subdivisions: usize) -> f64 {
        largest_distance(self, patch, subdivisions)
    }
}

/// The largest distance between two patches over the domain of the first, on a grid; infinite if one is not finite.
pub(crate) fn largest_distance(exact: &dyn Patch, patch: &dyn Patch, subdivisions: usize) -> f64 {
    let Domain::Rectangle { u, v } = exact.domain() else { return f64::INFINITY };
    let n = subdivisions.max(1);
    let steps = |(start, end): (f64, f64)| -> Vec<f64> {
        (0..=n).map(|k| if k == n { end } else { start + (end - start) * (k as f64 / n as f64) }).collect()
    };
    let (us, vs) = (steps(u), steps(v));
    exact.jets(&us, &vs).iter().zip(patch.jets(&us, &vs)).fold(0.0, |worst, (a, b)| {
        let distance = a.point.distance(b.point);
        if distance.is_nan() { f64::INFINITY } else { f64::max(worst, distance) }
    })
}

impl Patch for Helicoid {
    fn domain(&self) -> Domain {
        Domain::Rectangle { u: self.u, v: self.v }
    }

    fn jet(&self, u: f64, v: f64) -> Jet {
        let [a, b] = self.weights;
        let (sh, ch, s, c) = (libm::sinh(u), libm::cosh(u), libm::sin(v), libm::cos(v));
        let uu = Point::new(a * sh * c - b * ch * s, a * sh * s + b * ch * c, 0.0);
        let uv = Point::new(-a * ch * s - b * sh * c, a * ch * c - b * sh * s, 0.0);
        Jet {
            point: Point::new(uu.x, uu.y, a * v + b * u),
            u: Point::new(uv.y, -uv.x, b),
            v: Point::new(-uu.y, uu.x, a),
            uu,
            uv,
            vv: -uu,
        }
    }
}

/// One interval of a parameter with what the net needs of it: the AHT basis and control values of five functions.
struct Factor {
    basis: Arc<dyn Basis>,
    sinh: [f64; 6],
    cosh: [f64; 6],
    sin: [f64; 6],
    cos: [f64; 6],
    parameter: [f64; 6],
}

impl Factor {
    fn on((start, end): (f64, f64)) -> Result<Self, SurfaceError> {
        let basis = Aht::new(end - start)?;
        let control = |jet: &dyn Fn(f64) -> [f64; 3]| basis.control_values([jet(start), jet(end)]);
        Ok(Self {
            sinh: control(&|t| [libm::sinh(t), libm::cosh(t), libm::sinh(t)]),
            cosh: control(&|t| [libm::cosh(t), libm::sinh(t), libm::cosh(t)]),
            sin: control(&|t| [libm::sin(t), libm::cos(t), -libm::sin(t)]),
            cos: control(&|t| [libm::cos(t), -libm::sin(t), -libm::cos(t)]),
            parameter: control(&|t| [t, 1.0, 0.0]),
            basis: Arc::new(basis),
        })
    }

    /// The patch of the helicoid (a, b) with u from `self` and v from `other`.
    fn times(&self, other: &Self, [a, b]: [f64; 2]) -> Result<TensorPatch, SurfaceError> {
        let point = |i: usize, j: usize| {
            let (sh, ch, s, c) = (self.sinh[i], self.cosh[i], other.sin[j], other.cos[j]);
            Point::new(
                a * sh * c - b * ch * s,
                a * sh * s + b * ch * c,
                a * other.parameter[j] + b * self.parameter[i],
            )
        };
        let points = (0..6).flat_map(|i| (0..6).map(move |j| (i, j))).map(|(i, j)| point(i, j)).collect();
        let product = Product { u: self.basis.clone(), v: other.basis.clone() };
        TensorPatch::new(vec![product], Net::new(6, 6, points)?)
    }
}
