use surfaces::Point;

use super::side::{as_many, check};
use super::{BoundaryError, MAX_DEGREE};

/// Which two sides of a tensor net are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The rows i = 0 and i = m, `u0` and `u1`.
    Rows,
    /// The columns j = 0 and j = n, `v0` and `v1`.
    Columns,
}

/// Two opposite sides of a tensor net, and its degree in the direction between them.
#[derive(Clone, Debug, PartialEq)]
pub struct OppositeSides {
    direction: Direction,
    sides: [Vec<Point>; 2],
    degree: usize,
}

impl OppositeSides {
    /// The rows `P_{0,j}` and `P_{m,j}` of a net of degree m = `degree` in u, n + 1 points each; m, n from 1 to
    /// [`MAX_DEGREE`].
    ///
    /// # Errors
    /// [`BoundaryError`].
    pub fn rows(u0: Vec<Point>, u1: Vec<Point>, degree: usize) -> Result<Self, BoundaryError> {
        Self::new(Direction::Rows, [u0, u1], degree)
    }

    /// The columns `P_{i,0}` and `P_{i,n}` of a net of degree n = `degree` in v, m + 1 points each.
    ///
    /// # Errors
    /// [`BoundaryError`].
    pub fn columns(v0: Vec<Point>, v1: Vec<Point>, degree: usize) -> Result<Self, BoundaryError> {
        Self::new(Direction::Columns, [v0, v1], degree)
    }

    fn new(direction: Direction, sides: [Vec<Point>; 2], degree: usize) -> Result<Self, BoundaryError> {
        let names = direction.names();
        check(&names, &sides)?;
        as_many(names, [&sides[0], &sides[1]])?;
        if !(1..=MAX_DEGREE).contains(&degree) {
            return Err(BoundaryError::Degree { degree });
        }
        Ok(Self { direction, sides, degree })
    }

    /// Which sides these are.
    #[must_use]
    pub fn direction(&self) -> Direction {
        self.direction
    }

    /// The two sides, that of parameter 0 first.
    #[must_use]
    pub fn sides(&self) -> &[Vec<Point>; 2] {
        &self.sides
    }

    /// The same, to be moved.
    pub(super) fn sides_mut(&mut self) -> &mut [Vec<Point>; 2] {
        &mut self.sides
    }

    /// The degrees (m, n).
    #[must_use]
    pub fn degrees(&self) -> (usize, usize) {
        let along = self.sides[0].len() - 1;
        match self.direction {
            Direction::Rows => (self.degree, along),
            Direction::Columns => (along, self.degree),
        }
    }
}

impl Direction {
    /// The names of the two sides.
    #[must_use]
    pub fn names(self) -> [&'static str; 2] {
        match self {
            Self::Rows => ["u0", "u1"],
            Self::Columns => ["v0", "v1"],
        }
    }
}
