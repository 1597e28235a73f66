//! Quadrilaterals while they are being laid out.

use std::collections::{HashMap, HashSet};

use surfaces::{Bezier, Complex, FixedEdge, Vertex};

use super::CuttingError;

/// Vertices with names, quadrilaterals between them, and the curves of fixed edges.
#[derive(Debug, Clone, Default)]
pub(super) struct Blueprint {
    pub(super) names: Vec<String>,
    pub(super) vertices: Vec<Vertex>,
    pub(super) faces: Vec<[usize; 4]>,
    /// Curves by the vertices they join, from the first to the second.
    curves: HashMap<[usize; 2], Bezier>,
    /// Vertices that cut edges, by the ends of those.
    middles: HashMap<[usize; 2], usize>,
    taken: HashSet<String>,
    made: usize,
}

impl Blueprint {
    /// A vertex with a name that nobody else has.
    pub(super) fn named(&mut self, name: &str, vertex: Vertex) -> usize {
        self.taken.insert(name.to_owned());
        self.names.push(name.to_owned());
        self.vertices.push(vertex);
        self.vertices.len() - 1
    }

    /// A vertex that cutting makes: `#1`, `#2`, …
    pub(super) fn vertex(&mut self, vertex: Vertex) -> usize {
        loop {
            self.made += 1;
            let name = format!("#{}", self.made);
            if !self.taken.contains(&name) {
                return self.named(&name, vertex);
            }
        }
    }

    /// A free vertex that cutting makes.
    pub(super) fn free(&mut self) -> usize {
        self.vertex(Vertex::Free(None))
    }

    /// Fixes the edge from `a` to `b` on a curve.
    pub(super) fn fix(&mut self, a: usize, b: usize, curve: Bezier) {
        self.curves.insert([a, b], curve);
    }

    /// Vertices for a ring of pieces and the pieces between them.
    pub(super) fn ring(&mut self, pieces: &[Bezier], name: impl Fn(usize) -> String) -> Vec<usize> {
        let ring: Vec<usize> = pieces
            .iter()
            .enumerate()
            .map(|(k, piece)| self.named(&name(k), Vertex::Fixed(piece.start())))
            .collect();
        for (k, piece) in pieces.iter().enumerate() {
            self.fix(ring[k], ring[(k + 1) % ring.len()], piece.clone());
        }
        ring
    }

    /// The middle of the edge between two vertices, at the parameter ½ of its curve; the same one whenever asked.
    pub(super) fn middle(&mut self, a: usize, b: usize) -> usize {
        let key = [a.min(b), a.max(b)];
        if let Some(&middle) = self.middles.get(&key) {
            return middle;
        }
        let curve = self.curves.remove(&[a, b]).or_else(|| self.curves.remove(&[b, a]).map(Bezier::reversed));
        let middle = match curve.map(|curve| curve.split(0.5)) {
            Some([first, second]) => {
                let middle = self.vertex(Vertex::Fixed(first.end()));
                self.fix(a, middle, first);
                self.fix(middle, b, second);
                middle
            }
            None => self.free(),
        };
        self.middles.insert(key, middle);
        middle
    }

    /// The curve of a fixed edge from `a` to `b`; none for a free one.
    pub(super) fn curve(&self, a: usize, b: usize) -> Option<Bezier> {
        let back = || self.curves.get(&[b, a]).cloned().map(Bezier::reversed);
        self.curves.get(&[a, b]).cloned().or_else(back)
    }

    /// Halves all edges of the strip of faces that lie side by side across the edge from `a` to `b`: it runs on through the
    /// opposite side of every face it enters. What is cut conforms. Gives the middle of the edge
    /// asked for; none, and nothing is done, if no face has it.
    pub(super) fn halve_strip(&mut self, a: usize, b: usize) -> Option<usize> {
        let sorted = |a: usize, b: usize| [a.min(b), a.max(b)];
        let mut strip = HashSet::from([sorted(a, b)]);
        // Faces by their edges, so that a strip is followed in time proportional to its length.
        let mut faces_at: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
        for (face, corners) in self.faces.iter().enumerate() {
            for k in 0..4 {
                faces_at.entry(sorted(corners[k], corners[(k + 1) % 4])).or_default().push(face);
            }
        }
        if !faces_at.contains_key(&sorted(a, b)) {
            return None;
        }
        let mut open = vec![sorted(a, b)];
        while let Some(edge) = open.pop() {
            for &face in faces_at.get(&edge).into_iter().flatten() {
                let corners = self.faces[face];
                for k in 0..4 {
                    if sorted(corners[k], corners[(k + 1) % 4]) == edge {
                        let opposite = sorted(corners[(k + 2) % 4], corners[(k + 3) % 4]);
                        if strip.insert(opposite) {
                            open.push(opposite);
                        }
                    }
                }
            }
        }
        for [a, b, c, d] in std::mem::take(&mut self.faces) {
            match (strip.contains(&sorted(a, b)), strip.contains(&sorted(b, c))) {
                (false, false) => self.faces.push([a, b, c, d]),
                (true, false) => {
                    let (m, n) = (self.middle(a, b), self.middle(d, c));
                    self.faces.extend([[a, m, n, d], [m, b, c, n]]);
                }
                (false, true) => {
                    let (m, n) = (self.middle(b, c), self.middle(a, d));
                    self.faces.extend([[a, b, m, n], [n, m, c, d]]);
                }
                (true, true) => {
                    let [ab, bc, cd, da] = [[a, b], [b, c], [c, d], [d, a]].map(|[a, b]| self.middle(a, b));
                    let center = self.free();
                    self.faces.extend([
                        [a, ab, center, da],
                        [ab, b, bc, center],
                        [center, bc, c, cd],
                        [da, center, cd, d],
                    ]);
                }
            }
        }
        let middle = self.middle(a, b);
        // Edges that are no more have no middle: their ends may be joined anew.
        self.middles.clear();
        Some(middle)
    }

    /// The complex with patches of a degree, in its Coons start.
    pub(super) fn complex(&self, degree: usize) -> Result<Complex, CuttingError> {
        let mut curves: Vec<FixedEdge> =
            self.curves.iter().map(|(&ends, curve)| FixedEdge { ends, curve: curve.clone() }).collect();
        curves.sort_by_key(|edge| edge.ends);
        Ok(Complex::new(degree, &self.vertices, &self.faces, &curves)?)
    }
}
