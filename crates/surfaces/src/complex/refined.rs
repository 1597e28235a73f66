//! Complexes whose faces are parts of those of another.

use std::collections::HashMap;

use bases::{Matrix, Nodal};

use super::{Complex, ComplexError, Edge, Face, FixedEdge, Side, Vertex};
use crate::{Bezier, Patch, Point, TensorPatch};

/// Parameters (u, v) of the corners v00, v10, v11, v01 of a face.
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

/// A face of a refinement: part of a face of the complex.
pub(super) struct Cell {
    pub(super) parent: usize,
    pub(super) vertices: [usize; 4],
    /// The parameters of its corners in the parent; those between follow bilinearly.
    pub(super) at: [[f64; 2]; 4],
}

/// A complex while its faces are cut.
pub(super) struct Refinement<'a> {
    pub(super) coarse: &'a Complex,
    /// Number of vertices, those of the complex first.
    count: usize,
    pub(super) cells: Vec<Cell>,
    /// Vertices that cut edges: by the vertex they are seen from, and the other end.
    on_edges: HashMap<[usize; 2], usize>,
}

impl<'a> Refinement<'a> {
    pub(super) fn of(coarse: &'a Complex) -> Self {
        let cell = |(parent, face): (usize, &Face)| Cell { parent, vertices: face.vertices(), at: SQUARE };
        let cells = coarse.faces().iter().enumerate().map(cell).collect();
        Self { coarse, count: coarse.vertices(), cells, on_edges: HashMap::new() }
    }

    pub(super) fn vertex(&mut self) -> usize {
        self.count += 1;
        self.count - 1
    }

    /// The vertex that cuts the edge from `a` to `b`, the same one whenever asked.
    pub(super) fn on_edge(&mut self, a: usize, b: usize) -> usize {
        match self.on_edges.get(&[a, b]) {
            Some(&vertex) => vertex,
            None => {
                let vertex = self.vertex();
                self.on_edges.insert([a, b], vertex);
                vertex
            }
        }
    }

    /// The complex of the cells, on the surface of the coarse one.
    pub(super) fn complex(&self) -> Result<Complex, ComplexError> {
        let degree = self.coarse.degree();
        let patches = self.patches()?;
        let pieces = self.pieces();
        let mut fixed = Vec::new();
        let mut vertices: Vec<Option<Vertex>> = vec![None; self.count];
        for (vertex, place) in vertices.iter_mut().enumerate().take(self.coarse.vertices()) {
            let point = self.coarse.points()[vertex];
            let stays = self.coarse.fixed()[vertex];
            *place = Some(if stays { Vertex::Fixed(point) } else { Vertex::Free(Some(point)) });
        }
        for piece in &pieces {
            let point = piece.curve.end();
            vertices[piece.ends[1]].get_or_insert(match piece.is_fixed {
                true => Vertex::Fixed(point),
                false => Vertex::Free(Some(point)),
            });
            if piece.is_fixed {
                fixed.push(FixedEdge { ends: piece.ends, curve: piece.curve.clone() });
            }
        }
        for cell in &self.cells {
            for (&vertex, [u, v]) in cell.vertices.iter().zip(cell.at) {
                vertices[vertex].get_or_insert_with(|| Vertex::Free(Some(patches[cell.parent].point(u, v))));
            }
        }
        let vertices: Vec<Vertex> = vertices.into_iter().flatten().collect();
        let faces: Vec<[usize; 4]> = self.cells.iter().map(|cell| cell.vertices).collect();
        let mut fine = Complex::new(degree, &vertices, &faces, &fixed)?;
        if let Some(at) = Interpolation::of_degree(degree) {
            self.follow(&mut fine, &patches, &pieces, &at)?;
        }
        Ok(fine)
    }

    fn patches(&self) -> Result<Vec<TensorPatch>, ComplexError> {
        let coarse = self.coarse;
        let refused = |_| ComplexError::Degree { degree: coarse.degree(), max: Bezier::MAX_DEGREE };
        (0..coarse.faces().len()).map(|face| coarse.patch(face).map_err(refused)).collect()
    }

    /// The edges of the coarse complex as the cells cut them.
    fn pieces(&self) -> Vec<Piece> {
        let mut cuts: Vec<Vec<(f64, usize)>> = vec![Vec::new(); self.coarse.edges().len()];
        for cell in &self.cells {
            let face = &self.coarse.faces()[cell.parent];
            for (&vertex, &at) in cell.vertices.iter().zip(&cell.at) {
                if vertex < self.coarse.vertices() {
                    continue;
                }
                for (number, t) in on_border(self.coarse, cell.parent, face, at) {
                    if cuts[number].iter().all(|(_, known)| *known != vertex) {
                        cuts[number].push((t, vertex));
                    }
                }
            }
        }
        let mut pieces = Vec::new();
        for (number, mut cuts) in cuts.into_iter().enumerate() {
            let edge = &self.coarse.edges()[number];
            cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
            let ([mut from, end], mut rest, mut done) = (edge.ends(), self.coarse.edge_curve(number), 0.0);
            let is_fixed = edge.is_fixed();
            for (t, vertex) in cuts {
                let [curve, left] = rest.split((t - done) / (1.0 - done));
                pieces.push(Piece { ends: [from, vertex], curve, is_fixed });
                (from, rest, done) = (vertex, left, t);
            }
            pieces.push(Piece { ends: [from, end], curve: rest, is_fixed });
        }
        pieces
    }

    /// Moves the free points of a complex of the cells onto the surface of the coarse one.
    fn follow(
        &self,
        fine: &mut Complex,
        patches: &[TensorPatch],
        pieces: &[Piece],
        at: &Interpolation,
    ) -> Result<(), ComplexError> {
        let degree = fine.degree();
        let pieces: HashMap<[usize; 2], &Piece> = pieces.iter().map(|piece| (piece.ends, piece)).collect();
        for number in (0..fine.edges().len()).filter(|&k| !fine.edges()[k].is_fixed()).collect::<Vec<_>>() {
            let [a, b] = fine.edges()[number].ends();
            let known = pieces.get(&[a, b]).map(|piece| piece.curve.clone());
            let known = known.or_else(|| pieces.get(&[b, a]).map(|piece| piece.curve.clone().reversed()));
            let curve = known.unwrap_or_else(|| self.inner_curve(&fine.edges()[number], fine, patches, at));
            for (&node, &point) in fine.edge_nodes(number).iter().zip(curve.points()).take(degree).skip(1) {
                fine.points[node] = point;
            }
        }
        for (face, cell) in self.cells.iter().enumerate() {
            fine.fill(face);
            let refused = |_| ComplexError::Degree { degree, max: Bezier::MAX_DEGREE };
            let coons = fine.patch(face).map_err(refused)?;
            let missing = |[s, t]: [f64; 2]| {
                let [u, v] = cell.place(s, t);
                patches[cell.parent].point(u, v) - coons.point(s, t)
            };
            let nodes = fine.layout.faces[face].nodes();
            for (k, change) in at.net(missing).into_iter().enumerate() {
                let (i, j) = (k / (degree - 1) + 1, k % (degree - 1) + 1);
                fine.points[nodes[(degree + 1) * i + j]] += change;
            }
        }
        Ok(())
    }

    /// The curve of an edge within a face of the coarse complex.
    fn inner_curve(
        &self,
        edge: &Edge,
        fine: &Complex,
        patches: &[TensorPatch],
        at: &Interpolation,
    ) -> Bezier {
        let here = edge.uses()[0];
        let cell = &self.cells[here.face];
        let [a, b] = edge.ends().map(|vertex| fine.points[vertex]);
        let degree = fine.degree();
        let missing = |t: f64| {
            let (s, r) = here.parameters(t);
            let [u, v] = cell.place(s, r);
            patches[cell.parent].point(u, v) - (a * (1.0 - t) + b * t)
        };
        let mut points: Vec<Point> =
            (0..=degree).map(|k| k as f64 / degree as f64).map(|t| a * (1.0 - t) + b * t).collect();
        for (point, change) in points[1..].iter_mut().zip(at.curve(missing)) {
            *point += change;
        }
        Bezier { points }
    }
}

impl Cell {
    /// The parameters in the parent of the point at (s, t).
    fn place(&self, s: f64, t: f64) -> [f64; 2] {
        let [v00, v10, v11, v01] = self.at;
        along(along(v00, v10, s), along(v01, v11, s), t)
    }
}

/// A part of an edge of the coarse complex.
struct Piece {
    ends: [usize; 2],
    curve: Bezier,
    is_fixed: bool,
}

/// The edges of a face that the point at (u, v) lies on, with its parameter on each.
fn on_border(complex: &Complex, number: usize, face: &Face, [u, v]: [f64; 2]) -> Vec<(usize, f64)> {
    let on = |(side, edge): (Side, usize)| {
        let (is_on, t) = match side {
            Side::V0 => (v == 0.0, u),
            Side::U1 => (u == 1.0, v),
            Side::V1 => (v == 1.0, u),
            Side::U0 => (u == 0.0, v),
        };
        let mut uses = complex.edges()[edge].uses().iter();
        let reversed = uses.find(|here| here.face == number && here.side == side)?.reversed;
        is_on.then_some((edge, if reversed { 1.0 - t } else { t }))
    };
    Side::ALL.into_iter().zip(face.edges()).filter_map(on).collect()
}

/// The point at the share `t` of the way from `p` to `q`; exact where they agree in a coordinate.
pub(super) fn along(p: [f64; 2], q: [f64; 2], t: f64) -> [f64; 2] {
    std::array::from_fn(|k| p[k] + (q[k] - p[k]) * t)
}

/// Polynomials of a degree that vanish on the border, from their values at inner Gauss–Lobatto points.
struct Interpolation {
    nodes: Vec<f64>,
    /// From values to inner Bernstein coefficients, (p − 1)² both.
    lobatto: Matrix,
    bernstein: Matrix,
}

impl Interpolation {
    /// None for degree 1, which has no inner points.
    fn of_degree(degree: usize) -> Option<Self> {
        let nodal = Nodal::new(degree).ok().filter(|_| degree > 1)?;
        let nodes = nodal.nodes()[1..degree].to_vec();
        Some(Self { nodes, lobatto: nodal.inner_lobatto(), bernstein: nodal.inner_bernstein() })
    }

    /// The inner coefficients of a curve.
    fn curve(&self, value: impl Fn(f64) -> Point) -> Vec<Point> {
        let values: Vec<Point> = self.nodes.iter().map(|&t| value(t)).collect();
        product(&self.bernstein, &product(&self.lobatto, &values))
    }

    /// The inner coefficients of a net, row by row.
    fn net(&self, value: impl Fn([f64; 2]) -> Point) -> Vec<Point> {
        let count = self.nodes.len();
        let rows = self.nodes.iter().flat_map(|&s| self.curve(|t| value([s, t]))).collect::<Vec<_>>();
        let columns: Vec<Vec<Point>> = (0..count)
            .map(|j| (0..count).map(|i| rows[count * i + j]).collect::<Vec<_>>())
            .map(|column| product(&self.bernstein, &product(&self.lobatto, &column)))
            .collect();
        (0..count).flat_map(|i| columns.iter().map(move |column| column[i])).collect()
    }
}

fn product(matrix: &Matrix, points: &[Point]) -> Vec<Point> {
    let row = |k: usize| matrix.row(k).iter().zip(points).fold(Point::ZERO, |sum, (&m, &p)| sum + p * m);
    (0..matrix.rows()).map(row).collect()
}
