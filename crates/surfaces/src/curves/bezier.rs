//! Polynomial Bézier curves.

use crate::net::extent;
use crate::{Point, SurfaceError};

/// A Bézier curve `c(t) = Σ_k P_k B_{k,n}(t)`, t ∈ [0, 1], of degree n ≥ 1 in space.
///
/// ```
/// use surfaces::{Bezier, Point};
/// let arch = Bezier::new(vec![Point::ZERO, Point::new(1., 2., 0.), Point::new(2., 0., 0.)])?;
/// assert_eq!(arch.point(0.5), Point::new(1., 1., 0.));
/// let [left, right] = arch.split(0.5);
/// assert_eq!(left.end(), right.start());
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Bezier {
    pub(crate) points: Vec<Point>,
}

impl Bezier {
    /// Highest degree offered.
    pub const MAX_DEGREE: usize = 100;

    /// The curve of the given control points.
    ///
    /// # Errors
    /// [`SurfaceError::PolygonLength`] below 2 points and above [`Self::MAX_DEGREE`] + 1, [`SurfaceError::NotFinite`].
    pub fn new(points: Vec<Point>) -> Result<Self, SurfaceError> {
        let count = points.len();
        let allowed = count.clamp(2, Self::MAX_DEGREE + 1);
        if count != allowed {
            return Err(SurfaceError::PolygonLength { expected: allowed, found: count });
        }
        if let Some(index) = points.iter().position(|p| !p.is_finite()) {
            return Err(SurfaceError::NotFinite { index });
        }
        Ok(Self { points })
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.points.len() - 1
    }

    /// The n + 1 control points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// c(0).
    pub fn start(&self) -> Point {
        self.points[0]
    }

    /// c(1).
    pub fn end(&self) -> Point {
        self.points[self.degree()]
    }

    /// The diagonal of the bounding box of the control points.
    pub fn size(&self) -> f64 {
        extent(&self.points)
    }

    /// c(t) by de Casteljau's algorithm.
    pub fn point(&self, t: f64) -> Point {
        de_casteljau(self.points.clone(), t)
    }

    /// c'(t).
    pub fn derivative(&self, t: f64) -> Point {
        let n = self.degree() as f64;
        de_casteljau(self.points.windows(2).map(|ends| (ends[1] - ends[0]) * n).collect(), t)
    }

    /// c''(t).
    pub fn second_derivative(&self, t: f64) -> Point {
        let n = self.degree() as f64;
        let second = |p: &[Point]| (p[2] - p[1] * 2.0 + p[0]) * (n * (n - 1.0));
        match self.points.len() {
            0..=2 => Point::ZERO,
            _ => de_casteljau(self.points.windows(3).map(second).collect(), t),
        }
    }

    /// The curve run the other way.
    pub fn reversed(mut self) -> Self {
        self.points.reverse();
        self
    }

    /// The curve moved.
    pub(super) fn moved(&self, by: Point) -> Self {
        Self { points: self.points.iter().map(|&p| p + by).collect() }
    }

    /// The direction in which it leaves its start, of any length; zero only for a curve in one point.
    pub fn direction(&self) -> Point {
        let away = |p: &Point| *p - self.points[0];
        self.points.iter().map(away).find(|d| *d != Point::ZERO).unwrap_or_default()
    }

    /// The curve moved to other ends, finite ones, by a way linear in the number of the control point: lines stay lines.
    pub fn with_ends(&self, start: Point, end: Point) -> Self {
        let n = self.degree();
        let (at_start, at_end) = (start - self.start(), end - self.end());
        let moved = |(k, &p): (usize, &Point)| {
            let share = k as f64 / n as f64;
            p + at_start * (1.0 - share) + at_end * share
        };
        let mut points: Vec<Point> = self.points.iter().enumerate().map(moved).collect();
        (points[0], points[n]) = (start, end);
        Self { points }
    }

    /// The pieces over [0, t] and [t, 1], each again over [0, 1]; they share c(t) bit for bit.
    pub fn split(&self, t: f64) -> [Self; 2] {
        let n = self.degree();
        let mut row = self.points.clone();
        let (mut left, mut right) = (Vec::with_capacity(n + 1), Vec::with_capacity(n + 1));
        while let (Some(&first), Some(&last)) = (row.first(), row.last()) {
            left.push(first);
            right.push(last);
            row = between(&row, t);
        }
        right.reverse();
        [Self { points: left }, Self { points: right }]
    }

    /// The same curve with control points of degree `degree`; itself where `degree` is not above its own. The ends and,
    /// for curves of degree 1 cut evenly, the line stay as they are.
    pub fn raised(&self, degree: usize) -> Self {
        let mut points = self.points.clone();
        while points.len() <= degree {
            points = raised_once(&points);
        }
        Self { points }
    }
}

/// The next row of de Casteljau's scheme.
fn between(row: &[Point], t: f64) -> Vec<Point> {
    row.windows(2).map(|ends| ends[0] * (1.0 - t) + ends[1] * t).collect()
}

fn de_casteljau(mut row: Vec<Point>, t: f64) -> Point {
    while row.len() > 1 {
        row = between(&row, t);
    }
    row[0]
}

/// `Q_k = (1 − k/n) P_k + (k/n) P_{k−1}`, n the raised degree.
pub(crate) fn raised_once(points: &[Point]) -> Vec<Point> {
    let n = points.len();
    let inner = (1..n).map(|k| {
        let share = k as f64 / n as f64;
        points[k] * (1.0 - share) + points[k - 1] * share
    });
    std::iter::once(points[0]).chain(inner).chain(std::iter::once(points[n - 1])).collect()
}
