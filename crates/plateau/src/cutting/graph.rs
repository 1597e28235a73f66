//! Faces between the curves of a graph.

use std::collections::{HashMap, HashSet};

use surfaces::{Bezier, BoundaryCurve, Deviation, Point, Vertex, extent};

use super::blueprint::Blueprint;
use super::polygon::Cut;
use super::rim::{Rim, check_count, is_tame, length, longest, parts};
use super::{Cutting, CuttingError, Loop, Quads, Way};

/// A curve between two vertices of a graph.
#[derive(Debug, Clone, PartialEq)]
pub struct GraphCurve {
    /// The vertices at its start and its end.
    pub ends: [usize; 2],
    /// The curve.
    pub curve: BoundaryCurve,
}

/// A side of a face of a graph, in the sense in which it is walked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FaceSide {
    /// The vertices it leads from and to.
    pub ends: [usize; 2],
    /// The curve it runs along, either way; none for a free edge, found with the surface.
    pub curve: Option<usize>,
}

/// Curves that meet at vertices, and polygons spanned between them. Any number of faces may share a side.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveGraph {
    names: Vec<String>,
    vertices: Vec<Vertex>,
    curves: Vec<GraphCurve>,
    faces: Vec<Vec<FaceSide>>,
    weld: f64,
    welded: f64,
}

impl CurveGraph {
    /// The graph of faces given by their vertices: three or more, in order round. Where a curve joins two that follow one
    /// another, the face has it as a side; where none does, the side is a free edge.
    ///
    /// Vertices have names, which should differ, and a place or none: a vertex at the end of a curve is fixed there; others
    /// are free unless given as fixed. Ends of curves at most `weld` (a length) from their vertex are moved to it; None stands
    /// for [`Loop::WELD`] of the size.
    ///
    /// # Errors
    /// [`CuttingError`] for a face that is no polygon, for names of vertices that are not there, for curves that are closed or
    /// no side of a face, for two between the same vertices, and for ends that are farther from their vertex.
    pub fn new(
        vertices: Vec<(String, Vertex)>,
        curves: Vec<GraphCurve>,
        faces: &[Vec<usize>],
        weld: Option<f64>,
    ) -> Result<Self, CuttingError> {
        let mut between: HashMap<[usize; 2], usize> = HashMap::new();
        for (curve, GraphCurve { ends, .. }) in curves.iter().enumerate() {
            if let Some(other) = between.insert(sorted(*ends), curve) {
                return Err(CuttingError::TwoCurves { ends: *ends, curves: [other, curve] });
            }
        }
        let side = |face: &[usize], k: usize| {
            let ends = [face[k], face[(k + 1) % face.len()]];
            FaceSide { ends, curve: between.get(&sorted(ends)).copied() }
        };
        let faces = faces.iter().map(|face| (0..face.len()).map(|k| side(face, k)).collect()).collect();
        Self::with_sides(vertices, curves, faces, weld)
    }

    /// The graph of faces given by their sides, two or more, in order round: curves may then join the same vertices.
    ///
    /// # Errors
    /// As [`Self::new`], and [`CuttingError::Side`] for a side that does not begin where the one before ends, or not run between
    /// the vertices of its curve.
    pub fn with_sides(
        vertices: Vec<(String, Vertex)>,
        curves: Vec<GraphCurve>,
        faces: Vec<Vec<FaceSide>>,
        weld: Option<f64>,
    ) -> Result<Self, CuttingError> {
        let (names, vertices) = vertices.into_iter().unzip();
        let corners: Vec<Point> = curves.iter().flat_map(|c| [c.curve.start(), c.curve.point(0.5)]).collect();
        let size = curves.iter().map(|c| c.curve.size()).fold(extent(&corners), f64::max);
        if !curves.is_empty() {
            CuttingError::unless_large(size)?;
        }
        let weld = weld.unwrap_or(Loop::WELD * size);
        let mut graph = Self { names, vertices, curves, faces, weld, welded: 0.0 };
        graph.check_curves()?;
        graph.check_faces()?;
        graph.weld()?;
        Ok(graph)
    }

    /// The names of the vertices.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The curves.
    pub fn curves(&self) -> &[GraphCurve] {
        &self.curves
    }

    /// The faces.
    pub fn faces(&self) -> &[Vec<FaceSide>] {
        &self.faces
    }

    /// The graph moved.
    pub(crate) fn moved(&self, by: Point) -> Self {
        let vertices = self.vertices.iter().map(|vertex| match *vertex {
            Vertex::Fixed(point) => Vertex::Fixed(point + by),
            Vertex::Free(point) => Vertex::Free(point.map(|point| point + by)),
        });
        let curves = self
            .curves
            .iter()
            .map(|GraphCurve { ends, curve }| GraphCurve { ends: *ends, curve: curve.moved(by) });
        Self { vertices: vertices.collect(), curves: curves.collect(), ..self.clone() }
    }

    /// The places of vertices that are given or at ends of curves.
    pub(crate) fn places(&self) -> Vec<Point> {
        let place = |vertex: &Vertex| match *vertex {
            Vertex::Fixed(point) | Vertex::Free(Some(point)) => Some(point),
            Vertex::Free(None) => None,
        };
        self.vertices.iter().filter_map(place).collect()
    }

    fn check_curves(&self) -> Result<(), CuttingError> {
        let used: HashSet<usize> = self.faces.iter().flatten().filter_map(|side| side.curve).collect();
        for (curve, GraphCurve { ends, curve: given }) in self.curves.iter().enumerate() {
            self.check_vertices(*ends)?;
            if ends[0] == ends[1] || given.is_closed() {
                return Err(CuttingError::ClosedCurve { curve });
            }
            if !used.contains(&curve) {
                return Err(CuttingError::UnusedCurve { curve, ends: *ends });
            }
        }
        Ok(())
    }

    fn check_vertices(&self, ends: [usize; 2]) -> Result<(), CuttingError> {
        let count = self.vertices.len();
        match ends.into_iter().find(|vertex| *vertex >= count) {
            Some(vertex) => Err(CuttingError::UnknownVertex { vertex, count }),
            None => Ok(()),
        }
    }

    fn check_faces(&self) -> Result<(), CuttingError> {
        for (face, sides) in self.faces.iter().enumerate() {
            let mut once: Vec<usize> = sides.iter().map(|side| side.ends[0]).collect();
            once.sort_unstable();
            once.dedup();
            let found = once.len();
            // Two vertices are enough where two curves join them: not two free edges, nor one curve there and back.
            let is_lens = found == 2
                && sides.iter().all(|side| side.curve.is_some())
                && sides[0].curve != sides[1].curve;
            if found != sides.len() || !(found >= 3 || is_lens) {
                return Err(CuttingError::Polygon { face, found });
            }
            for (k, side) in sides.iter().enumerate() {
                self.check_vertices(side.ends)?;
                let is_chained = side.ends[1] == sides[(k + 1) % sides.len()].ends[0];
                let is_along = match side.curve {
                    Some(curve) => {
                        self.curves.get(curve).is_some_and(|c| sorted(c.ends) == sorted(side.ends))
                    }
                    None => true,
                };
                if !(is_chained && is_along) {
                    return Err(CuttingError::Side { face, side: k });
                }
            }
        }
        Ok(())
    }

    /// Puts every vertex at the end of a curve to its place: where it is given, else where the first curve ends.
    fn weld(&mut self) -> Result<(), CuttingError> {
        let mut met = vec![false; self.vertices.len()];
        // Where a vertex has no place, the first curve that ends there gives it one, and all others are held against that.
        for (curve, GraphCurve { ends, curve: given }) in self.curves.iter().enumerate() {
            for (&vertex, end) in ends.iter().zip([given.start(), given.end()]) {
                let place = match self.vertices[vertex] {
                    Vertex::Fixed(point) | Vertex::Free(Some(point)) => point,
                    Vertex::Free(None) => end,
                };
                let gap = place.distance(end);
                if gap.is_nan() || gap > self.weld {
                    return Err(CuttingError::Apart { curve, vertex, gap, weld: self.weld });
                }
                self.welded = self.welded.max(gap);
                self.vertices[vertex] = Vertex::Fixed(place);
                met[vertex] = true;
            }
        }
        Ok(())
    }

    /// The curves as pieces, each from its vertices on.
    fn pieces(&self, cutting: &Cutting) -> Result<(Vec<Vec<Bezier>>, Deviation), CuttingError> {
        let mut deviation = Deviation::default();
        let mut all = Vec::with_capacity(self.curves.len());
        for (curve, GraphCurve { ends, curve: given }) in self.curves.iter().enumerate() {
            let mut pieces: Vec<Bezier> = Vec::new();
            for part in parts(given, false) {
                let fit = part
                    .fit(cutting.degree, cutting.tolerance)
                    .map_err(|error| CuttingError::Curve { curve, error })?;
                deviation = deviation.and(fit.deviation());
                pieces.extend_from_slice(fit.pieces());
            }
            // The ends are put on the vertices, so that curves meet bit for bit; what that moves counts as deviation.
            for (&vertex, at) in ends.iter().zip([0, pieces.len() - 1]) {
                let (Vertex::Fixed(point) | Vertex::Free(Some(point))) = self.vertices[vertex] else {
                    continue;
                };
                let piece = &pieces[at];
                let (start, end) =
                    if vertex == ends[0] { (point, piece.end()) } else { (piece.start(), point) };
                let gap = start.distance(piece.start()).max(end.distance(piece.end()));
                deviation = deviation.and(Deviation { largest: gap, area: 0.5 * gap * length(piece) });
                pieces[at] = piece.with_ends(start, end);
            }
            all.push(pieces);
        }
        Ok((all, deviation))
    }
}

pub(super) fn cut(graph: &CurveGraph, cutting: &Cutting) -> Result<(Quads, f64), CuttingError> {
    match cutting.way {
        None | Some(Way::Faces | Way::Midpoint | Way::Ring | Way::TurnedRing) => {}
        Some(Way::Grid | Way::Annulus | Way::Parts) => {
            let (asked, needs) = ("one patch, an annulus or parts", "loops; faces are cut one by one");
            return Err(CuttingError::Unsuitable { asked, needs });
        }
    }
    let (mut pieces, deviation) = graph.pieces(cutting)?;
    check_count(pieces.iter().map(Vec::len).sum())?;
    // All sides of all faces in the same even number of pieces: then any two faces conform along any edge.
    let half = even(&mut pieces);
    let mut blueprint = Blueprint::default();
    for (name, &vertex) in graph.names.iter().zip(&graph.vertices) {
        blueprint.named(name, vertex);
    }
    // Vertices along every curve, and along free edges from their smaller end.
    let mut along = Vec::with_capacity(pieces.len());
    for (GraphCurve { ends, .. }, pieces) in graph.curves.iter().zip(&pieces) {
        let inner = pieces[1..].iter().map(|piece| blueprint.vertex(Vertex::Fixed(piece.start())));
        let run = [vec![ends[0]], inner.collect(), vec![ends[1]]].concat();
        for (k, piece) in pieces.iter().enumerate() {
            blueprint.fix(run[k], run[k + 1], piece.clone());
        }
        along.push(run);
    }
    let mut free: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
    for sides in &graph.faces {
        let mut ring = Vec::new();
        for FaceSide { ends, curve } in sides {
            let run = match curve {
                Some(curve) => &along[*curve],
                // A free edge gets its inner vertices once, from the smaller end on; the second face finds them again.
                None => free.entry(sorted(*ends)).or_insert_with_key(|[a, b]| {
                    let inner = (1..2 * half).map(|_| blueprint.free()).collect();
                    [vec![*a], inner, vec![*b]].concat()
                }),
            };
            // Runs go from the first end of the curve: a face may walk them backwards.
            let mut run = run.clone();
            if run[0] != ends[0] {
                run.reverse();
            }
            // Without the last vertex, which is the first of the next side.
            ring.extend_from_slice(&run[..2 * half]);
        }
        let cut = cut_of_face(&blueprint, &ring, half, cutting);
        blueprint.polygon(&ring, half, cut);
    }
    let quads = Quads { blueprint, way: Way::Faces, corners: graph.vertices.len(), deviation };
    Ok((quads, graph.welded))
}

/// Cuts the longest pieces of curves in two until all have the same even number of them; half of that.
fn even(pieces: &mut [Vec<Bezier>]) -> usize {
    let half = pieces.iter().map(|pieces| pieces.len().div_ceil(2)).max().unwrap_or(1);
    for pieces in pieces {
        while pieces.len() < 2 * half {
            let longest = longest(pieces);
            let halves = pieces[longest].split(0.5);
            pieces.splice(longest..=longest, halves);
        }
    }
    half
}

/// How a face is cut whose sides run through these vertices.
fn cut_of_face(blueprint: &Blueprint, ring: &[usize], half: usize, cutting: &Cutting) -> Cut {
    match cutting.way {
        Some(Way::Ring) => Cut::Ring,
        Some(Way::TurnedRing) => Cut::TurnedRing,
        Some(Way::Midpoint) => Cut::Fan,
        None | Some(Way::Faces | Way::Grid | Way::Annulus | Way::Parts) => {
            if has_tame_corners(blueprint, ring, half, cutting) { Cut::Fan } else { Cut::Ring }
        }
    }
}

/// Whether all corners of a face are between 30° and 150°, as far as they are known: where a side is free they are not.
fn has_tame_corners(blueprint: &Blueprint, ring: &[usize], half: usize, cutting: &Cutting) -> bool {
    let piece = |k: usize| blueprint.curve(ring[k], ring[(k + 1) % ring.len()]);
    let Some(pieces) = (0..ring.len()).map(piece).collect() else { return true };
    let rim = Rim::of_pieces(pieces, Deviation::default(), cutting.corner_angle);
    rim.corners.iter().step_by(2 * half).all(|corner| corner.is_some_and(is_tame))
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}
