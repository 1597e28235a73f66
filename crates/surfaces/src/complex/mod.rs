//! Quadrilateral patches glued along edges.

mod coons;
mod degree;
mod error;
mod graded;
mod layout;
mod mesh;
mod orientation;
mod refined;

pub use error::ComplexError;
pub use layout::{Edge, EdgeUse, Face, Side};
pub use mesh::ComplexMesh;
pub use orientation::Orientation;

use crate::net::extent;
use crate::{Bezier, Net, Point, SurfaceError, TensorPatch};
use degree::raised_net;
use layout::Layout;

/// A corner of faces, as [`Complex::new`] is given it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Vertex {
    /// Stays at this point: on a rim or a wire, or pinned.
    Fixed(Point),
    /// To be determined; starts at this point if there is one, else where the graph of edges pulls it.
    Free(Option<Point>),
}

/// An edge that stays on a given curve, as [`Complex::new`] is given it.
#[derive(Debug, Clone, PartialEq)]
pub struct FixedEdge {
    /// The vertices at the start and the end of the curve.
    pub ends: [usize; 2],
    /// The curve, of degree at most that of the complex.
    pub curve: Bezier,
}

/// A surface of quadrilateral Bernstein–Bézier patches of bidegree (p, p) that share vertices and edges.
///
/// Two faces with an edge in common have its p + 1 control points in common, so the surface is watertight by
/// construction and continuous (C0). An edge may belong to one face (the rim), to two, or to more (a triple line of films).
/// Points on given curves are fixed, all others are free. Neighbouring faces need not be oriented alike.
///
/// The control points stand in one list: one a vertex, then p − 1 an edge from its first end to its second, then
/// (p − 1)² a face. The leading [`Self::skeleton`] points are those on vertices and edges; every other point belongs to
/// one face alone.
///
/// ```
/// use surfaces::{Bezier, Complex, FixedEdge, Point, Vertex};
/// // Two unit squares side by side; the edge 1–4 between them is free.
/// let corners: Vec<Point> = (0..6).map(|k| Point::new((k % 3) as f64, (k / 3) as f64, 0.0)).collect();
/// let rim = [[0, 1], [1, 2], [2, 5], [5, 4], [4, 3], [3, 0]].map(|[a, b]| FixedEdge {
///     ends: [a, b],
///     curve: Bezier::new(vec![corners[a], corners[b]]).unwrap(),
/// });
/// let vertices: Vec<Vertex> = corners.iter().map(|&p| Vertex::Fixed(p)).collect();
/// let complex = Complex::new(3, &vertices, &[[0, 1, 4, 3], [1, 2, 5, 4]], &rim)?;
/// assert_eq!(complex.points().len(), 6 + 7 * 2 + 2 * 4);
/// assert_eq!(complex.fixed().iter().filter(|fixed| !**fixed).count(), 2 + 2 * 4);
/// # Ok::<(), surfaces::ComplexError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Complex {
    layout: Layout,
    points: Vec<Point>,
    fixed: Vec<bool>,
}

impl Complex {
    /// Most control points a complex may have.
    pub const MAX_POINTS: usize = 4_000_000;

    /// The complex of the given vertices, faces and fixed edges with patches of degree `degree` ≥ 1, in its Coons start:
    /// free vertices where the graph of edges pulls them (each at the mean of its neighbours), free edges straight, a Coons
    /// patch in each face.
    ///
    /// A face names its corners (v00, v10, v11, v01), vij at u = i, v = j.
    ///
    /// # Errors
    /// [`ComplexError`]: every vertex must be used and exist, no face may have a vertex twice, a fixed edge must belong to a
    /// face and its curve begin and end at its fixed vertices, curves may not exceed the degree, and every part of the
    /// surface needs a fixed vertex.
    pub fn new(
        degree: usize,
        vertices: &[Vertex],
        faces: &[[usize; 4]],
        fixed_edges: &[FixedEdge],
    ) -> Result<Self, ComplexError> {
        let layout = Layout::new(degree, vertices.len(), faces, fixed_edges)?;
        let mut points = vec![Point::ZERO; layout.count()];
        let mut fixed = vec![false; layout.count()];
        for (index, vertex) in vertices.iter().enumerate() {
            let (point, stays) = match *vertex {
                Vertex::Fixed(point) => (Some(point), true),
                Vertex::Free(point) => (point, false),
            };
            let point = point.unwrap_or(Point::ZERO);
            if !point.is_finite() {
                return Err(ComplexError::NotFinite { vertex: index });
            }
            points[index] = point;
            fixed[index] = stays;
        }
        for FixedEdge { ends, curve } in fixed_edges {
            for (&vertex, point) in ends.iter().zip([curve.start(), curve.end()]) {
                if !fixed[vertex] {
                    return Err(ComplexError::FreeEnd { vertex });
                }
                if points[vertex] != point {
                    let (vertex_at, curve_at) = (points[vertex].into(), point.into());
                    return Err(ComplexError::Corner { vertex, vertex_at, curve_at });
                }
            }
            let Some(edge) = layout.edge_between(*ends) else { continue };
            for (&node, &point) in layout.run(edge, *ends).iter().zip(curve.raised(degree).points()) {
                (points[node], fixed[node]) = (point, true);
            }
        }
        let mut complex = Self { layout, points, fixed };
        complex.start(vertices)?;
        Ok(complex)
    }

    /// The complex of one face with the surface of a Bernstein–Bézier net, its lower degree raised to the other: points on the border
    /// are fixed, all others free.
    ///
    /// # Errors
    /// [`ComplexError::Degree`] for a net of degree 0 or above [`Bezier::MAX_DEGREE`].
    pub fn of_net(net: &Net) -> Result<Self, ComplexError> {
        let (m, n) = net.degrees();
        let row = |i: usize| (0..=n).map(|j| net.points()[(n + 1) * i + j]).collect::<Vec<_>>();
        let column = |j: usize| (0..=m).map(|i| net.points()[(n + 1) * i + j]).collect::<Vec<_>>();
        let side = |ends: [usize; 2], points| FixedEdge { ends, curve: Bezier { points } };
        let sides = [([0, 1], column(0)), ([1, 2], row(m)), ([3, 2], column(n)), ([0, 3], row(0))];
        let corners = [(0, 0), (m, 0), (m, n), (0, n)];
        let vertices = corners.map(|(i, j)| Vertex::Fixed(net.points()[(n + 1) * i + j]));
        let degree = m.max(n);
        let fixed = sides.map(|(ends, points)| side(ends, points));
        let mut complex = Self::new(degree, &vertices, &[[0, 1, 2, 3]], &fixed)?;
        let net = raised_net(net.points().to_vec(), n, degree);
        for (&node, point) in complex.layout.faces[0].nodes().iter().zip(net) {
            if !complex.fixed[node] {
                complex.points[node] = point;
            }
        }
        Ok(complex)
    }

    /// The degree p of every patch in both parameters.
    pub fn degree(&self) -> usize {
        self.layout.degree
    }

    /// Number of vertices; the first that many points are theirs.
    pub fn vertices(&self) -> usize {
        self.layout.vertices
    }

    /// Number of leading points that lie on vertices and edges.
    pub fn skeleton(&self) -> usize {
        self.layout.skeleton()
    }

    /// The faces.
    pub fn faces(&self) -> &[Face] {
        &self.layout.faces
    }

    /// The edges, each with its faces.
    pub fn edges(&self) -> &[Edge] {
        &self.layout.edges
    }

    /// The global indices of the p + 1 points of an edge, from its first end to its second.
    ///
    /// # Panics
    /// If there is no edge of this number.
    pub fn edge_nodes(&self, edge: usize) -> Vec<usize> {
        self.layout.run(edge, self.layout.edges[edge].ends())
    }

    /// The curve of an edge, from its first end to its second.
    ///
    /// # Panics
    /// If there is no edge of this number.
    pub fn edge_curve(&self, edge: usize) -> Bezier {
        Bezier { points: self.edge_nodes(edge).into_iter().map(|k| self.points[k]).collect() }
    }

    /// All control points: vertices, edges, interiors face by face.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// For every control point, whether it is fixed.
    pub fn fixed(&self) -> &[bool] {
        &self.fixed
    }

    /// The diagonal of the bounding box of the control points: the size errors are measured against.
    pub fn size(&self) -> f64 {
        extent(&self.points)
    }

    /// The complex with other control points.
    ///
    /// # Errors
    /// [`ComplexError::Points`] for another number of points, [`ComplexError::FixedPoint`] if a fixed point moved,
    /// [`ComplexError::NotFinitePoint`].
    pub fn with_points(&self, points: Vec<Point>) -> Result<Self, ComplexError> {
        if points.len() != self.points.len() {
            return Err(ComplexError::Points { expected: self.points.len(), found: points.len() });
        }
        for (index, point) in points.iter().enumerate() {
            if !point.is_finite() {
                return Err(ComplexError::NotFinitePoint { index });
            }
            if self.fixed[index] && *point != self.points[index] {
                return Err(ComplexError::FixedPoint { index });
            }
        }
        Ok(Self { points, ..self.clone() })
    }

    /// The complex moved.
    ///
    /// # Errors
    /// [`ComplexError::NotFinitePoint`] where it leaves the range of doubles.
    pub fn moved(&self, by: Point) -> Result<Self, ComplexError> {
        let points: Vec<Point> = self.points.iter().map(|&p| p + by).collect();
        match points.iter().position(|p| !p.is_finite()) {
            Some(index) => Err(ComplexError::NotFinitePoint { index }),
            None => Ok(Self { points, ..self.clone() }),
        }
    }

    /// The (p + 1) × (p + 1) net of a face, all its points fixed.
    ///
    /// # Errors
    /// None for a complex that was made.
    ///
    /// # Panics
    /// If there is no face of this number.
    pub fn net(&self, face: usize) -> Result<Net, SurfaceError> {
        let side = self.degree() + 1;
        let points = self.layout.faces[face].nodes().iter().map(|&k| self.points[k]).collect();
        Net::new(side, side, points)
    }

    /// The patch of a face, all points of its net fixed.
    ///
    /// # Errors
    /// None for a complex that was made.
    ///
    /// # Panics
    /// If there is no face of this number.
    pub fn patch(&self, face: usize) -> Result<TensorPatch, SurfaceError> {
        TensorPatch::bernstein(self.net(face)?)
    }
}
