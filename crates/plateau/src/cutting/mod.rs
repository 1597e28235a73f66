//! Boundaries cut into quadrilaterals.

mod annulus;
mod blueprint;
mod closed_loop;
mod disc;
mod error;
mod graph;
mod polygon;
mod rim;
mod slender;

use std::f64::consts::PI;

pub use closed_loop::Loop;
pub use error::CuttingError;
pub use graph::{CurveGraph, FaceSide, GraphCurve};

use blueprint::Blueprint;
use surfaces::{Bezier, Complex, CurveError, Deviation};

/// How a boundary is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// One four-sided patch, or a grid of them where sides are pieced together or the patch would be slender.
    Grid,
    /// Midpoint subdivision: a quad at every corner, all around one centre.
    Midpoint,
    /// A ring of quads along the boundary and an inner polygon, cut from its middle where it has not four corners.
    Ring,
    /// The same with the corners of the inner polygon over the middles of the sides.
    TurnedRing,
    /// A ring of quads between two loops.
    Annulus,
    /// Each face of a graph by itself: by its middle, with a ring where its corners are blunt or sharp.
    Faces,
}

/// How boundaries are cut into quadrilaterals.
///
/// ```
/// use plateau::{Cutting, Loop, Way};
/// use surfaces::Point;
/// // Six edges of a cube.
/// let corners =
///     [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]].map(Point::from);
/// let cut = Cutting::new(4, 1e-6)?.loops(&[Loop::polygon(&corners)?])?;
/// assert_eq!((cut.way(), cut.complex().faces().len()), (Way::Midpoint, 6));
/// # Ok::<(), plateau::CuttingError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cutting {
    degree: usize,
    tolerance: f64,
    corner_angle: f64,
    way: Option<Way>,
}

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
    /// The turn of a direction, in radians, above which a point is a corner unless something else is said: 30°.
    pub const CORNER_ANGLE: f64 = PI / 6.0;

    /// Patches of degree `degree`, whose rims may deviate from the curves by `tolerance` (a length) where they cannot be
    /// met exactly.
    ///
    /// # Errors
    /// [`CuttingError::Curve`] for a degree that is not offered or a tolerance that is not positive.
    pub fn new(degree: usize, tolerance: f64) -> Result<Self, CuttingError> {
        let refused = |error| Err(CuttingError::Curve { curve: 0, error });
        if !(1..=Bezier::MAX_DEGREE).contains(&degree) {
            return refused(CurveError::Degree { degree, max: Bezier::MAX_DEGREE });
        }
        if tolerance.is_nan() || tolerance <= 0.0 {
            return refused(CurveError::Tolerance { tolerance });
        }
        Ok(Self { degree, tolerance, corner_angle: Self::CORNER_ANGLE, way: None })
    }

    /// Corners are points where the direction turns by more than `angle` (radians, between 0 and π; what lies outside is
    /// taken to the nearer end).
    #[must_use]
    pub fn with_corner_angle(mut self, angle: f64) -> Self {
        self.corner_angle = if angle.is_nan() { Self::CORNER_ANGLE } else { angle.clamp(0.0, PI) };
        self
    }

    /// Cuts in the given way, whatever the corners are like.
    #[must_use]
    pub fn with_way(mut self, way: Way) -> Self {
        self.way = Some(way);
        self
    }

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

/// Quadrilaterals of a boundary, laid out.
struct Quads {
    blueprint: Blueprint,
    way: Way,
    corners: usize,
    deviation: Deviation,
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
