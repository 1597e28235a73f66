//! Surfaces known by their points at nodes.

use bases::Matrix;
use energy::Cell;
use surfaces::{Patch, Point};

use crate::MethodError;

/// Surfaces of one kind over one border, known by their points at the nodes of cells that are all alike.
///
/// In nodes the condition of the Hessian grows slowly with the degree, where in control points it grows like 4ⁿ.
pub(super) trait Space {
    /// What the surfaces are outside of this module.
    type Surface;

    /// Which node belongs to which cell.
    fn topology(&self) -> &Topology;

    /// The coordinates in which the nodes are given.
    fn frame(&self) -> &Frame;

    /// The degree that decides how fine a rule must be.
    fn degree(&self) -> usize;

    /// The cell at the rule of `points` points in each direction.
    fn cell(&self, points: usize) -> Result<Box<dyn Cell>, MethodError>;

    /// The cell at its own nodes, all weights 1.
    fn at_nodes(&self) -> Result<Box<dyn Cell>, MethodError>;

    /// The points of a surface at the nodes.
    fn nodes(&self, surface: &Self::Surface) -> Result<Vec<Point>, MethodError>;

    /// The surface with these points at the nodes; its border is as given, to the last bit.
    fn surface(&self, x: &[Point]) -> Result<Self::Surface, MethodError>;

    /// The function with the values `f` at the nodes, 0 at fixed ones, in the functions of the surface: one coefficient a
    /// control point.
    fn coefficients(&self, f: &[f64]) -> Result<Vec<f64>, MethodError>;

    /// The matrix from the points of a cell at its nodes to its control points: (nodes)². None where control points are not asked to be
    /// near.
    fn control(&self) -> Result<Option<Matrix>, MethodError>;

    /// The cells as patches, with the points `x` at the nodes.
    fn patches(&self, x: &[Point]) -> Result<Vec<Box<dyn Patch>>, MethodError>;

    /// The points at the nodes from which to start, and whether they are to be moved to the Dirichlet extremal first: that
    /// of the form with these coefficients (a, b, c) of `a ∂uψ ∂uψ + b (∂uψ ∂vψ + ∂vψ ∂uψ) + c ∂vψ ∂vψ`.
    fn start(&self) -> (Vec<Point>, Option<[f64; 3]>);
}

/// Which node of a surface is which of its cells.
#[derive(Debug, Clone)]
pub(super) struct Topology {
    /// For every cell the node of each of its own.
    pub(super) cells: Vec<Vec<usize>>,
    /// For every node whether it stays.
    pub(super) fixed: Vec<bool>,
    /// The leading nodes may belong to several cells, all others to one.
    pub(super) skeleton: usize,
    /// For every node whether it lies on a line where three or more cells meet: there is no normal.
    pub(super) joint: Vec<bool>,
    /// For every cell whether its normal is to be turned round to agree with those of its neighbours; none if no choice of sides agrees.
    pub(super) flipped: Option<Vec<bool>>,
}

impl Topology {
    /// A single cell whose nodes are numbered as its own.
    pub(super) fn single(fixed: Vec<bool>) -> Self {
        let count = fixed.len();
        Self {
            cells: vec![(0..count).collect()],
            skeleton: 0,
            joint: vec![false; count],
            flipped: Some(vec![false]),
            fixed,
        }
    }

    /// The same with the nodes on lines where three or more cells meet held.
    pub(super) fn with_joints_held(&self) -> Self {
        let fixed = self.fixed.iter().zip(&self.joint).map(|(fixed, joint)| *fixed || *joint).collect();
        Self { fixed, ..self.clone() }
    }

    /// For every node the side of the first cell it belongs to: 1, or −1 where that is turned round.
    pub(super) fn sides(&self) -> Vec<f64> {
        let mut sides = vec![1.0; self.fixed.len()];
        let flipped = |cell: usize| self.flipped.as_ref().is_some_and(|flipped| flipped[cell]);
        for (k, cell) in self.cells.iter().enumerate().rev() {
            cell.iter().for_each(|&node| sides[node] = if flipped(k) { -1.0 } else { 1.0 });
        }
        sides
    }

    /// The points of a cell.
    pub(super) fn of_cell(&self, cell: usize, x: &[Point]) -> Vec<Point> {
        self.cells[cell].iter().map(|&node| x[node]).collect()
    }

    /// Adds what a cell gives to the nodes; fixed ones take nothing.
    pub(super) fn add(&self, cell: usize, parts: &[Point], sums: &mut [Point]) {
        for (&node, &part) in self.cells[cell].iter().zip(parts) {
            if !self.fixed[node] {
                sums[node] += part;
            }
        }
    }

    /// For every node of a cell whether it may move.
    pub(super) fn free(&self, cell: usize) -> Vec<bool> {
        self.cells[cell].iter().map(|&node| !self.fixed[node]).collect()
    }
}

/// The coefficients of the function with the values `f` at the nodes, by what `convert` does to points; 0 at fixed ones.
pub(super) fn of_values(f: &[f64], convert: impl FnOnce(&[Point]) -> Vec<Point>, fixed: &[bool]) -> Vec<f64> {
    let values: Vec<Point> = f.iter().map(|&f| Point::new(f, 0.0, 0.0)).collect();
    convert(&values).iter().zip(fixed).map(|(p, fixed)| if *fixed { 0.0 } else { p.x }).collect()
}

/// Coordinates in which the border begins at the origin and is about 1 in size: what is computed in them does not depend on
/// where the border lies, nor on its unit beyond rounding.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    origin: Point,
    /// A power of two.
    unit: f64,
}

impl Frame {
    /// The frame of the given points of a border.
    pub(super) fn of(border: impl Iterator<Item = Point> + Clone) -> Self {
        // A point of the border itself: coordinates near it lose nothing by the difference.
        let origin = border.clone().next().unwrap_or(Point::ZERO);
        let size = border.map(|p| p.distance(origin)).fold(0.0, f64::max);
        // A power of two rounds nothing; `libm` gives the same bits on every machine.
        let unit =
            if size > 0.0 && size.is_finite() { libm::exp2(libm::floor(libm::log2(size))) } else { 1.0 };
        Self { origin, unit }
    }

    pub(super) fn enter(&self, point: Point) -> Point {
        (point - self.origin) * (1.0 / self.unit)
    }

    pub(super) fn leave(&self, point: Point) -> Point {
        point * self.unit + self.origin
    }

    /// The unit of length of the frame, in that of the border.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }
}
