use surfaces::{BoundaryCurve, CurveError, Point, extent};

use super::CuttingError;

/// A closed chain of curves, each beginning where the one before ends.
///
/// ```
/// use plateau::Loop;
/// use surfaces::Point;
/// let corners = [[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]].map(Point::from);
/// assert_eq!(Loop::polygon(&corners)?.curves().len(), 4);
/// # Ok::<(), plateau::CuttingError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Loop {
    curves: Vec<BoundaryCurve>,
    weld: f64,
}

impl Loop {
    /// Share of the size of a loop below which ends of curves are one point unless more is asked for: what the last digits of
    /// numbers given one by one explain.
    pub const WELD: f64 = 1e-6;

    /// The loop of `curves`, in order and sense; one closed curve is a loop, too. Ends at most `weld` (a length) apart are
    /// made one; None stands for [`Self::WELD`] of the size.
    ///
    /// # Errors
    /// [`CuttingError::NoCurve`], [`CuttingError::Gap`].
    pub fn new(curves: Vec<BoundaryCurve>, weld: Option<f64>) -> Result<Self, CuttingError> {
        if curves.is_empty() {
            return Err(CuttingError::NoCurve);
        }
        let ends: Vec<Point> = curves.iter().flat_map(|curve| [curve.start(), curve.point(0.5)]).collect();
        let size = curves.iter().map(BoundaryCurve::size).fold(extent(&ends), f64::max);
        CuttingError::unless_large(size)?;
        let weld = weld.unwrap_or(Self::WELD * size);
        for k in 0..curves.len() {
            let before = &curves[(k + curves.len() - 1) % curves.len()];
            let gap = before.end().distance(curves[k].start());
            if gap.is_nan() || gap > weld {
                return Err(CuttingError::Gap { curve: k, gap, weld });
            }
        }
        Ok(Self { curves, weld })
    }

    /// The closed polygon with the given corners, the first not repeated.
    ///
    /// # Errors
    /// [`CuttingError::Curve`] where two neighbours are the same point or one is not finite, [`CuttingError::NoCurve`].
    pub fn polygon(corners: &[Point]) -> Result<Self, CuttingError> {
        let side = |k: usize| vec![corners[k], corners[(k + 1) % corners.len()]];
        Self::sides((0..corners.len()).map(side).collect())
    }

    /// The loop of Bézier sides given by their control points, in order round, of any degrees.
    ///
    /// # Errors
    /// [`CuttingError::Curve`], [`CuttingError::NoCurve`], [`CuttingError::Gap`].
    pub fn sides(sides: Vec<Vec<Point>>) -> Result<Self, CuttingError> {
        let side = |(curve, points)| {
            let error = |error: CurveError| CuttingError::Curve { curve, error };
            BoundaryCurve::bezier(points).map_err(error)
        };
        Self::new(sides.into_iter().enumerate().map(side).collect::<Result<_, _>>()?, None)
    }

    /// The curves.
    pub fn curves(&self) -> &[BoundaryCurve] {
        &self.curves
    }

    /// The loop moved.
    pub(crate) fn moved(&self, by: Point) -> Self {
        Self { curves: self.curves.iter().map(|curve| curve.moved(by)).collect(), weld: self.weld }
    }

    /// The largest distance of ends that are made one (a length).
    pub fn weld(&self) -> f64 {
        self.weld
    }

    /// The largest distance of two ends that are made one: 0 where all agree digit for digit.
    pub fn welded(&self) -> f64 {
        let count = self.curves.len();
        let gap = |k: usize| self.curves[k].end().distance(self.curves[(k + 1) % count].start());
        (0..count).map(gap).fold(0.0, f64::max)
    }
}
