//! Complexes of quadrilateral patches that share edges.

use bases::{Bernstein, Matrix};
use energy::{Cell, ProductCell};
use surfaces::{Complex, Net, Patch, Point, Product, TensorPatch, discrete_coons};

use super::family::{Family, curve_nodes, displaced, inner_curve, net_nodes, of_nets};
use super::space::{Frame, Space, Topology, of_values};
use crate::MethodError;

/// Complexes with the faces, edges and fixed points of one.
pub(super) struct Glued<'a> {
    complex: &'a Complex,
    frame: Frame,
    family: Family,
    topology: Topology,
    start: Vec<Point>,
}

/// Faces at an edge from which on it is a line where films meet.
const JOINT: usize = 3;

impl<'a> Glued<'a> {
    /// The complexes like `complex`, which is the start.
    pub(super) fn new(complex: &'a Complex) -> Result<Self, MethodError> {
        let family = Family::bernstein(&Bernstein::new(complex.degree())?)?;
        let held = complex.points().iter().zip(complex.fixed()).filter(|(_, fixed)| **fixed);
        let frame = Frame::of(held.map(|(&p, _)| p));
        let mut joint = vec![false; complex.points().len()];
        for (number, edge) in complex.edges().iter().enumerate() {
            if edge.uses().len() >= JOINT {
                complex.edge_nodes(number).into_iter().for_each(|node| joint[node] = true);
            }
        }
        let orientation = complex.orientation();
        let topology = Topology {
            cells: complex.faces().iter().map(|face| face.nodes().to_vec()).collect(),
            fixed: complex.fixed().to_vec(),
            skeleton: complex.skeleton(),
            joint,
            flipped: orientation.torn().is_empty().then(|| orientation.flipped().to_vec()),
        };
        let mut space = Self { complex, frame, family, topology, start: Vec::new() };
        space.start = space.nodes(complex)?;
        Ok(space)
    }

    /// The control points, in the frame, of the surface with the points `x` at the nodes.
    fn control(&self, x: &[Point]) -> Result<Vec<Point>, MethodError> {
        let fixed = self.complex.fixed();
        let mut points: Vec<Point> = x.to_vec();
        for (k, &point) in self.complex.points().iter().enumerate().filter(|(k, _)| fixed[*k]) {
            points[k] = self.frame.enter(point);
        }
        self.with_free(points, x)
    }

    /// `points` with what is free of them such that the points at the nodes are `x`.
    fn with_free(&self, mut points: Vec<Point>, x: &[Point]) -> Result<Vec<Point>, MethodError> {
        let degree = self.complex.degree();
        for (number, edge) in self.complex.edges().iter().enumerate().filter(|(_, edge)| !edge.is_fixed()) {
            debug_assert!(!edge.uses().is_empty());
            let nodes = self.complex.edge_nodes(number);
            let (a, b) = (points[nodes[0]], points[nodes[degree]]);
            let straight = |t: f64| a * (1.0 - t) + b * t;
            let bend: Vec<Point> =
                (1..degree).map(|k| x[nodes[k]] - straight(self.family.nodes[k])).collect();
            for (k, change) in inner_curve(&self.family, &bend).into_iter().enumerate() {
                points[nodes[k + 1]] = straight((k + 1) as f64 / degree as f64) + change;
            }
        }
        let both = [&self.family, &self.family];
        for face in self.complex.faces() {
            let of_face = |points: &[Point]| face.nodes().iter().map(|&k| points[k]).collect::<Vec<_>>();
            let base = coons(degree, &of_face(&points))?;
            let net = displaced(both, &base, &net_nodes(both, &base), &of_face(x));
            for (&node, point) in face.nodes().iter().zip(net) {
                if node >= self.topology.skeleton {
                    points[node] = point;
                }
            }
        }
        Ok(points)
    }
}

/// The discrete Coons net of the border of a net of degree (p, p).
fn coons(p: usize, net: &[Point]) -> Result<Vec<Point>, MethodError> {
    let row = |i: usize| (0..=p).map(|j| net[(p + 1) * i + j]).collect::<Vec<_>>();
    let column = |j: usize| (0..=p).map(|i| net[(p + 1) * i + j]).collect::<Vec<_>>();
    Ok(discrete_coons(&row(0), &row(p), &column(0), &column(p))?.points().to_vec())
}

impl Space for Glued<'_> {
    type Surface = Complex;

    fn topology(&self) -> &Topology {
        &self.topology
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn degree(&self) -> usize {
        self.complex.degree()
    }

    fn cell(&self, points: usize) -> Result<Box<dyn Cell>, MethodError> {
        let nodal = self.family.nodal.as_ref();
        Ok(Box::new(ProductCell::new(nodal, nodal, points)?))
    }

    fn at_nodes(&self) -> Result<Box<dyn Cell>, MethodError> {
        let (nodal, nodes) = (self.family.nodal.as_ref(), &self.family.nodes);
        Ok(Box::new(ProductCell::at(nodal, nodal, nodes, nodes)))
    }

    fn nodes(&self, surface: &Complex) -> Result<Vec<Point>, MethodError> {
        let degree = self.complex.degree();
        let control: Vec<Point> = surface.points().iter().map(|&p| self.frame.enter(p)).collect();
        let mut x = control.clone();
        let both = [&self.family, &self.family];
        for face in self.complex.faces() {
            let net: Vec<Point> = face.nodes().iter().map(|&k| control[k]).collect();
            for (&node, point) in face.nodes().iter().zip(net_nodes(both, &net)) {
                x[node] = point;
            }
        }
        // Edges once more, each by itself: two faces at an edge round in different order.
        for number in 0..self.complex.edges().len() {
            let nodes = self.complex.edge_nodes(number);
            let curve: Vec<Point> = nodes.iter().map(|&k| control[k]).collect();
            let at = curve_nodes(&self.family, &curve);
            (1..degree).for_each(|k| x[nodes[k]] = at[k]);
        }
        let vertices = self.complex.vertices();
        x[..vertices].copy_from_slice(&control[..vertices]);
        Ok(x)
    }

    fn surface(&self, x: &[Point]) -> Result<Complex, MethodError> {
        let mut points = self.complex.points().to_vec();
        for ((point, control), fixed) in points.iter_mut().zip(self.control(x)?).zip(self.complex.fixed()) {
            if !fixed {
                *point = self.frame.leave(control);
            }
        }
        Ok(self.complex.with_points(points)?)
    }

    fn coefficients(&self, f: &[f64]) -> Result<Vec<f64>, MethodError> {
        let values: Vec<Point> = f.iter().map(|&f| Point::new(f, 0.0, 0.0)).collect();
        let control = self.with_free(values.clone(), &values)?;
        Ok(of_values(f, |_| control, &self.topology.fixed))
    }

    fn control(&self) -> Result<Option<Matrix>, MethodError> {
        let of_edges = self.family.coefficients()?;
        Ok(Some(of_nets(&of_edges, &of_edges)))
    }

    fn patches(&self, x: &[Point]) -> Result<Vec<Box<dyn Patch>>, MethodError> {
        let product = Product { u: self.family.nodal.clone(), v: self.family.nodal.clone() };
        let count = self.family.count();
        let patch = |k: usize| -> Result<Box<dyn Patch>, MethodError> {
            let net = Net::new(count, count, self.topology.of_cell(k, x))?;
            Ok(Box::new(TensorPatch::new(vec![product.clone()], net)?))
        };
        (0..self.topology.cells.len()).map(patch).collect()
    }

    fn start(&self) -> (Vec<Point>, Option<[f64; 3]>) {
        (self.start.clone(), None)
    }
}
