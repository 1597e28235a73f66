use thiserror::Error;

/// Why a control net or a patch could not be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// A boundary polygon has another number of points than the one opposite.
    #[error("boundary row {name} has {found} points, the opposite one {expected}")]
    Length {
        /// Name of the row as in the experiment file.
        name: &'static str,
        /// Points of the opposite row.
        expected: usize,
        /// Points found.
        found: usize,
    },
    /// A boundary polygon needs at least two points.
    #[error("boundary row {name} has {found} points and needs at least 2")]
    TooShort {
        /// Name of the row.
        name: &'static str,
        /// Points found.
        found: usize,
    },
    /// Two boundary polygons disagree on the corner they share.
    #[error("corner: {first} has {a:?} and {second} has {b:?}; they must be the same point")]
    Corner {
        /// One row, and which end of it.
        first: &'static str,
        /// The other row, and which end of it.
        second: &'static str,
        /// The corner as the first row has it.
        a: [f64; 3],
        /// The corner as the second row has it.
        b: [f64; 3],
    },
    /// A net of points does not have the size its patch needs.
    #[error("a net of {rows} × {cols} points is needed, got {found} points")]
    Size {
        /// Rows needed.
        rows: usize,
        /// Columns needed.
        cols: usize,
        /// Points found.
        found: usize,
    },
    /// A tensor patch is a sum of products of families and was given none.
    #[error("a tensor patch needs at least one product of families")]
    NoProduct,
    /// A border polygon of a triangular net has another number of points than the first.
    #[error(
        "border row {name} has {found} points and ab has {expected}; all three sides need the same number"
    )]
    TriangleRow {
        /// Name of the row as in the experiment file.
        name: &'static str,
        /// Points of the row ab.
        expected: usize,
        /// Points found.
        found: usize,
    },
    /// A list of points is not a triangular net of its degree.
    #[error("a triangular net of degree {degree} has {expected} points, got {found}")]
    TriangleSize {
        /// The degree n.
        degree: usize,
        /// (n + 1)(n + 2)/2.
        expected: usize,
        /// Points found.
        found: usize,
    },
    /// The corner weight of a mask leaves no finite weight for the edges.
    #[error("mask weight α = {alpha:?} leaves no finite edge weight; give a finite number")]
    Mask {
        /// The weight given.
        alpha: f64,
    },
    /// A coordinate is not a finite number.
    #[error("control point {index} is not finite")]
    NotFinite {
        /// Position in the list of points.
        index: usize,
    },
    /// A curve has another number of control points than its family has functions.
    #[error("a curve in this basis needs {expected} control points, got {found}")]
    PolygonLength {
        /// Functions of the family.
        expected: usize,
        /// Points found.
        found: usize,
    },
    /// A parameter interval is empty, reversed or not finite.
    #[error("the {name} interval from {start:?} to {end:?} must be finite and of positive length")]
    Interval {
        /// Name of the parameter.
        name: &'static str,
        /// Start of the interval.
        start: f64,
        /// End of the interval.
        end: f64,
    },
    /// The weights of a generalized helicoid are both zero or not finite.
    #[error("helicoid weights a = {a:?}, b = {b:?} must be finite and not both 0")]
    Weights {
        /// Weight of the right helicoid.
        a: f64,
        /// Weight of the catenoid.
        b: f64,
    },
    /// A parameter interval would need too many patches.
    #[error("the {name} interval of length {span:?} would need more than {max} patches; shorten it")]
    TooManyPieces {
        /// Name of the parameter.
        name: &'static str,
        /// Length of the interval.
        span: f64,
        /// Most patches in one direction.
        max: usize,
    },
    /// A side of a trapezium is not finite over its whole length.
    #[error("side {side} of the trapezium, γ = {gamma:?}, β = {beta:?}, is not finite over the whole span")]
    Side {
        /// 0 for the side at u = 0, 1 for the other.
        side: usize,
        /// Offset.
        gamma: f64,
        /// Slope.
        beta: f64,
    },
    /// The two sides of a trapezium cross, or are the same.
    #[error("the two sides of the trapezium meet at v = {v:?}; they may meet at one end only")]
    Crossing {
        /// Where they meet.
        v: f64,
    },
    /// A blend of several products of families has no subdivision on one net.
    #[error("only a patch with one product of families can be subdivided, this one has {found}")]
    SeveralProducts {
        /// Products of the patch.
        found: usize,
    },
    /// More halvings of a curve than are offered.
    #[error("{levels} levels of subdivision asked for, at most {max} are offered")]
    Levels {
        /// Levels asked for.
        levels: u32,
        /// Most levels.
        max: u32,
    },
    /// A patch has another number of shape parameters than its family.
    #[error("{family} has {expected} shape parameters, got {found}")]
    ShapeCount {
        /// The family.
        family: &'static str,
        /// Parameters of the family.
        expected: usize,
        /// Parameters given.
        found: usize,
    },
    /// The families of the patch could not be made.
    #[error(transparent)]
    Basis(#[from] bases::BasisError),
}
