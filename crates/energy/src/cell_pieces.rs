//! Cells cut into quadrilaterals, on each of which their polynomials are sums of products.

use std::sync::{Arc, OnceLock};

use bases::{Matrix, Nodal};
use surfaces::Point;

use crate::cell::{Cell, Freedom};
use crate::panel::{Left, Right, product};
use crate::{EnergyError, ProductCell, SampledCell};

/// The corners (u, v) of a quadrilateral, one after the other around it.
pub type Quadrilateral = [[f64; 2]; 4];

/// How polynomials of one degree, known by N values at nodes, are sums of products over quadrilaterals: whatever their rules.
#[derive(Debug)]
pub struct Pieces {
    nodal: Nodal,
    corners: Vec<Quadrilateral>,
    nodes: usize,
    /// Values at the nodes of all pieces from those at the nodes of the cell, and the transpose.
    spread: Right,
    collect: Right,
}

/// Coordinates of a point.
const AXES: usize = 3;

impl Pieces {
    /// The pieces with these corners of polynomials of `degree` in u and v together, whose values at any parameters from those at the
    /// nodes are the rows of `values`: parameters × nodes.
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a degree that is not offered.
    pub fn new(
        degree: usize,
        corners: Vec<Quadrilateral>,
        values: impl FnOnce(&[[f64; 2]]) -> Matrix,
    ) -> Result<Self, EnergyError> {
        let nodal = Nodal::new(degree)?;
        let t = nodal.nodes();
        // A polynomial of degree n in u and v is one of degree (n, n) in s and t on a bilinear piece: its values at (n + 1)² nodes
        // determine it exactly.
        let at = |corners: &Quadrilateral| -> Vec<[f64; 2]> {
            let grid = t.iter().flat_map(|&s| t.iter().map(move |&t| [s, t]));
            grid.map(|[s, t]| Bilinear::at(corners, s, t).place).collect()
        };
        let parameters: Vec<[f64; 2]> = corners.iter().flat_map(at).collect();
        let values = values(&parameters);
        Ok(Self {
            nodes: values.cols(),
            spread: Right::of_columns(values.cols(), values.as_slice()),
            collect: Right::of_columns(values.rows(), values.transpose().as_slice()),
            nodal,
            corners,
        })
    }

    /// Nodes of one piece.
    fn each(&self) -> usize {
        self.nodal.nodes().len().pow(2)
    }

    /// Points of `all` by `across`, which is `spread` or `collect`.
    fn transformed(across: &Right, all: &[Point]) -> Vec<Point> {
        let mut left = Left::new(all.len(), AXES);
        for (k, &point) in all.iter().enumerate() {
            left.set_point(k, &<[f64; 3]>::from(point));
        }
        let count = across.columns();
        let mut out = vec![0.0; AXES * count];
        product(&left, across, &mut out);
        (0..count).map(|k| Point::new(out[k], out[count + k], out[2 * count + k])).collect()
    }
}

/// Where a quadrilateral has a point, and its derivatives.
struct Bilinear {
    place: [f64; 2],
    by_s: [f64; 2],
    by_t: [f64; 2],
}

impl Bilinear {
    fn at([a, b, c, d]: &Quadrilateral, s: f64, t: f64) -> Self {
        let each = |of: &dyn Fn(usize) -> f64| [of(0), of(1)];
        Self {
            place: each(&|k| (1.0 - t) * ((1.0 - s) * a[k] + s * b[k]) + t * ((1.0 - s) * d[k] + s * c[k])),
            by_s: each(&|k| (1.0 - t) * (b[k] - a[k]) + t * (c[k] - d[k])),
            by_t: each(&|k| (1.0 - s) * (d[k] - a[k]) + s * (c[k] - b[k])),
        }
    }

    fn determinant(&self) -> f64 {
        self.by_s[0] * self.by_t[1] - self.by_s[1] * self.by_t[0]
    }
}

/// A cell of pieces at a product rule on each of them. Tangents and gradients cost O(q² n) and a transformation of N values; tables of all
/// functions at all points are made once Hessians and forms ask for them.
#[derive(Debug)]
pub struct PiecedCell {
    pieces: Arc<Pieces>,
    product: ProductCell,
    parameters: Vec<[f64; 2]>,
    weights: Vec<f64>,
    /// (s_u, s_v, t_u, t_v) at every point.
    inverse: Vec<[f64; 4]>,
    tables: OnceLock<SampledCell>,
}

impl PiecedCell {
    /// The pieces at the rule of `points`² points on each.
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a rule that is not offered.
    pub fn new(pieces: Arc<Pieces>, points: usize) -> Result<Self, EnergyError> {
        let product = ProductCell::new(&pieces.nodal, &pieces.nodal, points)?;
        let count = pieces.corners.len() * product.weights().len();
        let mut parameters = Vec::with_capacity(count);
        let (mut weights, mut inverse) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for corners in &pieces.corners {
            for ([s, t], w) in product.parameters().into_iter().zip(product.weights()) {
                let map = Bilinear::at(corners, s, t);
                let determinant = map.determinant();
                parameters.push(map.place);
                // The orientation of a piece is of no matter to an area.
                weights.push(w * determinant.abs());
                let ([u_s, v_s], [u_t, v_t]) = (map.by_s, map.by_t);
                // The inverse of ((u_s, u_t), (v_s, v_t)), by Cramer's rule.
                inverse.push([v_t, -u_t, -v_s, u_s].map(|x| x / determinant));
            }
        }
        Ok(Self { pieces, product, parameters, weights, inverse, tables: OnceLock::new() })
    }

    /// Points of the rule on one piece.
    fn of_piece(&self) -> usize {
        self.product.weights().len()
    }

    /// All functions at all points.
    fn tables(&self) -> &SampledCell {
        // Most steps ask for tangents and gradients alone; the tables are the dear part, so they wait for the first Hessian.
        self.tables.get_or_init(|| {
            let (points, nodes) = (self.weights.len(), self.pieces.nodes);
            let mut tables = [0; 3].map(|_| Matrix::zeros(points, nodes));
            let [values, by_u, by_v] = &mut tables;
            let mut unit = vec![Point::ZERO; nodes];
            // Three functions at once, one as each coordinate.
            for first in (0..nodes).step_by(AXES) {
                let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                let chosen = first..(first + AXES).min(nodes);
                chosen.clone().zip(axes).for_each(|(k, axis)| unit[k] = Point::from(axis));
                let place = self.place(&unit);
                for (p, ([u, v], x)) in self.tangents(&unit).into_iter().zip(place).enumerate() {
                    for (table, at) in [(&mut *values, x), (&mut *by_u, u), (&mut *by_v, v)] {
                        let numbers = <[f64; 3]>::from(at);
                        table.row_mut(p)[chosen.clone()].copy_from_slice(&numbers[..chosen.len()]);
                    }
                }
                unit[chosen].fill(Point::ZERO);
            }
            let [values, by_u, by_v] = tables;
            SampledCell::of(self.parameters.clone(), self.weights.clone(), values, [by_u, by_v])
        })
    }

    /// The points of the surface with the points `x` at the nodes.
    fn place(&self, x: &[Point]) -> Vec<Point> {
        let all = Pieces::transformed(&self.pieces.spread, x);
        all.chunks_exact(self.pieces.each()).flat_map(|piece| self.product.place(piece)).collect()
    }
}

impl Cell for PiecedCell {
    fn nodes(&self) -> usize {
        self.pieces.nodes
    }

    fn weights(&self) -> &[f64] {
        &self.weights
    }

    fn parameters(&self) -> Vec<[f64; 2]> {
        self.parameters.clone()
    }

    fn tangents(&self, x: &[Point]) -> Vec<[Point; 2]> {
        // On a piece the surface is known over (s, t): its tangents are turned into those over (u, v) by the chain rule.
        let all = Pieces::transformed(&self.pieces.spread, x);
        let mut tangents: Vec<[Point; 2]> =
            all.chunks_exact(self.pieces.each()).flat_map(|piece| self.product.tangents(piece)).collect();
        for ([x_s, x_t], [s_u, s_v, t_u, t_v]) in tangents.iter_mut().zip(&self.inverse) {
            (*x_s, *x_t) = (*x_s * *s_u + *x_t * *t_u, *x_s * *s_v + *x_t * *t_v);
        }
        tangents
    }

    fn adjoint(&self, pairs: &[[Point; 2]]) -> Vec<Point> {
        // The transpose of what `tangents` does, factor by factor: first the chain rule, then the pieces, then the spread.
        let turned: Vec<[Point; 2]> = pairs
            .iter()
            .zip(&self.inverse)
            .map(|(&[a, b], &[s_u, s_v, t_u, t_v])| [a * s_u + b * s_v, a * t_u + b * t_v])
            .collect();
        let all: Vec<Point> =
            turned.chunks_exact(self.of_piece()).flat_map(|piece| self.product.adjoint(piece)).collect();
        Pieces::transformed(&self.pieces.collect, &all)
    }

    fn stiffness(&self, wanted: &[bool], forms: &[[f64; 3]]) -> Matrix {
        self.tables().stiffness(wanted, forms)
    }

    fn mass(&self, wanted: &[bool], factors: &[f64]) -> Matrix {
        self.tables().mass(wanted, factors)
    }

    fn hessian_into(
        &self,
        freedoms: &[Freedom],
        tangents: &[[Point; 2]],
        hessian: &mut Matrix,
    ) -> Result<(), EnergyError> {
        self.tables().hessian_into(freedoms, tangents, hessian)
    }
}
