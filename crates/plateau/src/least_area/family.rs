//! Functions of one variable by their values at nodes.

use std::sync::Arc;

use bases::{Basis, Matrix, Nodal, Stacked};
use solve::solve_general;
use surfaces::Point;

use crate::MethodError;

/// A family of n + 1 functions of one variable that interpolates at its ends, and the cardinal functions of its span at the
/// Gauss–Lobatto points of its interval.
#[derive(Debug, Clone)]
pub(super) struct Family {
    /// The cardinal functions.
    pub(super) nodal: Arc<dyn Basis>,
    /// Their nodes.
    pub(super) nodes: Vec<f64>,
    /// Values at the nodes from coefficients in the family: (n + 1)².
    values: Matrix,
    /// From inner values of a function that vanishes at both ends to its inner coefficients, in two steps: (n − 1)² each.
    inner: [Matrix; 2],
    /// Whether rounding is dropped between the two steps.
    drops: bool,
}

/// Degree from which coefficients of the size of rounding are dropped, and that as a share of the size.
const DROPPED_FROM: usize = 20;
const DROPPED: f64 = 4.0 * f64::EPSILON;

impl Family {
    /// Bernstein polynomials.
    pub(super) fn bernstein(family: &dyn Basis) -> Result<Self, MethodError> {
        let degree = family.count() - 1;
        let nodal = Nodal::new(degree)?;
        Ok(Self {
            nodes: nodal.nodes().to_vec(),
            values: table(family, nodal.nodes()),
            inner: [nodal.inner_lobatto(), nodal.inner_bernstein()],
            nodal: Arc::new(nodal),
            drops: degree >= DROPPED_FROM,
        })
    }

    /// Any family, its cardinal functions by the inverse of its values at the nodes.
    pub(super) fn general(family: &Arc<dyn Basis>) -> Result<Self, MethodError> {
        let count = family.count();
        let (start, end) = family.domain();
        let nodes: Vec<f64> =
            Nodal::new(count - 1)?.nodes().iter().map(|t| start + (end - start) * t).collect();
        let values = table(family.as_ref(), &nodes);
        let cardinal = inverse(&values)?.transpose();
        let inner = Matrix::from_fn(count - 2, count - 2, |i, j| values[(i + 1, j + 1)]);
        Ok(Self {
            nodal: Arc::new(Stacked::new(vec![family.clone()], cardinal)?),
            nodes,
            inner: [inverse(&inner)?, Matrix::identity(count - 2)],
            values,
            drops: false,
        })
    }

    /// The coefficients of the functions that are 1 at one node: (n + 1)².
    pub(super) fn coefficients(&self) -> Result<Matrix, MethodError> {
        inverse(&self.values)
    }

    pub(super) fn count(&self) -> usize {
        self.nodes.len()
    }
}

/// Values at points: points × functions.
pub(super) fn table(family: &dyn Basis, points: &[f64]) -> Matrix {
    let mut table = Matrix::zeros(points.len(), family.count());
    points.iter().enumerate().for_each(|(p, &t)| family.evaluate_into(t, 0, table.row_mut(p)));
    table
}

/// The inverse of a square matrix.
pub(super) fn inverse(matrix: &Matrix) -> Result<Matrix, MethodError> {
    let n = matrix.rows();
    let x = solve_general(n, matrix.as_slice(), n, Matrix::identity(n).as_slice())?.x;
    Ok(Matrix::from_fn(n, n, |i, j| x[i * n + j]))
}

/// `left · net · rightᵀ` for a net of left.cols() × right.cols() points.
pub(super) fn transformed(left: &Matrix, net: &[Point], right: &Matrix) -> Vec<Point> {
    let (columns, width) = (right.cols(), right.rows());
    let sum = |row: &[f64], point: &dyn Fn(usize) -> Point| {
        row.iter().enumerate().fold(Point::ZERO, |sum, (k, &a)| sum + point(k) * a)
    };
    let across: Vec<Point> = (0..left.cols())
        .flat_map(|i| (0..width).map(move |j| (i, j)))
        .map(|(i, j)| sum(right.row(j), &|l| net[i * columns + l]))
        .collect();
    (0..left.rows())
        .flat_map(|i| (0..width).map(move |j| (i, j)))
        .map(|(i, j)| sum(left.row(i), &|k| across[k * width + j]))
        .collect()
}

/// Drops coefficients in functions of rising degree that are rounding of a surface of some size: control points are 2ⁿ times as large.
pub(super) fn without_rounding(coefficients: &mut [Point], size: f64) {
    coefficients.iter_mut().filter(|c| c.norm() <= DROPPED * size).for_each(|c| *c = Point::ZERO);
}

/// The product of what two matrices do to the rows and columns of a net.
pub(super) fn of_nets(left: &Matrix, right: &Matrix) -> Matrix {
    let (rows, columns) = (right.rows(), right.cols());
    Matrix::from_fn(left.rows() * rows, left.cols() * columns, |a, b| {
        left[(a / rows, b / columns)] * right[(a % rows, b % columns)]
    })
}

/// The values at the nodes of `curve`, given by its coefficients.
pub(super) fn curve_nodes(family: &Family, curve: &[Point]) -> Vec<Point> {
    (0..family.count())
        .map(|k| family.values.row(k).iter().zip(curve).fold(Point::ZERO, |sum, (&b, &p)| sum + p * b))
        .collect()
}

/// The inner coefficients of a curve that vanishes at both ends, from its values at the inner nodes.
pub(super) fn inner_curve(family: &Family, values: &[Point]) -> Vec<Point> {
    transformed(
        &family.inner[1],
        &transformed(&family.inner[0], values, &Matrix::identity(1)),
        &Matrix::identity(1),
    )
}

/// The points of a net at the nodes of both families, row by row.
pub(super) fn net_nodes([u, v]: [&Family; 2], net: &[Point]) -> Vec<Point> {
    transformed(&u.values, net, &v.values)
}

/// `base` with its inner points displaced so that the points at the inner nodes are those of `x` instead of `base_nodes`,
/// which agrees with `x` on the border; all of them nets row by row.
pub(super) fn displaced(
    [u, v]: [&Family; 2],
    base: &[Point],
    base_nodes: &[Point],
    x: &[Point],
) -> Vec<Point> {
    let (rows, columns) = (u.count(), v.count());
    let mut net = base.to_vec();
    if rows < 3 || columns < 3 {
        return net;
    }
    let inner = || (1..rows - 1).flat_map(|i| (1..columns - 1).map(move |j| i * columns + j));
    let change: Vec<Point> = inner().map(|k| x[k] - base_nodes[k]).collect();
    let mut between = transformed(&u.inner[0], &change, &v.inner[0]);
    if u.drops || v.drops {
        without_rounding(&mut between, x.iter().chain(base_nodes).map(|p| p.norm()).fold(0.0, f64::max));
    }
    for (k, change) in inner().zip(transformed(&u.inner[1], &between, &v.inner[1])) {
        net[k] += change;
    }
    net
}
