//! The boundary of a patch: the control points that are given.

mod error;
mod opposite;
mod side;
mod tensor;
mod triangle;

pub use error::{BoundaryError, Gap};
pub use opposite::{Direction, OppositeSides};
pub use tensor::TensorBoundary;
pub use triangle::TriangleBoundary;

use surfaces::{Point, extent};

use crate::Warning;

/// Highest degree of a control net, in each direction, after `raise`.
///
/// Gram matrices of Bernstein-like bases are singular in `f64` long before this degree; the limit
/// keeps the time and memory of a solve bounded, it promises no accuracy.
pub const MAX_DEGREE: usize = 64;

/// Largest admissible |coordinate| of a control point.
///
/// Areas are roots of products of four lengths, curvatures quotients of such products: within the limits all of them are
/// finite, at any degree, and none is lost to underflow.
pub const MAX_COORDINATE: f64 = 1e60;

/// Least admissible size of a boundary: the largest |coordinate| of its control points, unless all are 0.
pub const MIN_SIZE: f64 = 1e-60;

/// A corner: its name and the two sides that begin or (true) end there, by their places among the sides.
pub type Corner = (&'static str, [(usize, bool); 2]);

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

    /// What is to be said of corners that were made one: nothing where they agree digit for digit.
    #[must_use]
    pub fn welding(&self) -> Option<Warning> {
        let (distance, sides): (f64, &[Vec<Point>]) = match self {
            Self::Tensor(boundary) => (boundary.welded(), boundary.sides()),
            Self::Opposite(_) => return None,
            Self::Triangle(boundary) => (boundary.welded(), boundary.sides()),
        };
        let size = extent(&sides.concat());
        (distance > 0.0).then(|| Warning::Welded { distance, share: distance / size })
    }
}
