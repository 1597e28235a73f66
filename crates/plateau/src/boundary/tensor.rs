use surfaces::{Net, Point, SurfaceError};

use super::BoundaryError;
use super::Corner;
use super::side::{as_many, check, weld};

/// All four sides of a tensor net of degree (m, n), which meet in their corners.
///
/// ```
/// use plateau::TensorBoundary;
/// use surfaces::Point;
/// let line = |a: [f64; 3], b: [f64; 3]| vec![Point::from(a), Point::from(b)];
/// // sin(2π) · 2 is no zero, but as good as one.
/// let [a, b, c, d] = [[0., 0., 0.], [2., -4.9e-16, 0.], [0., 1., 0.], [2., 1., 1.]];
/// let frame = TensorBoundary::new(line(a, b), line(c, d), line(a, c), line([2., 0., 0.], d))?;
/// assert_eq!((frame.degrees(), frame.welded()), ((1, 1), 4.9e-16));
/// # Ok::<(), plateau::BoundaryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TensorBoundary {
    sides: [Vec<Point>; 4],
    welded: f64,
}

impl TensorBoundary {
    /// The sides by their names, in order.
    pub const NAMES: [&'static str; 4] = ["u0", "u1", "v0", "v1"];

    /// The corners by their names, each with the two sides that begin or (true) end there.
    pub const CORNERS: [Corner; 4] = [
        ("P_00", [(0, false), (2, false)]),
        ("P_0n", [(0, true), (3, false)]),
        ("P_m0", [(1, false), (2, true)]),
        ("P_mn", [(1, true), (3, true)]),
    ];

    /// The boundary with rows `P_{0,j}` (`u0`) and `P_{m,j}` (`u1`) of n + 1 points, columns `P_{i,0}` (`v0`) and `P_{i,n}`
    /// (`v1`) of m + 1 points; m, n from 1 to [`MAX_DEGREE`](crate::MAX_DEGREE). Corners stand in two sides; points of theirs
    /// at most [`Loop::WELD`](crate::Loop::WELD) of the size apart are made one, halfway.
    ///
    /// # Errors
    /// [`BoundaryError`].
    pub fn new(
        u0: Vec<Point>,
        u1: Vec<Point>,
        v0: Vec<Point>,
        v1: Vec<Point>,
    ) -> Result<Self, BoundaryError> {
        let mut sides = [u0, u1, v0, v1];
        check(&Self::NAMES, &sides)?;
        as_many(["u0", "u1"], [&sides[0], &sides[1]])?;
        as_many(["v0", "v1"], [&sides[2], &sides[3]])?;
        let welded = weld(&mut sides, &Self::CORNERS)?;
        Ok(Self { sides, welded })
    }

    /// The sides `u0`, `u1`, `v0`, `v1`.
    #[must_use]
    pub fn sides(&self) -> &[Vec<Point>; 4] {
        &self.sides
    }

    /// The same, to be moved.
    pub(super) fn sides_mut(&mut self) -> &mut [Vec<Point>; 4] {
        &mut self.sides
    }

    /// The degrees (m, n).
    #[must_use]
    pub fn degrees(&self) -> (usize, usize) {
        (self.sides[2].len() - 1, self.sides[0].len() - 1)
    }

    /// The largest distance of two corners that were made one (a length).
    #[must_use]
    pub fn welded(&self) -> f64 {
        self.welded
    }

    /// The net with this border, its interior free.
    pub(crate) fn net(&self) -> Result<Net, SurfaceError> {
        let [u0, u1, v0, v1] = &self.sides;
        Net::from_boundary(u0, u1, v0, v1)
    }
}
