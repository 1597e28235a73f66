//! Tensor patches of high degree: the Coons patch of a border, displaced inside by polynomials of lower degrees.

use std::sync::Arc;

use bases::{Basis, Bernstein, Matrix, Nodal, Stacked};
use energy::{Cell, ProductCell};
use surfaces::{Net, Patch, Point, TensorPatch};

use super::family::{table, transformed, without_rounding};
use super::space::{Frame, Space, Topology};
use super::tensor::{coons, inside, with_inner};
use crate::MethodError;

/// Bernstein–Bézier patches over one border that are its Coons patch and a displacement of the given degrees, at most those of the net. They are
/// nets of the degrees of the border, and known by their displacements at the inner Gauss–Lobatto points of the lower degrees: as many
/// unknowns as these have, and control points no further away than theirs, since raising takes means.
///
/// Of a cell the leading functions of each direction are cardinal at these points, and the others are those of the Coons patch; its nodes are all
/// their products. Free are those of the leading ones alone, fixed those of the others, at which stands the Coons patch; mixed ones are 0.
pub(super) struct Displaced {
    patch: TensorPatch,
    frame: Frame,
    u: Direction,
    v: Direction,
    /// The net of the Coons patch.
    base: Vec<Point>,
    topology: Topology,
    /// The Coons patch without a displacement, at the nodes.
    undisplaced: Vec<Point>,
}

/// The functions of one variable.
struct Direction {
    /// The functions that are cardinal at the inner nodes of the displacement and vanish at the ends; then the cardinal ones of the border's degree.
    functions: Arc<dyn Basis>,
    /// The points where each of them is 1.
    nodes: Vec<f64>,
    /// How many of them displace.
    inner: usize,
    /// Values of the Bernstein polynomials of the border's degree m: inner nodes × (m + 1), and nodes of the border × (m + 1).
    values: [Matrix; 2],
    /// From the displacement at the inner nodes to its coefficients in functions of rising degree, and from these to inner control points of
    /// degree m: inner × inner, (m − 1) × inner.
    coefficients: [Matrix; 2],
}

impl Direction {
    fn new(degree: usize, displacement: usize) -> Result<Self, MethodError> {
        let (of_border, of_inner) = (Nodal::new(degree)?, Nodal::new(displacement)?);
        let bernstein = Bernstein::new(degree)?;
        let inner = displacement - 1;
        let inner_nodes = &of_inner.nodes()[1..displacement];
        let nodes: Vec<f64> = inner_nodes.iter().chain(of_border.nodes()).copied().collect();
        // All functions of both but those of the displacement that do not vanish at the ends.
        let taken = |k: usize| if k < inner { k + 1 } else { k + 2 };
        let map = Matrix::from_fn(nodes.len(), nodes.len() + 2, |i, j| f64::from(u8::from(taken(i) == j)));
        let values = [inner_nodes, of_border.nodes()].map(|nodes| table(&bernstein, nodes));
        let bernstein_inner = of_border.inner_bernstein();
        let raised = Matrix::from_fn(degree - 1, inner, |i, j| bernstein_inner[(i, j)]);
        let coefficients = [of_inner.inner_lobatto(), raised];
        let functions = Arc::new(Stacked::new(vec![Arc::new(of_inner), Arc::new(of_border)], map)?);
        Ok(Self { functions, nodes, inner, values, coefficients })
    }
}

impl Displaced {
    /// The patches over the border of `patch` with displacements of the degrees `(m, n)`, at least 1, at most those of the net.
    pub(super) fn new(patch: &TensorPatch, (m, n): (usize, usize)) -> Result<Self, MethodError> {
        let (frame, net) = coons(patch)?;
        let degrees = net.degrees();
        let (u, v) = (Direction::new(degrees.0, m)?, Direction::new(degrees.1, n)?);
        let columns = v.nodes.len();
        let fixed = (0..u.nodes.len() * columns).map(|k| k / columns >= u.inner || k % columns >= v.inner);
        let fixed: Vec<bool> = fixed.collect();
        let mut undisplaced = vec![Point::ZERO; fixed.len()];
        let of_border = transformed(&u.values[1], net.points(), &v.values[1]);
        for (k, point) in of_border.into_iter().enumerate() {
            let (i, j) = (k / (degrees.1 + 1), k % (degrees.1 + 1));
            undisplaced[(u.inner + i) * columns + v.inner + j] = point;
        }
        let base = net.points().to_vec();
        let topology = Topology::single(fixed);
        Ok(Self { patch: patch.clone(), frame, u, v, base, topology, undisplaced })
    }

    /// The share of the size of the border by which rounding of its control points moves a surface, about.
    pub(super) fn rounding(&self, surface: &TensorPatch) -> f64 {
        // In the frame that size is about 1.
        let reach = surface.net().points().iter().map(|&p| self.frame.enter(p).norm()).fold(0.0, f64::max);
        f64::EPSILON * reach
    }

    /// The inner control points of a displacement, row by row, from its values at all nodes.
    fn inner_net(&self, x: &[Point], size: f64) -> Vec<Point> {
        let free = x.iter().zip(&self.topology.fixed).filter(|(_, fixed)| !**fixed);
        let values: Vec<Point> = free.map(|(&x, _)| x).collect();
        let mut between = transformed(&self.u.coefficients[0], &values, &self.v.coefficients[0]);
        without_rounding(&mut between, size);
        transformed(&self.u.coefficients[1], &between, &self.v.coefficients[1])
    }

    /// The net of a surface, in the frame.
    fn net(&self, x: &[Point]) -> Result<Net, MethodError> {
        let net = self.patch.net();
        let size = self.base.iter().chain(x).map(|p| p.norm()).fold(0.0, f64::max);
        let mut points = self.base.clone();
        let free = points.iter_mut().zip(inside(net)).filter(|(_, inside)| *inside);
        free.zip(self.inner_net(x, size)).for_each(|((point, _), change)| *point += change);
        Ok(Net::new(net.rows(), net.cols(), points)?)
    }
}

impl Space for Displaced {
    type Surface = TensorPatch;

    fn topology(&self) -> &Topology {
        &self.topology
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn degree(&self) -> usize {
        let (m, n) = self.patch.net().degrees();
        m.max(n)
    }

    fn cell(&self, points: usize) -> Result<Box<dyn Cell>, MethodError> {
        Ok(Box::new(ProductCell::new(self.u.functions.as_ref(), self.v.functions.as_ref(), points)?))
    }

    fn at_nodes(&self) -> Result<Box<dyn Cell>, MethodError> {
        let (u, v) = (&self.u, &self.v);
        Ok(Box::new(ProductCell::at(u.functions.as_ref(), v.functions.as_ref(), &u.nodes, &v.nodes)))
    }

    fn nodes(&self, surface: &TensorPatch) -> Result<Vec<Point>, MethodError> {
        let net = surface.net().points().iter().zip(&self.base);
        let displacement: Vec<Point> = net.map(|(&p, &base)| self.frame.enter(p) - base).collect();
        let mut values = transformed(&self.u.values[0], &displacement, &self.v.values[0]).into_iter();
        let fixed = self.topology.fixed.iter().zip(&self.undisplaced);
        Ok(fixed.map(|(fixed, &x)| if *fixed { x } else { values.next().unwrap_or(x) }).collect())
    }

    fn surface(&self, x: &[Point]) -> Result<TensorPatch, MethodError> {
        with_inner(&self.patch, &self.frame, self.net(x)?.points())
    }

    fn coefficients(&self, f: &[f64]) -> Result<Vec<f64>, MethodError> {
        let x: Vec<Point> = f.iter().map(|&f| Point::new(f, 0.0, 0.0)).collect();
        let mut inner = self.inner_net(&x, 0.0).into_iter();
        let of = |inside: bool| if inside { inner.next().map_or(0.0, |p| p.x) } else { 0.0 };
        Ok(inside(self.patch.net()).into_iter().map(of).collect())
    }

    fn control(&self) -> Result<Option<Matrix>, MethodError> {
        Ok(None)
    }

    fn patches(&self, x: &[Point]) -> Result<Vec<Box<dyn Patch>>, MethodError> {
        Ok(vec![Box::new(TensorPatch::bernstein(self.net(x)?)?)])
    }

    fn start(&self) -> (Vec<Point>, Option<[f64; 3]>) {
        (self.undisplaced.clone(), None)
    }
}
