use surfaces::Point;
use thiserror::Error;

use super::{MAX_COORDINATE, MAX_DEGREE, MIN_SIZE};

/// Why sides make no boundary.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum BoundaryError {
    /// Too few or too many points on a side.
    #[error("the side {side} has {found} points; give 2 to {}", MAX_DEGREE + 1)]
    Count {
        /// The side.
        side: &'static str,
        /// Points given.
        found: usize,
    },
    /// A coordinate that is not finite or too large.
    #[error(
        "point {index} of the side {side} is not finite, or a coordinate of it is above {MAX_COORDINATE:e}"
    )]
    Coordinate {
        /// The side.
        side: &'static str,
        /// Position of the point, from 0.
        index: usize,
    },
    /// All coordinates are so small that areas leave the range of doubles.
    #[error(
        "the largest coordinate of the boundary is {size:e}; it must be at least {MIN_SIZE:e}, or all must be 0"
    )]
    TooSmall {
        /// The largest |coordinate|.
        size: f64,
    },
    /// Sides of one net with different numbers of points.
    #[error("the sides {} and {} have {} and {} points; they must have as many", sides[0], sides[1], counts[0], counts[1])]
    Lengths {
        /// The two sides.
        sides: [&'static str; 2],
        /// Their numbers of points.
        counts: [usize; 2],
    },
    /// Sides that do not meet in their corners.
    #[error(
        "sides do not meet in {} of the corners; ends within {weld:.1e} are made one, at {} they are {:.3e} apart",
        gaps.len(), gaps[0].corner, gaps[0].distance()
    )]
    Apart {
        /// Where; not empty.
        gaps: Vec<Gap>,
        /// The largest distance of ends that are made one.
        weld: f64,
    },
    /// A degree that is not offered.
    #[error("degree {degree} is not offered; give one from 1 to {MAX_DEGREE}")]
    Degree {
        /// The degree.
        degree: usize,
    },
}

/// A corner in which two sides do not meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// The corner: `P_00`, …, or `A`, `B`, `C`.
    pub corner: &'static str,
    /// The two sides, each by its place among the sides, and whether it should end there.
    pub ends: [(usize, bool); 2],
    /// Their points there.
    pub points: [Point; 2],
}

impl Gap {
    /// How far the points are apart.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.points[0].distance(self.points[1])
    }
}
