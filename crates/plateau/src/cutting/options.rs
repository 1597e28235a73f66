use std::f64::consts::PI;

use surfaces::{Bezier, CurveError};

use super::CuttingError;

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
    /// Convex parts between straight lines from vertex to vertex, each cut by its middle.
    Parts,
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
    pub(super) degree: usize,
    pub(super) tolerance: f64,
    pub(super) corner_angle: f64,
    pub(super) way: Option<Way>,
}

impl Cutting {
    /// The turn of a direction, in radians, above which curves meet in a corner unless something else is said: 30°.
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

    /// Curves meet in a corner where the direction turns by more than `angle` (radians, between 0 and π; what lies outside is
    /// taken to the nearer end). What is a corner among samples is theirs: [`surfaces::Samples::with_corner_degrees`].
    #[must_use]
    pub fn with_corner_angle(mut self, angle: f64) -> Self {
        self.corner_angle = if angle.is_nan() { Self::CORNER_ANGLE } else { angle.clamp(0.0, PI) };
        self
    }

    /// Cuts in the given way, whatever the corners are like; None leaves it to them.
    #[must_use]
    pub fn with_way(mut self, way: impl Into<Option<Way>>) -> Self {
        self.way = way.into();
        self
    }
}
