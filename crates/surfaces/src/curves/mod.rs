//! Curves a boundary is made of.

mod analytic_fit;
mod bezier;
mod boundary;
mod ellipse_arc;
mod error;
mod fit;
mod interpolation;
mod polyline;
mod refinement;
mod sample_fit;
mod samples;
mod spline;

pub use bezier::Bezier;
pub(crate) use bezier::raised_once;
pub use boundary::BoundaryCurve;
pub use ellipse_arc::EllipseArc;
pub use error::{CurveError, CurvePart};
pub use fit::{CurveFit, Deviation};
pub use polyline::Polyline;
pub use samples::Samples;
pub use spline::SplineCurve;
pub(crate) use spline::joined_pieces;

use crate::Point;
use crate::net::extent;

/// Most points of a curve.
const MAX_POINTS: usize = 1_000_000;

/// Checks the points of a curve: enough of them, not too many, finite, of finite size, not all the same.
fn check_points(kind: &'static str, min: usize, points: &[Point]) -> Result<(), CurveError> {
    let found = points.len();
    if !(min..=MAX_POINTS).contains(&found) {
        return Err(CurveError::Count { kind, found, min, max: MAX_POINTS });
    }
    if let Some(index) = points.iter().position(|p| !p.is_finite()) {
        return Err(CurveError::NotFinite { index });
    }
    if !extent(points).is_finite() {
        return Err(CurveError::NotFinite { index: 0 });
    }
    if points.iter().all(|p| *p == points[0]) {
        return Err(CurveError::Point);
    }
    Ok(())
}
