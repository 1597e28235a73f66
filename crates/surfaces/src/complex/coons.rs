//! The start: harmonic vertices, straight edges, Coons patches.

use std::collections::HashMap;

use super::{Complex, ComplexError, Side, Vertex};
use crate::Point;
use crate::conjugate_gradients::conjugate_gradients;

impl Complex {
    /// Places all free points, see [`Complex::new`].
    pub(super) fn start(&mut self, vertices: &[Vertex]) -> Result<(), ComplexError> {
        let placed: Vec<bool> = vertices
            .iter()
            .map(|vertex| match vertex {
                Vertex::Fixed(_) | Vertex::Free(Some(_)) => true,
                Vertex::Free(None) => false,
            })
            .collect();
        let neighbours = self.neighbours();
        self.check_held(&neighbours)?;
        self.place_vertices(&neighbours, &placed);
        for edge in 0..self.layout.edges.len() {
            if !self.layout.edges[edge].fixed {
                self.straighten(edge);
            }
        }
        for face in 0..self.layout.faces.len() {
            self.fill(face);
        }
        Ok(())
    }

    /// For every vertex those at the other ends of its edges.
    fn neighbours(&self) -> Vec<Vec<usize>> {
        let mut neighbours = vec![Vec::new(); self.vertices()];
        for [a, b] in self.layout.edges.iter().map(super::Edge::ends) {
            neighbours[a].push(b);
            neighbours[b].push(a);
        }
        neighbours
    }

    /// Every part of the graph has a fixed vertex.
    fn check_held(&self, neighbours: &[Vec<usize>]) -> Result<(), ComplexError> {
        let mut held = self.fixed[..self.vertices()].to_vec();
        let mut reached: Vec<usize> = (0..held.len()).filter(|&v| held[v]).collect();
        while let Some(vertex) = reached.pop() {
            for &next in &neighbours[vertex] {
                if !held[next] {
                    held[next] = true;
                    reached.push(next);
                }
            }
        }
        match held.iter().position(|held| !held) {
            Some(vertex) => Err(ComplexError::Loose { vertex }),
            None => Ok(()),
        }
    }

    /// The vertices that have no place yet, each at the mean of its neighbours: the graph Laplacian over them, symmetric
    /// and positive definite because every part is held.
    fn place_vertices(&mut self, neighbours: &[Vec<usize>], placed: &[bool]) {
        let open: Vec<usize> = (0..placed.len()).filter(|&v| !placed[v]).collect();
        let unknown: HashMap<usize, usize> = open.iter().enumerate().map(|(k, &v)| (v, k)).collect();
        let laplacian = |x: &[Point]| -> Vec<Point> {
            let at = |(k, &v): (usize, &usize)| {
                let around = neighbours[v].iter().filter_map(|w| unknown.get(w));
                around.fold(x[k] * neighbours[v].len() as f64, |sum, &w| sum - x[w])
            };
            open.iter().enumerate().map(at).collect()
        };
        // From a placed vertex as the origin: a frame far away costs no digits.
        let Some(origin) = (0..placed.len()).find(|&v| placed[v]).map(|v| self.points[v]) else { return };
        let pull = |&v: &usize| {
            let around = neighbours[v].iter().filter(|&&w| placed[w]);
            around.fold(Point::ZERO, |sum, &w| sum + (self.points[w] - origin))
        };
        let rhs: Vec<Point> = open.iter().map(pull).collect();
        for (&v, x) in open.iter().zip(conjugate_gradients(laplacian, &rhs)) {
            self.points[v] = origin + x;
        }
    }

    /// The free points of an edge, evenly on the segment between its ends.
    fn straighten(&mut self, edge: usize) {
        let nodes = self.edge_nodes(edge);
        let p = self.degree();
        let (a, b) = (self.points[nodes[0]], self.points[nodes[p]]);
        for k in 1..p {
            let t = k as f64 / p as f64;
            self.points[nodes[k]] = a * (1.0 - t) + b * t;
        }
    }

    /// The Coons patch of a face's border: with control points in place of points, because Bernstein polynomials
    /// reproduce linear functions.
    pub(super) fn fill(&mut self, face: usize) {
        let p = self.degree();
        let nodes = self.layout.faces[face].nodes();
        let row =
            |side: Side| -> Vec<Point> { (0..=p).map(|k| self.points[nodes[side.place(p, k)]]).collect() };
        let [v0, u1, v1, u0] = Side::ALL.map(row);
        let mut inner = Vec::with_capacity((p - 1).pow(2));
        for i in 1..p {
            let s = i as f64 / p as f64;
            for j in 1..p {
                let t = j as f64 / p as f64;
                let ruled = v0[i] * (1.0 - t) + v1[i] * t + u0[j] * (1.0 - s) + u1[j] * s;
                let bilinear =
                    (v0[0] * (1.0 - s) + v0[p] * s) * (1.0 - t) + (v1[0] * (1.0 - s) + v1[p] * s) * t;
                inner.push((nodes[(p + 1) * i + j], ruled - bilinear));
            }
        }
        for (node, point) in inner {
            self.points[node] = point;
        }
    }
}
