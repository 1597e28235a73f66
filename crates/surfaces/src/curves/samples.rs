use super::{CurveError, Polyline};
use crate::Point;

/// A curve known by points on it, in order, and how near to them it has to pass; smooth but where it turns sharply.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    chain: Polyline,
    tolerance: f64,
    corner_degrees: f64,
}

impl Samples {
    /// The turn of a direction, in degrees, above which a sample is a corner unless something else is said: a little less than that of
    /// a regular octagon.
    pub const CORNER_DEGREES: f64 = 44.0;

    /// The curve near `points`; a fit may leave each by at most `tolerance` (a length), and begins and ends at the first
    /// and the last. Closed if these are the same point.
    ///
    /// # Errors
    /// As [`Polyline::new`], and [`CurveError::Tolerance`].
    pub fn new(points: Vec<Point>, tolerance: f64) -> Result<Self, CurveError> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(CurveError::Tolerance { tolerance });
        }
        Ok(Self { chain: Polyline::new(points)?, tolerance, corner_degrees: Self::CORNER_DEGREES })
    }

    /// The same with corners where the chain turns by more than `degrees`; what lies outside [0, 180] is taken to the nearer end.
    #[must_use]
    pub fn with_corner_degrees(mut self, degrees: f64) -> Self {
        self.corner_degrees = if degrees.is_nan() { Self::CORNER_DEGREES } else { degrees.clamp(0.0, 180.0) };
        self
    }

    /// The turn of direction in degrees above which a sample is a corner.
    pub fn corner_degrees(&self) -> f64 {
        self.corner_degrees
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

    /// The samples moved.
    pub(super) fn moved(&self, by: Point) -> Self {
        Self { chain: self.chain.moved(by), ..*self }
    }

    /// The curve run the other way.
    pub fn reversed(&self) -> Self {
        Self { chain: self.chain.reversed(), ..*self }
    }
}
