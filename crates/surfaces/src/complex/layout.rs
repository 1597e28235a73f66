//! Which control point of a face is which of the complex.

use std::collections::HashMap;

use super::{Complex, ComplexError, FixedEdge};
use crate::Bezier;

/// A side of a face, named by what is constant on it; it runs with the other parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// v = 0, from v00 to v10.
    V0,
    /// u = 1, from v10 to v11.
    U1,
    /// v = 1, from v01 to v11.
    V1,
    /// u = 0, from v00 to v01.
    U0,
}

impl Side {
    /// The four sides in the order of [`Face::edges`].
    pub const ALL: [Self; 4] = [Self::V0, Self::U1, Self::V1, Self::U0];

    /// The corners at its start and end as places in (v00, v10, v11, v01).
    pub fn corners(self) -> [usize; 2] {
        match self {
            Self::V0 => [0, 1],
            Self::U1 => [1, 2],
            Self::V1 => [3, 2],
            Self::U0 => [0, 3],
        }
    }

    /// Parameters (u, v) of the point at t ∈ [0, 1] on it.
    pub fn parameters(self, t: f64) -> (f64, f64) {
        match self {
            Self::V0 => (t, 0.0),
            Self::U1 => (1.0, t),
            Self::V1 => (t, 1.0),
            Self::U0 => (0.0, t),
        }
    }

    /// Place of its point k in the (p + 1)² net of a face.
    pub(crate) fn place(self, degree: usize, k: usize) -> usize {
        let n = degree + 1;
        match self {
            Self::V0 => n * k,
            Self::U1 => n * degree + k,
            Self::V1 => n * k + degree,
            Self::U0 => k,
        }
    }

    /// Whether it runs with the border of the face walked v00, v10, v11, v01.
    pub fn runs_round(self) -> bool {
        match self {
            Self::V0 | Self::U1 => true,
            Self::V1 | Self::U0 => false,
        }
    }
}

/// A quadrilateral of a complex.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    vertices: [usize; 4],
    edges: [usize; 4],
    nodes: Vec<usize>,
}

impl Face {
    /// Its corners (v00, v10, v11, v01).
    pub fn vertices(&self) -> [usize; 4] {
        self.vertices
    }

    /// Numbers of its edges in the order of [`Side::ALL`].
    pub fn edges(&self) -> [usize; 4] {
        self.edges
    }

    /// Global index of `P_ij` at `(p + 1) i + j`, i with u.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }
}

/// One face at an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EdgeUse {
    /// Number of the face.
    pub face: usize,
    /// The side of the face that is the edge.
    pub side: Side,
    /// Whether the side's parameter runs from the edge's second end to its first.
    pub reversed: bool,
}

/// An edge of a complex with the faces it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    ends: [usize; 2],
    uses: Vec<EdgeUse>,
    pub(super) fixed: bool,
}

impl Edge {
    /// Its vertices; its control points run from the first to the second.
    pub fn ends(&self) -> [usize; 2] {
        self.ends
    }

    /// The faces at it: one at the rim, two inside, more on a line where films meet.
    pub fn uses(&self) -> &[EdgeUse] {
        &self.uses
    }

    /// Whether it stays on a given curve.
    pub fn is_fixed(&self) -> bool {
        self.fixed
    }
}

/// The numbering of the control points of a complex: vertices, edges, interiors.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout {
    pub(super) degree: usize,
    pub(super) vertices: usize,
    pub(super) faces: Vec<Face>,
    pub(super) edges: Vec<Edge>,
    by_ends: HashMap<[usize; 2], usize>,
}

impl Layout {
    pub(super) fn new(
        degree: usize,
        vertices: usize,
        faces: &[[usize; 4]],
        fixed_edges: &[FixedEdge],
    ) -> Result<Self, ComplexError> {
        check_size(degree, faces.len())?;
        check_vertices(vertices, faces)?;
        let mut layout = Self {
            degree,
            vertices,
            faces: Vec::with_capacity(faces.len()),
            edges: Vec::new(),
            by_ends: HashMap::new(),
        };
        // Edges are numbered as the faces name them first: the same faces always give the same numbers.
        for (face, corners) in faces.iter().enumerate() {
            let edges = Side::ALL.map(|side| {
                let ends = side.corners().map(|k| corners[k]);
                layout.enter(ends, EdgeUse { face, side, reversed: ends[0] > ends[1] })
            });
            layout.faces.push(Face { vertices: *corners, edges, nodes: Vec::new() });
        }
        layout.fix(fixed_edges)?;
        layout.number();
        Ok(layout)
    }

    /// The layout of the same faces with patches of another degree ≥ 1.
    pub(super) fn with_degree(&self, degree: usize) -> Result<Self, ComplexError> {
        check_size(degree, self.faces.len())?;
        let mut layout = Self { degree, ..self.clone() };
        layout.number();
        Ok(layout)
    }

    /// Number of control points on vertices and edges.
    pub(super) fn skeleton(&self) -> usize {
        self.vertices + self.edges.len() * (self.degree - 1)
    }

    /// Number of control points.
    pub(super) fn count(&self) -> usize {
        self.skeleton() + self.faces.len() * (self.degree - 1).pow(2)
    }

    /// The edge between two vertices.
    pub(super) fn edge_between(&self, ends: [usize; 2]) -> Option<usize> {
        self.by_ends.get(&sorted(ends)).copied()
    }

    /// The points of an edge from `ends[0]` to `ends[1]`, its vertices in either order.
    pub(super) fn run(&self, edge: usize, ends: [usize; 2]) -> Vec<usize> {
        // Inner points follow the vertices, edge by edge, in the direction of the edge.
        let first = self.vertices + edge * (self.degree - 1);
        let mut run = vec![self.edges[edge].ends[0]];
        run.extend(first..first + self.degree - 1);
        run.push(self.edges[edge].ends[1]);
        if ends != self.edges[edge].ends {
            run.reverse();
        }
        run
    }

    /// The edge between `ends`, new if no face had it so far; it runs from the smaller vertex to the larger.
    fn enter(&mut self, ends: [usize; 2], here: EdgeUse) -> usize {
        let ends = sorted(ends);
        let edge = *self.by_ends.entry(ends).or_insert(self.edges.len());
        if edge == self.edges.len() {
            self.edges.push(Edge { ends, uses: Vec::new(), fixed: false });
        }
        self.edges[edge].uses.push(here);
        edge
    }

    fn fix(&mut self, fixed_edges: &[FixedEdge]) -> Result<(), ComplexError> {
        for FixedEdge { ends, curve } in fixed_edges {
            let ends = *ends;
            if let Some(&vertex) = ends.iter().find(|vertex| **vertex >= self.vertices) {
                return Err(ComplexError::UnknownVertex { vertex, count: self.vertices });
            }
            let edge = self.edge_between(ends).ok_or(ComplexError::UnusedCurve { ends })?;
            if self.edges[edge].fixed {
                return Err(ComplexError::TwoCurves { ends });
            }
            if curve.degree() > self.degree {
                return Err(ComplexError::CurveDegree { ends, found: curve.degree(), degree: self.degree });
            }
            self.edges[edge].fixed = true;
        }
        Ok(())
    }

    /// Numbers the points of every face.
    fn number(&mut self) {
        let (n, inner) = (self.degree + 1, self.degree - 1);
        let skeleton = self.skeleton();
        let nodes: Vec<Vec<usize>> = (0..self.faces.len())
            .map(|face| {
                let Face { vertices, edges, .. } = &self.faces[face];
                let mut nodes = vec![0; n * n];
                for (side, &edge) in Side::ALL.into_iter().zip(edges) {
                    // Corners are written by two sides, with the same number.
                    let ends = side.corners().map(|k| vertices[k]);
                    for (k, node) in self.run(edge, ends).into_iter().enumerate() {
                        nodes[side.place(self.degree, k)] = node;
                    }
                }
                for i in 1..self.degree {
                    for j in 1..self.degree {
                        // Interiors stand behind all points that faces share: the order in which they can be condensed.
                        nodes[n * i + j] = skeleton + (face * inner + i - 1) * inner + j - 1;
                    }
                }
                nodes
            })
            .collect();
        for (face, nodes) in self.faces.iter_mut().zip(nodes) {
            face.nodes = nodes;
        }
    }
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

fn check_size(degree: usize, faces: usize) -> Result<(), ComplexError> {
    if faces == 0 {
        return Err(ComplexError::NoFace);
    }
    if !(1..=Bezier::MAX_DEGREE).contains(&degree) {
        return Err(ComplexError::Degree { degree, max: Bezier::MAX_DEGREE });
    }
    // Before anything is allocated.
    if faces.saturating_mul((degree + 1).pow(2)) > Complex::MAX_POINTS {
        return Err(ComplexError::TooLarge { faces, degree, max: Complex::MAX_POINTS });
    }
    Ok(())
}

fn check_vertices(count: usize, faces: &[[usize; 4]]) -> Result<(), ComplexError> {
    let mut used = vec![false; count];
    for (face, corners) in faces.iter().enumerate() {
        for (k, &vertex) in corners.iter().enumerate() {
            if vertex >= count {
                return Err(ComplexError::UnknownVertex { vertex, count });
            }
            if corners[..k].contains(&vertex) {
                return Err(ComplexError::RepeatedVertex { face, vertex });
            }
            used[vertex] = true;
        }
    }
    match used.iter().position(|used| !used) {
        Some(vertex) => Err(ComplexError::UnusedVertex { vertex }),
        None => Ok(()),
    }
}
