//! Faces cut towards vertices.

use std::collections::HashSet;

use super::refined::{Cell, Refinement, along};
use super::{Complex, ComplexError, Side};

impl Complex {
    /// The complex with a layer of smaller faces around each of `corners`. Every face there becomes three: with v the corner and a, b, c
    /// the others round the face, (v, a′, m, c′), (a′, a, b, m) and (m, b, c, c′), where a′, m, c′ lie at `share` (between 0 and 1) of the
    /// way from v to a, b, c in the parameters of the face. A face with several of the corners is cut in the middle between them first,
    /// and so are all that lie beside it across its edges, as far as the strip goes: what results conforms, whatever the number of
    /// faces at an edge. Fixed edges stay on their curves, which are cut; vertices keep their numbers, and new ones follow.
    ///
    /// The surface is the same but for lines from m to b, which polynomials of the same degree follow at Gauss–Lobatto points,
    /// and the faces beside these.
    ///
    /// # Errors
    /// [`ComplexError::UnknownVertex`], [`ComplexError::Share`], [`ComplexError::TooLarge`].
    pub fn graded(&self, corners: &[usize], share: f64) -> Result<Self, ComplexError> {
        let count = self.vertices();
        if let Some(&vertex) = corners.iter().find(|vertex| **vertex >= count) {
            return Err(ComplexError::UnknownVertex { vertex, count });
        }
        if !(share > 0.0 && share < 1.0) {
            return Err(ComplexError::Share { share });
        }
        let mut cut = Refinement::of(self);
        let corners: HashSet<usize> = corners.iter().copied().collect();
        cut.halve(&self.between(&corners));
        cut.grade(&corners, share);
        cut.complex()
    }

    /// The complex with every face cut in four by lines between the middles of its sides. Fixed edges stay on their curves, which are cut in
    /// the middle; vertices keep their numbers, and new ones follow. The surface is the same but for rounding.
    ///
    /// # Errors
    /// [`ComplexError::TooLarge`].
    pub fn halved(&self) -> Result<Self, ComplexError> {
        let mut cut = Refinement::of(self);
        cut.halve(&(0..self.edges().len()).collect());
        cut.complex()
    }

    /// The complex with `edges` cut in the middle, and the faces at them from there to the middle of the side opposite, as far as the
    /// strip goes, so that what results conforms. Fixed edges stay on their curves; vertices keep their numbers, and new ones follow. The
    /// surface is the same but for rounding.
    ///
    /// # Errors
    /// [`ComplexError::UnknownEdge`], [`ComplexError::TooLarge`].
    pub fn halved_across(&self, edges: &[usize]) -> Result<Self, ComplexError> {
        let count = self.edges().len();
        if let Some(&edge) = edges.iter().find(|edge| **edge >= count) {
            return Err(ComplexError::UnknownEdge { edge, count });
        }
        let mut cut = Refinement::of(self);
        cut.halve(&self.strips(edges.to_vec()));
        cut.complex()
    }

    /// The edges to be halved so that no face has more than one of the corners, with all that are opposite to one of them in a face.
    fn between(&self, corners: &HashSet<usize>) -> HashSet<usize> {
        let mut open: Vec<usize> = Vec::new();
        for face in self.faces() {
            let is_corner = face.vertices().map(|vertex| corners.contains(&vertex));
            let across = Side::ALL.into_iter().zip(face.edges());
            let both = |side: Side| side.corners().iter().all(|&k| is_corner[k]);
            open.extend(across.filter(|(side, _)| both(*side)).map(|(_, edge)| edge));
            if is_corner == [true, false, true, false] || is_corner == [false, true, false, true] {
                open.extend(face.edges());
            }
        }
        self.strips(open)
    }

    /// These edges with all that are opposite to one of them in a face.
    fn strips(&self, mut open: Vec<usize>) -> HashSet<usize> {
        let mut halved = HashSet::new();
        while let Some(edge) = open.pop() {
            if halved.insert(edge) {
                for here in self.edges()[edge].uses() {
                    open.push(self.faces()[here.face].edges()[(here.side as usize + 2) % 4]);
                }
            }
        }
        halved
    }
}

impl Refinement<'_> {
    /// Cuts the edges of these numbers in the middle, and the faces at them with them. With an edge, the one opposite in every face is
    /// among them.
    fn halve(&mut self, edges: &HashSet<usize>) {
        for cell in std::mem::take(&mut self.cells) {
            let [v0, u1, ..] = self.coarse.faces()[cell.parent].edges().map(|edge| edges.contains(&edge));
            let halves = if v0 { self.halved(cell, Side::V0) } else { vec![cell] };
            for half in halves {
                let parts = if u1 { self.halved(half, Side::U1) } else { vec![half] };
                self.cells.extend(parts);
            }
        }
    }

    /// A cell cut from the middle of `side` to that of the opposite one.
    fn halved(&mut self, cell: Cell, side: Side) -> Vec<Cell> {
        let Cell { parent, vertices: [a, b, c, d], at: [pa, pb, pc, pd] } = cell;
        let mut middle = |k: usize, l: usize| {
            let ends = [k, l].map(|k| cell.vertices[k]);
            let at = along(cell.at[k], cell.at[l], 0.5);
            (self.on_edge(ends[0].min(ends[1]), ends[0].max(ends[1])), at)
        };
        let halves = match side {
            Side::V0 | Side::V1 => {
                let ((m, pm), (n, pn)) = (middle(0, 1), middle(3, 2));
                [([a, m, n, d], [pa, pm, pn, pd]), ([m, b, c, n], [pm, pb, pc, pn])]
            }
            Side::U1 | Side::U0 => {
                let ((m, pm), (n, pn)) = (middle(1, 2), middle(0, 3));
                [([a, b, m, n], [pa, pb, pm, pn]), ([n, m, c, d], [pn, pm, pc, pd])]
            }
        };
        halves.into_iter().map(|(vertices, at)| Cell { parent, vertices, at }).collect()
    }

    /// Cuts every cell at one of the corners in three. No cell has several.
    fn grade(&mut self, corners: &HashSet<usize>, share: f64) {
        for cell in std::mem::take(&mut self.cells) {
            let Some(k) = cell.vertices.iter().position(|vertex| corners.contains(vertex)) else {
                self.cells.push(cell);
                continue;
            };
            let parent = cell.parent;
            let [(v, pv), (a, pa), (b, pb), (c, pc)] =
                [0, 1, 2, 3].map(|j| (cell.vertices[(k + j) % 4], cell.at[(k + j) % 4]));
            let (near_a, near_c, middle) = (self.on_edge(v, a), self.on_edge(v, c), self.vertex());
            let [at_a, at_m, at_c] = [pa, pb, pc].map(|p| along(pv, p, share));
            let parts = [
                ([v, near_a, middle, near_c], [pv, at_a, at_m, at_c]),
                ([near_a, a, b, middle], [at_a, pa, pb, at_m]),
                ([middle, b, c, near_c], [at_m, pb, pc, at_c]),
            ];
            self.cells.extend(parts.map(|(vertices, at)| Cell { parent, vertices, at }));
        }
    }
}
