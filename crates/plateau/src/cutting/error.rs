use surfaces::{ComplexError, CurveError, Point};
use thiserror::Error;

use crate::{Degeneracy, MIN_SIZE};

/// Why a boundary could not be cut into quadrilaterals.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CuttingError {
    /// There is no curve.
    #[error("a loop needs at least one curve")]
    NoCurve,
    /// A curve does not begin where the one before ends.
    #[error(
        "curve {curve} begins {gap:.3e} from where the one before it ends; ends within {weld:.1e} are welded. Give the curves \
         in order round, each from end to start, or weld more"
    )]
    Gap {
        /// Number of the curve in its loop, from 0.
        curve: usize,
        /// Distance of the ends.
        gap: f64,
        /// Largest distance that is welded.
        weld: f64,
    },
    /// A curve cannot be made into Bézier pieces.
    #[error("curve {curve}: {error}")]
    Curve {
        /// Number of the curve in its loop or graph, from 0.
        curve: usize,
        /// Why.
        error: CurveError,
    },
    /// A boundary smaller than what is offered.
    #[error(
        "the boundary is {size:e} across; it must be at least {MIN_SIZE:e}: choose a smaller unit of length"
    )]
    TooSmall {
        /// Its size (a length).
        size: f64,
    },
    /// A loop lies in a plane and crosses itself.
    #[error(
        "the loop lies in a plane and crosses itself near {}: every disc over it folds or covers itself. Give its corners in order round, \
         or its parts as loops of their own",
        Degeneracy::shown(Point::from(*at))
    )]
    Crosses {
        /// Where.
        at: [f64; 3],
    },
    /// More pieces than are offered.
    #[error(
        "the curves take {found} Bézier pieces, at most {max} are offered: give fewer and longer ones, a higher degree, or a larger \
         tolerance"
    )]
    TooManyPieces {
        /// Pieces needed.
        found: usize,
        /// Most pieces of a loop, or of all curves of a graph.
        max: usize,
    },
    /// The number of loops is neither one nor two.
    #[error(
        "{found} loops: one is spanned by a disc, two by an annulus; surfaces with more loops are given by faces between \
         vertices on them"
    )]
    Loops {
        /// Loops given.
        found: usize,
    },
    /// The way of cutting asked for does not suit the boundary.
    #[error("{asked} needs {needs}")]
    Unsuitable {
        /// The way.
        asked: &'static str,
        /// What it needs.
        needs: &'static str,
    },
    /// A face of a graph is no polygon.
    #[error(
        "face {face} has {found} vertices; a polygon has 3 or more, each once, or 2 that two curves join"
    )]
    Polygon {
        /// Number of the face, from 0.
        face: usize,
        /// Vertices given, each counted once.
        found: usize,
    },
    /// A side of a face is not where it should be.
    #[error(
        "side {side} of face {face} must begin where the one before ends and run between the ends of its curve"
    )]
    Side {
        /// Number of the face, from 0.
        face: usize,
        /// Number of the side, from 0.
        side: usize,
    },
    /// A face or a curve names a vertex that is not there.
    #[error("vertex {vertex} is named, but there are {count} vertices, numbered from 0")]
    UnknownVertex {
        /// The vertex.
        vertex: usize,
        /// Number of vertices.
        count: usize,
    },
    /// Two curves join the same two vertices.
    #[error("vertices {} and {} are joined by curves {} and {}: faces by vertices cannot say which is meant", ends[0], ends[1], curves[0], curves[1])]
    TwoCurves {
        /// The vertices.
        ends: [usize; 2],
        /// The curves, from 0.
        curves: [usize; 2],
    },
    /// A curve of a graph does not end at its vertex.
    #[error("curve {curve} ends {gap:.3e} from vertex {vertex}; ends within {weld:.1e} are welded")]
    Apart {
        /// Number of the curve.
        curve: usize,
        /// The vertex.
        vertex: usize,
        /// Distance of the end from the vertex.
        gap: f64,
        /// Largest distance that is welded.
        weld: f64,
    },
    /// A curve of a graph begins and ends at the same vertex, or is closed.
    #[error("curve {curve} is closed; a curve between faces joins two vertices: cut it at a point of it")]
    ClosedCurve {
        /// Number of the curve.
        curve: usize,
    },
    /// A curve of a graph is no side of a face.
    #[error("curve {curve} joins vertices {} and {}, which are neighbours in no face", ends[0], ends[1])]
    UnusedCurve {
        /// Number of the curve.
        curve: usize,
        /// Its vertices.
        ends: [usize; 2],
    },
    /// The quadrilaterals do not make a complex.
    #[error(transparent)]
    Complex(#[from] ComplexError),
}

/// Which part of a boundary an error is about. Numbers are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CuttingSite {
    /// All of it.
    Boundary,
    /// A face of a graph.
    Face(usize),
    /// A curve of a loop or graph; the second of two.
    Curve(usize),
}

impl CuttingError {
    /// Which part of the boundary it is about.
    #[must_use]
    pub const fn site(&self) -> CuttingSite {
        match *self {
            Self::Polygon { face, .. } | Self::Side { face, .. } => CuttingSite::Face(face),
            Self::TwoCurves { curves: [_, curve], .. }
            | Self::Gap { curve, .. }
            | Self::Apart { curve, .. }
            | Self::ClosedCurve { curve }
            | Self::UnusedCurve { curve, .. }
            | Self::Curve { curve, .. } => CuttingSite::Curve(curve),
            Self::NoCurve
            | Self::TooSmall { .. }
            | Self::Crosses { .. }
            | Self::TooManyPieces { .. }
            | Self::Loops { .. }
            | Self::Unsuitable { .. }
            | Self::UnknownVertex { .. }
            | Self::Complex(_) => CuttingSite::Boundary,
        }
    }

    /// The error of a boundary so small that products of its lengths vanish, as those that make its size may.
    pub(super) fn unless_large(size: f64) -> Result<(), Self> {
        if size < MIN_SIZE { Err(Self::TooSmall { size }) } else { Ok(()) }
    }
}
