//! Boundaries cut into quadrilaterals.

mod annulus;
mod blueprint;
mod closed_loop;
mod disc;
mod error;
mod graph;
mod options;
mod parts;
mod polygon;
mod quads;
mod rim;
mod slender;

pub use closed_loop::Loop;
pub use error::{CuttingError, CuttingSite};
pub use graph::{CurveGraph, FaceSide, GraphCurve};
pub use options::{Cutting, Way};
pub(crate) use slender::{cut_slender, slenderness};

use quads::Quads;
use surfaces::{Complex, Deviation};

/// A boundary cut into quadrilaterals.
#[derive(Debug, Clone, PartialEq)]
pub struct CutBoundary {
    complex: Complex,
    names: Vec<String>,
    way: Way,
    corners: usize,
    deviation: Deviation,
    welded: f64,
}

impl Cutting {
    /// The surface between loops: a disc in one, an annulus between two. The way, unless one was asked for:
    ///
    /// - four corners, all between 30° and 150° in the plane of the loop: one patch;
    /// - three or more such corners: midpoint subdivision;
    /// - everything else (no corner, one, two, sharp or blunt or re-entrant ones, sides of many pieces): a ring, because a
    ///   smooth point of the boundary is no corner of a quad. Sides are halved until there are four;
    /// - two loops: both in the same number of pieces, matched so that the squared distances of their vertices are least.
    ///
    /// Quads more than four times as long as wide are cut across.
    ///
    /// # Errors
    /// [`CuttingError`].
    pub fn loops(&self, loops: &[Loop]) -> Result<CutBoundary, CuttingError> {
        let cut = match loops {
            [one] => disc::cut(one, self)?,
            [first, second] => annulus::cut(first, second, self)?,
            _ => return Err(CuttingError::Loops { found: loops.len() }),
        };
        let welded = loops.iter().map(Loop::welded).fold(0.0, f64::max);
        self.finished(cut, welded)
    }

    /// The surface of the faces of a graph of curves. Every edge is cut in the same even number of pieces.
    ///
    /// # Errors
    /// [`CuttingError`].
    pub fn graph(&self, graph: &CurveGraph) -> Result<CutBoundary, CuttingError> {
        let (cut, welded) = graph::cut(graph, self)?;
        self.finished(cut, welded)
    }

    fn finished(&self, mut cut: Quads, welded: f64) -> Result<CutBoundary, CuttingError> {
        let complex = slender::cut_across(&mut cut.blueprint, self.degree)?;
        let Quads { blueprint, way, corners, deviation } = cut;
        Ok(CutBoundary { complex, names: blueprint.names, way, corners, deviation, welded })
    }
}

impl CutBoundary {
    /// The complex, in its Coons start.
    pub fn complex(&self) -> &Complex {
        &self.complex
    }

    /// The name of every vertex of the complex: `v0`, `v1`, … around a loop (`a0`, …, `b0`, … around two), those of a graph as
    /// they were given, `#1`, `#2`, … for what cutting made.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The way it was cut.
    pub fn way(&self) -> Way {
        self.way
    }

    /// Number of corners of the loops.
    pub fn corners(&self) -> usize {
        self.corners
    }

    /// How far the rim of the complex is from the curves that were given.
    pub fn deviation(&self) -> Deviation {
        self.deviation
    }

    /// The largest distance of ends of curves that were made one point.
    pub fn welded(&self) -> f64 {
        self.welded
    }

    /// The complex by itself.
    pub fn into_complex(self) -> Complex {
        self.complex
    }
}
