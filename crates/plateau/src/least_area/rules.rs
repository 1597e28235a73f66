//! Quadrature rules, as fine as a surface asks.

use std::collections::BTreeMap;
use std::rc::Rc;

use energy::Cell;
use surfaces::Point;

use super::assembly::{Assembly, Tangents};
use super::space::Space;
use crate::MethodError;

/// The cell of a space at the rules that were asked for.
pub(super) struct Rules<'a, S: Space> {
    pub(super) space: &'a S,
    cells: BTreeMap<usize, Rc<dyn Cell>>,
    settled: f64,
}

/// Relative change of the area by the finer rule at which a rule is fine enough, as a share of the tolerance: steps in all
/// coordinates exploit what a rule misses, so that it must be far below what they are to gain.
const SETTLED: f64 = 1e-3;
const ROUNDING: f64 = 1e-13;

/// Points of the first rule beyond the degree.
const FIRST: usize = 4;

/// The rule is not made larger than this times the degree, nor than [`LARGEST`].
const MOST_OF_DEGREE: usize = 20;
const LEAST_LARGEST: usize = 64;
const LARGEST: usize = 160;

/// What a finer rule says of a surface.
#[derive(Debug, Clone)]
pub(super) struct Fine {
    /// The tangents at its points.
    pub(super) tangents: Tangents,
    pub(super) area: f64,
    /// The least over the mean of the area density there.
    pub(super) evenness: f64,
}

/// A surface at a rule and a finer one. The finer one gives its area and its gradient: by any two rules that are fine enough
/// these are the same to rounding, so that it plays no part which of them was chosen where a surface lies between.
#[derive(Debug, Clone)]
pub(super) struct Known {
    /// Its points at the nodes.
    pub(super) x: Vec<Point>,
    /// Points of the coarser rule in each direction.
    pub(super) points: usize,
    /// What the finer rule says.
    pub(super) fine: Fine,
    /// How far the areas by the two are apart.
    pub(super) error: f64,
    /// Whether that is rounding, or nearly.
    pub(super) settled: bool,
}

impl Known {
    pub(super) fn area(&self) -> f64 {
        self.fine.area
    }
}

impl<'a, S: Space> Rules<'a, S> {
    /// Rules for steps that gain no less than `tolerance`.
    pub(super) fn new(space: &'a S, tolerance: f64) -> Self {
        Self { space, cells: BTreeMap::new(), settled: (SETTLED * tolerance).max(ROUNDING) }
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

    /// The rule tried after one that is not fine enough.
    pub(super) fn next(points: usize) -> usize {
        points + (points / 4).max(2)
    }

    pub(super) fn finer(points: usize) -> usize {
        points + (points / 2).max(4)
    }

    /// What the finer of two rules says.
    pub(super) fn fine(&mut self, points: usize, x: &[Point]) -> Result<Fine, MethodError> {
        let cell = self.fine_cell(points)?;
        let assembly = Assembly { topology: self.space.topology(), cell: cell.as_ref() };
        let tangents = assembly.tangents(x);
        let (area, evenness) = assembly.measure(&tangents);
        Ok(Fine { tangents, area, evenness })
    }

    /// Points of the rule by which the evenness of surfaces of a rule is compared: the same for rules that are nearly as fine.
    pub(super) fn of_evenness(points: usize) -> usize {
        Self::finer(points).next_power_of_two()
    }

    /// The least over the mean of the area density at the points of a rule.
    pub(super) fn evenness(&mut self, points: usize, x: &[Point]) -> Result<f64, MethodError> {
        let cell = self.cell(points)?;
        let assembly = Assembly { topology: self.space.topology(), cell: cell.as_ref() };
        Ok(assembly.measure(&assembly.tangents(x)).1)
    }

    /// The finer of two rules: that of areas and gradients.
    pub(super) fn fine_cell(&mut self, points: usize) -> Result<Rc<dyn Cell>, MethodError> {
        self.cell(Self::finer(points))
    }

    /// A surface at a rule, of which the finer rule has said this.
    pub(super) fn known(&mut self, points: usize, x: Vec<Point>, fine: Fine) -> Result<Known, MethodError> {
        let cell = self.cell(points)?;
        let assembly = Assembly { topology: self.space.topology(), cell: cell.as_ref() };
        let error = (assembly.area_of(&assembly.tangents(&x)) - fine.area).abs();
        let settled = error <= self.settled * fine.area;
        Ok(Known { x, points, fine, error, settled })
    }

    /// A surface at a rule.
    pub(super) fn at(&mut self, points: usize, x: Vec<Point>) -> Result<Known, MethodError> {
        let fine = self.fine(points, &x)?;
        self.known(points, x, fine)
    }

    /// The surface at the smallest rule from its own on by which its area has settled; at the largest if there is none.
    pub(super) fn settle(&mut self, mut known: Known) -> Result<Known, MethodError> {
        while !known.settled && known.points < self.largest() {
            let points = Self::next(known.points).min(self.largest());
            known = self.at(points, known.x)?;
        }
        Ok(known)
    }

    /// The surface at the smallest rule by which its area has settled.
    pub(super) fn settled(&mut self, x: Vec<Point>) -> Result<Known, MethodError> {
        let known = self.at(self.first(), x)?;
        self.settle(known)
    }
}
