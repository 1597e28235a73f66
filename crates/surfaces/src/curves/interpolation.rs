//! Curves through their points at the Gauss–Lobatto nodes.

use bases::{Matrix, Nodal};

use super::{Bezier, CurveError};
use crate::Point;

/// Interpolation in one degree: the nodes, and what leads from values there to control points.
pub(super) struct Interpolation {
    nodes: Vec<f64>,
    /// Inner control points of a polynomial that vanishes at both ends from its inner values, (n − 1)².
    inner: Matrix,
}

impl Interpolation {
    pub(super) fn new(degree: usize) -> Result<Self, CurveError> {
        if !(1..=Bezier::MAX_DEGREE).contains(&degree) {
            return Err(CurveError::Degree { degree, max: Bezier::MAX_DEGREE });
        }
        let nodal = Nodal::new(degree).map_err(|_| CurveError::Degree { degree, max: Bezier::MAX_DEGREE })?;
        let inner = nodal.inner_bernstein().times(&nodal.inner_lobatto());
        Ok(Self { nodes: nodal.nodes().to_vec(), inner })
    }

    pub(super) fn degree(&self) -> usize {
        self.nodes.len() - 1
    }

    /// The curve of the degree that begins at `start`, ends at `end` and agrees with `f` at the inner nodes.
    ///
    /// What is interpolated is the way from the chord, so that straight lines stay straight to the last digit.
    pub(super) fn curve(&self, start: Point, end: Point, f: impl Fn(f64) -> Point) -> Bezier {
        let n = self.degree();
        let chord = |t: f64| start * (1.0 - t) + end * t;
        let off: Vec<Point> = self.nodes[1..n].iter().map(|&t| f(t) - chord(t)).collect();
        let mut points = vec![start; n + 1];
        points[n] = end;
        for i in 1..n {
            points[i] = chord(i as f64 / n as f64);
            for (&weight, &off) in self.inner.row(i - 1).iter().zip(&off) {
                points[i] += off * weight;
            }
        }
        Bezier { points }
    }
}
