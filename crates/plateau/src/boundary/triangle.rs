use surfaces::{Point, SurfaceError, TriangleNet};

use super::BoundaryError;
use super::Corner;
use super::side::{as_many, check, weld};

/// All three sides of a triangular net of degree n, which meet in their corners A = `P_{n,0,0}`, B = `P_{0,n,0}`,
/// C = `P_{0,0,n}`.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleBoundary {
    sides: [Vec<Point>; 3],
    welded: f64,
}

impl TriangleBoundary {
    /// The sides by their names, in order.
    pub const NAMES: [&'static str; 3] = ["ab", "bc", "ca"];

    /// The corners by their names, each with the two sides that begin or (true) end there.
    pub const CORNERS: [Corner; 3] =
        [("A", [(0, false), (2, true)]), ("B", [(0, true), (1, false)]), ("C", [(1, true), (2, false)])];

    /// The boundary with the sides from A to B, from B to C and from C to A, n + 1 points each; n from 1 to
    /// [`MAX_DEGREE`](crate::MAX_DEGREE). Corners stand in two sides; points of theirs at most
    /// [`Loop::WELD`](crate::Loop::WELD) of the size apart are made one, halfway.
    ///
    /// # Errors
    /// [`BoundaryError`].
    pub fn new(ab: Vec<Point>, bc: Vec<Point>, ca: Vec<Point>) -> Result<Self, BoundaryError> {
        let mut sides = [ab, bc, ca];
        check(&Self::NAMES, &sides)?;
        as_many(["ab", "bc"], [&sides[0], &sides[1]])?;
        as_many(["ab", "ca"], [&sides[0], &sides[2]])?;
        let welded = weld(&mut sides, &Self::CORNERS)?;
        Ok(Self { sides, welded })
    }

    /// The sides `ab`, `bc`, `ca`.
    #[must_use]
    pub fn sides(&self) -> &[Vec<Point>; 3] {
        &self.sides
    }

    /// The same, to be moved.
    pub(super) fn sides_mut(&mut self) -> &mut [Vec<Point>; 3] {
        &mut self.sides
    }

    /// The degree n.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.sides[0].len() - 1
    }

    /// The largest distance of two corners that were made one (a length).
    #[must_use]
    pub fn welded(&self) -> f64 {
        self.welded
    }

    /// The net with this border, its interior free.
    pub(crate) fn net(&self) -> Result<TriangleNet, SurfaceError> {
        let [ab, bc, ca] = &self.sides;
        TriangleNet::from_boundary(ab, bc, ca)
    }
}
