//! Quadrature rules, as fine as a surface asks.

use std::collections::BTreeMap;
use std::rc::Rc;

use energy::Cell;
use surfaces::Point;

use super::assembly::Assembly;
use super::space::Space;
use crate::MethodError;

/// The cell of a space at the rules that were asked for.
pub(super) struct Rules<'a, S: Space> {
    pub(super) space: &'a S,
    cells: BTreeMap<usize, Rc<dyn Cell>>,
}

/// Relative change of the area by the finer rule at which a rule is fine enough: steps in all coordinates exploit what a rule
/// misses, so that it must be far below what they are to gain.
const SETTLED: f64 = 1e-13;

/// Points of the first rule beyond the degree.
const FIRST: usize = 4;

/// The rule is not made larger than this times the degree, nor than [`LARGEST`].
const MOST_OF_DEGREE: usize = 8;
const LEAST_LARGEST: usize = 32;
const LARGEST: usize = 160;

/// The area by a rule and a finer one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Settled {
    /// Points of the rule in each direction.
    pub(super) points: usize,
    /// The area by the finer rule.
    pub(super) area: f64,
    /// How far the two are apart.
    pub(super) error: f64,
    /// Whether that is rounding, or nearly.
    pub(super) settled: bool,
}

impl<'a, S: Space> Rules<'a, S> {
    pub(super) fn new(space: &'a S) -> Self {
        Self { space, cells: BTreeMap::new() }
    }

    pub(super) fn first(&self) -> usize {
        self.space.degree() + FIRST
    }

    pub(super) fn largest(&self) -> usize {
        (MOST_OF_DEGREE * self.space.degree()).clamp(LEAST_LARGEST, LARGEST).max(self.first())
    }

    pub(super) fn cell(&mut self, points: usize) -> Result<Rc<dyn Cell>, MethodError> {
        if let Some(cell) = self.cells.get(&points) {
            return Ok(cell.clone());
        }
        let cell: Rc<dyn Cell> = Rc::from(self.space.cell(points)?);
        self.cells.insert(points, cell.clone());
        Ok(cell)
    }

    pub(super) fn finer(points: usize) -> usize {
        points + (points / 2).max(4)
    }

    /// The area by the finer of two rules.
    pub(super) fn fine_area(&mut self, points: usize, x: &[Point]) -> Result<f64, MethodError> {
        let cell = self.cell(Self::finer(points))?;
        Ok(Assembly { topology: self.space.topology(), cell: cell.as_ref() }.area(x))
    }

    /// The area by a rule and by the finer one.
    pub(super) fn compare(&mut self, points: usize, x: &[Point]) -> Result<Settled, MethodError> {
        let cell = self.cell(points)?;
        let coarse = Assembly { topology: self.space.topology(), cell: cell.as_ref() }.area(x);
        let area = self.fine_area(points, x)?;
        let error = (coarse - area).abs();
        Ok(Settled { points, area, error, settled: error <= SETTLED * area })
    }

    /// The smallest rule from `points` on by which the area of a surface has settled; the largest if none.
    pub(super) fn settle(&mut self, mut points: usize, x: &[Point]) -> Result<Settled, MethodError> {
        loop {
            let compared = self.compare(points, x)?;
            if compared.settled || points >= self.largest() {
                return Ok(compared);
            }
            points = (points + (points / 4).max(2)).min(self.largest());
        }
    }
}
