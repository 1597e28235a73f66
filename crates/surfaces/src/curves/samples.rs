use super::{CurveError, Polyline};
use crate::Point;

/// A smooth curve known by points on it, in order, and how near to them it has to pass.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    chain: Polyline,
    tolerance: f64,
}

impl Samples {
    /// The curve near `points`; a fit may leave each by at most `tolerance` (a length), and begins and ends at the first
    /// and the last. Closed if these are the same point.
    ///
    /// # Errors
    /// As [`Polyline::new`], and [`CurveError::Tolerance`].
    pub fn new(points: Vec<Point>, tolerance: f64) -> Result<Self, CurveError> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(CurveError::Tolerance { tolerance });
        }
        Ok(Self { chain: Polyline::new(points)?, tolerance })
    }

    /// The samples.
    pub fn points(&self) -> &[Point] {
        self.chain.points()
    }

    /// The chain through the samples.
    pub fn chain(&self) -> &Polyline {
        &self.chain
    }

    /// How far a fit may pass from a sample.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The curve run the other way.
    pub fn reversed(&self) -> Self {
        Self { chain: self.chain.reversed(), tolerance: self.tolerance }
    }
}
