use thiserror::Error;

/// Why a complex could not be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ComplexError {
    /// There is no face.
    #[error("a complex needs at least one face")]
    NoFace,
    /// The degree is not offered.
    #[error("patches of degree {degree} are not offered; give a degree from 1 to {max}")]
    Degree {
        /// The degree asked for.
        degree: usize,
        /// Highest degree.
        max: usize,
    },
    /// A complex was to be made of a lower degree.
    #[error("a complex of degree {own} cannot be given the lower degree {degree} without changing it")]
    Lowered {
        /// The degree asked for.
        degree: usize,
        /// Its own degree.
        own: usize,
    },
    /// More control points than are offered.
    #[error(
        "{faces} faces of degree {degree} have more than {max} control points; lower the degree or cut less"
    )]
    TooLarge {
        /// Number of faces.
        faces: usize,
        /// Degree of the patches.
        degree: usize,
        /// Most control points.
        max: usize,
    },
    /// A face or a fixed edge names a vertex that is not in the list.
    #[error("vertex {vertex} is named, but there are {count} vertices, numbered from 0")]
    UnknownVertex {
        /// The vertex named.
        vertex: usize,
        /// Number of vertices.
        count: usize,
    },
    /// An edge is named that is not one.
    #[error("edge {edge} is named, but there are {count} edges, numbered from 0")]
    UnknownEdge {
        /// The edge named.
        edge: usize,
        /// Number of edges.
        count: usize,
    },
    /// A face has a vertex twice.
    #[error("face {face} has vertex {vertex} twice; its four corners must differ")]
    RepeatedVertex {
        /// Number of the face.
        face: usize,
        /// The vertex.
        vertex: usize,
    },
    /// A vertex belongs to no face.
    #[error("vertex {vertex} belongs to no face")]
    UnusedVertex {
        /// The vertex.
        vertex: usize,
    },
    /// A fixed edge joins two vertices that no face has as neighbours.
    #[error("the curve from vertex {} to vertex {} is no side of a face", ends[0], ends[1])]
    UnusedCurve {
        /// Its vertices.
        ends: [usize; 2],
    },
    /// Two curves were given for one edge.
    #[error("vertices {} and {} are joined by two curves; an edge lies on one", ends[0], ends[1])]
    TwoCurves {
        /// The vertices.
        ends: [usize; 2],
    },
    /// A curve ends at a vertex that is free to move.
    #[error("a fixed curve ends at vertex {vertex}, which is free; a vertex on a curve is fixed")]
    FreeEnd {
        /// The vertex.
        vertex: usize,
    },
    /// A curve does not end at its vertex.
    #[error(
        "a curve ends at {curve_at:?}, its vertex {vertex} is at {vertex_at:?}; they must be the same point"
    )]
    Corner {
        /// The vertex.
        vertex: usize,
        /// Where it is.
        vertex_at: [f64; 3],
        /// Where the curve ends.
        curve_at: [f64; 3],
    },
    /// A curve has a higher degree than the patches.
    #[error(
        "the curve from vertex {} to vertex {} has degree {found}, the patches {degree}; raise their degree",
        ends[0],
        ends[1]
    )]
    CurveDegree {
        /// Vertices of the curve.
        ends: [usize; 2],
        /// Degree of the curve.
        found: usize,
        /// Degree of the patches.
        degree: usize,
    },
    /// Nothing holds a part of the surface.
    #[error("the part of the surface at vertex {vertex} has no fixed vertex; nothing spans it")]
    Loose {
        /// A vertex of the part.
        vertex: usize,
    },
    /// The coordinate of a vertex is not a finite number.
    #[error("vertex {vertex} is not at a finite point")]
    NotFinite {
        /// The vertex.
        vertex: usize,
    },
    /// A layer of faces was to be made of no width, or of all.
    #[error("a layer around corners takes a share of the faces there between 0 and 1, not {share:?}")]
    Share {
        /// The share asked for.
        share: f64,
    },
    /// A list of control points has the wrong length.
    #[error("this complex has {expected} control points, got {found}")]
    Points {
        /// Control points of the complex.
        expected: usize,
        /// Points given.
        found: usize,
    },
    /// A fixed control point was moved.
    #[error("control point {index} is fixed and was moved")]
    FixedPoint {
        /// Number of the point.
        index: usize,
    },
    /// A control point is not finite.
    #[error("control point {index} is not finite")]
    NotFinitePoint {
        /// Number of the point.
        index: usize,
    },
}
