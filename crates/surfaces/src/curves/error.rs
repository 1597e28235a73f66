use thiserror::Error;

/// Why a curve of a boundary could not be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CurveError {
    /// Too few or too many points.
    #[error("a {kind} of {found} points; {min} to {max} are offered")]
    Count {
        /// What was to be made of them.
        kind: &'static str,
        /// Points given.
        found: usize,
        /// Fewest.
        min: usize,
        /// Most.
        max: usize,
    },
    /// A coordinate is not a finite number, or the curve is so large that its size is none.
    #[error("point {index} is not finite, or too large")]
    NotFinite {
        /// Position in the list of points.
        index: usize,
    },
    /// All points coincide.
    #[error("all points of the curve are the same point; a curve needs two that differ")]
    Point,
    /// A degree that is not offered.
    #[error("curves of degree {degree} are not offered; give a degree from 1 to {max}")]
    Degree {
        /// The degree given.
        degree: usize,
        /// Highest degree.
        max: usize,
    },
    /// The number of knots does not go with degree and points.
    #[error("a spline of degree {degree} with {points} points has {expected} knots, got {found}")]
    KnotCount {
        /// The degree.
        degree: usize,
        /// Control points.
        points: usize,
        /// points + degree + 1.
        expected: usize,
        /// Knots given.
        found: usize,
    },
    /// Knots descend or are not finite.
    #[error("knot {index} is {knot:?}: knots must be finite and never descend")]
    KnotOrder {
        /// Position in the list of knots.
        index: usize,
        /// The knot.
        knot: f64,
    },
    /// A knot is repeated so often that the curve breaks there.
    #[error(
        "the knot {knot:?} stands so often that the curve breaks there; inside at most {degree} times, at the ends once more"
    )]
    KnotMultiplicity {
        /// The knot.
        knot: f64,
        /// The degree.
        degree: usize,
    },
    /// The number of weights differs from that of the points.
    #[error("{found} weights for {points} control points; give one for each")]
    WeightCount {
        /// Control points.
        points: usize,
        /// Weights given.
        found: usize,
    },
    /// A weight is not positive, or far too large or small beside the others.
    #[error("weight {index} is {weight:?}: weights must be positive, none more than 1e9 times another")]
    Weight {
        /// Position in the list.
        index: usize,
        /// The weight.
        weight: f64,
    },
    /// A tolerance is not positive.
    #[error("tolerance {tolerance:?} must be a positive number")]
    Tolerance {
        /// The tolerance given.
        tolerance: f64,
    },
    /// The axes of an arc are not perpendicular unit vectors.
    #[error("the axes {first:?} and {second:?} of an arc must be perpendicular and of length 1")]
    Axes {
        /// First axis.
        first: [f64; 3],
        /// Second axis.
        second: [f64; 3],
    },
    /// A radius is not positive.
    #[error("radius {radius:?} must be a positive number")]
    Radius {
        /// The radius given.
        radius: f64,
    },
    /// An arc is empty or longer than a full turn.
    #[error("an arc from {from:?} to {to:?} radians; it must turn, and by no more than a full turn")]
    Angles {
        /// Angle of the start.
        from: f64,
        /// Angle of the end.
        to: f64,
    },
    /// Pieces of the degree stay farther from the curve than the tolerance.
    #[error(
        "pieces of degree {degree} stay {deviation:.1e} away from the curve, the tolerance is {tolerance:.1e}; raise the \
         degree or the tolerance"
    )]
    NotMet {
        /// Degree of the pieces.
        degree: usize,
        /// The tolerance given.
        tolerance: f64,
        /// How near they came.
        deviation: f64,
    },
}

/// What of a curve an error is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurvePart {
    /// Its points.
    Points,
    /// Its degree.
    Degree,
    /// The knots of a spline.
    Knots,
    /// The weights of a rational curve.
    Weights,
    /// The circle or ellipse that an arc is of, and from where to where it turns.
    Arc,
    /// How near its pieces are to be.
    Tolerance,
}

impl CurveError {
    /// What it is about.
    #[must_use]
    pub const fn part(&self) -> CurvePart {
        match self {
            Self::Count { .. } | Self::NotFinite { .. } | Self::Point => CurvePart::Points,
            Self::Degree { .. } => CurvePart::Degree,
            Self::KnotCount { .. } | Self::KnotOrder { .. } | Self::KnotMultiplicity { .. } => {
                CurvePart::Knots
            }
            Self::WeightCount { .. } | Self::Weight { .. } => CurvePart::Weights,
            Self::Axes { .. } | Self::Radius { .. } | Self::Angles { .. } => CurvePart::Arc,
            Self::Tolerance { .. } | Self::NotMet { .. } => CurvePart::Tolerance,
        }
    }
}
