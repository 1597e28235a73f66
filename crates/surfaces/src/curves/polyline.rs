use super::{CurveError, check_points};
use crate::Point;
use crate::net::extent;

/// A chain of straight segments through given points, no two neighbours the same.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyline {
    points: Vec<Point>,
    /// Length from the start to each point.
    lengths: Vec<f64>,
}

impl Polyline {
    /// The chain through `points`; a point given twice in a row counts once. Closed if it ends where it begins.
    ///
    /// # Errors
    /// [`CurveError::Count`] below two points, [`CurveError::NotFinite`], [`CurveError::Point`].
    pub fn new(points: Vec<Point>) -> Result<Self, CurveError> {
        check_points("polyline", 2, &points)?;
        Ok(Self::measured(points))
    }

    fn measured(mut points: Vec<Point>) -> Self {
        points.dedup();
        let mut length = 0.0;
        let mut lengths = vec![0.0];
        for ends in points.windows(2) {
            length += ends[0].distance(ends[1]);
            lengths.push(length);
        }
        Self { points, lengths }
    }

    /// The points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Length from the start to each point.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// Length of the whole.
    pub fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// The diagonal of the bounding box.
    pub fn size(&self) -> f64 {
        extent(&self.points)
    }

    /// The chain moved; neighbours that rounding makes one count once.
    pub(super) fn moved(&self, by: Point) -> Self {
        Self::measured(self.points.iter().map(|&p| p + by).collect())
    }

    /// The point at the share `t` ∈ [0, 1] of the length.
    pub fn point(&self, t: f64) -> Point {
        let last = self.points.len() - 1;
        let along = t * self.length();
        let k = self.lengths.partition_point(|length| *length <= along).clamp(1, last);
        let share = (along - self.lengths[k - 1]) / (self.lengths[k] - self.lengths[k - 1]);
        let share = share.clamp(0.0, 1.0);
        self.points[k - 1] * (1.0 - share) + self.points[k] * share
    }

    /// The chain run the other way.
    pub fn reversed(&self) -> Self {
        let length = self.length();
        Self {
            points: self.points.iter().rev().copied().collect(),
            lengths: self.lengths.iter().rev().map(|l| length - l).collect(),
        }
    }
}
