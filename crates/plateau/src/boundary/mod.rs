//! The boundary of a patch: the control points that are given.

mod corner;
mod error;
mod limits;
mod opposite;
mod side;
mod tensor;
mod triangle;

pub use corner::Corner;
pub use error::{BoundaryError, Gap};
pub use limits::{MAX_COORDINATE, MAX_DEGREE, MIN_SIZE};
pub use opposite::{Direction, OppositeSides};
pub use tensor::TensorBoundary;
pub use triangle::TriangleBoundary;

use surfaces::{Point, anchor, extent};

use crate::Warning;

/// The fixed control points of a net.
#[derive(Clone, Debug, PartialEq)]
pub enum Boundary {
    /// All four sides of a tensor net.
    Tensor(TensorBoundary),
    /// Two opposite sides of a tensor net, for harmonic nets.
    Opposite(OppositeSides),
    /// All three sides of a triangular net.
    Triangle(TriangleBoundary),
}

impl Boundary {
    /// Degrees (m, n) of a tensor net, or (n, n) of a triangular one, before it is raised.
    #[must_use]
    pub fn degrees(&self) -> (usize, usize) {
        match self {
            Self::Tensor(sides) => sides.degrees(),
            Self::Opposite(sides) => sides.degrees(),
            Self::Triangle(sides) => (sides.degree(), sides.degree()),
        }
    }

    /// How many sides there are, in words.
    pub(crate) fn sides(&self) -> &'static str {
        match self {
            Self::Tensor(_) => "four",
            Self::Opposite(_) => "two opposite ones",
            Self::Triangle(_) => "three",
        }
    }

    /// All control points given, side by side.
    fn points(&self) -> Vec<Point> {
        let sides: &[Vec<Point>] = match self {
            Self::Tensor(boundary) => boundary.sides(),
            Self::Opposite(boundary) => boundary.sides(),
            Self::Triangle(boundary) => boundary.sides(),
        };
        sides.concat()
    }

    /// The boundary relative to a point of its own, and that point: nothing of it is rounded ([`anchor`]).
    pub(crate) fn anchored(&self) -> (Self, Point) {
        let origin = anchor(&self.points());
        let mut near = self.clone();
        let sides: &mut [Vec<Point>] = match &mut near {
            Self::Tensor(boundary) => boundary.sides_mut(),
            Self::Opposite(boundary) => boundary.sides_mut(),
            Self::Triangle(boundary) => boundary.sides_mut(),
        };
        sides.iter_mut().flatten().for_each(|p| *p = *p - origin);
        (near, origin)
    }

    /// What is to be said of corners that were made one: nothing where they agree digit for digit.
    #[must_use]
    pub fn welding(&self) -> Option<Warning> {
        let distance = match self {
            Self::Tensor(boundary) => boundary.welded(),
            Self::Opposite(_) => return None,
            Self::Triangle(boundary) => boundary.welded(),
        };
        let size = extent(&self.points());
        (distance > 0.0).then(|| Warning::Welded { distance, share: distance / size })
    }
}
