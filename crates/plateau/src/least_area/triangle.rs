//! Triangular patches.

use std::sync::Arc;

use bases::{Matrix, Nodal};
use energy::{Cell, PiecedCell, Pieces, Quadrilateral, SampledCell};
use surfaces::{Patch, Point, SurfaceError, TriangleBasis, TriangleNet, TrianglePatch};

use super::family::inverse;
use super::space::{Frame, Space, Topology, of_values};
use super::tensor::times;
use crate::{MethodError, memory};

/// Triangular patches over one border.
pub(super) struct Triangular {
    net: TriangleNet,
    frame: Frame,
    basis: TriangleBasis,
    /// Parameters of the nodes: on the border Gauss–Lobatto points, inside their symmetric means (Blyth and Pozrikidis).
    parameters: Vec<[f64; 2]>,
    /// Values at the nodes from the net, and back: (nodes)².
    values: Matrix,
    back: Matrix,
    pieces: Arc<Pieces>,
    start: Vec<Point>,
    topology: Topology,
}

impl Triangular {
    pub(super) fn new(net: &TriangleNet) -> Result<Self, MethodError> {
        let degree = net.degree();
        let basis = TriangleBasis::new(degree).map_err(SurfaceError::from)?;
        let border = net.boundary();
        let frame = Frame::of(border.iter().flatten().copied());
        // Whatever stands inside is moved to the Dirichlet extremal.
        let start: Vec<Point> = net
            .indices()
            .zip(net.points())
            .map(|(index, &p)| if index.contains(&0) { frame.enter(p) } else { Point::ZERO })
            .collect();
        let t = Nodal::new(degree)?.nodes().to_vec();
        let at = |i: usize, j: usize, k: usize| (1.0 + 2.0 * t[i] - t[j] - t[k]) / 3.0;
        let parameters: Vec<[f64; 2]> = net.indices().map(|[i, j, k]| [at(i, j, k), at(j, i, k)]).collect();
        let [values, _, _] = tables(&basis, &parameters);
        let back = inverse(&values)?;
        let pieces = Pieces::new(degree, three_quadrilaterals(), |parameters| {
            let [values, _, _] = tables(&basis, parameters);
            values.times(&back)
        })?;
        let fixed = net.indices().map(|index| index.contains(&0)).collect();
        Ok(Self {
            start: times(&values, &start),
            net: net.clone(),
            frame,
            basis,
            parameters,
            values,
            back,
            pieces: Arc::new(pieces),
            topology: Topology::single(fixed),
        })
    }
}

/// Values and derivatives of the basis: points × functions.
fn tables(basis: &TriangleBasis, parameters: &[[f64; 2]]) -> [Matrix; 3] {
    let count = basis.count();
    let mut tables = [0; 3].map(|_| Matrix::zeros(parameters.len(), count));
    let mut all = vec![0.0; 3 * count];
    for (p, &[u, v]) in parameters.iter().enumerate() {
        basis.evaluate_into(u, v, 1, &mut all);
        for (table, part) in tables.iter_mut().zip(all.chunks_exact(count)) {
            table.row_mut(p).copy_from_slice(part);
        }
    }
    tables
}

/// The quadrilaterals between a corner, the middles of its sides and the centre: the same however the corners are named.
fn three_quadrilaterals() -> Vec<Quadrilateral> {
    let corners = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
    let mean = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let at = |k: usize| {
        let corner = corners[k];
        [corner, mean(corner, corners[(k + 1) % 3]), [1.0 / 3.0; 2], mean(corner, corners[(k + 2) % 3])]
    };
    (0..3).map(at).collect()
}

impl Space for Triangular {
    type Surface = TrianglePatch;

    fn topology(&self) -> &Topology {
        &self.topology
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn degree(&self) -> usize {
        // Each of the three pieces of the rule spans half of every side.
        self.net.degree().div_ceil(2) + 2
    }

    fn cell(&self, points: usize) -> Result<Box<dyn Cell>, MethodError> {
        // What Hessians ask for: three tables of points × nodes.
        memory::holds(3 * size_of::<f64>() * 3 * points * points * self.parameters.len())?;
        Ok(Box::new(PiecedCell::new(self.pieces.clone(), points)?))
    }

    fn at_nodes(&self) -> Result<Box<dyn Cell>, MethodError> {
        let [values, by_u, by_v] = tables(&self.basis, &self.parameters).map(|table| table.times(&self.back));
        let weights = vec![1.0; self.parameters.len()];
        Ok(Box::new(SampledCell::new(self.parameters.clone(), weights, values, [by_u, by_v])?))
    }

    fn nodes(&self, surface: &TrianglePatch) -> Result<Vec<Point>, MethodError> {
        let net: Vec<Point> = surface.net().points().iter().map(|&p| self.frame.enter(p)).collect();
        Ok(times(&self.values, &net))
    }

    fn surface(&self, x: &[Point]) -> Result<TrianglePatch, MethodError> {
        let mut coordinates = self.net.coordinates();
        for (k, point) in times(&self.back, x).into_iter().enumerate() {
            if !self.topology.fixed[k] {
                coordinates[3 * k..3 * k + 3].copy_from_slice(&<[f64; 3]>::from(self.frame.leave(point)));
            }
        }
        Ok(TrianglePatch::new(self.net.with_coordinates(&coordinates)?)?)
    }

    fn coefficients(&self, f: &[f64]) -> Result<Vec<f64>, MethodError> {
        Ok(of_values(f, |x| times(&self.back, x), &self.topology.fixed))
    }

    fn control(&self) -> Result<Option<Matrix>, MethodError> {
        Ok(Some(self.back.clone()))
    }

    fn patches(&self, x: &[Point]) -> Result<Vec<Box<dyn Patch>>, MethodError> {
        let net = TriangleNet::new(self.net.degree(), times(&self.back, x))?;
        Ok(vec![Box::new(TrianglePatch::new(net)?)])
    }

    fn start(&self) -> (Vec<Point>, Option<[f64; 3]>) {
        // The Dirichlet energy over the equilateral triangle: the same however the corners are named.
        let side = 2.0 / 3f64.sqrt();
        (self.start.clone(), Some([side, -0.5 * side, side]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_and_the_nodes_reproduce_a_plane() {
        let point = |i: usize, j: usize| Point::new(i as f64, 2.0 * j as f64, 0.0);
        let net = TriangleNet::new(4, (0..=4).flat_map(|i| (0..=4 - i).map(move |j| point(i, j))).collect())
            .unwrap();
        let space = Triangular::new(&net).unwrap();
        let cell = space.cell(4).unwrap();
        let (parameters, weights) = (cell.parameters(), cell.weights());
        assert!((weights.iter().sum::<f64>() - 0.5).abs() <= 1e-15);
        let moment: f64 = parameters.iter().zip(weights).map(|([u, v], w)| w * u * u * v).sum();
        assert!((moment - 2.0 / 120.0).abs() <= 1e-15, "{moment}");
        let x = space.nodes(&TrianglePatch::new(net.clone()).unwrap()).unwrap();
        let cell = space.cell(6).unwrap();
        let unit = space.frame().unit();
        assert!((cell.area(&cell.tangents(&x)) * unit * unit - 16.0).abs() <= 1e-12);
        for (found, given) in space.surface(&x).unwrap().net().points().iter().zip(net.points()) {
            assert!(found.distance(*given) <= 1e-13, "{found:?} {given:?}");
        }
    }
}
